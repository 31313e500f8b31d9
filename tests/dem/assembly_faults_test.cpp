// What an assembly does not do yet; each test moves to where it belongs once it passes.
#define BOOST_TEST_MODULE assembly_faults
#include "tests/dem/assembly_alone.hpp"

using namespace scenes;

BOOST_AUTO_TEST_CASE(bonds_are_those_of_now_in_the_total_form) {
  for (const Case& c : {Case{"total", dem::BondForm::total, false, 0.1, 0}, {"curved", dem::BondForm::total, true, 0, 0}}) {
    BOOST_TEST(off_of(c, dem::best_instruction_set(), 1).angle < 1e-12, c.name);
  }
}

/// The first half step back is the relaxation's, not the one in vacuum.
BOOST_AUTO_TEST_CASE(weight_in_a_fluid_is_started_as_the_march_does) {
  using dem::BondForm;
  for (const Case& c : {Case{"fluid, gravity", BondForm::incremental, false, 0, 0, {}, Case::steady, true},
                        {"fluid, total, damped, gravity", BondForm::total, false, 0.13, 0, {}, Case::unsteady, true}}) {
    const Off off = off_of(c, dem::best_instruction_set(), 1);
    BOOST_TEST(off.position < 1e-12, c.name << ": " << off.position);
    BOOST_TEST(off.velocity < 2e-11, c.name << ": " << off.velocity);
  }
}
