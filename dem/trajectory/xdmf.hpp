#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fiberchain::dem {

/// XDMF 2 that describes the frames of a trajectory (dem/trajectory/h5md.hpp) to ParaView: spheres with
/// radius, fiber, velocity.
/// @param file name of the trajectory beside which it will stand
/// @param times of the frames [s]
std::string xdmf(const std::string& file, const std::vector<double>& times, std::size_t spheres);

}  // namespace fiberchain::dem
