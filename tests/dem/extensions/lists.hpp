#pragma once

#include "dem/contact/laws/laws.hpp"
#include "dem/model/shapes/shapes.hpp"
#include "tests/dem/extensions/linear_contact.hpp"
#include "tests/dem/extensions/sphere_wall.hpp"

// The lists of laws.hpp and shapes.hpp with a further law, and with a further shape. Loops of their own are
// compiled for them (kernels.cpp), so that the library stays as it is.
namespace extensions {

using MoreLaws = TypeList<LinearContact>;
using MoreShapes = ShapeList<BasicSphereWall>;

}  // namespace extensions
