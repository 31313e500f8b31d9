#pragma once

#include <array>
#include <optional>
#include <string>

#include "dem/scene/key_table.hpp"
#include "dem/scene/material_ranges.hpp"
#include "dem/scene/read_failure.hpp"
#include "dem/scene/read_material_damping.hpp"
#include "dem/scene/scene.hpp"

// Keys that scenes of several kinds have in common. All readers throw SceneError.
namespace fiberchain::dem {

inline constexpr ValueRange kFraction{.low = 0, .high = 1, .low_open = true, .high_open = true};
inline constexpr ValueRange kCoefficient{.low = 0, .high = 1e6};  ///< of friction, damping, drag
inline constexpr ValueRange kStepRatio{.low = 1e-6, .high = 1e5};
inline constexpr const char* kAxes[] = {"x", "y", "z"};

/// Words for which axes are held: `xyz`, `xy`, ..., `none`.
const Words<std::array<bool, 3>>& axis_words();

/// A fiber as typed.
struct FiberKeys {
  double diameter = 0;  ///< [m]
  int aspect_ratio = 0;
  double spacing = Fiber{}.spacing;          ///< as typed; the fiber's makes whole bonds exactly
  std::string material;                      ///< whose values count where these are left out
  std::optional<double> youngs_modulus;      ///< [Pa]
  std::optional<double> poisson_ratio;       ///< this, or
  std::optional<double> shear_modulus;       ///< this [Pa], or both
  std::optional<double> transverse_modulus;  ///< [Pa]
  std::optional<double> density;             ///< [kg/m^3]
  std::optional<MaterialDampingKeys> material_damping = {};
  MassModel mass = Fiber{}.mass;
};

/// Declares the keys of a fiber, for a T that has them.
template <class T>
void declare_fiber(KeyTable<T>& table) {
  table.quantity("diameter", "m", &T::diameter, kPositive, "diameter of the fiber and of its spheres")
      .required();
  table
      .integer(
          "aspect_ratio", &T::aspect_ratio, {.low = 1, .high = 1e6},
          "length between the centers of the end spheres over the diameter; without `spacing` the number "
          "of bonds")
      .required();
  table.number("spacing", &T::spacing, {.low = 0.01, .high = 1e6},
               "length of a bond over the diameter, with a whole number of bonds in `aspect_ratio`; other "
               "than 1 for fibers that no fluid and no other fiber touches");
  table
      .word("material", &T::material, "name in data/materials, or path of a .yaml file beside the scene",
            "whose moduli and density count where they are not given; it damps nothing by itself, see "
            "`material_damping`")
      .content_counts()
      .otherwise("none");
  table.quantity("youngs_modulus", "Pa", &T::youngs_modulus, kPositive, "Young's modulus E")
      .otherwise("that of `material`");
  table
      .number("poisson_ratio", &T::poisson_ratio, kPoissonRatio,
              "Poisson's ratio ν, for G = E / (2 (1 + ν)); beside `shear_modulus` that of contacts only")
      .otherwise("with `shear_modulus`, or that of `material`");
  table
      .quantity("shear_modulus", "Pa", &T::shear_modulus, kPositive,
                "shear modulus G, any: a fiber may be stiffer along than across")
      .otherwise("with `poisson_ratio`, or that of `material`");
  table
      .quantity("transverse_modulus", "Pa", &T::transverse_modulus, kPositive,
                "Young's modulus across the fiber, of contacts")
      .otherwise("that of `material`, else `youngs_modulus`")
      .only_with("shear_modulus or a material that has one",
                 [](const T& keys) { return keys.shear_modulus || !keys.material.empty(); });
  table.quantity("density", "kg/m^3", &T::density, kPositive, "density of the material")
      .otherwise("that of `material`");
  table
      .mapping_or_word(
          "material_damping", "from-material", MaterialDampingKeys{.from_material = true},
          material_damping_keys(),
          [](const StrictMapping&, const MaterialDampingKeys& typed, T& keys) {
            keys.material_damping = typed;
          },
          "damping of the material as Maxwell branches beside the bonds' springs; the dashpots of "
          "`bond.damping` add to it")
      .otherwise("none");
  table.choice("mass", &T::mass, words_of({MassModel::spheres, MassModel::cylinder}),
               "what the chain weighs: spheres of the material's density, two thirds of the fiber, as in the "
               "paper; or the fiber's cylinder, end spheres half as heavy");
}

/// Whole number of bonds nearest to aspect_ratio / spacing, 1 at least.
double bonds_of(const FiberKeys& keys);

/// A fiber as read.
struct ReadFiber {
  Fiber fiber;
  DampingSummary damping = {};
  std::optional<SceneText> material_file = {};
};

/// The fiber of these keys, with the default bonds and, of material damping, their branches.
/// @throws SceneError at `key` of the mapping for numbers that make no sense together
ReadFiber fiber_of(const StrictMapping& mapping, const std::string& key, const FiberKeys& keys);

/// Mapping "bond" as typed.
struct BondKeys {
  BondModel model = BondModel::paper;
  BondForm form = BondForm::total;
  double damping = 0;
  double rolling_friction = 0;
  Rolling rolling = Rolling::set_valued;
  std::optional<StrengthKeys> strength = {};
  std::optional<YieldKeys> yield = {};
};

/// Keys of a mapping "bond" that not all kinds of scenes have.
struct BondParts {
  std::optional<BondForm> form = {};  ///< key form, with this default
  bool rolling_friction = false;      ///< key rolling_friction
  bool rolling = false;               ///< key rolling, its scheme
  bool failure = false;               ///< keys strength and yield
};
KeyTable<BondKeys> bond_keys(const BondParts& parts);

/// Gives the fiber its bonds.
void apply(const BondKeys& keys, Fiber& fiber);

/// Refuses what is not built together with material_damping: rolling friction of the bonds.
void check_branches(const StrictMapping& top, const Fiber& fiber);

/// Mapping "load" as typed.
struct LoadKeys {
  std::optional<double> reduced;  ///< P L^2 / (E I), or
  std::optional<double> force;    ///< P [N]
  std::array<double, 3> direction = EndPull{}.direction;
};
KeyTable<LoadKeys> load_keys();

/// The pull at the fiber's end.
EndPull pull_of(const StrictMapping& load, const LoadKeys& keys, const Fiber& fiber, Dimension dimension);

/// Refuses a direction out of the x-y plane where the scene is planar.
void check_planar(const StrictMapping& mapping, const char* key, const std::array<double, 3>& direction,
                  Dimension dimension);

/// Declares keys dimension, fiber and bond of a scene of one fiber. `store` gets (BondKeys, scene) for what
/// is not of the fiber itself.
template <class T, class Store>
void declare_single_fiber(KeyTable<T>& table, const BondParts& parts, Store store) {
  table.choice("dimension", &T::dimension, words_of({Dimension::planar, Dimension::spatial}),
               "motion in the x-y plane, or in space");
  KeyTable<FiberKeys> fiber;
  declare_fiber(fiber);
  const auto store_fiber = [](const StrictMapping& mapping, const FiberKeys& keys, T& scene) {
    const ReadFiber read = fiber_of(mapping, "", keys);
    scene.fiber = read.fiber;
    scene.damping = read.damping;
  };
  table.mapping("fiber", fiber, store_fiber, "the fiber").required();
  const auto store_bond = [store](const StrictMapping&, const BondKeys& keys, T& scene) {
    apply(keys, scene.fiber);
    store(keys, scene);
  };
  table.mapping("bond", bond_keys(parts), store_bond, "the bonds between the spheres");
}

/// Course of a flow in time as typed.
struct CourseKeys {
  std::optional<double> start_up;     ///< [s], or
  std::optional<double> oscillation;  ///< [s]
  double phase = 0;                   ///< [rad]
};

/// A named flow: u = A x with A of this rate.
struct NamedFlow {
  const char* name;
  Gradient (*gradient)(double rate);
  bool operator==(const NamedFlow&) const = default;
};

/// Mapping "fluid" as typed.
struct FluidKeys {
  double viscosity = 0;                                          ///< [Pa s]
  std::optional<NamedFlow> flow;                                 ///< with its rate, or
  double rate = 0;                                               ///< [1/s]
  std::optional<std::array<std::array<double, 3>, 3>> gradient;  ///< [1/s]
  std::optional<CourseKeys> course;
  Hydrodynamics hydrodynamics = Hydrodynamics::free_draining;
  bool compressible = false;

  bool flows() const { return flow || gradient; }
};

/// Keys of a mapping "fluid", with these hydrodynamics; `may_rest`: flow and gradient may both be left out.
KeyTable<FluidKeys> fluid_keys(std::initializer_list<Hydrodynamics> hydrodynamics, bool may_rest);

/// A fluid with the rate that strain is counted by.
struct FluidInFlow {
  Fluid fluid;
  double rate = 0;     ///< size of the named flow's rate, or the gradient's Frobenius norm [1/s]
  bool shear = false;  ///< a simple shear, steady
};
FluidInFlow fluid_of(const StrictMapping& mapping, const FluidKeys& keys, Dimension dimension);

// Keys and reader of each kind of scene.
std::vector<KeyDeclaration> cantilever_declarations();
std::vector<KeyDeclaration> release_declarations();
std::vector<KeyDeclaration> flow_declarations();
std::vector<KeyDeclaration> rod_declarations();
std::vector<KeyDeclaration> packing_declarations();
CantileverScene read_cantilever(const StrictMapping& top);
ReleaseScene read_release(const StrictMapping& top);
FlowScene read_flow(const StrictMapping& top);
RodScene read_rod(const StrictMapping& top);
PackingScene read_packing(const StrictMapping& top);

/// Diameter of the thickest fibers [m].
double largest_diameter(const PackingScene& scene);

/// Declares key start_from.
void declare_start_from(KeyTable<PackingScene>& table);

/// Declares keys periodic, walls, gravity, fluid and contacts of a packing.
void declare_domain(KeyTable<PackingScene>& table);

/// Declares key walls, which is read after the periods.
void declare_walls(KeyTable<PackingScene>& table);

/// An entry of list "walls.meshes" as typed.
struct MeshWallKeys : Wall {
  std::string file;
  double scale = 1;       ///< [m]
  Vec<double, 3> axis{};  ///< of the turn
  double angle = 0;       ///< [rad]
};

KeyTable<MeshWallKeys> mesh_wall_keys();

/// The wall of these keys.
/// @throws SceneError at key file for one that cannot be read or is no mesh, at sides where its triangles
/// look to both sides of it
Wall mesh_wall(const StrictMapping& mapping, const MeshWallKeys& keys);

/// Declares keys from and until of a Wall, or of a T that is one.
template <class T>
void declare_times(KeyTable<T>& table, const std::string& from, const std::string& until) {
  table.quantity("from", "s", &T::active_from, kFinite, from);
  table.quantity("until", "s", &T::active_until, kFinite, until).otherwise("always there");
}

/// Mapping "rotation" as typed.
struct RotationKeys {
  WallAxis about;
  double angular_velocity = 0;  ///< [1/s]
};
KeyTable<RotationKeys> rotation_keys();

KeyTable<WallOscillation> oscillation_keys();

/// Mapping "course" as typed.
struct CourseFileKeys {
  std::string file;
  Vec<double, 3> direction{};
  std::optional<Vec<double, 3>> point, axis;
};
KeyTable<CourseFileKeys> course_file_keys();
void store_course(const StrictMapping& mapping, const CourseFileKeys& keys, Wall& wall);

/// Declares how a Wall, or a T that is one, moves and when it is there.
template <class T>
void declare_rigid_motion(KeyTable<T>& table, const std::string& velocity, const std::string& from,
                          const std::string& until) {
  table.vector("velocity", "m/s", &T::velocity, velocity);
  declare_times(table, from, until);
  const auto store_rotation = [](const StrictMapping&, const RotationKeys& keys, Wall& wall) {
    wall.motion.about = keys.about;
    wall.motion.angular_velocity = keys.angular_velocity;
  };
  const auto store_oscillation = [](const StrictMapping&, const WallOscillation& keys, Wall& wall) {
    wall.motion.oscillation = keys;
  };
  table
      .mapping("rotation", rotation_keys(), store_rotation,
               "it turns about an axis, beside what else it does")
      .otherwise("none");
  table.mapping("oscillation", oscillation_keys(), store_oscillation, "it goes to and fro").otherwise("none");
  table.mapping("course", course_file_keys(), &store_course, "it goes as a table says").otherwise("none");
}

/// Declares keys held and loads, which are read after the fibers.
void declare_held(KeyTable<PackingScene>& table);

/// Declares how a wall (Wall or MeshWallKeys) moves, when it is there, and its surface.
template <class T>
void declare_wall_motion(KeyTable<T>& table);

/// Gives a plate that a pressure drives, without an area, the force on the cross section between periodic
/// sides and walls that have been read.
void complete_drive(const StrictMapping& mapping, Wall& wall, const PackingScene& scene);

/// Gives a plate that a pressure drives, without an area, the force on the cross section between periodic
/// sides and walls that have been read.
void complete_drive(const StrictMapping& mapping, Wall& wall, const PackingScene& scene);

/// Keys of a mapping "contacts" that has what differs from the scene's; `of_fibers`: the elasticity of the
/// fibers' surface too.
KeyTable<ContactChoices> contact_choice_keys(bool of_fibers);

/// Declares a wall's name, elasticity and contacts. `wall` gives the wall of a T.
template <class T, class Of>
void declare_wall_surface(KeyTable<T>& table, Of wall) {
  table
      .word(
          "name", [=](T & keys) -> auto& { return wall(keys).name; }, "text",
          "by which `contacts.pairs` and NAME-walls.csv call it; several walls may have the same")
      .otherwise("none");
  table
      .quantity(
          "youngs_modulus", "Pa", [=](T & keys) -> auto& { return wall(keys).youngs_modulus; }, kPositive,
          "Young's modulus of this wall")
      .otherwise("that of all walls");
  table
      .number(
          "poisson_ratio", [=](T & keys) -> auto& { return wall(keys).poisson_ratio; }, kPoissonRatio,
          "Poisson's ratio of this wall")
      .otherwise("that of all walls")
      .only_with("youngs_modulus",
                 [=](const T& keys) { return wall(const_cast<T&>(keys)).youngs_modulus.has_value(); });
  table
      .mapping_into(
          "contacts", [=](T & keys) -> auto& { return wall(keys).contacts; }, contact_choice_keys(false),
          "of fibers at this wall")
      .otherwise("those of all");
}

/// Declares key contacts, which is read after the fibers and the walls that its pairs name.
void declare_contacts(KeyTable<PackingScene>& table);

/// Declares key filling, which is read after the fibers and the domain.
void declare_filling(KeyTable<PackingScene>& table);

/// Gives the scene's box the sides that neither walls nor periods give: those of the region, and of fibers
/// from files.
void complete_scene_box(PackingScene& scene);

}  // namespace fiberchain::dem
