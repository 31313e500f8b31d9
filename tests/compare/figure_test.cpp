#include "compare/figures/figure.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "compare/figures/figure_metadata.hpp"
#include "compare/figures/gnuplot.hpp"
#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(figure_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::compare;
using namespace std::string_view_literals;

namespace {

Figure example() {
  return {.title = "It's a 'test' of {/:Italic r_f}",
          .x = {.label = "load", .logarithmic = true},
          .y = {.label = "departure", .range = std::pair{0.0, 0.5}},
          .series = {{.label = "a < b", .x = {0.1, 1, 10}, .y = {0.1, std::nan(""), 0.3}},
                     {.label = "", .x = {0.2, 2}, .y = {0.3, 0.2}, .mark = Mark::points}},
          .annotations = {{"here", 1, 0.2}}};
}

dem::Provenance provenance() {
  dem::Provenance p;
  p.commit = "abc";
  p.command = "x <é> & y";
  return p;
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// The tEXt chunks of a PNG; every chunk's length and CRC must be right.
std::vector<std::string> text_chunks(const std::string& png) {
  std::vector<std::string> texts;
  std::size_t at = 8;
  while (at + 12 <= png.size()) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(png.data()) + at;
    const std::size_t length = boost::endian::load_big_u32(bytes);
    BOOST_REQUIRE(at + 12 + length <= png.size());
    boost::crc_32_type crc;
    crc.process_bytes(bytes + 4, length + 4);
    BOOST_TEST(crc.checksum() == boost::endian::load_big_u32(bytes + 8 + length));
    if (png.compare(at + 4, 4, "tEXt") == 0) texts.push_back(png.substr(at + 8, length));
    at += 12 + length;
  }
  BOOST_TEST(at == png.size());
  return texts;
}

}  // namespace

BOOST_AUTO_TEST_CASE(svg_is_whole_and_carries_its_provenance) {
  const std::string svg = to_svg(example(), provenance());
  BOOST_TEST(count(svg, "</svg>") == 1);
  BOOST_TEST(
      svg.find("<metadata>\nprogram: fiberchain\ncommit: abc\ncommand: x &lt;é&gt; &amp; y\n</metadata>") !=
      std::string::npos);
  BOOST_TEST(svg.find("a &lt; b") != std::string::npos);
  BOOST_TEST(svg.find("It's a 'test' of ") != std::string::npos);
  BOOST_TEST(svg.find("here") != std::string::npos);
}

/// gnuplot writes letters of its Symbol font as Latin ones, and viewers drop spaces at changes of font.
BOOST_AUTO_TEST_CASE(greek_letters_and_spaces_are_what_they_are) {
  Figure figure = example();
  figure.title = "bond, ν = 0.3, 3πμ{/:Italic L} wide";
  const std::string svg = to_svg(figure, {});
  BOOST_TEST(svg.find("bond, ν = 0.3, 3πμ") != std::string::npos);
  BOOST_TEST(svg.find("<svg xml:space=\"preserve\"") != std::string::npos);
  int figures = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(FIBERCHAIN_SOURCE_DIR) / "data/figures")) {
    if (entry.path().extension() != ".svg") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    BOOST_TEST(text.find("Symbol") == std::string::npos, entry.path());
    ++figures;
  }
  BOOST_TEST(figures > 5);
}

BOOST_AUTO_TEST_CASE(png_is_whole_and_carries_its_provenance) {
  const std::string png = to_png(example(), provenance());
  BOOST_TEST(png.starts_with("\x89PNG\r\n\x1a\n"sv));
  const auto texts = text_chunks(png);
  BOOST_TEST(texts.size() == 3);
  BOOST_TEST(texts[1] == "fiberchain:commit\0abc"sv);
  BOOST_TEST(texts[2] ==
             "fiberchain:command\0x <?"
             "?> & y"sv);
}

// Series 1: two finite points of three, and its mark in the legend; series 2: two points and no legend.
BOOST_AUTO_TEST_CASE(every_finite_point_is_drawn_and_no_other) {
  const std::string svg = to_svg(example(), {});
  BOOST_TEST(count(svg, "<use xlink:href='#gpPt6' transform='translate") == 3);
  BOOST_TEST(count(svg, "<use xlink:href='#gpPt4' transform='translate") == 2);
}

// A cell and a number for each finite value, a frame for those below the mark, none for what is missing.
BOOST_AUTO_TEST_CASE(a_heat_map_has_a_cell_for_every_value) {
  Figure figure{.title = "map", .x = {"columns"}, .y = {"it's rows"}, .series = {}};
  figure.map = HeatMap{.x = {-0.2, 0.3, 0.49},
                       .y = {0, 5},
                       .value = {{0.123, 0.456, 0.789}, {0.0345, std::nan(""), 7.89}},
                       .label = "value",
                       .framed_below = 0.2};
  const std::string svg = to_svg(figure, provenance());
  for (const char* number :
       {">0.123<", ">0.456<", ">0.789<", ">0.0345<", ">7.89<", ">-0.2<", ">0.49<", ">5<"}) {
    BOOST_TEST(svg.find(number) != std::string::npos, number);
  }
  BOOST_TEST(svg.find(">nan<") == std::string::npos);
  // the frames' color: of two cells
  BOOST_TEST(count(svg, "rgb(213,  94,   0)") + count(svg, "#D55E00") + count(svg, "#d55e00") > 0);
  figure.map->framed_below = 0;
  BOOST_TEST(count(to_svg(figure, provenance()), "rgb(213,  94,   0)") == 0);
  figure.map->value[1].pop_back();
  BOOST_CHECK_THROW(to_svg(figure, {}), FigureError);
  figure.map->value.pop_back();
  BOOST_CHECK_THROW(to_svg(figure, {}), FigureError);
  figure.map->value = {{0, -1, 0}, {0, 0, 0}};
  BOOST_CHECK_THROW(to_svg(figure, {}), FigureError);
}

BOOST_AUTO_TEST_CASE(a_figure_that_makes_no_sense_is_refused) {
  Figure figure = example();
  figure.series[0].y.pop_back();
  BOOST_CHECK_THROW(to_svg(figure, {}), FigureError);
  BOOST_CHECK_THROW(run_gnuplot("plot nonsense here\n"), FigureError);
  BOOST_CHECK_THROW(run_gnuplot(""), FigureError);
  BOOST_CHECK_THROW(with_svg_metadata("<html></html>", {}), FigureError);
  BOOST_CHECK_THROW(with_png_metadata("GIF89a", {}), FigureError);
}

// The new trailer leads to the new dictionary, to the table before it and to the same root.
BOOST_AUTO_TEST_CASE(pdf_is_whole_and_carries_its_provenance) {
  const std::string pdf = to_pdf(example(), provenance());
  BOOST_TEST(pdf.starts_with("%PDF-1."));
  BOOST_TEST(count(pdf, "startxref") == 2);
  const auto number_behind = [&](std::size_t at, std::string_view key) {
    return std::stoul(pdf.substr(pdf.find(key, at) + key.size()));
  };
  const std::size_t table = number_behind(pdf.rfind("startxref"), "startxref"),
                    before = number_behind(pdf.find("startxref"), "startxref");
  BOOST_TEST(pdf.substr(table, 5) == "xref\n");
  BOOST_TEST(pdf.substr(before, 5) == "xref\n");
  BOOST_TEST(number_behind(table, "/Prev") == before);
  BOOST_TEST(number_behind(table, "/Root") == number_behind(before, "/Root"));
  const std::size_t info = number_behind(table, "/Info"),
                    place = number_behind(table, fmt::format("{} 1\n", info));
  BOOST_TEST(info == number_behind(before, "/Size"));
  BOOST_TEST(number_behind(table, "/Size") == info + 1);
  const std::string entries = pdf.substr(place, table - place);
  BOOST_TEST(entries.starts_with(fmt::format("{} 0 obj\n<< ", info)), entries);
  BOOST_TEST(entries.find("/fiberchain:commit (abc)\n") != std::string::npos, entries);
  BOOST_TEST(entries.find("/fiberchain:command (x <?"
                          "?> & y)\n") != std::string::npos,
             entries);
  dem::Provenance odd;
  odd.command = "a (b\\";
  BOOST_TEST(with_pdf_metadata(pdf, odd).find("/fiberchain:command (a \\(b\\\\)\n") != std::string::npos);
  BOOST_CHECK_THROW(with_pdf_metadata("%PDF-1.5\nstartxref\n9\n%%EOF\n", {}), FigureError);
}

BOOST_AUTO_TEST_CASE(formats_and_titles_are_those_asked_for) {
  const auto files =
      figure_files("f", example(), {}, {.formats = {FigureFormat::pdf, FigureFormat::svg}, .title = false});
  BOOST_REQUIRE(files.size() == 2);
  BOOST_TEST(files[0].name == "f.pdf");
  BOOST_TEST(files[0].content.starts_with("%PDF"));
  BOOST_TEST(files[1].name == "f.svg");
  BOOST_TEST(count(files[1].content, "'test'") == 0);
  BOOST_TEST(count(files[1].content, "departure") == 1);
  const auto usual = figure_files("f", example(), {});
  BOOST_TEST(usual.size() == 2);
  BOOST_TEST(count(usual[0].content, "'test'") == 1);
}

// From low to high at the first and the last x; what is not finite has no place in it.
BOOST_AUTO_TEST_CASE(a_band_is_one_tinted_area) {
  Figure figure{"Spread", {"time"}, {"angle", false, std::pair{0.0, 10.0}}, {}};
  figure.series.push_back({"mean", {0, 1, 2}, {2, 4, 6}, Mark::line});
  const std::string without = to_svg(figure, {});
  Series band{"", {0, 1, 2}, {3, std::nan(""), 8}, Mark::band, Dash::solid, 0};
  band.y_low = {1, 2, 4};
  figure.series.push_back(band);
  const std::string svg = to_svg(figure, {});
  BOOST_TEST(count(svg, "<polygon") == count(without, "<polygon") + 1);
  const std::size_t at = svg.find("points = '", svg.rfind("<polygon"));
  const std::string points = svg.substr(at + 10, svg.find('\'', at + 10) - at - 10);
  BOOST_TEST(count(points, ",") == 4u, points);
  BOOST_TEST(svg.find("fill-opacity = '0.220000'") != std::string::npos);
  figure.series.back().y_low.pop_back();
  BOOST_CHECK_THROW(to_svg(figure, {}), FigureError);
}

BOOST_AUTO_TEST_CASE(letters_of_the_symbol_font_are_refused) {
  Figure figure = example();
  figure.x.label = "{/Symbol x}_f";
  BOOST_CHECK_THROW(to_svg(figure, {}), FigureError);
}

BOOST_AUTO_TEST_CASE(thirteen_curves_have_thirteen_colors) {
  Figure figure{"Energy", {"time"}, {"energy"}, {}};
  for (int n = 0; n < 13; ++n) figure.series.push_back({"curve", {0, 1}, {1.0 * n, 2.0 * n}, Mark::line});
  const std::string svg = to_svg(figure, {});
  std::set<std::string> colors;
  for (std::size_t at = svg.find("stroke='rgb("); at != std::string::npos;
       at = svg.find("stroke='rgb(", at + 1))
    colors.insert(svg.substr(at, svg.find(')', at) - at));
  BOOST_TEST(colors.size() >= 13u);
}

BOOST_AUTO_TEST_CASE(without_gnuplot_the_error_says_what_to_install) {
  ::setenv("PATH", "/nonexistent", 1);
  BOOST_CHECK_EXCEPTION(to_svg(example(), {}), FigureError, [](const FigureError& error) {
    return std::string(error.what()).find("gnuplot-nox") != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
