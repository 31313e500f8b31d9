#pragma once

#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "tests/program/process.hpp"

namespace fiberchain::test {

/// `validate` with these options ends well, no row fails, and every verdict occurs.
inline void matrix_holds(std::vector<std::string> options) {
  const Scratch scratch;
  options.insert(options.begin(), "validate");
  const Outcome outcome = run(options, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 0, outcome.out);
  BOOST_TEST(outcome.error.find(" 0 fail\n") != std::string::npos, outcome.error);
  const std::string rows = content(scratch.path / "results/validation.csv");
  for (const char* verdict : {",holds,", ",holds only if,", ",disputed,"}) {
    BOOST_TEST(rows.find(verdict) != std::string::npos, verdict);
  }
}

}  // namespace fiberchain::test
