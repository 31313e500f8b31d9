// Marching against solving, the incremental form against the total one.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/time_step.hpp"

BOOST_AUTO_TEST_SUITE(dynamic_relaxation_test)

namespace dem = fiberchain::dem;

namespace {

dem::Fiber odd_fiber(int aspect_ratio, dem::BondModel model = dem::BondModel::paper) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, aspect_ratio, model};
}

template <int Dim>
std::vector<dem::RelaxCase<Dim>> cantilevers(const dem::Fiber& fiber, const std::vector<double>& loads) {
  std::vector<dem::RelaxCase<Dim>> cases;
  for (const double load : loads) {
    dem::Load<Dim> tip{fiber.aspect_ratio, {}, {}};
    tip.force[1] = dem::load_force(fiber, load);
    if constexpr (Dim == 3) tip.force[2] = 0.5 * tip.force[1];
    cases.push_back({dem::straight_chain<Dim>(fiber), {dem::Boundary<Dim>{{0}, {tip}}}});
  }
  return cases;
}

/// Largest distance between marched and solved spheres, over the tip's deflection.
template <int Dim>
double difference(const dem::RelaxCase<Dim>& job, const dem::RelaxResult<Dim>& marched) {
  const auto solved = dem::solve_equilibrium(job.chain, job.loading.back());
  double largest = 0;
  for (std::size_t i = 0; i < solved.poses.size(); ++i) {
    largest = std::max(largest, dem::norm(solved.poses[i].position - marched.poses[i].position));
  }
  return largest / dem::norm(solved.poses.back().position - job.chain.poses.back().position);
}

template <int Dim>
void total_form_marches_to_the_solved_state(dem::BondModel model) {
  const auto cases = cantilevers<Dim>(odd_fiber(13, model), {0.05, 1.0, 6.0});
  const auto marched = dem::relax_to_equilibrium(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    BOOST_TEST(difference(cases[i], marched[i]) < 1e-8);
    BOOST_TEST(marched[i].residual.moment < 1e-10);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(total_form_planar) {
  total_form_marches_to_the_solved_state<2>(dem::BondModel::paper);
  total_form_marches_to_the_solved_state<2>(dem::BondModel::corrected);
}

BOOST_AUTO_TEST_CASE(total_form_spatial) {
  total_form_marches_to_the_solved_state<3>(dem::BondModel::paper);
  total_form_marches_to_the_solved_state<3>(dem::BondModel::corrected);
}

BOOST_AUTO_TEST_CASE(bond_damping_alone_settles_the_chain_as_in_the_paper) {
  const auto cases = cantilevers<2>(odd_fiber(5), {0.3, 2.0});
  const auto marched = dem::relax_to_equilibrium(cases, {.bond_damping = 1.0, .drag = 0.0, .residual = 1e-9});
  for (std::size_t i = 0; i < cases.size(); ++i) BOOST_TEST(difference(cases[i], marched[i]) < 1e-8);
}

BOOST_AUTO_TEST_CASE(incremental_form_rests_close_by_and_second_order_in_the_step) {
  const auto cases = cantilevers<2>(odd_fiber(10), {3.0});
  const auto tip = [&](double step_ratio) {
    const auto marched = dem::relax_to_equilibrium(cases, {.form = dem::BondForm::incremental,
                                                           .step_ratio = step_ratio,
                                                           .ramp_periods = 0.5,
                                                           .residual = 1e-13});
    return marched[0].poses.back().position[1] / dem::fiber_length(cases[0].chain.fiber);
  };
  const double coarse = tip(0.4), middle = tip(0.2), fine = tip(0.1);
  const double order = std::log2(std::abs((coarse - middle) / (middle - fine)));
  BOOST_TEST(order > 1.9);
  BOOST_TEST(order < 2.1);
  const double solved = dem::solve_equilibrium(cases[0].chain, cases[0].loading[0]).poses.back().position[1] /
                        dem::fiber_length(cases[0].chain.fiber);
  BOOST_TEST_MESSAGE("incremental - total at load 3: " << fine - solved << " L, step part " << fine - middle);
  BOOST_TEST(std::abs(fine - solved) > 1e-7);
  BOOST_TEST(std::abs(fine - solved) < 2e-5);
}

BOOST_AUTO_TEST_CASE(spatial_incremental_form_equals_the_planar_one_in_the_plane) {
  const dem::Fiber fiber = odd_fiber(13);
  std::vector<dem::RelaxCase<3>> spatial;
  const auto planar = cantilevers<2>(fiber, {1.0, 4.0});
  for (const auto& job : planar) {
    const double P = job.loading[0].loads[0].force[1];
    spatial.push_back(
        {dem::straight_chain<3>(fiber), {dem::Boundary<3>{{0}, {{13, {0, 0.6 * P, 0.8 * P}, {}}}}}});
  }
  const dem::RelaxOptions options{.form = dem::BondForm::incremental, .step_ratio = 0.1};
  const auto flat = dem::relax_to_equilibrium(planar, options);
  const auto tilted = dem::relax_to_equilibrium(spatial, options);
  for (std::size_t i = 0; i < planar.size(); ++i) {
    for (int s = 0; s <= 13; ++s) {
      const auto& p = flat[i].poses[s].position;
      const auto& q = tilted[i].poses[s].position;
      const double L = dem::fiber_length(fiber);
      // the same scheme, but for the third order of the Cayley turn of the stored strain
      BOOST_TEST(std::abs(q[0] - p[0]) / L < 1e-7);
      BOOST_TEST(std::abs(0.6 * q[1] + 0.8 * q[2] - p[1]) / L < 1e-7);
      BOOST_TEST(std::abs(0.8 * q[1] - 0.6 * q[2]) / L < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(corner_by_total_form_forgets_its_path_and_by_increments_does_not) {
  const dem::Fiber fiber = odd_fiber(12);
  const dem::Chain<3> chain = dem::cornered_chain<3>(fiber, 6);
  const double arm = 6 * dem::bond_length(fiber);
  for (const double load : {0.1, 1.0, 3.0}) {
    const double P = load * dem::bending_stiffness(fiber) / (arm * arm);
    const dem::Boundary<3> final{{0}, {{12, {0, 0, P}, {}}}},
        detour{{0}, {{12, {0.8 * P, -0.5 * P, 0.2 * P}, {}}}};
    const dem::RelaxCase<3> direct{chain, {final, final}}, around{chain, {detour, final}};
    const auto solved = dem::solve_equilibrium(chain, final).poses.back().position;
    const double deflection = dem::norm(solved - chain.poses.back().position);
    const auto gap = [&](dem::BondForm form) {
      const auto marched = dem::relax_to_equilibrium<3>(
          {direct, around}, {.form = form, .ramp_periods = 1.0, .residual = 1e-9});
      const auto a = marched[0].poses.back().position, b = marched[1].poses.back().position;
      BOOST_TEST_MESSAGE("load " << load << " " << name(form) << ": paths apart "
                                 << dem::norm(a - b) / deflection << ", direct path from solved "
                                 << dem::norm(a - solved) / deflection);
      return std::max(dem::norm(a - b), dem::norm(a - solved)) / deflection;
    };
    BOOST_TEST(gap(dem::BondForm::total) < 1e-8);
    BOOST_TEST(gap(dem::BondForm::incremental) > 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(stable_step_is_that_of_the_infinite_chains_spectrum) {
  // model.md: nu = 0.3
  const double damping[] = {0, 0.1, 0.25, 0.5, 1, 2, 5};
  const double limit[] = {1.00, 0.82, 0.60, 0.39, 0.218, 0.113, 0.046};
  const double digits[] = {1e-9, 5e-3, 5e-3, 5e-3, 5e-4, 5e-4, 5e-4};
  for (int i = 0; i < 7; ++i) {
    const dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.3, 431.0), 0.0262, 13, dem::BondModel::paper,
                           damping[i]};
    BOOST_TEST(std::abs(dem::stable_time_step(fiber) / dem::bond_time_step(fiber) - limit[i]) <= digits[i]);
  }
  const auto undamped = [](double nu, dem::BondModel model) {
    const dem::Fiber fiber{dem::isotropic_material(3.7e5, nu, 431.0), 0.0262, 13, model};
    return dem::stable_time_step(fiber) / dem::bond_time_step(fiber);
  };
  BOOST_TEST(undamped(-0.2, dem::BondModel::paper) == 0.8, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(undamped(0, dem::BondModel::paper) == std::sqrt(0.8), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(undamped(0.17, dem::BondModel::paper) == std::sqrt(0.8 * 1.17),
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(undamped(0.4, dem::BondModel::paper) == 1.0, boost::test_tools::tolerance(1e-6));
  // K_t = 3/4 K_n: rotation against shear at k = 0 gives sqrt(4 * 0.4 / (4 * 0.75))
  BOOST_TEST(undamped(0.3, dem::BondModel::corrected) == std::sqrt(1.6 / 3),
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(refuses_an_unstable_step_and_names_the_limit) {
  const auto cases = cantilevers<2>(odd_fiber(13), {1.0});
  BOOST_CHECK_EXCEPTION(dem::relax_to_equilibrium(cases, {.bond_damping = 1.0, .step_ratio = 0.25}),
                        dem::InvalidInput, [](const dem::InvalidInput& error) {
                          return std::string(error.what()).find("largest stable step") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(refuses_marches_that_cannot_end) {
  const auto cases = cantilevers<2>(odd_fiber(13), {1.0});
  BOOST_CHECK_THROW(dem::relax_to_equilibrium(cases, {.bond_damping = 0.0, .drag = 0.0}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::relax_to_equilibrium(cases, {.residual = 0.0}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::relax_to_equilibrium(cases, {.residual = 1e-13, .max_periods = 0.1}),
                    dem::NoConvergence);
  auto inner = cases;
  inner[0].loading[0].loads[0].sphere = 5;
  BOOST_CHECK_THROW(dem::relax_to_equilibrium(inner), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(a_load_beyond_the_bonds_diverges_and_says_where) {
  dem::Fiber fiber = odd_fiber(5);
  auto cases = cantilevers<2>(fiber, {1.0});
  cases[0].loading[0].loads[0].force[1] = std::numeric_limits<double>::max();
  BOOST_CHECK_EXCEPTION(
      dem::relax_to_equilibrium(cases, {.ramp_periods = 0.1}), dem::Diverged, [](const dem::Diverged& error) {
        const std::string what = error.what();
        return what.find("step") != std::string::npos && what.find("sphere") != std::string::npos &&
               what.find("fiber") != std::string::npos;
      });
}

BOOST_AUTO_TEST_SUITE_END()
