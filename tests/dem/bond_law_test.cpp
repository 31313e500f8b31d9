// The bond law against its own energy, by automatic differentiation: forces and moments are the first
// derivatives of U, the Jacobian the derivative of the forces and moments.
#include <array>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <random>

#include "dem/bond/tangent.hpp"
#include "tests/dem/dual.hpp"

BOOST_AUTO_TEST_SUITE(bond_law_test)

namespace dem = fiberchain::dem;

namespace {

template <int Dim>
constexpr int motions = 2 * dem::sphere_motions<Dim>;
template <int Dim>
using MotionDual = Dual<motions<Dim>>;

dem::Fiber odd_fiber(dem::BondModel model, double rest_angle) {
  dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 13, model, 0.7};
  fiber.rest_angle = rest_angle;
  return fiber;
}

template <class Real>
dem::BondParameters<Real> parameters(const dem::Fiber& fiber) {
  const dem::BondParameters<double> b = dem::bond_parameters(fiber);
  const dem::BondCoupling<double>& c = b.coupling;
  return {Real(b.stretch),
          Real(b.shear),
          Real(b.twist),
          Real(b.bend),
          Real(b.rest_length),
          Real(b.unbent_length),
          Real(b.chord),
          Real(b.rest_moment),
          {Real(c.shear), Real(c.bend), Real(c.arc_shear), Real(c.arc_twist), Real(c.arc_bend)},
          Real(b.dash_stretch),
          Real(b.dash_shear),
          Real(b.dash_twist),
          Real(b.dash_bend),
          {}};
}

template <int Dim>
using Pair = std::array<dem::Pose<double, Dim>, 2>;

/// Two spheres, strained and bent by `amount` in every way about their rest shape.
template <int Dim>
Pair<Dim> random_pair(double amount, unsigned seed, double l0, double rest_angle) {
  const double half = rest_angle / 2;
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Pair<Dim> pair;
  if constexpr (Dim == 2) {
    const double angle = normal(generator);
    pair[0] = {{0.3, -0.2}, angle - half + amount * normal(generator)};
    pair[1] = {{0.3 + l0 * (std::cos(angle) + 0.2 * amount * normal(generator)),
                -0.2 + l0 * (std::sin(angle) + 0.2 * amount * normal(generator))},
               angle + half + amount * normal(generator)};
  } else {
    const dem::Vec<double, 3> tilt{normal(generator), normal(generator), normal(generator)};
    const dem::Quaternion<double> frame = dem::rotation(tilt);
    const auto small = [&] {
      return dem::Vec<double, 3>{amount * normal(generator), amount * normal(generator),
                                 amount * normal(generator)};
    };
    const dem::Vec<double, 3> axis = dem::rotate(frame, {1, 0, 0});
    pair[0] = {{0.3, -0.2, 0.1}, dem::rotation(small()) * frame * dem::rotation({0, 0, -half})};
    pair[1] = {pair[0].position + l0 * (axis + 0.2 * small()),
               dem::rotation(small()) * frame * dem::rotation({0, 0, half})};
  }
  return pair;
}

/// The same pair as dual numbers of its motions: displacement and left rotation of each sphere.
template <int Dim>
std::array<dem::Pose<MotionDual<Dim>, Dim>, 2> moving(const Pair<Dim>& pair) {
  using Real = MotionDual<Dim>;
  std::array<dem::Pose<Real, Dim>, 2> poses;
  for (int i = 0; i < 2; ++i) {
    const int first = i * dem::sphere_motions<Dim>;
    for (int c = 0; c < Dim; ++c) poses[i].position[c] = Real(pair[i].position[c], first + c);
    if constexpr (Dim == 2) {
      poses[i].orientation = Real(pair[i].orientation, first + 2);
    } else {
      dem::Vec<Real, 3> half;
      for (int c = 0; c < 3; ++c) half[c] = Real(0.5) * Real(0.0, first + 3 + c);
      const dem::Quaternion<double>& q = pair[i].orientation;
      const dem::Quaternion<Real> fixed{Real(q.w), {Real(q.v[0]), Real(q.v[1]), Real(q.v[2])}};
      poses[i].orientation = dem::Quaternion<Real>{Real(1.0), half} * fixed;
    }
  }
  return poses;
}

template <class Real, int Dim>
std::array<Real, motions<Dim>> load_components(const dem::BondLoads<Real, Dim>& loads) {
  constexpr int n = dem::sphere_motions<Dim>;
  std::array<Real, motions<Dim>> all;
  for (int c = 0; c < Dim; ++c) all[c] = loads.force_on_first[c], all[n + c] = -loads.force_on_first[c];
  for (int c = 0; c < dem::spin_size<Dim>; ++c) {
    all[Dim + c] = loads.moment_on_first[c];
    all[n + Dim + c] = loads.moment_on_second[c];
  }
  return all;
}

/// Natural size of a force (c < Dim) or a moment component, to make errors relative.
double load_scale(const dem::BondParameters<double>& b, int component, int dim) {
  const double force = b.stretch * b.rest_length;
  return component < dim ? force : force * b.rest_length;
}

template <int Dim>
void check_forces_and_jacobian(dem::BondModel model, double rest_angle, double amount, unsigned seed) {
  using Real = MotionDual<Dim>;
  constexpr int n = dem::sphere_motions<Dim>;
  const dem::Fiber fiber = odd_fiber(model, rest_angle);
  const auto b = parameters<double>(fiber);
  const Pair<Dim> pair = random_pair<Dim>(amount, seed, b.rest_length, rest_angle);
  const auto poses = moving<Dim>(pair);
  const auto bond = parameters<Real>(fiber);
  const auto k = dem::bond_kinematics(poses[0], poses[1]);
  const Real energy = dem::bond_energy<Real, Dim>(bond, k.separation, k.rotation);
  const auto loads = dem::bond_loads(k, dem::bond_stress<Real, Dim>(bond, k.separation, k.rotation));
  const auto components = load_components<Real, Dim>(loads);
  const auto tangent = dem::bond_tangent(b, dem::bond_kinematics(pair[0], pair[1]));
  for (int i = 0; i < motions<Dim>; ++i) {
    const double scale = load_scale(b, i % n, Dim);
    BOOST_TEST_CONTEXT("component " << i << " amount " << amount << " arc " << rest_angle << " seed "
                                    << seed) {
      BOOST_TEST(std::abs(components[i].value() + energy.derivative(i)) / scale < 2e-15);
      for (int j = 0; j < motions<Dim>; ++j) {
        const double unit = j % n < Dim ? b.rest_length : 1.0;
        BOOST_TEST(std::abs(tangent(i, j) - components[i].derivative(j)) / scale * unit < 2e-14,
                   i << "," << j << ": " << tangent(i, j) << " against " << components[i].derivative(j));
      }
    }
  }
}

}  // namespace

BOOST_DATA_TEST_CASE(loads_are_derivatives_of_the_energy_and_the_jacobian_of_the_loads,
                     boost::unit_test::data::make({1e-9, 1e-4, 0.01, 0.1, 0.3, 0.6}), amount) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    for (const auto model : {dem::BondModel::paper, dem::BondModel::corrected}) {
      for (const double rest_angle : {0.0, -0.31}) {
        check_forces_and_jacobian<2>(model, rest_angle, amount, seed);
        check_forces_and_jacobian<3>(model, rest_angle, amount, seed);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
