// Fibers of an assembly that touch nothing move as each alone in dem's march, whatever they consist of.
#include "dem/model/errors.hpp"
#include "tests/dem/assembly/assembly_alone.hpp"

BOOST_AUTO_TEST_SUITE(assembly_physics_test)

using namespace scenes;

namespace {

using dem::BondForm, dem::Rolling, dem::BondModel, dem::DashpotLaw;

/// The same with bonds solved for within the step.
Case stiff(Case c) {
  c.stiff = true;
  return c;
}

const Case cases[]{
    {"incremental", BondForm::incremental, false, 0, 0},
    {"incremental, curved", BondForm::incremental, true, 0, 0},
    {"incremental, damped", BondForm::incremental, false, 0.37, 0},
    {"incremental, damped, curved, gravity", BondForm::incremental, true, 0.23, 0, {}, Case::vacuum, true},
    {"incremental, retardation time",
     BondForm::incremental,
     false,
     0.11,
     0,
     {},
     Case::vacuum,
     false,
     BondModel::paper,
     DashpotLaw::retardation_time},
    {"incremental, bending only",
     BondForm::incremental,
     false,
     0.9,
     0,
     {},
     Case::vacuum,
     false,
     BondModel::paper,
     DashpotLaw::bending_only},
    {"incremental, corrected bond",
     BondForm::incremental,
     false,
     0,
     0,
     {},
     Case::vacuum,
     true,
     BondModel::corrected},
    {"incremental, corrected, damped",
     BondForm::incremental,
     true,
     0.19,
     0,
     {},
     Case::vacuum,
     false,
     BondModel::corrected},
    {"rolling", BondForm::incremental, false, 0, 1.3, Rolling::set_valued},
    {"rolling, damped, gravity", BondForm::incremental, false, 0.31, 2.7, Rolling::set_valued, Case::vacuum,
     true},
    {"rolling, curved", BondForm::incremental, true, 0.31, 0.7, Rolling::set_valued},
    {"rolling by sign", BondForm::incremental, false, 0, 1.3, Rolling::explicit_sign},
    {"rolling by sign, damped, curved", BondForm::incremental, true, 0.17, 0.6, Rolling::explicit_sign},
    {"total", BondForm::total, false, 0, 0},
    {"total, curved, gravity", BondForm::total, true, 0, 0, {}, Case::vacuum, true},
    {"total, damped", BondForm::total, false, 0.37, 0},
    {"total, damped, curved", BondForm::total, true, 0.23, 0},
    {"total, corrected, damped",
     BondForm::total,
     false,
     0.23,
     0,
     {},
     Case::vacuum,
     true,
     BondModel::corrected},
    {"fluid, incremental", BondForm::incremental, false, 0, 0, {}, Case::steady},
    {"fluid, incremental, damped, unsteady", BondForm::incremental, true, 0.2, 0, {}, Case::unsteady},
    {"fluid, total", BondForm::total, false, 0, 0, {}, Case::unsteady},
    {"fluid, total, damped, curved", BondForm::total, true, 0.2, 0, {}, Case::steady},
    {"fluid, gravity", BondForm::incremental, false, 0, 0, {}, Case::steady, true},
    {"fluid, total, damped, gravity", BondForm::total, false, 0.13, 0, {}, Case::unsteady, true},
    stiff({"stiff, incremental", BondForm::incremental, false, 0, 0}),
    stiff({"stiff, incremental, damped, gravity",
           BondForm::incremental,
           false,
           0.3,
           0,
           {},
           Case::vacuum,
           true}),
    stiff({"stiff, total, damped, curved", BondForm::total, true, 0.4, 0}),
    stiff({"stiff, total, corrected",
           BondForm::total,
           false,
           0.2,
           0,
           {},
           Case::vacuum,
           true,
           BondModel::corrected}),
    stiff({"stiff, fluid, total", BondForm::total, false, 0.2, 0, {}, Case::steady, true}),
    stiff({"stiff, fluid, incremental", BondForm::incremental, false, 0, 0, {}, Case::unsteady}),
};

}  // namespace

BOOST_AUTO_TEST_CASE(fibers_of_an_assembly_move_as_each_alone) {
  for (const Case& c : cases) {
    for (const auto set : {dem::best_instruction_set(), dem::InstructionSet::scalar}) {
      const Off off = off_of(c, set, 1);
      BOOST_TEST_MESSAGE(c.name << " (" << dem::name(set) << "): off by " << off.position << " d, velocity "
                                << off.velocity << ", spin " << off.spin << ", turn " << off.turn
                                << ", bending angle " << off.angle);
      // a sign that chatters makes more of round-off
      const double much = c.friction > 0 && c.rolling == Rolling::explicit_sign ? 1e4 : 1;
      BOOST_TEST(off.position < much * 1e-12, c.name);
      BOOST_TEST(off.velocity < much * 2e-11, c.name);
      BOOST_TEST(off.spin < much * 5e-11, c.name);
      BOOST_TEST(off.turn < much * 1e-12, c.name);
      BOOST_TEST(off.angle < much * 1e-12, c.name);
    }
  }
}

BOOST_AUTO_TEST_CASE(physics_that_is_not_built_is_refused) {
  const Case rolling{"rolling", BondForm::total, false, 0, 1.3};
  const Case in_fluid{"rolling in a fluid", BondForm::incremental, false, 0, 1.3, {}, Case::steady};
  for (const Case& c : {rolling, in_fluid}) {
    const dem::FiberGroup group = scattered(chain_of(c, 3, 1), 2, 0.01, 1);
    BOOST_CHECK_THROW(dem::Assembly({group}, around(c, group.chain.fiber), {.form = c.form}),
                      dem::InvalidInput);
  }
  const Case fluid{"fluid", BondForm::incremental, false, 0, 0, {}, Case::steady};
  const dem::FiberGroup group = scattered(chain_of(fluid, 3, 1), 2, 0.01, 1);
  dem::Domain s = around(fluid, group.chain.fiber);
  s.fluid->hydrodynamics = dem::Hydrodynamics::interactions;
  BOOST_CHECK_THROW(dem::Assembly({group}, s, {}), dem::InvalidInput);
}

namespace {

std::vector<double> positions(const Case& c, const dem::AssemblyOptions& options) {
  const dem::FiberGroup one = scattered(chain_of(c, 7, 1), 11, 0.07, 3);
  dem::FiberGroup two = scattered(chain_of(c, 5, 1.2), 3, 0.07, 3);
  for (auto& fiber : two.fibers) move(fiber, {0.003, 0.004, 0.0279});  // they touch
  dem::Domain s = around(c, one.chain.fiber);
  dem::Assembly assembly({one, two}, s, options);
  BOOST_TEST(assembly.touching() > 0);
  assembly.march(120);
  std::vector<double> all;
  for (const V& x : assembly.placed().position) all.insert(all.end(), x.c, x.c + 3);
  for (int f = 0; f < 11; ++f) {
    for (const dem::BondState& bond : assembly.bonds(0, f)) all.push_back(bond.bending_angle);
  }
  return all;
}

}  // namespace

/// What is only watched changes nothing.
BOOST_AUTO_TEST_CASE(booking_and_orientations_change_no_bit) {
  for (const Case& c : cases) {
    if (c.dashpots != DashpotLaw::bond_damping || c.model != BondModel::paper) continue;
    dem::AssemblyOptions options{.form = c.form, .rolling = c.rolling, .allow_passage = true};
    const auto plain = positions(c, options);
    options.account_energy = true;
    BOOST_TEST((positions(c, options) == plain), c.name << ", accounted");
    if (c.form == BondForm::total) continue;  // its bonds need the orientations
    options.orientations = false;
    BOOST_TEST((positions(c, options) == plain), c.name << ", without orientations");
    options.account_energy = false;
    BOOST_TEST((positions(c, options) == plain), c.name << ", without orientations, not accounted");
  }
}

BOOST_AUTO_TEST_SUITE_END()
