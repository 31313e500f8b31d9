// Fibers in a flow without inertia: balance on every sphere, orbits of stiff fibers against Jeffery's, the
// limit of vanishing inertia.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "dem/chain/flow_at_spheres.hpp"
#include "dem/flow/draining_balance.hpp"
#include "dem/flow/inertialess.hpp"
#include "dem/flow/interacting_balance.hpp"
#include "dem/flow/mobility.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/sheared_fibers.hpp"

BOOST_AUTO_TEST_SUITE(inertialess_test)

using namespace sheared_fibers;

namespace {

/// Strained: bent along a parabola and, in space, twisted.
template <int Dim>
dem::FlowCase<Dim> strained_case(const dem::Fiber& fiber, const dem::Fluid& fluid) {
  dem::FlowCase<Dim> flow = straight_case<Dim>(fiber, fluid);
  const double L = dem::fiber_length(fiber);
  for (auto& pose : flow.start) {
    const double s = pose.position[0] / L;
    pose.position[1] += 0.1 * L * s * s;
    if constexpr (Dim == 3) {
      pose.position[2] -= 0.07 * L * s * s * s;
      dem::turn_by_vector(pose.orientation, {0.2 * s, 0.2 * s * s, 0.2 * s});
    } else {
      dem::turn_by_vector(pose.orientation, {0.2 * s});
    }
  }
  return flow;
}

/// Largest force or moment left on any sphere, over the largest of its parts.
template <int Dim>
double left_over(const dem::FlowCase<Dim>& flow, const dem::ChainVector<Dim>& v) {
  const auto drag = dem::drag_of<Dim>(flow.fluid, flow.chain.fiber);
  const auto stream = dem::undisturbed<Dim>(flow.fluid.flow.gradient, flow.start);
  const auto bonds = dem::bond_forces(flow.chain, flow.start),
             dashpots = dem::dashpot_forces(flow.chain, flow.start, v);
  const auto loads = dem::applied_loads(flow.boundary, static_cast<int>(v.size()));
  double force = 0, force_size = 0, moment = 0, moment_size = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const dem::SphereVector<Dim> dragged = drag.cwiseProduct(stream[i] - v[i]);
    const dem::SphereVector<Dim> sum = dragged + bonds[i] + dashpots[i] + loads[i];
    force = std::max(force, sum.template head<Dim>().norm());
    moment = std::max(moment, sum.template tail<dem::spin_size<Dim>>().norm());
    force_size = std::max(force_size, bonds[i].template head<Dim>().norm());
    moment_size = std::max(moment_size, bonds[i].template tail<dem::spin_size<Dim>>().norm());
  }
  return std::max(force / force_size, moment / moment_size);
}

/// Largest motion of a sphere that the forces on it do not give through the mobility, over the largest that
/// the bonds' forces give.
template <int Dim>
double unexplained(const dem::FlowCase<Dim>& flow, const dem::ChainVector<Dim>& v) {
  const auto M = dem::mobility<Dim>(flow.fluid, kRadius, flow.start);
  const auto stream = dem::undisturbed<Dim>(flow.fluid.flow.gradient, flow.start);
  const auto bonds = dem::bond_forces(flow.chain, flow.start),
             dashpots = dem::dashpot_forces(flow.chain, flow.start, v);
  constexpr int m = dem::sphere_motions<Dim>;
  Eigen::VectorXd forces(v.size() * m), elastic(v.size() * m), rest(v.size() * m);
  for (std::size_t i = 0; i < v.size(); ++i) {
    elastic.segment<m>(i * m) = bonds[i];
    forces.segment<m>(i * m) = bonds[i] + dashpots[i];
    rest.segment<m>(i * m) = v[i] - stream[i];
  }
  rest -= M.motion * forces;
  if (M.strain.cols() > 0) rest -= M.strain * dem::strain_components(flow.fluid.flow.gradient);
  return rest.cwiseAbs().maxCoeff() / (M.motion * elastic).cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_sphere_is_in_balance) {
  for (const double damping : {0.0, 0.6}) {
    const dem::Fiber fiber = fiber_of(13, 40, damping);
    auto plane = strained_case<2>(fiber, shear());
    plane.boundary.loads = {{3, {0.01, -0.02}, {1e-4}}};
    BOOST_TEST(left_over(plane, dem::DrainingBalance<2>(plane.chain, plane.boundary, plane.fluid)
                                    .velocities(0, plane.start)) < 1e-12);
    auto space = strained_case<3>(fiber, shear());
    space.boundary.loads = {{3, {0.01, -0.02, 0.03}, {1e-4, 0, -1e-4}}};
    BOOST_TEST(left_over(space, dem::DrainingBalance<3>(space.chain, space.boundary, space.fluid)
                                    .velocities(0, space.start)) < 1e-12);
  }
}

/// The dashpots' forces, which depend on the velocities, act through the fluid on every sphere.
BOOST_AUTO_TEST_CASE(every_sphere_moves_by_the_forces_on_all) {
  for (const auto hydrodynamics : {dem::Hydrodynamics::interactions, dem::Hydrodynamics::stresslets}) {
    for (const double damping : {0.0, 0.6}) {
      const dem::Fiber fiber = fiber_of(7, 40, damping);
      const auto plane = strained_case<2>(fiber, shear(hydrodynamics));
      BOOST_TEST(
          unexplained(plane,
                      dem::InteractingBalance<2>(plane.chain, {}, plane.fluid).velocities(0, plane.start)) <
          1e-12);
      const auto space = strained_case<3>(fiber, shear(hydrodynamics));
      BOOST_TEST(
          unexplained(space,
                      dem::InteractingBalance<3>(space.chain, {}, space.fluid).velocities(0, space.start)) <
          1e-12);
    }
  }
}

/// Differences of the path against the balance; without its dashpots the fiber would move otherwise.
BOOST_AUTO_TEST_CASE(damped_spheres_that_interact_move_as_their_forces_say) {
  const auto flow = strained_case<3>(fiber_of(7, 40, 0.6), shear(dem::Hydrodynamics::interactions));
  dem::InertialessMotion<3> motion(flow, 1e-10);
  const double t = 0.2 / kRate, h = 1e-3 / kRate;
  const auto before = motion.at(t - h).poses, now = motion.at(t).poses, after = motion.at(t + h).poses;
  const auto off = [&](double damping) {
    dem::Chain<3> chain = flow.chain;
    chain.fiber.bond_damping = damping;
    const auto v = dem::InteractingBalance<3>(chain, {}, flow.fluid).velocities(t, now);
    double most = 0, largest = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const auto moved = (0.5 / h) * (after[i].position - before[i].position);
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(moved[c] - v[i][c]));
      largest = std::max(largest, dem::norm(moved));
    }
    return most / largest;
  };
  BOOST_TEST(off(0.6) < 1e-4);
  BOOST_TEST(off(0) > 1e-3);
}

/// Falling at one speed under the same force on every sphere: the drag is that of all spheres, ends included.
BOOST_AUTO_TEST_CASE(sedimentation_is_dragged_at_every_sphere) {
  const dem::Fiber fiber = fiber_of(13, 1);
  auto flow = straight_case<3>(fiber, {kViscosity, {}}, 0.4);
  const dem::Vec<double, 3> force{0.011, -0.023, 0.017};
  for (int i = 0; i < 13; ++i) flow.boundary.loads.push_back({i, force, {}});
  const auto state = dem::InertialessMotion<3>(flow, 1e-9).at(2.0);
  for (int i = 0; i < 13; ++i) {
    for (int c = 0; c < 3; ++c) {
      const double u = force[c] / (6 * pi * kViscosity * kRadius);
      BOOST_TEST(state.velocity[i][c] == u, boost::test_tools::tolerance(1e-8));
      BOOST_TEST(state.poses[i].position[c] - flow.start[i].position[c] == 2 * u,
                 boost::test_tools::tolerance(1e-8));
    }
  }
}

/// Interactions: velocities of a pair along and across its line, Rotne and Prager's.
BOOST_AUTO_TEST_CASE(pair_falls_as_rotne_and_prager) {
  const dem::Fiber fiber = fiber_of(2, 0.1);
  auto flow = straight_case<2>(fiber, {kViscosity, {}, dem::Hydrodynamics::interactions});
  for (int i = 0; i < 2; ++i) flow.boundary.loads.push_back({i, {0.3, 0.4}, {}});
  const auto v = dem::InteractingBalance<2>(flow.chain, flow.boundary, flow.fluid).velocities(0, flow.start);
  const double alone = 1 / (6 * pi * kViscosity * kRadius);
  // 1 + 3/4 (1/2)(2 - 4/3 /4), 1 + 3/4 (1/2)(1 + 2/3 / 4) at two radii
  BOOST_TEST(v[0][0] == 0.3 * alone * 1.625, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(v[1][1] == 0.4 * alone * (1 + 0.4375), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(oscillating_flow_is_followed) {
  const double period = 5.3, aspect = chain_aspect(5);
  auto flow = straight_case<2>(fiber_of(5, 0.01), shear());
  flow.fluid.flow = dem::oscillation(dem::simple_shear(kRate), period, -pi / 2);
  dem::InertialessMotion<2> motion(flow, 1e-10);
  const auto angle = [&](double t) {
    const auto state = motion.at(t);
    const auto r = state.poses.back().position - state.poses.front().position;
    return std::atan2(r[1], r[0]);
  };
  // tan(angle) = -tan(total strain / (r + 1/r)) / r along Jeffery's orbit
  const double strain = kRate * period / pi;
  BOOST_TEST(std::tan(angle(period / 2)) == -std::tan(strain / (aspect + 1 / aspect)) / aspect,
             boost::test_tools::tolerance(2e-4));
  BOOST_TEST(std::abs(angle(period)) < 1e-4);
}

/// Dashpots slow the bonds down but do not drag: a chain in a quiet fluid keeps its center.
BOOST_AUTO_TEST_CASE(damped_bonds_relax_slower_to_the_same_rest) {
  double bend[2];
  for (int i = 0; i < 2; ++i) {
    auto flow = strained_case<2>(fiber_of(9, 40, i == 0 ? 0.0 : 40.0), {kViscosity, {}});
    dem::InertialessMotion<2> motion(flow, 1e-9);
    const auto early = motion.at(0.01).poses, late = motion.at(400).poses;
    bend[i] = early.back().orientation - early.front().orientation;
    dem::Vec<double, 2> center{}, start{};
    for (std::size_t k = 0; k < late.size(); ++k) {
      center = center + late[k].position;
      start = start + flow.start[k].position;
    }
    BOOST_TEST(dem::norm(center - start) < 1e-8 * kRadius * 9);
    BOOST_TEST(std::abs(late.back().orientation - late.front().orientation) < 1e-6);
  }
  BOOST_TEST(bend[1] > 1.02 * bend[0]);
}

/// With inertia falling, the path approaches that without in first order of the density.
BOOST_AUTO_TEST_CASE(inertia_vanishes_in_first_order) {
  double distance[2];
  for (int i = 0; i < 2; ++i) {
    dem::Fiber fiber = fiber_of(6, 30);
    fiber.material.density = i == 0 ? 8.0 : 2.0;
    const auto flow = strained_case<3>(fiber, shear());
    dem::ChainState<3> with, without;
    const double time = 3 / kRate;
    dem::integrate_in_flow<3>(flow, {time}, {.method = dem::FlowMethod::cvode, .tolerance = 1e-10},
                              [&](double, const dem::ChainState<3>& s) { with = s; });
    dem::integrate_in_flow<3>(flow, {time}, {.tolerance = 1e-10},
                              [&](double, const dem::ChainState<3>& s) { without = s; });
    distance[i] = dem::norm(with.poses.back().position - without.poses.back().position);
  }
  BOOST_TEST(std::log(distance[0] / distance[1]) / std::log(4.0) == 1, boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(clamped_fiber_comes_to_rest_in_the_flow) {
  auto flow = straight_case<2>(fiber_of(9, 20), {kViscosity, {{{{0, 0, 0}, {kRate, 0, 0}, {0, 0, 0}}}}});
  flow.boundary.clamped = {0};
  const auto state = dem::InertialessMotion<2>(flow, 1e-9).at(60);
  const auto drag = dem::drag_of<2>(flow.fluid, flow.chain.fiber);
  const auto stream = dem::undisturbed<2>(flow.fluid.flow.gradient, state.poses);
  const auto bonds = dem::bond_forces(flow.chain, state.poses);
  double size = 0;
  for (const auto& f : bonds) size = std::max(size, f.head<2>().norm());
  for (int i = 1; i < 9; ++i) {
    BOOST_TEST((bonds[i] + drag.cwiseProduct(stream[i])).head<2>().norm() < 1e-6 * size);
  }
  BOOST_TEST(std::abs(state.poses.back().position[1]) > 0.01 * dem::fiber_length(flow.chain.fiber));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const dem::Fiber fiber = fiber_of(5, 1);
  const auto nothing = [](double, const dem::ChainState<2>&) {};
  const auto refused = [&](const dem::FlowCase<2>& flow, const dem::FlowOptions& options = {}) {
    BOOST_CHECK_THROW(dem::integrate_in_flow<2>(flow, {1.0}, options, nothing), dem::InvalidInput);
  };
  auto flow = straight_case<2>(fiber, shear());
  BOOST_CHECK_NO_THROW(dem::integrate_in_flow<2>(flow, {0.1}, {}, nothing));
  for (const double viscosity : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    auto other = flow;
    other.fluid.viscosity = viscosity;
    refused(other);
  }
  auto squeezed = flow;
  squeezed.fluid.flow.gradient[1][1] = 0.1;
  refused(squeezed);
  squeezed.fluid.compressible = true;
  BOOST_CHECK_NO_THROW(dem::integrate_in_flow<2>(squeezed, {0.1}, {}, nothing));
  auto leaving = flow;
  leaving.fluid.flow.gradient[2][0] = 1;
  refused(leaving);
  auto interacting = flow;
  interacting.fluid.hydrodynamics = dem::Hydrodynamics::interactions;
  refused(interacting, {.method = dem::FlowMethod::cvode});
  interacting.boundary.clamped = {0};
  refused(interacting);
  refused(flow, {.form = dem::BondForm::incremental});
  refused(flow, {.tolerance = 0});
  BOOST_CHECK_THROW(dem::integrate_in_flow<2>(flow, {1.0, 0.5}, {}, nothing), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::start_up(dem::simple_shear(1), 0), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::oscillation(dem::simple_shear(1), -1), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
