#pragma once

#include <istream>
#include <string>

#include "dem/model/wall_motion.hpp"

namespace fiberchain::dem {

/// Places and angles of a wall from a CSV text with the columns `time` [s] and `place` [m], `angle` [rad] or
/// both, at least two lines, times that rise. What has no column is 0.
/// @throws SceneError "NAME:LINE: what is wrong"
WallCourse read_wall_course(std::istream& text, const std::string& name);

}  // namespace fiberchain::dem
