#include "compare/study/published.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(published_test)

using namespace fiberchain::compare;
namespace fs = std::filesystem;

namespace {

const std::string kHeader =
    "id,feature,reference_kind,quantity,value,tolerance,tolerance_scale,rule,unit,source,page_or_figure,"
    "statement,"
    "evidence,dispute\n";

/// A row of these, the rest of which is well formed.
std::string row(const std::string& id, const std::string& value = "1", const std::string& kind = "published",
                const std::string& rule = "must hold", const std::string& tolerance = "0.5") {
  return id + ",f," + kind + ",q," + value + "," + tolerance + ",unit," + rule +
         ",1,\"S, 2015\",Fig 4,says so,seen,-\n";
}

/// A data directory with one file of published values; it goes when the test ends.
struct Data {
  explicit Data(const std::string& rows)
      : path(fs::temp_directory_path() / ("fiberchain-data-" + std::to_string(::getpid()))) {
    fs::remove_all(path);
    fs::create_directories(path / "published");
    std::ofstream(path / "published/a.csv") << rows;
  }
  ~Data() { fs::remove_all(path); }
  fs::path path;
};

std::string error_of(const std::string& rows) {
  const Data data(rows);
  try {
    read_all_published(data.path);
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(std::min(message.find("a.csv"), message.size()));
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(claims_are_read_with_all_they_say) {
  const Data data(kHeader + row("x", "0.25") + row("y", "nan", "published", "disputed", "nan"));
  const auto claims = read_all_published(data.path);
  BOOST_TEST(claims.size() == 2);
  BOOST_TEST(claims[0].source == "S, 2015");
  BOOST_TEST(claims[0].subject == "a");
  BOOST_TEST(claims[0].tolerance == 0.5);
  BOOST_TEST((claims[1].rule == VerdictRule::disputed));
  BOOST_TEST(find_claim(claims, "x").value == 0.25);
  BOOST_TEST(std::isnan(find_claim(claims, "y").value));
  BOOST_CHECK_THROW(find_claim(claims, "z"), InputError);
}

BOOST_AUTO_TEST_CASE(faults_are_named_by_file_line_and_column) {
  BOOST_TEST(error_of(kHeader + row("x", "a")) == "a.csv:2: column value: 'a' is no number");
  BOOST_TEST(error_of(kHeader + row("x") + row("x")) == "a.csv:3: column id: 'x' comes twice");
  BOOST_TEST(error_of(kHeader + row("")) == "a.csv:2: column id is empty");
  BOOST_TEST(error_of(kHeader + row("x", "1", "guessed")) ==
             "a.csv:2: column reference_kind: 'guessed' is none of its words");
  BOOST_TEST(error_of(kHeader + row("x", "1", "exact", "disputed")) ==
             "a.csv:2: column rule: only a published claim can be disputed");
  BOOST_TEST(error_of(kHeader + row("x", "1", "exact", "must hold", "-1")) ==
             "a.csv:2: column tolerance must be at least 0");
  BOOST_TEST(error_of(kHeader + row("x", "1", "exact", "must hold", "nan")) ==
             "a.csv:2: column tolerance must be at least 0");
  BOOST_TEST(error_of("id,feature\nx,f\n") == "a.csv: column reference_kind is missing");
}

BOOST_AUTO_TEST_CASE(an_id_in_two_files_is_refused) {
  const Data data(kHeader + row("x"));
  fs::copy(data.path / "published/a.csv", data.path / "published/b.csv");
  BOOST_CHECK_THROW(read_all_published(data.path), InputError);
}

BOOST_AUTO_TEST_CASE(the_data_directory_is_the_one_asked_for) {
  const Data data(kHeader);
  BOOST_TEST(find_data_directory(data.path) == data.path);
  BOOST_CHECK_THROW(find_data_directory("/nonexistent"), InputError);
  ::setenv("FIBERCHAIN_DATA", data.path.c_str(), 1);
  BOOST_TEST(find_data_directory(std::nullopt) == data.path);
  ::setenv("FIBERCHAIN_DATA", "/nonexistent", 1);
  BOOST_CHECK_THROW(find_data_directory(std::nullopt), InputError);
  ::unsetenv("FIBERCHAIN_DATA");
  BOOST_TEST(fs::equivalent(find_data_directory(std::nullopt), std::string(FIBERCHAIN_SOURCE_DIR) + "/data"));
}

BOOST_AUTO_TEST_SUITE_END()
