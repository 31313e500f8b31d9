#pragma once

#include <cstdint>
#include <vector>

#include "compare/app/command.hpp"
#include "dem/trajectory/h5md.hpp"

/// What commands on trajectories share.
namespace fiberchain::app {

/// The trajectory FILE.
/// @throws compare::InputError where it is none
dem::TrajectoryReader open_trajectory(const Arguments& arguments);

/// Numbers of the frames that an option asks for: "all", "last", one, or FROM..TO; all where it was not
/// typed.
/// @throws compare::InputError if the trajectory has no such frames, or none
std::vector<std::int64_t> frames_of(const Arguments& arguments, const std::string& option,
                                    const dem::TrajectoryReader& trajectory);

}  // namespace fiberchain::app
