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

/// Mapping "rotation" as typed.
struct RotationKeys {
  WallAxis about;
  double angular_velocity = 0;  ///< [1/s]
};

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

/// Mapping "course" as typed.
struct CourseFileKeys {
  std::string file;
  Vec<double, 3> direction{};
  std::optional<Vec<double, 3>> point, axis;
};

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

bool is_all_zero(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return value == 0; });
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
      .required()
      .only_with("pressure", [](const DriveKeys& keys) { return keys.pressure.has_value(); });
  table.quantity(
      "damping", "N s/m", [](DriveKeys & keys) -> auto& { return keys.drive.damping; }, kNonNegative,
      "drag over its velocity, which brings it to rest");
  return table;
}

}  // namespace

void declare_wall_motion(KeyTable<Wall>& table) {
  table.vector("velocity", "m/s", &Wall::velocity,
               "constant velocity; `point` is of time 0. A plate that stops is one wall `until` a time, and "
               "one at rest `from` then");
  table.quantity("from", "s", &Wall::active_from, kFinite, "the wall is there from this time on");
  table.quantity("until", "s", &Wall::active_until, kFinite, "and gone from this time on")
      .otherwise("always there");
  table
      .mapping(
          "rotation", rotation_keys(),
          [](const StrictMapping&, const RotationKeys& keys, Wall& wall) {
            wall.motion.about = keys.about;
            wall.motion.angular_velocity = keys.angular_velocity;
          },
          "it turns about an axis, beside what else it does")
      .otherwise("none");
  table
      .mapping(
          "oscillation", oscillation_keys(),
          [](const StrictMapping&, const WallOscillation& keys, Wall& wall) {
            wall.motion.oscillation = keys;
          },
          "it goes to and fro")
      .otherwise("none");
  table.mapping("course", course_file_keys(), &store_course, "it goes as a table says").otherwise("none");
  table
      .mapping(
          "drive", drive_keys(),
          [](const StrictMapping&, const DriveKeys& keys, Wall& wall) {
            wall.motion.drive = keys.drive;
            wall.motion.drive->force = keys.pressure ? *keys.pressure * keys.area : *keys.force;
          },
          "a force or a pressure moves it as a plate of given mass")
      .otherwise("none");
}

}  // namespace fiberchain::dem
