#pragma once

#include <any>
#include <concepts>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "dem/model/shapes/nearest_point.hpp"

// A wall's shape is a template on the number type (plane.hpp): with doubles it is a value of a Domain, with
// SIMD packs it stands in the contact loop, compiled once for each shape of a list (shapes.hpp).
namespace fiberchain::dem {

/// Numbers a shape may consist of.
inline constexpr int wall_shape_size = 12;

/// Numbers only, of which `point` [m] moves with the wall; nearest() takes points relative to it. Its gap is
/// a distance: from one point to another it changes by no more than the way between them.
template <class Shape>
concept WallGeometry = std::is_trivially_copyable_v<Shape> &&
                           sizeof(Shape) <= wall_shape_size * sizeof(double) &&
                       requires(const Shape& shape, const Vec<double, 3>& from, int axis) {
  { shape.nearest(from) } -> std::same_as<NearestPoint<double>>;
  { shape.is_invariant_along(axis) } -> std::same_as<bool>;
  { shape.point[axis] } -> std::convertible_to<double>;
  { Shape::name } -> std::convertible_to<std::string_view>;
};

/// The functions of a shape, on a std::any that holds it.
struct WallShapeType {
  std::string_view name;
  /// Of `point` [m] where the shape has moved by `offset` [m].
  NearestPoint<double> (*nearest)(const std::any& shape, const Vec<double, 3>& point,
                                  const Vec<double, 3>& offset);
  bool (*is_invariant_along)(const std::any& shape, int axis);
  /// Writes the numbers of the shape where it has moved by `offset` [m].
  void (*numbers)(const std::any& shape, const Vec<double, 3>& offset, double* numbers);
};

template <WallGeometry Shape>
inline constexpr WallShapeType wall_shape_type{
    .name = Shape::name,
    .nearest =
        [](const std::any& shape, const Vec<double, 3>& point, const Vec<double, 3>& offset) {
          const Shape& s = *std::any_cast<Shape>(&shape);
          return s.nearest(point - s.point - offset);
        },
    .is_invariant_along = [](const std::any& shape,
                             int axis) { return std::any_cast<Shape>(&shape)->is_invariant_along(axis); },
    .numbers =
        [](const std::any& shape, const Vec<double, 3>& offset, double* numbers) {
          Shape moved = *std::any_cast<Shape>(&shape);
          moved.point = moved.point + offset;
          std::memcpy(numbers, &moved, sizeof moved);
        }};

/// A shape of any kind, by value.
class WallShape {
 public:
  template <WallGeometry Shape>
  WallShape(const Shape& shape) : type_(&wall_shape_type<Shape>), shape_(shape) {}

  const WallShapeType& type() const { return *type_; }
  /// The shape itself; null where it is of another kind.
  template <WallGeometry Shape>
  Shape* get_if() {
    return std::any_cast<Shape>(&shape_);
  }
  template <WallGeometry Shape>
  const Shape* get_if() const {
    return std::any_cast<Shape>(&shape_);
  }

  NearestPoint<double> nearest(const Vec<double, 3>& point, const Vec<double, 3>& offset) const {
    return type_->nearest(shape_, point, offset);
  }
  bool is_invariant_along(int axis) const { return type_->is_invariant_along(shape_, axis); }
  void numbers(const Vec<double, 3>& offset, double* numbers) const {
    type_->numbers(shape_, offset, numbers);
  }

 private:
  const WallShapeType* type_;
  std::any shape_;
};

}  // namespace fiberchain::dem
