#include "compare/app/open_trajectory.hpp"

#include <fmt/format.h>

#include <numeric>

#include "compare/app/options.hpp"
#include "compare/study/errors.hpp"
#include "dem/files/file_error.hpp"
#include "dem/files/numbers.hpp"

namespace fiberchain::app {
namespace {

std::vector<std::int64_t> from_to(std::int64_t from, std::int64_t to) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(to - from + 1));
  std::iota(all.begin(), all.end(), from);
  return all;
}

}  // namespace

dem::TrajectoryReader open_trajectory(const Arguments& arguments) {
  try {
    return dem::TrajectoryReader(arguments.text("FILE"));
  } catch (const dem::ReadError& error) {
    throw compare::InputError(error.what());
  }
}

std::vector<std::int64_t> frames_of(const Arguments& arguments, const std::string& option,
                                    const dem::TrajectoryReader& trajectory) {
  const std::int64_t last = trajectory.frames() - 1;
  if (last < 0) throw compare::InputError(arguments.text("FILE") + ": holds no frame yet");
  const std::string asked = arguments.text(option);
  if (!arguments.has(option) || asked == "all") return from_to(0, last);
  if (asked == "last") return {last};
  if (const std::size_t dots = asked.find(".."); dots != std::string::npos) {
    const auto from = dem::parse_integer(asked.substr(0, dots)),
               to = dem::parse_integer(asked.substr(dots + 2));
    if (from && to && 0 <= *from && *from <= *to && *to <= last) return from_to(*from, *to);
    throw compare::InputError(fmt::format(
        "{}: '{}' is not allowed: all, last, a number or FROM..TO within 0..{}", option, asked, last));
  }
  int frame = 0;
  read_number(arguments, option, {.low = 0, .high = static_cast<double>(last)}, frame);
  return {frame};
}

}  // namespace fiberchain::app
