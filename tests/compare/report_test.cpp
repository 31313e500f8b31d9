// The page of `fiberchain report`, part by part.
#include <fmt/format.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>

#include "compare/report/page.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/validation.hpp"

BOOST_AUTO_TEST_SUITE(report_test)

namespace fs = std::filesystem;
namespace dem = fiberchain::dem;
using namespace fiberchain::compare;

namespace {

const fs::path kData = fs::path(FIBERCHAIN_SOURCE_DIR) / "data";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

/// A claim as it would be if a run had measured the middle of all that is expected.
dem::Table measured_as_expected(const std::vector<Claim>& claims) {
  std::vector<ValidationRow> rows;
  for (const Claim& claim : claims) {
    Claim plain = claim;
    plain.evidence = "measured by nobody";
    if (std::isnan(plain.value)) plain.value = 1;
    Measured measured{.value = plain.value, .spread = 1};
    if (plain.otherwise) measured.otherwise = plain.otherwise->value;
    rows.push_back(row_of(plain, measured));
  }
  return to_table(rows);
}

/// A page without figures.
Report report_of(std::vector<MatrixEntry> matrix) {
  dem::Provenance provenance;
  provenance.version = "9.8.7";
  provenance.commit = "0123456789abcdef-dirty";
  return {.provenance = provenance,
          .matrix = std::move(matrix),
          .paper = paper_figures({}),
          .sections = report_sections({}),
          .packing = std::nullopt,
          .tables = {},
          .notes = {}};
}

MatrixEntry nasty_entry() {
  MatrixEntry entry;
  entry.id = "nasty";
  entry.quantity = "a < b && c > \"d\" <script>alert('x')</script> {{quantity}}";
  entry.verdict = "disputed";
  return entry;
}

/// Two fibers of three and two spheres of other radii, somewhere off the origin.
dem::TrajectoryFrame two_fibers(double time) {
  return {.time = time,
          .step = 1,
          .low = {-7, 1, 2},
          .high = {3, 5, 22},
          .periodic = {false, false, false},
          .position = {{-5, 2, 3}, {-4, 2, 3}, {-3, 2, 3}, {1, 4, 13}, {1, 4, 12}},
          .velocity = std::vector<dem::Vec<double, 3>>(5),
          .radius = {0.5, 0.5, 0.5, 0.25, 0.25},
          .fiber = {0, 0, 0, 1, 1},
          .bonds = {}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_row_of_the_matrix_is_in_the_page) {
  const auto claims = read_all_published(kData);
  BOOST_TEST_REQUIRE(claims.size() > 150u);
  const auto matrix = matrix_entries(claims, {measured_as_expected(claims)});
  const MatrixCounts counts = counts_of(matrix);
  BOOST_TEST(counts.all == static_cast<int>(claims.size()));
  BOOST_TEST(counts.holds + counts.holds_only_if + counts.disputed == counts.all);
  BOOST_TEST(counts.disputed > 10);
  BOOST_TEST(counts.failed == 0);
  const std::string page = to_html(report_of(matrix), kData / "report");
  for (const Claim& claim : claims)
    BOOST_TEST(count_of(page, "<tr id=\"row-" + claim.id + "\"") == 1u, claim.id);
  BOOST_TEST(count_of(page, "data-verdict=\"disputed\"") == static_cast<std::size_t>(counts.disputed));
  BOOST_TEST(count_of(page, "data-verdict=\"holds-only-if\"") ==
             static_cast<std::size_t>(counts.holds_only_if));
  BOOST_TEST(count_of(page, "<dd>measured by nobody</dd>") == claims.size());
}

BOOST_AUTO_TEST_CASE(statements_of_the_paper_stand_beside_their_figures) {
  const auto claims = read_all_published(kData);
  const auto matrix = matrix_entries(claims, {});
  const std::string page = to_html(report_of(matrix), kData / "report");
  for (const MatrixEntry& entry : matrix)
    BOOST_TEST(count_of(page, "href=\"#row-" + entry.id + "\"") == (entry.of_paper ? 1u : 0u), entry.id);
  const auto four = page.find("<h3>Fig 4."), five = page.find("<h3>Fig 5."),
             least = page.find("href=\"#row-paper-fig4-rf10-least\"");
  BOOST_TEST((four < least && least < five));
  BOOST_TEST(figure_named("p. 178, Fig 4; p. 181") == 4);
  BOOST_TEST(figure_named("p. 181, Fig 12") == 12);
  BOOST_TEST(figure_named("p. 180, Eq 20") == 0);
}

BOOST_AUTO_TEST_CASE(rows_without_a_run_and_runs_without_a_claim_are_said) {
  const auto claims = read_all_published(kData);
  const std::vector<Claim> first(claims.begin(), claims.begin() + 3);
  const dem::Table measured = measured_as_expected({claims[1], claims[2], claims[7]});
  const auto matrix = matrix_entries(first, {measured, measured});
  BOOST_TEST_REQUIRE(matrix.size() == 4u);
  BOOST_TEST(matrix[0].verdict == "not measured");
  BOOST_TEST(matrix[0].measured == "");
  BOOST_TEST(matrix[1].measured != "");
  BOOST_TEST(matrix[3].id == claims[7].id);
  BOOST_TEST(counts_of(matrix).not_measured == 1);
}

BOOST_AUTO_TEST_CASE(a_row_that_is_not_as_expected_fails) {
  const auto claims = read_all_published(kData);
  const Claim& claim = find_claim(claims, "elastica-y-1");
  const auto matrix = matrix_entries({claim}, {to_table({row_of(claim, {.value = claim.value + 1})})});
  BOOST_TEST(counts_of(matrix).failed == 1);
  const std::string page = to_html(report_of(matrix), kData / "report");
  BOOST_TEST(has(page, "data-verdict=\"fails\""));
  BOOST_TEST(has(page, "not as expected"));
}

BOOST_AUTO_TEST_CASE(texts_are_escaped) {
  const std::string page = to_html(report_of({nasty_entry()}), kData / "report");
  BOOST_TEST(!has(page, "<script>alert"));
  BOOST_TEST(has(page, "a &lt; b &amp;&amp; c &gt; &quot;d&quot; &lt;script&gt;"));
  BOOST_TEST(has(page, "{{quantity}}"));  // no template of ours
  BOOST_TEST(count_of(page, "{{") == 1u);
}

BOOST_AUTO_TEST_CASE(claims_are_written_in_greek) {
  BOOST_TEST(in_unicode("xi_f at PL^2/EI >= 1, nu = 0.3") == "ξ_f at PL²/EI ≥ 1, ν = 0.3");
  BOOST_TEST(in_unicode("(omega dt)^4, 10^-12, r_f^2.5") == "(ω dt)⁴, 10⁻¹², r_f^2.5");
  BOOST_TEST(in_unicode("numerical pieces, maximum, ^") == "numerical pieces, maximum, ^");
}

BOOST_AUTO_TEST_CASE(nothing_is_loaded_and_the_page_is_small) {
  const Sources sources{{kData / "figures", "data/figures"}};
  Report report = report_of(matrix_entries(read_all_published(kData), {}));
  report.paper = paper_figures(sources);
  report.sections = report_sections(sources);
  const std::string page = to_html(report, kData / "report");
  BOOST_TEST(count_of(page, "<img src=\"data:image/svg+xml;base64,") > 10u);
  BOOST_TEST(count_of(page, "<img src=\"data:image/png;base64,") == 1u);
  for (const ReportSection& section : report.sections) BOOST_TEST(!section.figures.empty(), section.id);
  for (const PaperFigure& figure : report.paper) BOOST_TEST(!figure.figures.empty(), figure.number);
  // whatever is asked for is inside the page or an anchor of it
  const std::regex reference(R"re((src|href|action|poster|data)="([^"]{0,30}))re");
  for (std::sregex_iterator at(page.begin(), page.end(), reference), end; at != end; ++at) {
    const std::string target = (*at)[2];
    BOOST_TEST((target.starts_with("data:") || target.starts_with("#")), target);
  }
  for (const char* loads :
       {"@import", "url(", "fetch(", "XMLHttpRequest", "<link rel=\"stylesheet\"", "import("})
    BOOST_TEST(!has(page, loads), loads);
  BOOST_TEST(page.size() < 5'000'000u);
  BOOST_TEST(has(page, "9.8.7"));
  BOOST_TEST(has(page, "0123456789-dirty"));
}

BOOST_AUTO_TEST_CASE(files_say_which_run_made_them) {
  const std::string svg = read_source(kData / "figures" / "fig-9.svg");
  const Origin drawn = origin_of("data/figures/fig-9.svg", svg);
  BOOST_TEST(drawn.version == "0.2.0");
  BOOST_TEST(drawn.commit.size() >= 40u);
  BOOST_TEST(has(drawn.command, "tables damping"));
  BOOST_TEST(drawn.date.size() == 20u);
  const Origin rendered = origin_of("x", read_source(kData / "figures" / "fig-11.png"));
  BOOST_TEST(rendered.commit == "a7293477415126667e3f25c0e7ecbdfd0288493b");
  BOOST_TEST(rendered.command == "build/release/fiberchain tables packing --out /tmp/tp2/results");
  BOOST_TEST(rendered.date.size() == 20u);
  BOOST_TEST(origin_of("x", "<svg>\n<metadata>\ncommand: a &lt; b &amp;lt;\n</metadata>").command ==
             "a < b &lt;");
  BOOST_TEST(origin_of("x", "# program: f\n# commit: abc\nid\n1\n").commit == "abc");
  BOOST_TEST(origin_of("x", "nothing").commit == "");
}

BOOST_AUTO_TEST_CASE(directories_given_first_go_first) {
  const fs::path made = fs::temp_directory_path() / fmt::format("report_test_{}", ::getpid());
  fs::create_directories(made);
  std::ofstream(made / "fig-9.svg") << "<svg>anew</svg>";
  std::ofstream(made / "stability-map-paper-leapfrog-10.svg") << "<svg>anew</svg>";
  const Sources sources{{made, "made"}, {kData / "figures", "data/figures"}};
  BOOST_TEST(find_source(sources, "fig-9.svg")->label == "made/fig-9.svg");
  BOOST_TEST(find_source(sources, "fig-4.svg")->label == "data/figures/fig-4.svg");
  BOOST_TEST(!find_source(sources, "none.svg").has_value());
  for (const ReportSection& section : report_sections(sources)) {
    if (section.id == "stability")
      BOOST_TEST(section.figures.at(0).origin.file == "made/stability-map-paper-leapfrog-10.svg");
  }
  fs::remove_all(made);
  BOOST_CHECK_THROW(read_source(made / "fig-9.svg"), InputError);
}

BOOST_AUTO_TEST_CASE(a_packing_is_compact) {
  const PackingView view = packing_view({two_fibers(0), two_fibers(0.25)});
  BOOST_TEST(view.spheres == 5);
  BOOST_TEST(view.shown == 5);
  BOOST_TEST(view.frames == 2);
  BOOST_TEST(view.last == 0.25);
  BOOST_TEST(view.json.starts_with(
      R"({"size":10,"frames":[{"time":0,"low":[-0.1,-0.1,-0.1],"high":[0.7,0.3,1.1],)"));
  BOOST_TEST(has(view.json, R"("runs":[0,3,0.05,1,2,0.025])"));
  // x, y, z of five spheres: 0 0 0, 0.1 0 0, 0.2 0 0, 0.6 0.2 1, 0.6 0.2 0.9 of 65535, as Python packs them
  BOOST_TEST(has(view.json, R"("points":"AAAAAAAAmhkAAAAAMzMAAAAAmZkzM///mZkzM2bm")"));
  for (const char letter : {'<', '>', '&'}) BOOST_TEST(view.json.find(letter) == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_large_packing_is_thinned_by_whole_fibers) {
  const PackingView view = packing_view({two_fibers(0)}, {.spheres = 4});
  BOOST_TEST(view.spheres == 5);
  BOOST_TEST(view.shown == 3);
  BOOST_TEST(has(view.json, R"("runs":[0,3,0.05])"));
  BOOST_TEST((chosen_frames(11, 4) == std::vector<std::int64_t>{0, 3, 6, 10}));
  BOOST_TEST((chosen_frames(11, 1) == std::vector<std::int64_t>{10}));
  BOOST_TEST((chosen_frames(11, 0) == std::vector<std::int64_t>{10}));
  BOOST_TEST((chosen_frames(2, 50) == std::vector<std::int64_t>{0, 1}));
  BOOST_CHECK_THROW(packing_view(std::vector<dem::TrajectoryFrame>{}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
