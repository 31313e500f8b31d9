// Collisions of two spheres, and of a sphere and a wall, through the whole engine: against Hertz's closed
// forms, and against CVODE where they are oblique.
#include <boost/test/unit_test.hpp>

#include "dem/contact/restitution.hpp"
#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(two_body_contact_test)

using namespace transverse;

namespace {

const dem::Fiber soft = fiber_of(2.6e6, 0.31, 1130, 1.66e-3), hard = fiber_of(7.1e6, 0.22, 2410, 1.66e-3),
                 large = fiber_of(4.4e6, 0.41, 610, 3.9e-3);

struct Outcome {
  double time, overlap, force;
  ref::PlanarMotion first, second;
  double astray;  ///< out of the plane or unlike
};

/// A collision of `first` with `second`, or with the wall where there is none, in `steps` steps of Hertz's
/// time.
struct Collision {
  dem::Fiber first;
  const dem::Fiber* second;
  dem::Domain around;
  double steps = 1500;
  dem::AssemblyOptions options{};
  double phase = 0.37;  ///< part of a step at which they touch

  Outcome run(const ref::PlanarMotion& one, const ref::PlanarMotion& two) {
    const ref::HertzPair pair = ref::hertz_pair(body_of(first), second ? body_of(*second) : wall_of(around));
    const double closing = one.velocity[0] - two.velocity[0], R = dem::sphere_radius(first);
    const double dt = ref::hertz_collision(pair, closing).time / steps, gap = phase * dt * closing;
    std::vector<dem::FiberGroup> groups;
    if (second) {
      const double reach = R + dem::sphere_radius(*second);
      groups = {group_of(first, 0, 0, one),
                group_of(*second, reach + gap, -phase * dt * (two.velocity[1] - one.velocity[1]), two)};
    } else {
      // the wall's x at the touch is 0
      groups = {group_of(first, -R - gap, 0, one)};
      around.walls = {{dem::Plane{{}, tilted(-1, 0, 0)}, tilted(two.velocity[0], two.velocity[1], 0)}};
    }
    options.step = dt;
    dem::Assembly assembly(groups, around, options);
    Outcome o{};
    bool touched = false;
    V before = assembly.state(0, 0).velocity[0];
    for (int n = 0; n < 6 * steps && !(touched && assembly.touching() == 0); ++n) {
      assembly.march(1);
      const V now = assembly.state(0, 0).velocity[0];
      if (norm(now - before) > 1e-12 * closing) o.time += dt;
      before = now;
      touched = touched || assembly.touching() > 0;
      for (const auto& contact : assembly.contacts()) {
        o.overlap = std::max(o.overlap, contact.overlap);
        o.force = std::max(o.force, norm(contact.force));
      }
      o.astray = std::max(o.astray, out_of_plane(assembly, 0) / closing);
    }
    BOOST_TEST(assembly.touching() == 0);
    o.first = motion_of(assembly, 0);
    o.second = second ? motion_of(assembly, 1) : two;
    return o;
  }
};

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

dem::Domain elastic_walls() {
  dem::Domain around;
  around.wall_youngs_modulus = 3.3e7;
  around.wall_poisson_ratio = 0.37;
  return around;
}

}  // namespace

BOOST_AUTO_TEST_CASE(head_on_collisions_are_hertz_to_a_thousandth) {
  struct Pair {
    const dem::Fiber* first;
    const dem::Fiber* second;
    dem::Domain around;
  };
  double worst = 0;
  for (const Pair& pair : {Pair{&soft, &soft, {}},
                           {&soft, &hard, {}},
                           {&hard, &soft, {}},
                           {&large, nullptr, {}},
                           {&soft, nullptr, elastic_walls()}}) {
    for (const double e : {1.0, 0.83, 0.4, 0.17}) {
      for (const double speed : {0.021, 0.7}) {
        Collision collision{*pair.first, pair.second, pair.around, 3000};
        collision.around.contacts = {e, 0.6, 0.02};
        const double zeta = dem::damping_ratio_for(e);
        const ref::HertzPair hertz =
            ref::hertz_pair(body_of(*pair.first), pair.second ? body_of(*pair.second) : wall_of(pair.around));
        const auto closed = ref::damped_hertz_collision(hertz, zeta, speed);
        const auto hit = collision.run({{0.31 * speed, 0}, 0}, {{-0.69 * speed, 0}, 0});
        within(hit.time / closed.time, 1, 1e-3, "time");  // it is counted in whole steps
        within(hit.overlap / closed.overlap, 1, 1e-4, "overlap");
        const double after = hit.second.velocity[0] - hit.first.velocity[0];
        within(after / speed, e, 2e-4 * e, "restitution");
        within(closed.restitution, e, 1e-12, "reference");
        BOOST_TEST(hit.astray < 1e-11);
        worst = std::max(worst, std::abs(after / speed / e - 1));
        if (e == 1) within(hit.force / ref::hertz_collision(hertz, speed).force, 1, 1e-3, "force");
        if (pair.second) {
          const double m1 = dem::sphere_mass(*pair.first), m2 = dem::sphere_mass(*pair.second);
          within((m1 * hit.first.velocity[0] + m2 * hit.second.velocity[0]) / speed, 0.31 * m1 - 0.69 * m2,
                 1e-12 * (m1 + m2), "momentum");
        }
      }
    }
  }
  BOOST_TEST_MESSAGE("head on: restitution off by at most " << worst);
}

/// Squares of distances tell who touches; where they differ by round-off, roots may say the opposite.
BOOST_AUTO_TEST_CASE(spheres_that_touch_by_round_off_do_nothing_to_each_other) {
  int touch = 0;
  for (const auto set : {dem::InstructionSet::scalar, dem::best_instruction_set()}) {
    for (int k = 50; k < 400; ++k) {
      const double R = 1e-5 * k;
      const dem::Fiber fiber = fiber_of(1e7, 0.3, 1000, 2 * R);
      const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
      dem::FiberGroup group{chain, {}};
      for (const V& place : {V{0, 0, 0}, V{0, 2 * R, 0}, V{0, R, std::sqrt(3.0) * R}, V{0, 0, -2 * R}}) {
        group.fibers.push_back(dem::placed(chain, {place, V{1, 0, 0}}));
      }
      dem::Assembly assembly({group}, {}, {.instruction_set = set});
      touch += static_cast<int>(assembly.touching());
      assembly.march(3);
      for (int f = 0; f < 4; ++f)
        BOOST_TEST(norm(assembly.state(0, f).velocity[1]) < 1e-12, "R = " << R << ", fiber " << f);
    }
  }
  BOOST_TEST(touch > 100);
}

/// Faster than the list of near pairs is wide.
BOOST_AUTO_TEST_CASE(spheres_that_part_within_a_step_leave_no_contact_behind) {
  const dem::Fiber fiber = fiber_of(1e5, 0.3, 1000, 2e-3);
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::Domain around;
  dem::AssemblyOptions options{.step = 2e-6};
  const double away = 0.35 * dem::sphere_radius(fiber) / *options.step;
  dem::Assembly assembly({{chain,
                           {dem::placed(chain, {V{}, V{1, 0, 0}}),
                            dem::placed(chain, {V{0, 1.999e-3, 0}, V{1, 0, 0}, V{0, away, 0}})}}},
                         around, options);
  BOOST_TEST(assembly.touching() == 2);
  BOOST_TEST(assembly.energy().contacts > 0);
  assembly.march(1);
  BOOST_TEST(assembly.touching() == 0);
  BOOST_TEST(assembly.energy().contacts == 0);
}

BOOST_AUTO_TEST_CASE(restitution_holds_at_the_step_of_a_packing) {
  // 40 steps a collision, which begins anywhere within a step
  for (const double e : {1.0, 0.5, 0.4}) {
    double least = 1, most = -1;
    for (const double phase : {0.02, 0.2, 0.37, 0.6, 0.8, 0.98}) {
      Collision collision{soft, &hard, {}, 40, {}, phase};
      collision.around.contacts = {e, 0.3};
      const auto hit = collision.run({{0.4, 0}, 0}, {});
      const double off = (hit.second.velocity[0] - hit.first.velocity[0]) / (0.4 * e) - 1;
      least = std::min(least, off), most = std::max(most, off);
    }
    BOOST_TEST_MESSAGE("restitution " << e << " at 40 steps a collision is off by " << least << " to "
                                      << most);
    BOOST_TEST(least > -0.012);
    BOOST_TEST(most < 0.012);
    if (e < 1) BOOST_TEST(most - least > 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(oblique_impact_sticks_and_slides_as_the_differential_equations_say) {
  double worst = 0;
  int sticks = 0, slides = 0, changes = 0;
  for (const double e : {1.0, 0.4, 0.71}) {
    for (const double mu : {0.07, 0.6}) {
      for (const double across : {-0.03, 0.11, 0.31, 1.3}) {
        for (const dem::Fiber* second : {&hard, static_cast<const dem::Fiber*>(nullptr)}) {
          Collision collision{soft, second, elastic_walls()};
          collision.around.contacts = {e, mu};
          const ref::PlanarMotion one{{0.37, across}, 83},
              two = second ? ref::PlanarMotion{{-0.21, 0.05}, -29} : ref::PlanarMotion{{-0.13, 0.02}, 0};
          const auto exact =
              ref::collide(body_of(soft), second ? body_of(*second) : wall_of(collision.around),
                           {dem::damping_ratio_for(e), mu}, one, two);
          const auto hit = collision.run(one, two);
          const double speed = one.velocity[0] - two.velocity[0], R = dem::sphere_radius(soft);
          const auto compare = [&](const ref::PlanarMotion& a, const ref::PlanarMotion& b) {
            for (int k = 0; k < 2; ++k)
              worst = std::max(worst, std::abs(a.velocity[k] - b.velocity[k]) / speed);
            worst = std::max(worst, std::abs(a.spin - b.spin) * R / speed);
          };
          compare(hit.first, exact.first);
          if (second) compare(hit.second, exact.second);
          within(hit.overlap / exact.overlap, 1, 1e-3, "overlap");
          BOOST_TEST(hit.astray < 1e-11);
          exact.starts_sliding ? ++slides : ++sticks;
          changes += exact.changes;
        }
      }
    }
  }
  BOOST_TEST_MESSAGE("oblique impact: velocities and R spin off by "
                     << worst << " of the closing speed; " << sticks << " start sticking, " << slides
                     << " sliding");
  BOOST_TEST(worst < 1e-3);  // the tangential dashpot lags
  BOOST_TEST(worst > 1e-8);
  BOOST_TEST(sticks > 8);
  BOOST_TEST(slides > 8);
  BOOST_TEST(changes > 20);
}

BOOST_AUTO_TEST_CASE(every_form_and_instruction_set_collides_alike) {
  const ref::PlanarMotion one{{0.37, 0.31}, 83}, two{{-0.21, 0.05}, -29};
  std::vector<Outcome> all;
  for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
    for (const auto set : {dem::InstructionSet::scalar, dem::best_instruction_set()}) {
      for (const bool accounted : {false, true}) {
        Collision collision{
            soft, &hard, {}, 300, {.form = form, .account_energy = accounted, .instruction_set = set}};
        collision.around.contacts = {0.6, 0.2};
        all.push_back(collision.run(one, two));
      }
    }
  }
  for (const Outcome& o : all) {
    for (int k = 0; k < 2; ++k) within(o.second.velocity[k], all[0].second.velocity[k], 1e-11, "velocity");
    within(o.first.spin, all[0].first.spin, 1e-8, "spin");
    within(o.overlap / all[0].overlap, 1, 1e-11, "overlap");
  }
}

BOOST_AUTO_TEST_SUITE_END()
