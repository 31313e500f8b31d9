// Packings of fibers with Maxwell branches: their energy goes where the books say, and the state is whole.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/motion/time_step.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(viscoelastic_packing_test)

namespace dem = fiberchain::dem;
using scenes::V;

namespace {

/// Branches beside all springs of one kind, in bending alone of the other, dashpots beside them.
void make_viscoelastic(dem::Fiber& fiber, bool bending_alone) {
  const double t_b = dem::bond_time_step(fiber);
  const dem::PronySeries bend{{0.3, 7 * t_b}, {0.2, 60 * t_b}};
  fiber.branches = dem::maxwell_branches(
      bending_alone ? dem::MaterialRelaxation{{}, {}, bend}
                    : dem::MaterialRelaxation{{{0.4, 5 * t_b}}, {{0.7, 3 * t_b}, {0.1, 40 * t_b}}, {}},
      fiber.bond_model);
}

scenes::SmallPacking viscoelastic_packing(int first, int second) {
  scenes::SmallPacking packing = scenes::packing_in_a_box(first, second);
  make_viscoelastic(packing.groups[0].chain.fiber, false);
  make_viscoelastic(packing.groups[1].chain.fiber, true);
  return packing;
}

/// Part of its energy that a packing of thrown fibers, without contact, has lost or gained in the books.
double missing(dem::BondForm form, dem::Integrator integrator, double step_ratio, double& spent) {
  dem::Fiber fiber = scenes::odd_fiber(5);
  fiber.bond_model = dem::BondModel::corrected;
  fiber.bond_damping = 0.02;
  make_viscoelastic(fiber, false);
  const dem::FiberGroup group = scenes::scattered(dem::straight_chain<3>(fiber), 9, 1e-3, 3);
  dem::AssemblyOptions options{.form = form};
  options.integrator = integrator;
  options.account_energy = true;
  options.step = step_ratio * dem::bond_time_step(fiber);
  dem::Assembly assembly({group}, {}, options);
  const double before = total(assembly.energy());
  assembly.march(static_cast<int>(std::lround(30 / step_ratio)));
  const dem::EnergyBalance after = assembly.energy();
  spent = after.bond_damping / before;
  return (total(after) - before) / before;
}

dem::AssemblyOptions with_threads(dem::BondForm form, dem::Integrator integrator, int threads) {
  dem::AssemblyOptions options{.form = form};
  options.integrator = integrator;
  options.threads = threads;
  return options;
}

}  // namespace

BOOST_AUTO_TEST_CASE(energy_closes_at_second_order_in_the_step) {
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const auto integrator : {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff}) {
      double spent = 0;
      const double coarse = missing(form, integrator, 0.04, spent),
                   fine = missing(form, integrator, 0.02, spent);
      BOOST_TEST_MESSAGE(dem::name(form) << " " << dem::name(integrator) << ": " << coarse << ", " << fine
                                         << " of which spent " << spent);
      BOOST_TEST((spent > 0.2 && spent < 0.9));
      BOOST_TEST(std::abs(fine) < 3e-4);
      BOOST_TEST(std::abs(std::log2(coarse / fine) - 2) < 0.1);
    }
  }
}

BOOST_AUTO_TEST_CASE(packing_goes_on_from_its_saved_state_to_the_bit_and_on_any_number_of_threads) {
  for (const auto form : {dem::BondForm::total, dem::BondForm::incremental}) {
    for (const auto integrator : {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff}) {
      const scenes::SmallPacking packing = viscoelastic_packing(12, 9);
      dem::Assembly through = packing.assembly(with_threads(form, integrator, 1)),
                    again = packing.assembly(with_threads(form, integrator, 2));
      through.march(300);
      const dem::SavedState saved = through.saved();
      through.march(300);
      BOOST_TEST(through.touching() > 0);
      again.restore(saved);
      again.march(300);
      BOOST_TEST(scenes::numbers(again) == scenes::numbers(through), boost::test_tools::per_element());
      dem::Assembly one_run = packing.assembly(with_threads(form, integrator, 2));
      one_run.march(600);
      BOOST_TEST(scenes::numbers(one_run) == scenes::numbers(through), boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(forms_agree_and_differ_from_springs) {
  dem::Fiber fiber = scenes::odd_fiber(5), elastic = fiber;
  make_viscoelastic(fiber, false);
  const auto end_of = [](const dem::Fiber& of, dem::BondForm form) {
    dem::AssemblyOptions options{.form = form};
    options.step = 0.01 * dem::bond_time_step(of);
    dem::Assembly assembly({scenes::scattered(dem::straight_chain<3>(of), 9, 1e-4, 3)}, {}, options);
    assembly.march(1000);
    return assembly.state(0, 2).velocity[3];
  };
  const V total = end_of(fiber, dem::BondForm::total), summed = end_of(fiber, dem::BondForm::incremental);
  BOOST_TEST(dem::norm(total - summed) < 1e-3 * dem::norm(total));
  BOOST_TEST(dem::norm(total - end_of(elastic, dem::BondForm::total)) > 0.1 * dem::norm(total));
}

BOOST_AUTO_TEST_SUITE_END()
