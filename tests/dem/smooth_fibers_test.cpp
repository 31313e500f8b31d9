// Smooth fibers: two that slide over each other, many that collide, a packing: no bumps, nothing lost, none
// missed.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "dem/contact/contact_law.hpp"
#include "dem/contact/fiber_bodies.hpp"
#include "dem/contact/segment_geometry.hpp"
#include "dem/model/invalid_key.hpp"
#include "reference/crossed_cylinders.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(smooth_fibers_test)

using namespace scenes;
namespace ref = fiberchain::reference;

namespace {

dem::Fiber fiber_with(int bonds, double spacing = 1) {
  dem::Fiber fiber{dem::isotropic_material(2.6e7, 0.17, 1130), 1.66e-3, bonds};
  fiber.bond_damping = 0.1;
  fiber.spacing = spacing;
  return fiber;
}

std::vector<dem::SphereAddress> all_spheres(int group, int spheres) {
  std::vector<dem::SphereAddress> all;
  for (int i = 0; i < spheres; ++i) all.push_back({group, 0, i});
  return all;
}

/// Mean and spread of friction over normal force, and of the normal force.
struct Ripple {
  double friction = 0, spread = 0;  ///< mean [N]; largest departure from it over it
  double normal = 0;                ///< mean [N]
  int most = 0;                     ///< contacts at once
};

constexpr double friction_coefficient = 0.3, load = 2e-3;

/// A fiber of 5 diameters, held at all its spheres, drawn over a fixed one of 20 under an angle, along that
/// one by two.
Ripple slide(bool smooth, double angle, double spacing = 1) {
  const double R = 0.83e-3, speed = 0.1;
  const auto chain = [&](double length) {
    return dem::straight_chain<3>(fiber_with(static_cast<int>(std::lround(length / spacing)), spacing));
  };
  dem::Chain<3> fixed = chain(20), drawn = chain(5);
  fixed.smooth = drawn.smooth = smooth;
  const V along{std::cos(angle), std::sin(angle), 0};
  const dem::ChainState<3> a = dem::placed(fixed, {{0, 0, 0}, {1, 0, 0}});
  const dem::ChainState<3> b =
      dem::placed(drawn, {V{14.3 * R, 0, 1.999 * R} - 4.77 * R * along, along, {speed, 0, 0}});
  dem::Domain around;
  around.contacts = {0.3, friction_coefficient, 0};
  dem::Grip base, carriage;
  base.place = base.turn = carriage.turn = {true, true, true}, carriage.place = {true, true, false};
  const int spheres = drawn.fiber.aspect_ratio + 1;
  base.spheres = all_spheres(0, fixed.fiber.aspect_ratio + 1), carriage.spheres = all_spheres(1, spheres);
  carriage.body.velocity = {speed, 0, 0}, carriage.force = {0, 0, -6 * load / spheres};
  dem::Assembly assembly({{fixed, {a}}, {drawn, {b}}}, around, {.step = 1.2e-6, .grips = {base, carriage}});
  assembly.march(20000);
  Ripple ripple;
  std::vector<double> all;
  const int samples = 200, steps = static_cast<int>(4 * R / speed / assembly.step() / samples);
  for (int n = 0; n < samples; ++n) {
    assembly.march(steps, dem::ContactForces::kept);
    V force{};
    const auto contacts = assembly.contact_forces();
    for (const dem::ContactState& c : contacts) force = force + c.force;
    ripple.most = std::max(ripple.most, static_cast<int>(contacts.size()));
    all.push_back(force[0]);
    ripple.friction += force[0] / samples, ripple.normal -= force[2] / samples;
  }
  for (const double f : all) ripple.spread = std::max(ripple.spread, std::abs(f / ripple.friction - 1));
  return ripple;
}

}  // namespace

/// Against reference/crossed_cylinders.hpp.
BOOST_AUTO_TEST_CASE(stiffness_of_crossed_fibers_is_that_of_hertzs_ellipse) {
  double worst = 0;
  for (const double ratio : {1.0, 1.7}) {
    for (double angle = 0.106; angle < std::numbers::pi / 2; angle += 0.01) {
      const double k = ref::crossed_cylinder_stiffness(1, 1, ratio, angle), sine = std::sin(angle);
      const double sphere = 4.0 / 3 * std::sqrt(ratio / (1 + ratio));
      worst = std::max(worst,
                       std::abs(sphere * dem::crossed_stiffness(1.0, ratio, 0.0, 0.0, sine * sine) / k - 1));
    }
  }
  BOOST_TEST(worst < 5e-4);
  BOOST_TEST(worst > 1e-4);  // or there is no approximation any more
  BOOST_TEST(dem::crossed_stiffness(1.0, 1.7, 1.0, 1.0, 0.5) == 1, boost::test_tools::tolerance(1e-12));
}

namespace {

/// A segment of a fiber of radius 1 with these nodes.
dem::SegmentNodes<double> segment_of(const std::vector<V>& nodes, std::size_t i) {
  const std::size_t last = nodes.size() - 1;
  return {nodes[i > 0 ? i - 1 : 0], nodes[i], nodes[i + 1], nodes[std::min(last, i + 2)], 1.0};
}

struct Crossing {
  double change = 0;             ///< of the force from place to place
  double least = 1e9, most = 0;  ///< size of the force over that of the deepest pair alone
};

/// A straight fiber under an angle drawn over the joint of one that is bent there, towards it where `bend` >
/// 0, in so many places: its height follows that fiber.
Crossing cross_joint(double angle, double bend, int places) {
  const V along{std::cos(angle), std::sin(angle), 0};
  std::vector<V> bent;
  for (int i = -5; i <= 5; ++i)
    bent.push_back(2.0 * i * V{std::cos(bend / 2), 0, (i < 0 ? -1 : 1) * std::sin(bend / 2)});
  Crossing crossing;
  V last{};
  for (int n = 0; n <= places; ++n) {
    const double x = 2.4 * n / places - 1.2, z = 1.98 + std::tan(bend / 2) * std::abs(x);
    std::vector<V> straight;
    for (int i = -5; i <= 5; ++i) straight.push_back(V{x, 0, z} + (2.0 * i + 0.37 + 0.3 * x) * along);
    V force{};
    double deepest = 0;
    for (std::size_t i = 0; i < 10; ++i) {
      for (std::size_t j = 0; j < 10; ++j) {
        const auto a = segment_of(bent, i), b = segment_of(straight, j);
        const dem::SegmentContact<double> at = dem::segment_contact(a, b);
        const V r = separation(a, b, at.first, at.second);
        if (at.share < dem::least_share || norm(r) > 2) continue;
        const double whole = std::pow((2 - norm(r)) / 0.02, 1.5);
        force = force + (at.share * whole / norm(r)) * r;
        deepest = std::max(deepest, whole);
      }
    }
    crossing.least = std::min(crossing.least, norm(force) / deepest),
    crossing.most = std::max(crossing.most, norm(force) / deepest);
    if (n > 0) crossing.change = std::max(crossing.change, norm(force - last));
    last = force;
  }
  return crossing;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_joint_is_touched_once_and_without_a_jump_straight_or_bent) {
  for (const double angle : {1.57, 0.7}) {
    const Crossing straight = cross_joint(angle, 0, 500);
    BOOST_TEST(straight.change < 1e-4);
    BOOST_TEST(straight.least > 1 - 1e-4);
    BOOST_TEST(straight.most < 1 + 1e-4);
    for (const double bend : {-0.3, -0.1, 0.1}) {
      const Crossing coarse = cross_joint(angle, bend, 500), fine = cross_joint(angle, bend, 1000);
      BOOST_TEST_MESSAGE("angle " << angle << ", bend " << bend << ": force " << fine.least << " to "
                                  << fine.most << " of one contact, changes by " << coarse.change << ", "
                                  << fine.change);
      BOOST_TEST(fine.change < 0.6 * coarse.change);
      BOOST_TEST(fine.least > 0.75);
      BOOST_TEST(fine.most < 1 + 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(friction_of_smooth_fibers_that_slide_does_not_ripple) {
  const double degree = std::numbers::pi / 180;
  for (const double angle : {90 * degree, 35 * degree, 0.0}) {
    const Ripple smooth = slide(true, angle), bumpy = slide(false, angle);
    BOOST_TEST_MESSAGE("angle " << angle / degree << ": friction " << smooth.friction << " N, normal "
                                << smooth.normal << " N, spread " << smooth.spread << ", at most "
                                << smooth.most << " contacts; bumpy " << bumpy.friction << " N, spread "
                                << bumpy.spread);
    BOOST_TEST(std::abs(smooth.normal / (6 * load) - 1) < 1e-4);
    BOOST_TEST(std::abs(smooth.friction / (friction_coefficient * smooth.normal) - 1) < 1e-5);
    BOOST_TEST(smooth.spread < 1e-4);
    BOOST_TEST(bumpy.spread > 1);
  }
  for (const double spacing : {2.5, 0.5}) {
    const Ripple spaced = slide(true, 35 * degree, spacing);
    BOOST_TEST_MESSAGE("spacing " << spacing << ": spread " << spaced.spread);
    BOOST_TEST(std::abs(spaced.friction / (friction_coefficient * spaced.normal) - 1) < 1e-5);
    BOOST_TEST(spaced.spread < 1e-4);
  }
}

namespace {

/// Fibers of two kinds that fly towards the middle of a box.
SmallPacking cloud(int first, int second, double edge, bool spaced = false) {
  dem::Fiber one{dem::isotropic_material(2.6e6, 0.3, 1000), 2e-3, spaced ? 4 : 8};
  dem::Fiber two{dem::isotropic_material(4.1e6, 0.17, 1300), 1.37e-3, spaced ? 5 : 13};
  one.spacing = 8.0 / one.aspect_ratio, two.spacing = 13.0 / two.aspect_ratio;
  one.bond_damping = two.bond_damping = 0.05;
  dem::Chain<3> straight = dem::straight_chain<3>(one),
                bent = curled(two, {0.02 * two.spacing, 0.06 * two.spacing, 0.09 * two.spacing});
  straight.smooth = bent.smooth = true;
  SmallPacking packing;
  packing.around.contacts = {0.4, 0.6, 0.02};
  dem::InsertionRules rules{{{0, 0, 0}, {edge, edge, edge}}};
  rules.seed = 5, rules.gap = spaced ? 1.6e-3 : 0.9e-3;  // of spheres, that segments start apart
  packing.groups = dem::random_insertion({{straight, first}, {bent, second}}, rules, packing.around);
  const V middle{edge / 2, edge / 2, edge / 2};
  for (dem::FiberGroup& group : packing.groups) {
    for (dem::ChainState<3>& state : group.fibers) {
      const V from = state.poses[state.poses.size() / 2].position - middle;
      for (V& v : state.velocity) v = -60.0 * from;
    }
  }
  return packing;
}

/// Pairs of segments that touch, every one with every other.
std::set<dem::ContactKey> brute_force(const dem::Assembly& assembly, const V& period) {
  const dem::PlacedSpheres spheres = assembly.placed();
  dem::FiberBodies bodies;
  std::vector<int> fiber;
  for (int g = 0, number = 0; g < assembly.groups(); ++g) {
    bodies.add(assembly.chain(g), assembly.fibers(g));
    for (int f = 0; f < assembly.fibers(g); ++f, ++number)
      fiber.insert(fiber.end(), assembly.chain(g).poses.size(), number);
  }
  bodies.build(0);
  std::set<dem::ContactKey> pairs;
  const auto position = [&](std::int64_t i) { return spheres.position[static_cast<std::size_t>(i)]; };
  const auto count = static_cast<std::int64_t>(fiber.size());
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::int64_t j = i + 1; j < count; ++j) {
      if (bodies.is_none(i) || bodies.is_none(j) || (fiber[i] == fiber[j] && j - i <= bodies.apart[i]))
        continue;
      const auto a = bodies.nodes(i, position);
      auto b = bodies.nodes(j, position);
      for (int c = 0; c < 3; ++c) {
        if (!(period[c] > 0)) continue;
        const double shift =
            -period[c] * std::round(0.5 * (b.begin[c] + b.end[c] - a.begin[c] - a.end[c]) / period[c]);
        for (V* node : {&b.before, &b.begin, &b.end, &b.behind}) (*node)[c] += shift;
      }
      if (norm(b.begin - a.begin) > a.radius + b.radius + norm(a.end - a.begin) + norm(b.end - b.begin))
        continue;
      const dem::SegmentContact<double> at = dem::segment_contact(a, b);
      if (at.share > dem::least_share && norm(separation(a, b, at.first, at.second)) < a.radius + b.radius)
        pairs.insert({dem::segment_primitive(i), dem::segment_primitive(j)});
    }
  }
  return pairs;
}

std::set<dem::ContactKey> found(const dem::Assembly& assembly) {
  std::set<dem::ContactKey> keys;
  for (const dem::ContactState& c : assembly.contacts()) {
    if (!is_facet(c.key.second)) keys.insert(c.key);
  }
  return keys;
}

}  // namespace

BOOST_DATA_TEST_CASE(fifty_smooth_fibers_that_collide_keep_momenta_and_their_energy_is_accounted,
                     boost::unit_test::data::make({false, true}), spaced) {
  dem::Assembly assembly = cloud(30, 20, spaced ? 0.041 : 0.034, spaced).assembly({.account_energy = true});
  const Momenta before = momenta(assembly);
  const double energy = total(assembly.energy());
  std::int64_t most = 0;
  std::size_t compared = 0;
  double drift = 0;
  for (int n = 0; n < 40; ++n) {
    assembly.march(100);
    most = std::max(most, assembly.touching());
    const auto exact = brute_force(assembly, {});
    compared += exact.size();
    BOOST_TEST((found(assembly) == exact), "moment " << n << ": " << exact.size() << " contacts");
    drift = std::max(drift, std::abs(total(assembly.energy()) / energy - 1));
  }
  const Momenta after = momenta(assembly);
  BOOST_TEST_MESSAGE("up to " << most << " contacts, " << compared << " compared; momentum off by "
                              << norm(after.linear - before.linear) / before.linear_size << ", angular by "
                              << norm(after.angular - before.angular) / before.angular_size << ", energy by "
                              << drift);
  BOOST_TEST(most > 15);
  BOOST_TEST(compared > 300u);
  BOOST_TEST(norm(after.linear - before.linear) < 1e-13 * before.linear_size);
  BOOST_TEST(norm(after.angular - before.angular) < 1e-13 * before.angular_size);
  BOOST_TEST(drift < 1e-3);
}

namespace {

bool same_bits(const dem::Assembly& a, const dem::Assembly& b) {
  const dem::PlacedSpheres one = a.placed(), other = b.placed();
  for (std::size_t i = 0; i < one.position.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      if (one.position[i][c] != other.position[i][c]) return false;
    }
  }
  return found(a) == found(b);
}

}  // namespace

/// Several parts, whose segments touch across them.
BOOST_AUTO_TEST_CASE(neither_threads_nor_a_pause_change_smooth_fibers) {
  const SmallPacking packing = cloud(260, 180, 0.062);
  dem::Assembly one = packing.assembly({.account_energy = true}),
                two = packing.assembly({.threads = 2, .account_energy = true}),
                resumed = packing.assembly({.account_energy = true});
  one.march(500), two.march(500);
  resumed.restore(one.saved());
  one.march(700), two.march(700), resumed.march(700);
  BOOST_TEST(one.spheres() > 4500);
  BOOST_TEST(found(one).size() > 100u);
  BOOST_TEST(same_bits(one, two));
  BOOST_TEST(same_bits(one, resumed));
  BOOST_TEST((found(one) == brute_force(one, {})));
  dem::Assembly scalar = packing.assembly({.instruction_set = dem::InstructionSet::scalar});
  scalar.march(200);
  dem::Assembly wide = packing.assembly({});
  wide.march(200);
  double apart = 0;
  const dem::PlacedSpheres a = scalar.placed(), b = wide.placed();
  for (std::size_t i = 0; i < a.position.size(); ++i)
    apart = std::max(apart, norm(a.position[i] - b.position[i]));
  BOOST_TEST(apart < 1e-12);
}

BOOST_AUTO_TEST_CASE(what_is_not_built_for_smooth_fibers_is_refused) {
  SmallPacking packing = cloud(2, 2, 0.04);
  const auto refused = [&](const dem::Domain& around) {
    BOOST_CHECK_THROW(dem::Assembly(packing.groups, around, {}), dem::InvalidInput);
  };
  dem::Domain adhesive = packing.around;
  adhesive.contacts.law = &dem::contact_law("jkr");
  adhesive.contacts.work_of_adhesion = 0.01;
  refused(adhesive);
}

BOOST_AUTO_TEST_SUITE_END()
