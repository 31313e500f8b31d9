// The largest stable step with contacts, by bisection, against the one that is chosen.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/contact/contact_rates.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(contact_step_test)

using namespace scenes;

namespace {

/// A fiber of two spheres between two rigid plates that press it in, all but at rest.
struct Squeezed {
  double overlap;  ///< over R
  dem::ContactProperties rules;

  dem::Fiber fiber() const { return {dem::isotropic_material(2.6e6, 0.3, 1000), 2e-3, 1}; }
  dem::Domain around() const {
    dem::Domain s;
    s.contacts = rules;
    const double at = 1e-3 * (1 - overlap);
    s.walls = {side({0, 0, at}, {0, 0, 1}), side({0, 0, -at}, {0, 0, -1})};
    for (dem::Wall& wall : s.walls)
      wall.shape.get_if<dem::Plane>()->point = -wall.shape.get_if<dem::Plane>()->point;
    return s;
  }
  /// Whether what moves it does not grow. Both spheres move alike: the bond has no part in it.
  bool stable(double step) const {
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber());
    dem::ChainState<3> state = dem::placed(chain, {{0, 0, 0}, {1, 0, 0}});
    for (int i : {0, 1}) state.velocity[i] = 1e-9 * V{0, 1.1, 0.7}, state.spin[i] = 1e-6 * V{0.8, 0, 0};
    dem::Assembly assembly({{chain, {state}}}, around(), {.step = step});
    const double start = assembly.energy().kinetic;
    try {
      for (int n = 0; n < 40; ++n) {
        assembly.march(50);
        if (!(assembly.energy().kinetic < 10 * start)) return false;
      }
    } catch (const dem::Diverged&) {
      return false;
    }
    return true;
  }
  double largest_stable() const {
    double low = 1e-6, high = 1e-4;
    for (int i = 0; i < 14; ++i) {
      const double middle = std::sqrt(low * high);
      (stable(middle) ? low : high) = middle;
    }
    return low;
  }
  /// Where the two contacts use up what stability allows.
  double expected() const {
    const auto rates = dem::contact_rates(dem::sphere_body(fiber(), rules), dem::wall_body(around()), rules,
                                          overlap * 1e-3, 2);
    double low = 0, high = 1e-3;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (rates.used(middle) < 1 ? low : high) = middle;
    }
    return low;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_squeezed_sphere_is_stable_up_to_the_step_that_is_said) {
  for (const double overlap : {0.2, 0.4}) {
    for (const double e : {0.5, 0.4, 0.1}) {  // less damped, the bond sets the limit
      for (const double friction : {0.0, 5.0}) {
        const Squeezed scene{overlap, {e, friction, 0}};
        const double ratio = scene.largest_stable() / scene.expected();
        BOOST_TEST_MESSAGE("overlap " << overlap << " R, restitution " << e << ", friction " << friction
                                      << ": stable up to " << ratio << " of " << scene.expected() << " s");
        BOOST_TEST(ratio > (friction > 0 ? 0.8 : 0.98));
        BOOST_TEST(ratio < (friction > 0 ? 1.3 : 1.02));
      }
    }
  }
}

namespace {

/// A packing squeezed by a plate until spheres overlap by a tenth of the radius and more, come to rest.
struct Dense {
  SmallPacking packing;
  double stored, deepest, mean;
  std::size_t contacts;

  Dense(double restitution, double damping) : packing(packing_in_a_periodic_box(16, 1)) {
    packing.groups.resize(1);
    packing.groups[0].chain.fiber.bond_damping = damping;
    packing.around.contacts = {restitution, 0.3, 0};
    packing.around.wall_youngs_modulus = 0;
    const double fibers = 16 * 9 * 4.0 / 3 * 3.14159 * 1e-9, speed = 1.2;
    const double height = fibers / (packing.around.period[0] * packing.around.period[1]) / 0.5;
    dem::Wall& plate = packing.around.walls[1];
    plate.velocity = {0, 0, -speed};
    plate.active_until = (plate.shape.get_if<dem::Plane>()->point[2] - height) / speed;
    const double stop = plate.active_until;
    packing.around.walls.push_back(side({0, 0, height}, {0, 0, -1}));
    packing.around.walls[2].active_from = stop;
    dem::Assembly assembly = packing.assembly({.step = 4e-6, .form = dem::BondForm::total});
    assembly.march(static_cast<int>(stop / 4e-6) + 6000);
    for (int f = 0; f < 16; ++f) packing.groups[0].fibers[f] = dem::at_rest<3>(assembly.state(0, f).poses);
    const dem::EnergyBalance now = assembly.energy();
    stored = now.bonds + now.contacts;
    deepest = mean = 0;
    const auto all = assembly.contacts();
    for (const auto& c : all)
      deepest = std::max(deepest, c.overlap / 1e-3),
      mean += c.overlap / 1e-3 / static_cast<double>(all.size());
    contacts = all.size();
    packing.around.walls.erase(packing.around.walls.begin() + 1);
    packing.around.walls[1].active_from = 0;
  }

  double chosen() const { return packing.assembly({}).step(); }

  /// Kinetic energy that is left after 4 ms, over what is stored.
  double unrest(double step) const {
    dem::Assembly assembly = packing.assembly({.step = step, .form = dem::BondForm::total});
    try {
      assembly.march(static_cast<int>(4e-3 / step));
    } catch (const dem::Diverged&) {
      return 1;
    }
    return assembly.energy().kinetic / stored;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_dense_packing_is_quiet_at_the_chosen_step_and_not_at_twice_that) {
  for (const double e : {0.4, 0.1}) {
    for (const double damping : {0.0, 0.3}) {
      const Dense dense(e, damping);
      const double step = dense.chosen(), fine = dense.unrest(0.3 * step), chosen = dense.unrest(step),
                   twice = dense.unrest(2 * step);
      BOOST_TEST_MESSAGE("restitution "
                         << e << ", xi_b = " << damping << ": " << dense.contacts
                         << " contacts of 144 spheres, " << dense.mean << " R deep, at most " << dense.deepest
                         << " R; step " << step << " s: kinetic energy left over that stored " << chosen
                         << ", at 0.3 of the step " << fine << ", at twice the step " << twice);
      BOOST_TEST(dense.mean > 0.05);
      BOOST_TEST(chosen < 3 * fine + 1e-6);
      BOOST_TEST(twice > 30 * chosen);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
