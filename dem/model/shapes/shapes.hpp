#pragma once

#include "dem/model/shapes/box.hpp"
#include "dem/model/shapes/cone.hpp"
#include "dem/model/shapes/cylinder.hpp"
#include "dem/model/shapes/plane.hpp"
#include "dem/model/shapes/sphere.hpp"

// The wall shapes that the contact loops are compiled for: a further one is a header and a line here.
namespace fiberchain::dem {

/// Shapes as templates on the number type.
template <template <class> class... Shapes>
struct ShapeList {
  static constexpr int size = sizeof...(Shapes);
};

using WallShapes = ShapeList<BasicPlane, BasicCylinder, BasicSphere, BasicBoxObstacle, BasicCone>;

}  // namespace fiberchain::dem
