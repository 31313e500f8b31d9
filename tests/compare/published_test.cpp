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
    "id,feature,reference_kind,quantity,value,tolerance,tolerance_scale,basis,claim,reading,condition,"
    "otherwise_expected,otherwise_tolerance,unit,source,page_or_figure,statement,evidence\n";

/// A row of these, the rest of which is well formed.
struct Row {
  std::string id, value = "1", kind = "published", tolerance = "0.5", basis = "theory", claim = "0.5..1.5",
                  reading = "as printed", condition = "-", otherwise = "nan,nan";
};
std::string text(const Row& r) {
  return r.id + ",f," + r.kind + ",q," + r.value + "," + r.tolerance + ",unit," + r.basis + "," + r.claim +
         "," + r.reading + "," + r.condition + "," + r.otherwise + ",1,\"S, 2015\",Fig 4,says so,seen\n";
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
  const Data data(
      kHeader + text({.id = "x", .value = "0.25", .condition = "by night", .otherwise = "2,0.125"}) +
      text({.id = "y", .value = "nan", .kind = "exact", .basis = "-", .claim = "-", .reading = "-"}));
  const auto claims = read_all_published(data.path);
  BOOST_TEST(claims.size() == 2);
  BOOST_TEST(claims[0].source == "S, 2015");
  BOOST_TEST(claims[0].subject == "a");
  BOOST_TEST(claims[0].tolerance == 0.5);
  BOOST_TEST(claims[0].range->text() == "0.5..1.5");
  BOOST_TEST(claims[0].condition == "by night");
  BOOST_TEST(claims[0].otherwise->value == 2);
  BOOST_TEST(claims[0].otherwise->tolerance == 0.125);
  BOOST_TEST(!claims[1].range.has_value());
  BOOST_TEST(!claims[1].otherwise.has_value());
  BOOST_TEST(find_claim(claims, "x").value == 0.25);
  BOOST_TEST(std::isnan(find_claim(claims, "y").value));
  BOOST_CHECK_THROW(find_claim(claims, "z"), InputError);
}

BOOST_AUTO_TEST_CASE(faults_are_named_by_file_line_and_column) {
  const auto error = [](const Row& row) { return error_of(kHeader + text(row)); };
  BOOST_TEST(error({.id = "x", .value = "a"}) == "a.csv:2: column value: 'a' is no number");
  BOOST_TEST(error_of(kHeader + text({.id = "x"}) + text({.id = "x"})) ==
             "a.csv:3: column id: 'x' comes twice");
  BOOST_TEST(error({.id = ""}) == "a.csv:2: column id is empty");
  BOOST_TEST(error({.id = "x", .kind = "guessed"}) ==
             "a.csv:2: column reference_kind: 'guessed' is none of its words");
  BOOST_TEST(error_of("id,feature\nx,f\n") == "a.csv: column reference_kind is missing");
}

// A row that could say nothing, or the same whatever is measured, is none.
BOOST_AUTO_TEST_CASE(a_row_whose_verdict_does_not_follow_is_refused) {
  const auto error = [](const Row& row) { return error_of(kHeader + text(row)); };
  for (const char* tolerance : {"0", "-1", "nan", "inf"}) {
    BOOST_TEST(error({.id = "x", .tolerance = tolerance}) ==
               "a.csv:2: column tolerance must be above 0 and finite");
  }
  BOOST_TEST(error({.id = "x", .claim = "about 1"}) ==
             "a.csv:2: column claim: 'about 1' is no claim: give LOW..HIGH, < X, <= X, > X, >= X, not "
             "LOW..HIGH, or -");
  BOOST_TEST(error({.id = "x", .kind = "exact"}) == "a.csv:2: column claim is for published rows only");
  BOOST_TEST(error({.id = "x", .reading = "-"}) ==
             "a.csv:2: column reading must say how the words became the claim");
  BOOST_TEST(error({.id = "x", .basis = "-"}) ==
             "a.csv:2: column basis must say where the expected value is from");
  BOOST_TEST(error({.id = "x", .claim = "-", .condition = "by night"}) ==
             "a.csv:2: column condition is for rows with a claim only");
  BOOST_TEST(error({.id = "x", .otherwise = "2,0.1"}) ==
             "a.csv:2: column otherwise_expected needs a condition");
  BOOST_TEST(error({.id = "x", .condition = "by night", .otherwise = "nan,0.1"}) ==
             "a.csv:2: column otherwise_expected must be a number");
  BOOST_TEST(error({.id = "x", .condition = "by night", .otherwise = "2,0"}) ==
             "a.csv:2: column otherwise_tolerance must be above 0 and finite");
}

BOOST_AUTO_TEST_CASE(an_id_in_two_files_is_refused) {
  const Data data(kHeader + text({.id = "x"}));
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
