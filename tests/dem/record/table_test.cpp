#include "dem/record/table.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "compare/study/errors.hpp"
#include "compare/study/json.hpp"
#include "compare/study/markdown.hpp"
#include "dem/record/columns.hpp"
#include "dem/record/csv.hpp"

BOOST_AUTO_TEST_SUITE(table_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::dem;

namespace {

dem::Provenance provenance() {
  dem::Provenance p;
  p.version = "1.2.3";
  p.commit = "abc";
  p.command = "fiberchain run 'a: b'";
  return p;
}

/// Numbers that are hard to write down exactly, text that is hard to quote.
dem::Table awkward() {
  dem::Table table({"aspect_ratio", "load", "tip_y", "status"});
  table.append(
      {{"aspect_ratio", 13}, {"load", 0.1}, {"tip_y", 1.0 / 3}, {"status", std::string("a,b \"c\"\nd")}});
  table.append({{"aspect_ratio", -7}, {"load", 5e-324}, {"tip_y", std::nextafter(1.0, 2.0)}});
  table.append({{"load", -std::numeric_limits<double>::max()},
                {"tip_y", std::nan("")},
                {"status", std::string("#x")}});
  table.append({{"aspect_ratio", 2}, {"load", 3}, {"tip_y", -0.0}, {"status", std::string("1e5")}});
  return table;
}

dem::CsvDocument read(const std::string& text) {
  std::istringstream stream(text);
  return dem::read_csv(stream, "t.csv");
}

std::string csv_error(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_column_is_documented_once) {
  std::set<std::string_view> names;
  for (const dem::Column& column : dem::all_columns()) {
    BOOST_TEST(names.insert(column.name).second, column.name << " comes twice");
    BOOST_TEST(!column.meaning.empty());
    BOOST_TEST(column.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") ==
               std::string_view::npos);
    if (column.kind == dem::CellKind::text)
      BOOST_TEST(column.unit.empty(), column.name << " is text with a unit");
  }
}

BOOST_AUTO_TEST_CASE(columns_outside_the_dictionary_are_refused) {
  BOOST_CHECK_THROW(dem::Table({"load", "lode"}), dem::TableError);
  BOOST_CHECK_THROW(dem::Table({"load", "load"}), dem::TableError);
  dem::Table table({"load", "status", "steps"});
  BOOST_CHECK_THROW(table.append({{"tip_y", 1.0}}), dem::TableError);
  BOOST_CHECK_THROW(table.append({{"load", 1.0}, {"load", 2.0}}), dem::TableError);
  BOOST_CHECK_THROW(table.append({{"load", std::string("1")}}), dem::TableError);
  BOOST_CHECK_THROW(table.append({{"status", 1.0}}), dem::TableError);
  BOOST_CHECK_THROW(table.append({{"steps", 1.5}}), dem::TableError);
  BOOST_TEST(table.rows().empty());
}

BOOST_AUTO_TEST_CASE(cells_are_found_by_name) {
  const dem::Table table = awkward();
  BOOST_TEST(table.number(0, "aspect_ratio") == 13);
  BOOST_TEST(std::isnan(table.number(2, "tip_y")));
  BOOST_TEST(std::isnan(table.number(2, "aspect_ratio")));
  BOOST_TEST(table.text(1, "status") == "");
  BOOST_CHECK_THROW(table.number(0, "status"), dem::TableError);
  BOOST_CHECK_THROW(table.text(0, "load"), dem::TableError);
  BOOST_CHECK_THROW(table.number(4, "load"), dem::TableError);
  BOOST_CHECK_THROW(table.number(0, "steps"), dem::TableError);
}

BOOST_AUTO_TEST_CASE(selected_columns_keep_their_cells_in_the_order_asked) {
  const dem::Table chosen = awkward().select({"tip_y", "aspect_ratio"});
  BOOST_TEST(chosen.columns().size() == 2);
  BOOST_TEST(chosen.number(0, "tip_y") == 1.0 / 3);
  BOOST_TEST(chosen.number(1, "aspect_ratio") == -7);
  BOOST_CHECK_THROW(awkward().select({"steps"}), dem::TableError);
}

BOOST_AUTO_TEST_CASE(csv_reads_back_to_the_same_bits) {
  const dem::Table table = awkward();
  const dem::CsvDocument back = read(dem::to_csv(table, provenance()));
  BOOST_TEST((back.table.columns() == table.columns()));
  BOOST_TEST((back.table.rows() == table.rows()));
  BOOST_TEST(std::signbit(back.table.number(3, "tip_y")));
  const std::vector<std::pair<std::string, std::string>> expected = {{"program", "fiberchain"},
                                                                     {"version", "1.2.3"},
                                                                     {"commit", "abc"},
                                                                     {"command", "fiberchain run 'a: b'"}};
  BOOST_TEST((back.comments == expected));
}

BOOST_AUTO_TEST_CASE(csv_looks_as_promised) {
  dem::Table table({"load", "status", "steps"});
  table.append({{"load", 0.1}, {"status", std::string("x,y")}});
  BOOST_TEST(dem::to_csv(table, {}) == "# program: fiberchain\nload,status,steps\n0.1,\"x,y\",nan\n");
}

BOOST_AUTO_TEST_CASE(csv_errors_name_file_line_and_column) {
  BOOST_TEST(csv_error("# c\n\nload,status\n1,ok\n2;ok,x\n") == "t.csv:5: column load: '2;ok' is no number");
  BOOST_TEST(csv_error("load,status\n1\n") == "t.csv:2: 1 fields where the header has 2");
  BOOST_TEST(csv_error("load,stattus\n") == "t.csv:1: no column is called 'stattus'");
  BOOST_TEST(csv_error("load,status\n1,\"ok\n\n") == "t.csv:3: a quoted field is not closed");
  BOOST_TEST(csv_error("load,status\n1,\"ok\"no\n") == "t.csv:2: text after a quoted field");
  BOOST_TEST(csv_error("steps,load\n1.5,1\n") == "t.csv:2: column steps: '1.5' is no integer");
  BOOST_TEST(csv_error("# only comments\n") == "t.csv:1: no header: the file holds no table");
  BOOST_CHECK_THROW(dem::read_csv(std::filesystem::path("no/such.csv")), InputError);
  BOOST_CHECK_THROW(dem::read_csv(std::filesystem::path("/")), InputError);
}

BOOST_AUTO_TEST_CASE(csv_of_other_programs_is_read) {
  const dem::CsvDocument document = read("load,status\r\n1e0,\"a \"\"b\"\"\"\r\n\r\n# note\r\n+2.5,\r\n");
  BOOST_TEST(document.table.rows().size() == 2);
  BOOST_TEST(document.table.text(0, "status") == "a \"b\"");
  BOOST_TEST(document.table.number(1, "load") == 2.5);
  BOOST_TEST(document.lines[1] == 5);
}

BOOST_AUTO_TEST_CASE(json_holds_the_same_rows) {
  const auto json = nlohmann::json::parse(dem::to_text(dem::to_json(awkward(), provenance())));
  BOOST_TEST(json.size() == 2);
  BOOST_TEST(json["provenance"]["commit"] == "abc");
  BOOST_TEST(json["rows"].size() == 4);
  BOOST_TEST(json["rows"][0]["tip_y"].get<double>() == 1.0 / 3);
  BOOST_TEST(json["rows"][0]["aspect_ratio"].is_number_integer());
  BOOST_TEST(json["rows"][0]["status"] == "a,b \"c\"\nd");
  BOOST_TEST(json["rows"][2]["tip_y"].is_null());
  BOOST_TEST(json["rows"][2]["aspect_ratio"].is_null());
}

BOOST_AUTO_TEST_CASE(json_survives_bytes_that_are_no_text) {
  dem::Table table({"status"});
  table.append({{"status", std::string("\xff\xfe")}});
  BOOST_CHECK_NO_THROW(nlohmann::json::parse(dem::to_text(dem::to_json(table, {}))));
}

BOOST_AUTO_TEST_CASE(markdown_is_aligned_and_escaped) {
  dem::Table table({"status", "load"});
  table.append({{"status", std::string("a|b")}, {"load", 1.0 / 3}});
  table.append({{"load", 12.0}});
  BOOST_TEST(dem::to_markdown(table) ==
             "| status |     load |\n"
             "| ------ | -------: |\n"
             "| a\\|b   | 0.333333 |\n"
             "| –      |       12 |\n");
  const std::string document = dem::to_markdown("Title", table, provenance());
  BOOST_TEST(document.starts_with("# Title\n\n| status"));
  BOOST_TEST(document.find("\n- commit: `abc`\n") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
