#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

#include "dem/scene/read_common.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/scene_text.hpp"
#include "dem/scene/wall_course_csv.hpp"

// How a wall of a scene moves.
namespace fiberchain::dem {
namespace {

constexpr std::size_t kLargestCourse = 64'000'000;  // [bytes]

bool is_all_zero(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return value == 0; });
}

/// Mapping "drive" as typed.
struct DriveKeys {
  WallDrive drive;
  std::optional<double> force, pressure;  ///< [N], [Pa]
  double area = 0;                        ///< [m^2]
};

KeyTable<DriveKeys> drive_keys() {
  KeyTable<DriveKeys> table;
  table
      .direction(
          "axis", [](DriveKeys & keys) -> auto& { return keys.drive.axis; },
          "direction of the force, along which the plate is free to move; in others it is held")
      .required();
  table
      .quantity(
          "mass", "kg", [](DriveKeys & keys) -> auto& { return keys.drive.mass; }, kPositive,
          "mass of the plate")
      .required();
  table.quantity("force", "N", &DriveKeys::force, kFinite,
                 "force on it, its weight included: gravity does not act on walls");
  table.quantity("pressure", "Pa", &DriveKeys::pressure, kFinite, "the same over `area`");
  table.one_of({"force", "pressure"});
  table.quantity("area", "m^2", &DriveKeys::area, kPositive, "that the pressure acts on")
      .otherwise("the cross section that periodic sides and walls before this one leave along the axis")
      .only_with("pressure", [](const DriveKeys& keys) { return keys.pressure.has_value(); });
  table.quantity(
      "damping", "N s/m", [](DriveKeys & keys) -> auto& { return keys.drive.damping; }, kNonNegative,
      "drag over its velocity, which brings it to rest");
  return table;
}

}  // namespace

KeyTable<RotationKeys> rotation_keys() {
  KeyTable<RotationKeys> table;
  table
      .vector(
          "point", "m", [](RotationKeys & keys) -> auto& { return keys.about.point; },
          "a point of the axis; it goes along with what else moves the wall")
      .required();
  table
      .direction(
          "axis", [](RotationKeys & keys) -> auto& { return keys.about.axis; }, "direction of the axis")
      .required();
  table
      .quantity("angular_velocity", "1/s", &RotationKeys::angular_velocity, kFinite,
                "constant, in radians a second (`30 rpm`), right-handed about the axis")
      .required();
  return table;
}

KeyTable<WallOscillation> oscillation_keys() {
  KeyTable<WallOscillation> table(WallOscillation{.phase = std::numbers::pi / 2});
  table.direction("axis", &WallOscillation::axis, "direction it goes to and fro").required();
  table.quantity("amplitude", "m", &WallOscillation::amplitude, kPositive, "amplitude A").required();
  table.quantity("frequency", "1/s", &WallOscillation::frequency, kPositive, "frequency f, in hertz")
      .required();
  table
      .quantity("phase", "rad", &WallOscillation::phase, kFinite,
                "phase φ of the shift A (sin(2π f t + φ) − sin φ): the wall is where it was put at time 0; "
                "with 90 degrees it starts at rest, with others at 2π f A cos φ unless there is a `ramp`")
      .otherwise("90 degrees");
  table
      .quantity("ramp", "s", &WallOscillation::ramp, kNonNegative,
                "time in which the amplitude comes up from 0, velocity continuous")
      .otherwise("0");
  return table;
}

KeyTable<CourseFileKeys> course_file_keys() {
  KeyTable<CourseFileKeys> table;
  table
      .word("file", &CourseFileKeys::file, "path",
            "CSV file beside the scene: `time` [s] and `place` [m], `angle` [rad] or both, times rising; "
            "between them smooth (velocity continuous, beyond no value), at rest before and after")
      .content_counts()
      .required();
  table.direction("direction", &CourseFileKeys::direction, "of places").otherwise("required with places");
  table.vector("point", "m", &CourseFileKeys::point, "a point of the axis that angles are about")
      .otherwise("required with angles");
  table.direction("axis", &CourseFileKeys::axis, "direction of that axis").otherwise("required with angles");
  return table;
}

void store_course(const StrictMapping& mapping, const CourseFileKeys& keys, Wall& wall) {
  const std::filesystem::path path = std::filesystem::path(mapping.file()).parent_path() / keys.file;
  try {
    std::istringstream text(read_scene_text(path, kLargestCourse).text);
    wall.motion.course = read_wall_course(text, path.string());
  } catch (const SceneError& error) {
    mapping.fail("file", error.what());
  }
  WallCourse& course = *wall.motion.course;
  course.axis = keys.direction;
  if (!is_all_zero(course.place.value) && norm(keys.direction) == 0) mapping.fail_missing("direction");
  if (is_all_zero(course.angle.value)) return;
  if (!keys.point) mapping.fail_missing("point");
  if (!keys.axis) mapping.fail_missing("axis");
  if (wall.motion.about) mapping.fail("axis", "is of use only without rotation: a wall turns about one axis");
  wall.motion.about = WallAxis{*keys.point, *keys.axis};
}

void complete_drive(const StrictMapping& mapping, Wall& wall, const PackingScene& scene) {
  if (!wall.motion.drive || mapping.mapping("drive").has("area")) return;
  const StrictMapping drive = mapping.mapping("drive");
  if (!drive.has("pressure")) return;
  const auto across = [&](int axis) {  // distance of what bounds the plate
    if (scene.domain.period[axis] > 0) return scene.domain.period[axis];
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for (const Wall& side : scene.domain.walls) {
      const auto* plane = side.shape.get_if<Plane>();
      if (plane == nullptr || !is_at_rest(side)) continue;
      if (plane->normal[axis] == 1) low = std::max(low, plane->point[axis]);
      if (plane->normal[axis] == -1) high = std::min(high, plane->point[axis]);
    }
    return high - low;
  };
  double area = 1;
  for (int a = 0; a < 3; ++a) {
    const double along = std::abs(wall.motion.drive->axis[a]);
    if (along > 1e-12 && along < 1 - 1e-12) area = 0;
    if (along < 0.5) area *= across(a);
  }
  if (!(area > 0 && std::isfinite(area)))
    drive.fail(
        "pressure",
        "needs area: neither periodic sides nor walls before this one bound the plate along x, y or z");
  wall.motion.drive->force = drive.quantity("pressure", "Pa", in_unit(kFinite, "Pa")) * area;
}

template <class T>
void declare_wall_motion(KeyTable<T>& table) {
  declare_rigid_motion(table,
                       "constant velocity; `point` is of time 0. A plate that stops is one wall `until` a "
                       "time, and one at rest `from` then",
                       "the wall is there from this time on", "and gone from this time on");
  table
      .mapping(
          "drive", drive_keys(),
          [](const StrictMapping&, const DriveKeys& keys, Wall& wall) {
            wall.motion.drive = keys.drive;
            wall.motion.drive->force = keys.pressure ? *keys.pressure * keys.area : *keys.force;
          },
          "a force or a pressure moves it as a plate of given mass")
      .otherwise("none");
  declare_wall_surface(
      table, [](T & wall) -> auto& { return wall; });
}

template void declare_wall_motion(KeyTable<Wall>& table);
template void declare_wall_motion(KeyTable<MeshWallKeys>& table);

}  // namespace fiberchain::dem
