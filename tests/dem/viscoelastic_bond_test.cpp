// One bond with Maxwell branches: its loads are derivatives of its energy, rigid turns are nothing to it,
// what has relaxed forgets its path, and what it dissipates is Boltzmann's integral.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "dem/bond/branch_steps.hpp"
#include "dem/bond/laws/laws.hpp"
#include "dem/bond/laws/viscoelastic_bond.hpp"

BOOST_AUTO_TEST_SUITE(viscoelastic_bond_test)

namespace dem = fiberchain::dem;

namespace {

using V = dem::Vec<double, 3>;
using Pose = dem::Pose<double, 3>;
using Total = dem::ViscoelasticBond<dem::TotalBond>;
using Incremental = dem::ViscoelasticBond<dem::IncrementalBond>;

constexpr double never = 1e30;

dem::Fiber odd_fiber(dem::BondModel model, const dem::MaxwellBranches& branches) {
  dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 13, model, 0.7};
  fiber.branches = branches;
  return fiber;
}

/// Two branches beside every spring, each of its own strength, of these times.
dem::MaxwellBranches everywhere(double first, double second) {
  return {.stretch = {{0.31, first}, {0.11, second}},
          .shear = {{0.23, first}, {0.07, second}},
          .twist = {{0.41, first}, {0.05, second}},
          .bend = {{0.17, first}, {0.13, second}}};
}

V random_vector(std::mt19937& generator, double size) {
  std::normal_distribution<double> normal;
  return size * V{normal(generator), normal(generator), normal(generator)};
}

/// A bond of a law in space, moved by hand.
template <class Law>
struct Bond {
  dem::Fiber fiber;
  dem::BondParameters<double> law;
  Pose first, second;
  typename Law::template History<double, 3> history{};
  std::vector<double> memory;
  dem::RelativeMotion<double, 3> motion{};

  Bond(const dem::Fiber& of, const Pose& a, const Pose& b)
      : fiber(of), law(dem::bond_parameters(of)), first(a), second(b) {
    const dem::BranchSteps steps = dem::branch_steps(fiber, 0, 3);
    memory.assign(
        dem::branch_memory<Law::keeps_strain, 3>(steps.stretch, steps.shear, steps.twist, steps.bend), 0.0);
    if constexpr (dem::has_history<Law>) with([&](const auto& now) { history = Law::start(law, now); });
    loads(0);
  }

  template <class Use>
  void with(const Use& use) const {
    const auto line =
        dem::bond_vector<double, 3>(second.position - first.position, 1 / dem::bond_length(fiber));
    use(dem::BondConfiguration<double, 3>{first, second, line, motion});
  }
  /// Undamped, at the end of a step of dt that led here.
  dem::BondLoads<double, 3> loads(double dt) {
    const dem::BranchSteps steps = dem::branch_steps(fiber, dt, 3);
    dem::BondLoads<double, 3> found{};
    with([&](const auto& now) {
      found = Law::template loads<false>(law, steps.view(), history, memory.data(), now, dt);
    });
    return found;
  }
  double spent(double dt) const {
    const dem::BranchSteps steps = dem::branch_steps(fiber, dt, 3);
    double found = 0;
    with([&](const auto& now) {
      found = dem::branch_dissipation<Law::keeps_strain, 3>(law, steps.view(), memory.data(),
                                                            Law::strains(law, history, now, dt), dt > 0);
    });
    return found;
  }
  double energy() const {
    const dem::BranchSteps steps = dem::branch_steps(fiber, 0, 3);
    double found = 0;
    with([&](const auto& now) {
      found = Law::stored_energy(law, history, now) +
              dem::branch_energy<Law::keeps_strain, 3>(law, steps.view(), memory.data());
    });
    return found;
  }
  /// The two spheres move on with these velocities and spins for dt.
  dem::BondLoads<double, 3> move(const V& v1, const V& w1, const V& v2, const V& w2, double dt) {
    motion = {v2 - v1, 0.5 * (w1 + w2), w2 - w1};
    first = moved(first, dt * v1, dt * w1), second = moved(second, dt * v2, dt * w2);
    return loads(dt);
  }
  static Pose moved(const Pose& pose, const V& by, const V& turned) {
    return {pose.position + by, dem::cayley_turn(0.5 * turned, pose.orientation)};
  }
};

/// Straight along x but for strains of about `size`.
template <class Law>
Bond<Law> strained(const dem::Fiber& fiber, double size, unsigned seed) {
  std::mt19937 generator(seed);
  const double l = dem::bond_length(fiber);
  const Pose rest{{}, {1, {}}};
  const Pose a = Bond<Law>::moved(rest, random_vector(generator, size * l), random_vector(generator, size));
  const Pose b =
      Bond<Law>::moved(rest, V{l, 0, 0} + random_vector(generator, size * l), random_vector(generator, size));
  return {fiber, a, b};
}

double size_of(const dem::BondLoads<double, 3>& a, double length) {
  return dem::norm(a.force_on_first) * length + dem::norm(a.moment_on_first) + dem::norm(a.moment_on_second);
}

dem::BondLoads<double, 3> difference(const dem::BondLoads<double, 3>& a, const dem::BondLoads<double, 3>& b) {
  return {a.force_on_first - b.force_on_first, a.moment_on_first - b.moment_on_first,
          a.moment_on_second - b.moment_on_second};
}

/// Largest strain of a branch over that before it.
double largest_change(const std::vector<double>& before, const std::vector<double>& after) {
  double change = 0, size = 0;
  for (std::size_t n = 0; n < before.size(); ++n) {
    change = std::max(change, std::abs(after[n] - before[n]));
    size = std::max(size, std::abs(before[n]));
  }
  return change / size;
}

}  // namespace

// With branches that never relax the energy is a function of the poses; virtual work by differences.
BOOST_AUTO_TEST_CASE(loads_of_the_total_form_are_derivatives_of_energy_and_in_balance) {
  for (const auto model : {dem::BondModel::paper, dem::BondModel::corrected}) {
    const dem::Fiber fiber = odd_fiber(model, everywhere(never, 2 * never));
    const double l = dem::bond_length(fiber), h = 1e-6;
    Bond<Total> bond = strained<Total>(fiber, 0.2, 5);
    std::mt19937 generator(7);
    // strain the branches, in another way than the bond now is
    bond.first =
        Bond<Total>::moved(bond.first, random_vector(generator, 0.1 * l), random_vector(generator, 0.1));
    const dem::BondLoads<double, 3> loads = Bond<Total>(bond).loads(1);
    const V r = bond.second.position - bond.first.position;
    BOOST_TEST(dem::norm(loads.moment_on_first + loads.moment_on_second -
                         dem::cross(r, loads.force_on_first)) < 1e-13 * size_of(loads, l));
    for (int motion = 0; motion < 12; ++motion) {
      V unit{};
      unit[motion % 3] = 1;
      const bool turns = motion >= 6, second = motion % 6 >= 3;
      const auto energy_at = [&](double by) {
        Bond<Total> other = bond;
        Pose& pose = second ? other.second : other.first;
        pose = Bond<Total>::moved(pose, turns ? V{} : by * l * unit, turns ? by * unit : V{});
        other.loads(1);
        return other.energy();
      };
      const double slope = (energy_at(h) - energy_at(-h)) / (2 * h);
      const V& moment = second ? loads.moment_on_second : loads.moment_on_first;
      const double work =
          turns ? dem::dot(moment, unit) : (second ? -1 : 1) * l * dem::dot(loads.force_on_first, unit);
      BOOST_TEST(std::abs(work + slope) < 1e-8 * size_of(loads, l));
    }
  }
}

namespace {

/// Strain of the branches after the whole bond has turned by about two radians in `steps` steps.
template <class Law>
double change_in_a_rigid_turn(int steps) {
  const dem::Fiber fiber = odd_fiber(dem::BondModel::corrected, everywhere(never, 2 * never));
  Bond<Law> bond = strained<Law>(fiber, 0.05, 3);
  std::mt19937 generator(11);
  const double l = dem::bond_length(fiber);
  bond.move(random_vector(generator, 0.02 * l), random_vector(generator, 0.02), {}, {}, 1);
  const std::vector<double> before = bond.memory;
  const V spin = (1.0 / steps) * V{1.1, -0.7, 1.5};
  for (int n = 0; n < steps; ++n) {
    // chords of the circles on which the spheres go: a turn by the same half-angle tangent vector
    const auto chord = [&](const V& x) {
      const V t = 0.5 * spin, c = dem::cross(t, x);
      return (2 / (1 + dem::dot(t, t))) * (c + dem::cross(t, c));
    };
    bond.move(chord(bond.first.position), spin, chord(bond.second.position), spin, 1);
  }
  return largest_change(before, bond.memory);
}

}  // namespace

BOOST_AUTO_TEST_CASE(rigid_turns_leave_branches_as_they_are) {
  for (const int steps : {9, 40}) {
    BOOST_TEST(change_in_a_rigid_turn<Total>(steps) < 1e-13);
    BOOST_TEST(change_in_a_rigid_turn<Incremental>(steps) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(what_has_relaxed_forgets_its_path) {
  const dem::Fiber fiber = odd_fiber(dem::BondModel::corrected, everywhere(1, 3)),
                   elastic = odd_fiber(dem::BondModel::corrected, {});
  const double l = dem::bond_length(fiber);
  std::mt19937 generator(2);
  const Pose rest{{}, {1, {}}}, end{{l, 0, 0}, {1, {}}};
  Bond<Total> bond(fiber, rest, end);
  const V v = random_vector(generator, 0.03 * l), w = random_vector(generator, 0.1);
  for (int n = 0; n < 5; ++n)
    bond.move(random_vector(generator, 0.01 * l), random_vector(generator, 0.05), v, w, 1);
  Bond<Total> straight_there(elastic, bond.first, bond.second);
  const double scale = size_of(straight_there.loads(0), l);
  BOOST_TEST(size_of(difference(bond.loads(0), straight_there.loads(0)), l) > 0.05 * scale);
  bond.move({}, {}, {}, {}, 150);
  BOOST_TEST(size_of(difference(bond.loads(0), straight_there.loads(0)), l) < 1e-13 * scale);
}

// Bent to and fro, theta = a sin(w t): of a standard linear solid a cycle takes pi K a^2 g w tau / (1 + w^2
// tau^2). Steps of any length: the strain's rate is constant over each, which costs (w dt)^2 alone.
BOOST_AUTO_TEST_CASE(a_cycle_of_bending_takes_the_area_of_its_loop) {
  const double tau = 0.7, g = 0.3, a = 1e-3;
  const dem::Fiber fiber =
      odd_fiber(dem::BondModel::paper, {.stretch = {}, .shear = {}, .twist = {}, .bend = {{g, tau}}});
  const double K = dem::bond_stiffness(fiber).bend, l = dem::bond_length(fiber);
  for (const double w_tau : {0.01, 1.0, 100.0}) {
    const double w = w_tau / tau;
    const int steps = 720, cycles = 3 + static_cast<int>(8 * w_tau);
    const double dt = 2 * std::numbers::pi / (w * steps);
    Bond<Total> bond(fiber, {{}, {1, {}}}, {{l, 0, 0}, {1, {}}});
    double angle = 0, spent = 0, work = 0;
    for (int n = 1; n <= cycles * steps; ++n) {
      const double next = a * std::sin(w * dt * n), turn = next - angle;
      angle = next;
      const double before = bond.loads(0).moment_on_second[2];
      bond.first = Bond<Total>::moved(bond.first, {}, {0, 0, -0.5 * turn});
      bond.second = Bond<Total>::moved(bond.second, {}, {0, 0, 0.5 * turn});
      if (n > (cycles - 1) * steps) spent += bond.spent(dt);
      const double after = bond.loads(dt).moment_on_second[2];
      if (n > (cycles - 1) * steps) work -= 0.5 * (before + after) * turn;
    }
    const double exact = std::numbers::pi * K * a * a * g * w_tau / (1 + w_tau * w_tau);
    BOOST_TEST(spent == exact, boost::test_tools::tolerance(2e-4));
    BOOST_TEST(work == exact, boost::test_tools::tolerance(2e-3));
  }
}

BOOST_AUTO_TEST_CASE(a_branch_that_hardly_relaxes_is_a_spring_and_one_that_relaxes_at_once_is_none) {
  for (const double ratio : {1e-12, 1e-3, 0.3, 1.0, 50.0, 1e9}) {
    const dem::Fiber fiber =
        odd_fiber(dem::BondModel::paper, {.stretch = {{0.3, 1}}, .shear = {}, .twist = {}, .bend = {}});
    const dem::BranchStep<double> step = dem::branch_steps(fiber, ratio, 3).steps.at(0);
    const double E = std::exp(-ratio), gone = -std::expm1(-ratio);
    BOOST_TEST(step.keep == E, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(step.gain == gone / ratio, boost::test_tools::tolerance(1e-15));
    // what a spring of strain z loses as the bond stays: all that it stored but for E^2
    BOOST_TEST(step.spent_strain == -std::expm1(-2 * ratio) / 2, boost::test_tools::tolerance(1e-15));
    // bond strained by 1 at a constant rate from z = 0: work f-weighted less what is stored, by Simpson's
    // rule
    const int n = 4000;
    double sum = 0;
    for (int k = 0; k <= n; ++k) {
      const double u = ratio * k / n, z = -std::expm1(-u) / ratio;
      sum += (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2) * z * z;
    }
    if (ratio < 100)
      BOOST_TEST(step.spent_change == sum * ratio / (3.0 * n), boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(memory_is_what_the_branches_take) {
  const auto numbers = [](int count) {
    return std::array{dem::branch_memory<true, 3>(0, 0, 0, count),
                      dem::branch_memory<false, 3>(0, 0, 0, count)};
  };
  BOOST_TEST((numbers(0) == std::array<std::size_t, 2>{0, 0}));
  BOOST_TEST((numbers(5) == std::array<std::size_t, 2>{12, 10}));
  BOOST_TEST((dem::branch_memory<true, 3>(5, 5, 5, 5)) == 36u);
  BOOST_TEST((dem::branch_memory<false, 2>(5, 5, 5, 5)) == 15u);
}

BOOST_AUTO_TEST_SUITE_END()
