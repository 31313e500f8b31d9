#pragma once

#include <any>
#include <concepts>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

// A wall's shape is a template on the number type (plane.hpp): with doubles it is a value of a Domain, with
// SIMD packs it stands in the contact loop, compiled once for each shape of a list (shapes.hpp). A mesh
// (dem/mesh) is no template: the loop is given its nearest points.
namespace fiberchain::dem {

/// Numbers a shape may consist of.
inline constexpr int wall_shape_size = 12;

/// Numbers only, as the loop takes a shape.
template <class Shape>
concept NumberShape = std::is_trivially_copyable_v<Shape> &&
                      sizeof(Shape) <= wall_shape_size * sizeof(double);

/// Its `point` [m] moves with the wall; nearest() takes points relative to it, turn() turns the shape about
/// it, is_round_about() says whether it looks the same turned about a line. Its gap is a distance: from one
/// point to another it changes by no more than the way between them.
template <class Shape>
concept WallGeometry = requires(const Shape& shape, const Vec<double, 3>& from, int axis, Shape& turning,
                                const Quaternion<double>& by) {
  { shape.nearest(from) } -> std::same_as<NearestPoint<double>>;
  { shape.is_invariant_along(axis) } -> std::same_as<bool>;
  { shape.is_round_about(from, from) } -> std::same_as<bool>;
  turning.turn(by);
  { shape.point[axis] } -> std::convertible_to<double>;
  { Shape::name } -> std::convertible_to<std::string_view>;
};

/// The functions of a shape, on a std::any that holds it.
struct WallShapeType {
  std::string_view name;
  NearestPoint<double> (*nearest)(const std::any& shape, const Vec<double, 3>& place);
  bool (*is_invariant_along)(const std::any& shape, int axis);
  bool (*is_round_about)(const std::any& shape, const Vec<double, 3>& place, const Vec<double, 3>& line);
  Vec<double, 3> (*point)(const std::any& shape);
  std::any (*moved)(const std::any& shape, const WallPose& pose);
  /// Writes the numbers of the shape where its wall stands; none of a shape that is more than numbers.
  void (*numbers)(const std::any& shape, const WallPose& pose, double* numbers);
};

template <WallGeometry Shape>
const Shape& shape_in(const std::any& shape) {
  return *std::any_cast<Shape>(&shape);
}

template <WallGeometry Shape>
inline constexpr WallShapeType wall_shape_type{
    .name = Shape::name,
    .nearest =
        [](const std::any& shape, const Vec<double, 3>& place) {
          const Shape& s = shape_in<Shape>(shape);
          return s.nearest(place - s.point);
        },
    .is_invariant_along = [](const std::any& shape,
                             int axis) { return shape_in<Shape>(shape).is_invariant_along(axis); },
    .is_round_about =
        [](const std::any& shape, const Vec<double, 3>& place, const Vec<double, 3>& line) {
          return shape_in<Shape>(shape).is_round_about(place, line);
        },
    .point = [](const std::any& shape) { return shape_in<Shape>(shape).point; },
    .moved = [](const std::any& shape,
                const WallPose& pose) { return std::any(dem::moved(shape_in<Shape>(shape), pose)); },
    .numbers =
        [](const std::any& shape, const WallPose& pose, double* numbers) {
          if constexpr (NumberShape<Shape>) {
            const Shape at = dem::moved(shape_in<Shape>(shape), pose);
            std::memcpy(numbers, &at, sizeof at);
          }
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

  NearestPoint<double> nearest(const Vec<double, 3>& place) const { return type_->nearest(shape_, place); }
  bool is_invariant_along(int axis) const { return type_->is_invariant_along(shape_, axis); }
  /// Whether it looks the same turned by any angle about the line through `place` along the unit vector.
  bool is_round_about(const Vec<double, 3>& place, const Vec<double, 3>& line) const {
    return type_->is_round_about(shape_, place, line);
  }
  Vec<double, 3> point() const { return type_->point(shape_); }  ///< at t = 0 [m]
  /// The shape where its wall stands.
  WallShape moved(const WallPose& pose) const { return {type_, type_->moved(shape_, pose)}; }
  void numbers(const WallPose& pose, double* numbers) const { type_->numbers(shape_, pose, numbers); }

 private:
  WallShape(const WallShapeType* type, std::any shape) : type_(type), shape_(std::move(shape)) {}

  const WallShapeType* type_;
  std::any shape_;
};

}  // namespace fiberchain::dem
