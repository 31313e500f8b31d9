#include "compare/bench/tables.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace fiberchain::compare {
namespace {

std::string duration(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.2g} µs", 1e6 * seconds);
  if (seconds < 1) return fmt::format("{:.2g} ms", 1e3 * seconds);
  return fmt::format("{:.2g} s", seconds);
}

/// "1.2e+02" of the %g form written out: three digits are more than a time on another machine is worth.
std::string plain(double seconds) {
  const std::string text = duration(seconds);
  const auto exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const auto space = text.find(' ');
  return fmt::format("{:.0f}{}", std::stod(text.substr(0, space)), text.substr(space));
}

std::string cell_of(const PrecisionRow* row) {
  return row ? fmt::format("{}, {}: {}", row->method, row->setting, plain(row->time.least)) : "–";
}

struct Choice {
  const char* name;
  Among among;
};
constexpr Choice choices[] = {{"all methods", Among::all}, {"in time", Among::in_time}};

/// Whether any of a problem's rows stands still: else both choices are one.
bool has_both(const PrecisionProblem& problem) {
  return std::ranges::any_of(problem.rows, [](const PrecisionRow& row) { return !row.in_time; });
}

}  // namespace

dem::Table precision_table(const std::vector<PrecisionProblem>& problems) {
  dem::Table table({"problem", "method", "setting", "aspect_ratio", "lanes", "error", "reference_error",
                    "run_time", "run_time_median", "runs", "steps", "bond_evaluations", "linear_solves",
                    "factorizations", "status"});
  for (const PrecisionProblem& problem : problems) {
    for (const PrecisionRow& row : problem.rows) {
      const bool measured = row.status == measured_status;
      const auto work = [&](double n) {
        return measured ? dem::Cell{static_cast<std::int64_t>(std::llround(n))} : dem::Cell{};
      };
      table.append({{"problem", problem.id},
                    {"method", row.method},
                    {"setting", row.setting},
                    {"aspect_ratio", std::int64_t{row.aspect_ratio}},
                    {"lanes", std::int64_t{row.lanes}},
                    {"error", row.error},
                    {"reference_error", problem.reference_error},
                    {"run_time", row.time.least},
                    {"run_time_median", row.time.median},
                    {"runs", std::int64_t{row.time.runs}},
                    {"steps", work(row.work.steps)},
                    {"bond_evaluations", work(row.work.bond_evaluations)},
                    {"linear_solves", work(row.work.linear_solves)},
                    {"factorizations", work(row.work.factorizations)},
                    {"status", row.status}});
    }
  }
  return table;
}

dem::Table wanted_table(const std::vector<PrecisionProblem>& problems) {
  dem::Table table({"problem", "wanted_error", "among", "method", "setting", "error", "run_time",
                    "run_time_paper", "speedup"});
  for (const PrecisionProblem& problem : problems) {
    for (const auto& [wanted, label] : wanted_errors) {
      for (const Choice& choice : choices) {
        if (choice.among == Among::in_time && !has_both(problem)) continue;
        const PrecisionRow* best = cheapest(problem.rows, wanted, choice.among);
        const PrecisionRow* paper = cheapest(problem.rows, wanted, Among::as_paper);
        dem::NamedRow row{
            {"problem", problem.id}, {"wanted_error", wanted}, {"among", std::string(choice.name)}};
        if (best) {
          row.insert(row.end(), {{"method", best->method},
                                 {"setting", best->setting},
                                 {"error", best->error},
                                 {"run_time", best->time.least}});
        }
        if (paper) row.push_back({"run_time_paper", paper->time.least});
        if (best && paper) row.push_back({"speedup", paper->time.least / best->time.least});
        table.append(row);
      }
    }
  }
  return table;
}

std::string wanted_markdown(const std::vector<PrecisionProblem>& problems) {
  std::string text = "| error wanted |", rule = "|---|";
  for (const WantedError& wanted : wanted_errors) text += fmt::format(" {} |", wanted.text), rule += "---|";
  text += "\n" + rule + "\n";
  for (const PrecisionProblem& problem : problems) {
    for (const Choice& choice : choices) {
      if (choice.among == Among::in_time && !has_both(problem)) continue;
      text += "| " + problem.short_title + (choice.among == Among::in_time ? ", marched" : "") + " |";
      for (const auto& [wanted, label] : wanted_errors)
        text += " " + cell_of(cheapest(problem.rows, wanted, choice.among)) + " |";
      text += "\n";
    }
  }
  return text;
}

std::string precision_notes(const std::vector<PrecisionProblem>& problems) {
  std::string text;
  for (const PrecisionProblem& problem : problems) {
    text += fmt::format("- {}: errors against {}, {:.1e}.\n", problem.id, problem.reference,
                        problem.reference_error);
    for (const PrecisionRow& row : problem.rows) {
      if (row.status != measured_status)
        text += fmt::format("  - {}, {}: {}\n", row.method, row.setting, row.status);
    }
  }
  return text;
}

}  // namespace fiberchain::compare
