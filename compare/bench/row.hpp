#pragma once

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "compare/bench/timing.hpp"
#include "compare/study/nan.hpp"
#include "dem/motion/integrator.hpp"

// Run time against error: what the bench measures, as values.
namespace fiberchain::compare {

/// One method at one setting on one problem. A method that fails keeps its row with the reason, its error
/// NaN.
struct PrecisionRow {
  std::string method;
  std::string setting;    ///< what sets its accuracy, e.g. "dt = 0.2 t_b"
  int aspect_ratio = 0;   ///< r_f
  int lanes = 1;          ///< equal chains side by side; the time is that of one
  bool in_time = true;    ///< follows the motion in time; false: finds the answer without
  bool as_paper = false;  ///< the paper's own way
  double error = nan;
  Timing time{nan, nan, 0};
  dem::Work work{};
  std::string status{};  ///< "measured", else why not
};

/// A question with a known answer, and the rows of all that were asked.
struct PrecisionProblem {
  std::string id;           ///< "damping-10"; part of file names
  std::string title;        ///< in gnuplot's enhanced notation
  std::string error_label;  ///< what the error is, likewise
  std::string short_title;  ///< in Markdown
  std::string reference;    ///< what the error is measured against; none of the ranked methods
  double reference_error;   ///< its own, estimated as `reference` says
  std::vector<PrecisionRow> rows;
  double periods = 0;  ///< of the first mode that a run covers; 0 where there are none
};

inline constexpr const char* measured_status = "measured";

/// What a run found: its error and its work.
struct Judged {
  double error;
  dem::Work work;
};

/// Runs `run`, judges what it returned, then times it warm. What either throws becomes the status of the row.
template <class Run, class Judge>
PrecisionRow measured_row(PrecisionRow asked, const TimingBudget& budget, const Run& run,
                          const Judge& judge) {
  try {
    std::optional<decltype(run())> result;
    const double first = time_once([&] { result = run(); });
    const Judged found = judge(*result);
    asked.time = first > budget.long_run ? Timing{first, first, 1}
                                         : time_warm([&] { static_cast<void>(run()); }, budget);
    asked.error = found.error;
    asked.work = found.work;
    asked.status = measured_status;
  } catch (const std::exception& why) {
    asked.status = why.what();
  }
  return asked;
}

/// Which methods a choice is made among.
enum class Among {
  all,      ///< every method
  in_time,  ///< those that follow the motion in time
  as_paper  ///< the paper's way alone
};

/// The row with the least run time that keeps `wanted`; nullptr if there is none. Rows of a method stand from
/// coarse to fine, and a row keeps an error only if the finer ones of its method do too: an error that passes
/// zero is no merit.
const PrecisionRow* cheapest(const std::vector<PrecisionRow>& rows, double wanted, Among among);

}  // namespace fiberchain::compare
