#include "dem/record/output.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <fstream>
#include <iterator>

#include "compare/study/errors.hpp"
#include "tests/dem/trajectory/files.hpp"

BOOST_AUTO_TEST_SUITE(output_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::dem;
namespace fs = std::filesystem;

namespace {

using fiberchain::test::content;
using fiberchain::test::Scratch;
using fiberchain::test::SizeLimit;

std::size_t entries(const fs::path& path) { return fiberchain::test::files_in(path); }

}  // namespace

BOOST_AUTO_TEST_CASE(files_appear_whole_and_nothing_else) {
  const Scratch scratch;
  const dem::OutputDirectory directory(scratch.path / "a" / "b");
  const std::string bytes("x\0y\n", 4);
  directory.write({{"one.csv", bytes}, {"two.csv", ""}});
  BOOST_TEST(content(scratch.path / "a/b/one.csv") == bytes);
  BOOST_TEST(fs::exists(scratch.path / "a/b/two.csv"));
  BOOST_TEST(entries(scratch.path / "a/b") == 2);
}

BOOST_AUTO_TEST_CASE(new_results_take_the_place_of_old_ones) {
  const Scratch scratch;
  const dem::OutputDirectory directory(scratch.path);
  directory.write({{"one.csv", "a longer old text"}});
  directory.write({{"one.csv", "new"}});
  BOOST_TEST(content(scratch.path / "one.csv") == "new");
}

BOOST_AUTO_TEST_CASE(files_are_as_readable_as_any_other) {
  const Scratch scratch;
  const mode_t before = ::umask(027);
  dem::OutputDirectory(scratch.path).write({{"one.csv", "x"}});
  ::umask(before);
  struct stat status {};
  BOOST_REQUIRE(::stat((scratch.path / "one.csv").c_str(), &status) == 0);
  BOOST_TEST((status.st_mode & 0777) == 0640);
}

// With a limit of 1000 bytes the second file fails: the first, already written, must not replace the old one.
BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_old_results_as_they_were) {
  const Scratch scratch;
  const dem::OutputDirectory directory(scratch.path);
  directory.write({{"one.csv", "old one"}, {"two.csv", "old two"}});
  {
    const SizeLimit limit(1000);
    BOOST_CHECK_EXCEPTION(directory.write({{"one.csv", "new one"}, {"two.csv", std::string(5000, 'x')}}),
                          dem::OutputError, [](const dem::OutputError& error) {
                            return std::string(error.what()).find("two.csv: File too large") !=
                                   std::string::npos;
                          });
  }
  BOOST_TEST(content(scratch.path / "one.csv") == "old one");
  BOOST_TEST(content(scratch.path / "two.csv") == "old two");
  BOOST_TEST(entries(scratch.path) == 2);
}

BOOST_AUTO_TEST_CASE(a_place_that_cannot_be_written_is_refused_at_once) {
  const Scratch scratch;
  std::ofstream(scratch.path / "file") << "x";
  BOOST_CHECK_THROW(dem::OutputDirectory(scratch.path / "file"), dem::OutputError);
  BOOST_CHECK_THROW(dem::OutputDirectory(scratch.path / "file" / "below"), dem::OutputError);
  BOOST_CHECK_THROW(dem::OutputDirectory("/proc/fiberchain"), dem::OutputError);
  BOOST_CHECK_THROW(dem::OutputDirectory(""), dem::OutputError);
  BOOST_TEST(content(scratch.path / "file") == "x");
}

BOOST_AUTO_TEST_CASE(a_directory_in_the_place_of_a_file_is_an_error) {
  const Scratch scratch;
  fs::create_directory(scratch.path / "one.csv");
  BOOST_CHECK_THROW(dem::OutputDirectory(scratch.path).write({{"one.csv", "x"}}), dem::OutputError);
  BOOST_TEST(entries(scratch.path) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
