#include "dem/record/progress.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(progress_test)

namespace dem = fiberchain::dem;
using fiberchain::dem::Progress;

namespace {

std::size_t stars(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '*')); }

}  // namespace

BOOST_AUTO_TEST_CASE(threads_share_a_bar_that_ends_full) {
  std::ostringstream stream;
  {
    dem::Progress progress(stream, 2000);
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        for (int k = 0; k < 500; ++k) progress.advance();
      });
    }
  }
  BOOST_TEST(stars(stream.str()) == 51);
  BOOST_TEST(stream.str().ends_with("*\n"));
}

BOOST_AUTO_TEST_CASE(work_that_ends_early_ends_its_line) {
  std::ostringstream stream;
  {
    dem::Progress progress(stream, 100);
    for (int k = 0; k < 50; ++k) progress.advance();
  }
  BOOST_TEST(stars(stream.str()) > 20);
  BOOST_TEST(stars(stream.str()) < 30);
  BOOST_TEST(stream.str().ends_with("*\n"));
}

BOOST_AUTO_TEST_SUITE_END()
