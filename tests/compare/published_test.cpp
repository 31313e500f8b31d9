#define BOOST_TEST_MODULE published
#include "compare/study/published.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "compare/study/errors.hpp"

using namespace fiberchain::compare;
namespace fs = std::filesystem;

namespace {

constexpr const char* kHeader = "id,feature,quantity,value,unit,source,page_or_figure,statement\n";

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

BOOST_AUTO_TEST_CASE(values_are_read_with_all_they_say) {
  const Data data(std::string(kHeader) +
                  "x,f,q,0.25,1,\"S, 2015\",Fig 4,says so\ny,f,q,nan,1,S,p. 1,a statement\n");
  const auto values = read_all_published(data.path);
  BOOST_TEST(values.size() == 2);
  BOOST_TEST(values[0].source == "S, 2015");
  BOOST_TEST(find_published(values, "x").value == 0.25);
  BOOST_TEST(std::isnan(find_published(values, "y").value));
  BOOST_CHECK_THROW(find_published(values, "z"), InputError);
}

BOOST_AUTO_TEST_CASE(faults_are_named_by_file_line_and_column) {
  BOOST_TEST(error_of(std::string(kHeader) + "x,f,q,a,1,S,p,s\n") ==
             "a.csv:2: column value: 'a' is no number");
  BOOST_TEST(error_of(std::string(kHeader) + "x,f,q,1,1,S,p,s\nx,f,q,1,1,S,p,s\n") ==
             "a.csv:3: column id: 'x' comes twice");
  BOOST_TEST(error_of(std::string(kHeader) + ",f,q,1,1,S,p,s\n") == "a.csv:2: column id is empty");
  BOOST_TEST(error_of("id,feature\nx,f\n") == "a.csv: column quantity is missing");
}

BOOST_AUTO_TEST_CASE(an_id_in_two_files_is_refused) {
  const Data data(std::string(kHeader) + "x,f,q,1,1,S,p,s\n");
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

BOOST_AUTO_TEST_CASE(the_published_values_of_the_project_are_whole) {
  const auto values = read_all_published(std::string(FIBERCHAIN_SOURCE_DIR) + "/data");
  BOOST_TEST(!values.empty());
  for (const PublishedValue& value : values) {
    BOOST_TEST_CONTEXT(value.id) {
      BOOST_TEST(!value.feature.empty());
      BOOST_TEST(!value.quantity.empty());
      BOOST_TEST(!value.unit.empty());
      BOOST_TEST(!value.source.empty());
      BOOST_TEST(!value.page_or_figure.empty());
      BOOST_TEST(!value.statement.empty());
    }
  }
}
