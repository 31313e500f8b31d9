// Large deflections where the answer is known without a beam theory: rings, frames, loading paths.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(equilibrium_test)

namespace dem = fiberchain::dem;
using std::numbers::pi;

namespace {

dem::Fiber odd_fiber(int aspect_ratio, dem::BondModel model = dem::BondModel::paper) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, aspect_ratio, model};
}

template <int Dim>
double distance(const dem::Poses<Dim>& a, const dem::Poses<Dim>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, dem::norm(a[i].position - b[i].position));
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(end_moment_closes_the_chain_to_a_ring) {
  for (const int bonds : {13, 40}) {
    const dem::Fiber fiber = odd_fiber(bonds);
    const double M = 2 * pi * dem::bending_stiffness(fiber) / dem::fiber_length(fiber);
    const auto flat =
        dem::solve_equilibrium(dem::straight_chain<2>(fiber), dem::Boundary<2>{{0}, {{bonds, {}, {M}}}});
    BOOST_TEST(dem::norm(flat.poses.back().position) / dem::fiber_length(fiber) < 1e-10);
    BOOST_TEST(std::abs(flat.poses.back().orientation - 2 * pi) < 1e-10);
    const auto spatial = dem::solve_equilibrium(dem::straight_chain<3>(fiber),
                                                dem::Boundary<3>{{0}, {{bonds, {}, {0, 0.6 * M, 0.8 * M}}}});
    BOOST_TEST(dem::norm(spatial.poses.back().position) / dem::fiber_length(fiber) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(corrected_ring_has_the_perimeter_of_the_arc) {
  // no force, so every bond has its rest length l0 (1 - theta^2/24): chord of the arc to fourth order
  const int bonds = 13;
  const dem::Fiber fiber = odd_fiber(bonds, dem::BondModel::corrected);
  const double theta = 2 * pi / bonds, M = dem::bond_stiffness(fiber).bend * theta;
  const auto ring =
      dem::solve_equilibrium(dem::straight_chain<2>(fiber), dem::Boundary<2>{{0}, {{bonds, {}, {M}}}});
  const double bond = dem::norm(ring.poses[5].position - ring.poses[4].position) / dem::bond_length(fiber);
  BOOST_TEST(std::abs(bond - (1 - theta * theta / 24)) < 1e-12);
  const double arc_error = std::abs(bond - std::sin(theta / 2) / (theta / 2));
  const double fourth_order = std::pow(theta, 4) / 1920;
  BOOST_TEST(arc_error > 0.98 * fourth_order);
  BOOST_TEST(arc_error < 1.02 * fourth_order);
}

BOOST_AUTO_TEST_CASE(spatial_law_gives_the_planar_answer_in_any_rotated_frame) {
  for (const auto model : {dem::BondModel::paper, dem::BondModel::corrected}) {
    const dem::Fiber fiber = odd_fiber(13, model);
    const double P = dem::load_force(fiber, 4.3), L = dem::fiber_length(fiber);
    const auto flat = dem::solve_equilibrium(dem::straight_chain<2>(fiber),
                                             dem::Boundary<2>{{0}, {{13, {0.3 * P, P}, {0.1 * P * L}}}});
    for (const dem::Vec<double, 3> tilt :
         {dem::Vec<double, 3>{0, 0, 0}, {0.7, -1.9, 0.4}, {2.2, 1.1, -1.6}}) {
      const dem::Quaternion<double> frame = dem::rotation(tilt);
      dem::Chain<3> chain = dem::straight_chain<3>(fiber);
      for (auto& pose : chain.poses) pose = {dem::rotate(frame, pose.position), frame * pose.orientation};
      const dem::Load<3> load{13, dem::rotate(frame, {0.3 * P, P, 0}),
                              dem::rotate(frame, {0, 0, 0.1 * P * L})};
      const auto spatial = dem::solve_equilibrium(chain, dem::Boundary<3>{{0}, {load}});
      for (int i = 0; i <= 13; ++i) {
        const auto back = dem::rotate(dem::conjugate(frame), spatial.poses[i].position);
        BOOST_TEST(std::abs(back[0] - flat.poses[i].position[0]) / L < 1e-10);
        BOOST_TEST(std::abs(back[1] - flat.poses[i].position[1]) / L < 1e-10);
        BOOST_TEST(std::abs(back[2]) / L < 1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(work_of_the_load_is_the_elastic_energy) {
  // d(energy)/d(load) = load * d(deflection)/d(load): by central difference around the same equilibrium
  const dem::Fiber fiber = odd_fiber(13, dem::BondModel::corrected);
  const auto chain = dem::straight_chain<3>(fiber);
  const auto at = [&](double load) {
    const double P = dem::load_force(fiber, load);
    return dem::solve_equilibrium(chain, dem::Boundary<3>{{0}, {{13, {0, 0.6 * P, 0.8 * P}, {}}}});
  };
  const double h = 1e-4, P = dem::load_force(fiber, 2.7);
  const auto below = at(2.7 - h), above = at(2.7 + h);
  const auto moved = above.poses.back().position - below.poses.back().position;
  const double work = P * (0.6 * moved[1] + 0.8 * moved[2]);
  const double energy = dem::elastic_energy(chain, above.poses) - dem::elastic_energy(chain, below.poses);
  BOOST_TEST(std::abs(energy / work - 1) < 1e-7);
}

BOOST_AUTO_TEST_CASE(corner_rests_alike_whatever_the_path_and_the_numbering) {
  const dem::Fiber fiber = odd_fiber(12);
  const dem::Chain<3> chain = dem::cornered_chain<3>(fiber, 6);
  const double arm = 6 * dem::bond_length(fiber);
  for (const double load : {0.1, 1.0, 3.0}) {
    const double P = load * dem::bending_stiffness(fiber) / (arm * arm);
    const dem::Boundary<3> final{{0}, {{12, {0, 0, P}, {}}}},
        detour{{0}, {{12, {0.8 * P, -0.5 * P, 0.2 * P}, {}}}};
    const auto straight = dem::solve_equilibrium(chain, final);
    const auto halfway = dem::solve_equilibrium(chain, detour);
    const auto around = dem::continue_equilibrium(chain, halfway.poses, detour, final);
    BOOST_TEST(distance(straight.poses, around.poses) / arm < 1e-8);

    const dem::Boundary<3> other_end{{12}, {{0, {0, 0, P}, {}}}};
    auto backward = dem::solve_equilibrium(dem::renumbered(chain), other_end).poses;
    std::reverse(backward.begin(), backward.end());
    BOOST_TEST(distance(straight.poses, backward) / arm < 1e-8);
    BOOST_TEST(dem::norm(straight.poses.back().position - chain.poses.back().position) / arm > 0.01);
  }
}

BOOST_AUTO_TEST_CASE(corner_is_free_of_stress_at_rest) {
  const dem::Chain<3> chain = dem::cornered_chain<3>(odd_fiber(12), 6);
  const double force = dem::axial_stiffness(chain.fiber);
  for (const auto& v : dem::bond_forces(chain, chain.poses)) BOOST_TEST(v.norm() / force < 1e-14);
  const dem::Chain<3> other = dem::renumbered(chain);
  for (const auto& v : dem::bond_forces(other, other.poses)) BOOST_TEST(v.norm() / force < 1e-14);
}

BOOST_AUTO_TEST_CASE(both_ends_clamped_share_a_load_at_the_middle) {
  const dem::Fiber fiber = odd_fiber(12);
  const double P = dem::load_force(fiber, 5.0);
  const auto found =
      dem::solve_equilibrium(dem::straight_chain<2>(fiber), dem::Boundary<2>{{0, 12}, {{6, {0, P}, {}}}});
  for (int i = 0; i <= 6; ++i) {
    BOOST_TEST(std::abs(found.poses[i].position[1] - found.poses[12 - i].position[1]) < 1e-14);
  }
  BOOST_TEST(found.residual.force < 1e-8);
}

BOOST_AUTO_TEST_CASE(newton_iterations_do_not_grow_with_the_length_of_the_chain) {
  const auto iterations = [](int bonds) {
    const dem::Fiber fiber = odd_fiber(bonds);
    const double P = dem::load_force(fiber, 5.0);
    return dem::solve_equilibrium(dem::straight_chain<2>(fiber), dem::Boundary<2>{{0}, {{bonds, {0, P}, {}}}})
        .statistics.newton_iterations;
  };
  BOOST_TEST(std::abs(iterations(1000) - iterations(20)) <= 3);
}

BOOST_AUTO_TEST_CASE(refuses_boundaries_that_make_no_sense) {
  const auto chain = dem::straight_chain<2>(odd_fiber(13));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(dem::solve_equilibrium(chain, dem::Boundary<2>{{}, {{13, {0, 1}, {}}}}),
                    dem::InvalidInput);
  BOOST_CHECK_THROW(dem::solve_equilibrium(chain, dem::Boundary<2>{{0}, {{14, {0, 1}, {}}}}),
                    dem::InvalidInput);
  BOOST_CHECK_THROW(dem::solve_equilibrium(chain, dem::Boundary<2>{{-1}, {{13, {0, 1}, {}}}}),
                    dem::InvalidInput);
  BOOST_CHECK_THROW(dem::solve_equilibrium(chain, dem::Boundary<2>{{0}, {{13, {0, nan}, {}}}}),
                    dem::InvalidInput);
  BOOST_CHECK_THROW(dem::cornered_chain<2>(odd_fiber(13), 13), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(gives_up_with_the_load_it_reached) {
  const auto chain = dem::straight_chain<2>(odd_fiber(13));
  const double P = dem::load_force(chain.fiber, 1e3);
  BOOST_CHECK_EXCEPTION(
      dem::solve_equilibrium(chain, dem::Boundary<2>{{0}, {{13, {0, P}, {}}}}, {.max_load_steps = 2}),
      dem::NoConvergence, [](const dem::NoConvergence& error) {
        return std::string(error.what()).find("of the load") != std::string::npos;
      });
}

BOOST_AUTO_TEST_SUITE_END()
