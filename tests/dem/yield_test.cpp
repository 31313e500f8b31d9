// Bonds that bend plastically: loops of moment against angle, where their work goes.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "dem/bond/laws/failing_bond.hpp"
#include "tests/dem/assembly/breaking_scenes.hpp"

BOOST_AUTO_TEST_SUITE(yield_test)

using namespace scenes;

namespace {

constexpr double yield_angle = 0.0123;  ///< M_y / K [rad]

dem::Fiber hinge(double hardening, int bonds = 1) {
  dem::Fiber fiber = odd_fiber(bonds);
  fiber.yield = dem::BondYield{dem::bond_stiffness(fiber).bend * yield_angle, hardening};
  return fiber;
}

/// Angle to and fro, and where it turns in units of the yield angle.
const std::vector<double> turns = {4.2, -3.1, 5.5, 0.4, 2.0, -6.0};

/// The hinge in closed form over K: elastic up to a yield moment that rises with the plastic angle, moment
/// and work where each stroke ends.
struct Hinge {
  double hardening, moment = 0, yield = yield_angle, angle = 0, work = 0;

  void go(double to) {
    const double way = std::abs(to - angle), side = to > angle ? 1 : -1;
    const double elastic = std::min(way, yield - side * moment);
    moment += side * elastic;
    const double beyond = way - elastic, rise = hardening * beyond, plastic = beyond - rise;
    moment += side * rise;
    work += (yield + 0.5 * rise) * plastic;
    yield += rise;
    angle = to;
  }
};

template <class Base>
struct Bent {
  using Law = dem::FailingBond<Base>;
  dem::BondParameters<double> bond;
  dem::BondLawHistory<Law, double, 3> history;
  double angle = 0;
  V axis;  ///< of the bending, across x

  Bent(const dem::Fiber& fiber, V about) : bond(dem::bond_parameters(fiber)), axis(about) {
    bond.own[dem::inverse_radius_place] = 4 / fiber.diameter;
    bond.own[dem::hardening_place] = fiber.yield->hardening / (1 - fiber.yield->hardening) * bond.bend;
    at(0, [&](const dem::BondConfiguration<double, 3>& now) { history = Law::start(bond, now); });
    history.failure.yield = fiber.yield->moment;
  }

  template <class Use>
  void at(double rate, const Use& use) {
    const double l = bond.rest_length;
    const dem::Pose<double, 3> first{{0, 0, 0}, dem::rotation(-0.5 * angle * axis)},
        second{{l, 0, 0}, dem::rotation(0.5 * angle * axis)};
    const auto line = dem::bond_vector<double, 3>(V{l, 0, 0}, 1 / l);
    const dem::RelativeMotion<double, 3> motion{{}, {}, rate * axis};
    use(dem::BondConfiguration<double, 3>{first, second, line, motion});
  }

  /// The moment about the axis where the bond is bent so far.
  double go(double to) {
    const double change = to - angle;
    angle = to;
    double moment = 0;
    at(change, [&](const dem::BondConfiguration<double, 3>& now) {
      moment = dot(Law::loads(bond, history, now, 1.0).moment_on_first, axis);
    });
    return moment;
  }
};

template <class Base>
void follows_the_loop(double hardening) {
  const dem::Fiber fiber = hinge(hardening);
  const double K = dem::bond_stiffness(fiber).bend;
  Bent<Base> bond(fiber, {0, 0.6, -0.8});
  Hinge closed{hardening};
  double area = 0, largest = 0;
  for (const double turn : turns) {
    const int steps = 400;
    const double from = closed.angle, to = turn * yield_angle;
    for (int n = 1; n <= steps; ++n) {
      const double next = from + (to - from) * n / steps, before = closed.moment, work = closed.work;
      const double way = next - closed.angle;
      closed.go(next);
      const double moment = bond.go(next);
      largest = std::max(largest, std::abs(moment / K - closed.moment));
      // but in the step that yields first the moment is a straight line
      if (work > 0 || closed.work == 0) area += 0.5 * (before + closed.moment) * way;
    }
    BOOST_TEST(std::abs(bond.history.failure.work / K - closed.work) < 1e-12 * yield_angle);
  }
  BOOST_TEST(largest < 1e-12 * yield_angle, Base::name << ", hardening " << hardening << ": " << largest);
  // what goes in is what is stored and what is lost
  const double stored = 0.5 * closed.moment * closed.moment;
  BOOST_TEST(std::abs(area - stored - closed.work) < 2e-3 * closed.work);
  BOOST_TEST(closed.work > 10 * yield_angle * yield_angle);
}

}  // namespace

BOOST_AUTO_TEST_CASE(moment_follows_the_loop_of_a_hinge) {
  for (const double hardening : {0.0, 0.13}) {
    follows_the_loop<dem::TotalBond>(hardening);
    follows_the_loop<dem::IncrementalBond>(hardening);
  }
}

namespace {

/// A bond whose spheres begin to turn against each other, fast enough to yield; its energy off by, at the
/// end.
struct Swing {
  double error, lost, rest;
};

Swing swing(double hardening, dem::BondForm form, double step, dem::Integrator scheme) {
  const dem::Fiber fiber = hinge(hardening, 3);
  dem::FiberGroup group{dem::straight_chain<3>(fiber),
                        {dem::at_rest<3>(dem::straight_chain<3>(fiber).poses)}};
  const double rate =
      5 * yield_angle * std::sqrt(dem::bond_stiffness(fiber).bend / dem::sphere_inertia(fiber));
  for (int i = 0; i <= 3; ++i) {
    group.fibers[0].spin[i] = (i - 1.5) * rate * V{0, 0.6, 0.8};
    group.fibers[0].velocity[i] = 0.1 * rate * fiber.diameter * V{0, (i % 2) - 0.5, 0.3};
  }
  dem::Assembly assembly({group}, {},
                         {.step = step * dem::bond_time_step(fiber),
                          .integrator = scheme,
                          .form = form,
                          .account_energy = true});
  const double before = dem::total(assembly.energy());
  assembly.march(std::llround(30 / step));
  const dem::EnergyBalance energy = assembly.energy();
  double rest = 0;
  for (const dem::BondState& bond : assembly.bonds(0, 0)) rest = std::max(rest, bond.bending_angle);
  return {std::abs(dem::total(energy) / before - 1), energy.yielding / before, rest};
}

}  // namespace

BOOST_AUTO_TEST_CASE(plastic_work_is_booked_to_second_order) {
  for (const auto scheme : {dem::Integrator::leapfrog, dem::Integrator::leapfrog_stiff}) {
    for (const dem::BondForm form : {dem::BondForm::total, dem::BondForm::incremental}) {
      for (const double hardening : {0.0, 0.2}) {
        const Swing coarse = swing(hardening, form, 0.04, scheme),
                    fine = swing(hardening, form, 0.01, scheme);
        BOOST_TEST_MESSAGE(name(scheme)
                           << ", " << name(form) << ", hardening " << hardening << ": " << fine.lost
                           << " lost, energy off by " << coarse.error << ", " << fine.error);
        BOOST_TEST(fine.lost > 0.2);
        BOOST_TEST(fine.error < 1e-3);
        BOOST_TEST(fine.error < 0.2 * coarse.error + 2e-5);
      }
    }
  }
}

/// A rod whose ends are turned by a moment beyond the yield moment keeps a curvature when they are let go:
/// what is beyond it over the hardening, less what springs back.
BOOST_AUTO_TEST_CASE(a_rod_that_yielded_stays_bent) {
  for (const dem::BondForm form : {dem::BondForm::total, dem::BondForm::incremental}) {
    const double hardening = 0.25, load = 1.6;
    dem::Fiber fiber = hinge(hardening, 6);
    fiber.bond_damping = 3;
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    dem::Grip clamp, turn, back;
    clamp.place = clamp.turn = {true, true, true}, clamp.spheres = {{0, 0, 0}};
    turn.moment = {0, 0, load * fiber.yield->moment}, turn.spheres = {{0, 0, 6}};
    const double period = 4e3 * dem::bond_time_step(fiber);
    turn.ramp = 3 * period;
    back = turn, back.moment = -turn.moment, back.body.active_from = 4 * period;
    dem::Assembly assembly({{chain, {dem::at_rest<3>(chain.poses)}}}, {},
                           {.integrator = dem::Integrator::leapfrog_stiff,
                            .form = form,
                            .account_energy = true,
                            .grips = {clamp, turn, back}});
    assembly.march(static_cast<int>(4 * period / assembly.step()));
    for (const dem::BondState& bond : assembly.bonds(0, 0)) {
      // the incremental strain is the elastic part
      const double expected = form == dem::BondForm::total ? 1 + (load - 1) / hardening : load;
      BOOST_TEST(std::abs(bond.bending_angle / (expected * yield_angle) - 1) < 0.02);
    }
    assembly.march(static_cast<int>(4 * period / assembly.step()));
    const dem::ChainState<3> end = assembly.state(0, 0);
    const double stays = (load - 1) / hardening - (load - 1);
    for (int i = 0; i < 6; ++i) {
      const auto relative = dem::conjugate(end.poses[i].orientation) * end.poses[i + 1].orientation;
      const double angle = 2 * std::atan2(norm(relative.v), relative.w);
      BOOST_TEST(std::abs(angle / (stays * yield_angle) - 1) < 0.02,
                 name(form) << ", bond " << i << ": " << angle / yield_angle << ", expected " << stays);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
