#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "dem/mesh/mesh_shape.hpp"
#include "dem/mesh/mesh_topology.hpp"
#include "dem/mesh/read_mesh.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/scene/read_common.hpp"

// Walls of triangles.
namespace fiberchain::dem {
namespace {

constexpr ValueRange kScale{.low = 1e-12, .high = 1e6};

struct TurnKeys {
  Vec<double, 3> axis{};
  double angle = 0;  ///< [rad]
};

KeyTable<TurnKeys> turn_keys() {
  KeyTable<TurnKeys> table;
  table.direction("axis", &TurnKeys::axis, "direction of an axis through the file's origin").required();
  table.quantity("angle", "rad", &TurnKeys::angle, kFinite, "right-handed about it").required();
  return table;
}

/// A mesh that fibers touch from one side has one.
void check_orientation(const StrictMapping& mapping, const TriangleMesh& mesh) {
  const auto turned = topology_of(mesh).turned;
  if (!turned) return;
  mapping.fail("sides", fmt::format("one is not allowed: triangles {} and {} of {} share an edge and look to "
                                    "opposite sides; allowed: both, or a file whose normals all point to the "
                                    "side of the fibers",
                                    (*turned)[0] + 1, (*turned)[1] + 1, mesh.name));
}

}  // namespace

KeyTable<MeshWallKeys> mesh_wall_keys() {
  KeyTable<MeshWallKeys> table(MeshWallKeys{{MeshShape{}}, {}, 1, {}, 0});
  const auto shape = [](MeshWallKeys & keys) -> auto& { return *keys.shape.get_if<MeshShape>(); };
  table
      .word("file", &MeshWallKeys::file, "path",
            "STL (binary or ASCII) or OBJ file beside the scene: triangles, normals to the outside")
      .content_counts()
      .required();
  table
      .quantity("scale", "m", &MeshWallKeys::scale, kScale,
                "length of the file's unit (`1 mm`); what is typed without a unit is in meters")
      .otherwise("1 m");
  table.choice(
      "sides", [=](MeshWallKeys & keys) -> auto& { return shape(keys).sides; },
      Words<MeshSides>{{"both", MeshSides::both}, {"one", MeshSides::one}},
      "from which sides fibers touch it: `both`, a thin sheet; `one`, from where its normals point, a closed "
      "one is solid");
  table.vector(
      "place", "m", [=](MeshWallKeys & keys) -> auto& { return shape(keys).point; },
      "where the file's origin is at time 0");
  table
      .mapping(
          "turn", turn_keys(),
          [](const StrictMapping&, const TurnKeys& turn, MeshWallKeys& keys) {
            keys.axis = turn.axis, keys.angle = turn.angle;
          },
          "by which the file's axes are turned at time 0")
      .otherwise("none");
  declare_wall_motion(table);
  return table;
}

Wall mesh_wall(const StrictMapping& mapping, const MeshWallKeys& keys) {
  const std::filesystem::path path =
      (std::filesystem::path(mapping.file()).parent_path() / keys.file).lexically_normal();
  Wall wall = keys;
  MeshShape& shape = *wall.shape.get_if<MeshShape>();
  try {
    shape.mesh =
        std::make_shared<const TriangleMesh>(make_mesh(read_mesh_file(path), keys.scale, path.string()));
  } catch (const InvalidKey& error) {
    mapping.fail(error.key, error.what());
  } catch (const InvalidInput& error) {
    mapping.fail("file", error.what());
  }
  if (shape.sides == MeshSides::one) check_orientation(mapping, *shape.mesh);
  if (keys.angle != 0) shape.turn(rotation(keys.angle * keys.axis));
  return wall;
}

}  // namespace fiberchain::dem
