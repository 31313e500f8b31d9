// Random filling: nothing overlaps, everything is inside, directions are as asked, the same seed gives the
// same.
#include "dem/insertion/random_insertion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "dem/analysis/observables.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/insertion/random_numbers.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(random_insertion_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

namespace {

constexpr double pi = std::numbers::pi;

dem::Chain<3> chain_of(int aspect_ratio, double diameter) {
  return dem::straight_chain<3>({dem::isotropic_material(2.6e6, 0.3, 1000), diameter, aspect_ratio});
}

/// A chain that is an arc of a circle at rest, its ends' offsets to match.
dem::Chain<3> arc_of(int aspect_ratio, double diameter, double bend) {
  dem::Chain<3> chain = chain_of(aspect_ratio, diameter);
  V at{};
  for (int i = 0; i <= aspect_ratio; ++i) {
    const auto turn = dem::rotation({0, 0, i * bend});
    chain.poses[i] = {at, turn};
    at = at + rotate(dem::rotation({0, 0, (i + 0.5) * bend}), V{diameter, 0, 0});
  }
  chain.natural.assign(aspect_ratio, {dem::rotation({0, 0, bend / 2}), dem::rotation({0, 0, -bend / 2})});
  return chain;
}

/// Surface distances over all pairs that are not neighbors in a fiber, by brute force over images.
double least_gap(const std::vector<dem::FiberGroup>& groups, const V& period,
                 const dem::PlacedSpheres& more = {}) {
  dem::PlacedSpheres s = dem::spheres_of(groups);
  std::vector<std::int32_t> fiber = dem::fiber_numbers(groups);
  for (std::size_t i = 0; i < more.radius.size(); ++i) {
    s.position.push_back(more.position[i]);
    s.radius.push_back(more.radius[i]);
    fiber.push_back(-1 - static_cast<std::int32_t>(i));
  }
  double least = 1;
  for (std::size_t i = 0; i < s.radius.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      V r = s.position[j] - s.position[i];
      const V direct = r;
      for (int k = 0; k < 3; ++k) {
        if (period[k] > 0) r[k] -= period[k] * std::round(r[k] / period[k]);
      }
      if (fiber[i] == fiber[j] && norm(r - direct) < 1e-9) continue;
      least = std::min(least, norm(r) - s.radius[i] - s.radius[j]);
    }
  }
  return least;
}

bool inside(const std::vector<dem::FiberGroup>& groups, const dem::Box& box) {
  const dem::PlacedSpheres s = dem::spheres_of(groups);
  for (std::size_t i = 0; i < s.radius.size(); ++i) {
    for (int a = 0; a < 3; ++a) {
      if (s.position[i][a] < box.low[a] + s.radius[i] * (1 - 1e-9)) return false;
      if (s.position[i][a] > box.high[a] - s.radius[i] * (1 - 1e-9)) return false;
    }
  }
  return true;
}

bool same(const std::vector<dem::FiberGroup>& a, const std::vector<dem::FiberGroup>& b) {
  const auto p = dem::spheres_of(a).position, q = dem::spheres_of(b).position;
  if (p.size() != q.size()) return false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (norm(p[i] - q[i]) != 0) return false;
  }
  return true;
}

constexpr dem::Box room{{-0.013, 0.004, 0.1}, {0.031, 0.043, 0.171}};

}  // namespace

BOOST_AUTO_TEST_CASE(random_numbers_are_a_function_of_seed_and_place) {
  const auto a = dem::uniform_numbers(7, {3, 1, 4});
  BOOST_TEST((a == dem::uniform_numbers(7, {3, 1, 4})));
  for (const auto& other : {dem::uniform_numbers(8, {3, 1, 4}), dem::uniform_numbers(7, {4, 1, 4}),
                            dem::uniform_numbers(7, {3, 2, 4}), dem::uniform_numbers(7, {3, 1, 5})}) {
    BOOST_TEST((a != other));
  }
  double sum = 0, squares = 0;
  const int n = 20000;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (const double u : dem::uniform_numbers(1, {i, 0, 0})) {
      BOOST_REQUIRE(u > 0 && u <= 1);
      sum += u, squares += u * u;
    }
  }
  BOOST_TEST(std::abs(sum / (4 * n) - 0.5) < 4 * std::sqrt(1.0 / 12 / (4 * n)));
  BOOST_TEST(std::abs(squares / (4 * n) - 1.0 / 3) < 4 * std::sqrt(4.0 / 45 / (4 * n)));
  // Philox 4x64-10 of counter 0, key 0, as its authors' known answers have it
  BOOST_TEST(dem::uniform_numbers(0, {0, 0, 0})[0] ==
             static_cast<double>(0x16554d9eca36314cULL) * 0x1p-64 + 0x1p-65);
}

BOOST_AUTO_TEST_CASE(fibers_of_several_kinds_fill_a_room_without_overlap) {
  const std::vector<dem::InsertionCount> counts{
      {chain_of(5, 1.1e-3), 60}, {chain_of(20, 0.9e-3), 150}, {arc_of(17, 1.4e-3, 0.12), 40}};
  dem::InsertionRules rules{room};
  rules.velocity = {0.1, -0.2, -0.7};
  rules.gap = 1e-5;
  const auto groups = dem::random_insertion(counts, rules, {});
  BOOST_TEST(groups.size() == 3u);
  for (std::size_t g = 0; g < 3; ++g)
    BOOST_TEST(groups[g].fibers.size() == static_cast<std::size_t>(counts[g].count));
  const double gap = least_gap(groups, {});
  BOOST_TEST(gap >= 1e-5 * (1 - 1e-9));
  BOOST_TEST(gap < 1e-4);
  BOOST_TEST(inside(groups, room));
  // at rest in their own shapes, orientations included
  for (const auto& group : groups) {
    for (const auto& state : group.fibers) {
      BOOST_TEST(dem::elastic_energy(group.chain, state.poses) < 1e-20);
      BOOST_TEST(norm(state.velocity.back() - rules.velocity) == 0);
      BOOST_TEST(norm(state.spin.back()) == 0);
    }
  }
  BOOST_TEST(same(groups, dem::random_insertion(counts, rules, {})));
  dem::InsertionRules other = rules;
  other.seed = 2;
  BOOST_TEST(!same(groups, dem::random_insertion(counts, other, {})));
}

BOOST_AUTO_TEST_CASE(a_second_batch_finds_room_beside_the_first) {
  const std::vector<dem::InsertionCount> counts{{chain_of(12, 1e-3), 90}};
  dem::InsertionRules rules{room};
  const auto first = dem::random_insertion(counts, rules, {});
  rules.first_number = 90;
  const auto second = dem::random_insertion({{chain_of(7, 1.3e-3), 90}}, rules, {}, dem::spheres_of(first));
  BOOST_TEST(least_gap(second, {}, dem::spheres_of(first)) >= -1e-15);
  BOOST_TEST(norm(second[0].fibers[0].poses[0].position - first[0].fibers[0].poses[0].position) > 1e-4);
}

BOOST_AUTO_TEST_CASE(periodic_sides_are_crossed_and_images_kept_apart) {
  // the fiber is longer than the cell along x: it must not meet itself
  const V period{0.0127, 0, 0.0211};
  const dem::Box cell{{0, 0, 0}, {0.0127, 0.03, 0.0211}};
  dem::InsertionRules rules{cell};
  dem::Domain domain;
  domain.period = period;
  const auto groups = dem::random_insertion({{chain_of(20, 1e-3), 25}}, rules, domain);
  BOOST_TEST(least_gap(groups, period) >= -1e-15);
  int outside = 0;
  for (const V& x : dem::spheres_of(groups).position) {
    outside += x[0] < 0 || x[0] >= period[0] || x[2] < 0 || x[2] >= period[2];
    BOOST_TEST((x[1] > 0.0005 * (1 - 1e-9) && x[1] < 0.0295 * (1 + 1e-9)));
  }
  BOOST_TEST(outside > 20);
  domain.period[0] = 0.0019;
  BOOST_CHECK_THROW(dem::random_insertion({{chain_of(1, 1e-3), 1}}, rules, domain), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(walls_stand_where_they_are_at_the_time) {
  dem::Domain s;
  const V axis = (1 / norm(V{0.1, 0.2, 1})) * V{0.1, 0.2, 1};
  s.walls.push_back({dem::Cylinder{{0.01, 0.02, 0}, axis, 0.015}});
  s.walls.push_back({dem::Plane{{0, 0, 0.1}, {0, 0, 1}}, {0, 0, 0.02}});
  s.walls.push_back({dem::Plane{{0, 0, 0}, {0, 0, -1}}, {}, 5.0});     // comes later
  s.walls.push_back({dem::Plane{{0, 0, 0}, {0, 0, -1}}, {}, 0, 0.5});  // has gone
  dem::InsertionRules rules{{{-0.03, -0.03, 0.1}, {0.06, 0.08, 0.19}}};
  rules.time = 1.5;
  const auto groups = dem::random_insertion({{chain_of(9, 1e-3), 150}}, rules, s);
  double to_plane = 1, to_cylinder = 1;
  for (const V& x : dem::spheres_of(groups).position) {
    const V r = x - V{0.01, 0.02, 0};
    to_plane = std::min(to_plane, x[2] - 0.13 - 0.0005);
    to_cylinder = std::min(to_cylinder, 0.015 - norm(cross(r, axis)) - 0.0005);
  }
  for (const double least : {to_plane, to_cylinder}) {
    BOOST_TEST(least >= -1e-15);
    BOOST_TEST(least < 1e-3);
  }
  BOOST_TEST(std::abs(dem::distance_to(s.walls[1], {3, 4, 0.5}, 2) - 0.36) < 1e-15);
  BOOST_TEST(std::isinf(dem::distance_to(s.walls[2], {}, 4.9)));
  BOOST_TEST(dem::distance_to(s.walls[3], {0, 0, 0.1}, 0.4) == -0.1);
}

namespace {

dem::Orientations orientations(const dem::InsertionOrientation& o, const V& up, const dem::Chain<3>& chain) {
  dem::InsertionRules rules{{{0, 0, 0}, {1, 1, 1}}};  // wide enough for its walls not to matter
  rules.orientation = o;
  dem::Orientations seen(up, 6);
  seen.add(dem::random_insertion({{chain, 4000}}, rules, {})[0].fibers);
  return seen;
}

}  // namespace

BOOST_AUTO_TEST_CASE(directions_are_spread_as_asked) {
  const auto chain = chain_of(1, 1e-3);
  const V up = (1 / norm(V{1, -2, 0.5})) * V{1, -2, 0.5};
  const auto isotropic = orientations({}, up, chain);
  // of n = 4000 independent directions: all bounds are four standard deviations, and no sample is as even as
  // the mean
  constexpr double n = 4000;
  const double sigma = 1.5 * std::sqrt(4.0 / 45 / n);  // of an eigenvalue of the order tensor
  BOOST_TEST(std::abs(isotropic.order_along_up()) < 4 * sigma);
  // the largest of three that sum to 0: between 0.38 and 4.2 for 40 seeds
  BOOST_TEST(isotropic.order() < 4.5 * sigma);
  BOOST_TEST(isotropic.order() > 0.3 * sigma);
  BOOST_TEST(std::abs(isotropic.mean_polar_angle() - 1) < 4 * std::sqrt((std::acos(-1.0) - 3) / n));
  double squares = 0;  // chi-squared of five degrees of freedom
  for (int k = 0; k < 6; ++k) {
    const double width = std::acos(0.0) / 6, share = std::cos(k * width) - std::cos((k + 1) * width),
                 off = isotropic.against_isotropic()[k] - 1;
    BOOST_TEST(off * off < 16 * (1 - share) / (n * share));
    squares += n * share * off * off;
  }
  BOOST_TEST(squares > 0.2);   // below: one sample in a thousand
  BOOST_TEST(squares < 20.5);  // above: likewise

  const double angle = 0.41;
  // heights uniform over a cap: <cos^2> = (1 + c + c^2) / 3; over a band: sin^2 / 3
  const double c = std::cos(angle), s = std::sin(angle);
  const auto near_axis = orientations({dem::Alignment::near_axis, 3.0 * up, angle}, up, chain);
  BOOST_TEST(std::abs(near_axis.order_along_up() - ((1 + c + c * c) - 1) / 2) < 0.005);
  const auto near_plane = orientations({dem::Alignment::near_plane, up, angle}, up, chain);
  BOOST_TEST(std::abs(near_plane.order_along_up() - (s * s - 1) / 2) < 0.01);
  BOOST_TEST(near_plane.principal()[1] > 0.4);  // around the axis all alike
  const auto parallel = orientations({dem::Alignment::near_axis, up, 0}, up, chain);
  BOOST_TEST(std::abs(parallel.order_along_up() - 1) < 1e-12);
  // a curved fiber points from its first sphere to its last
  dem::InsertionRules rules{{{0, 0, 0}, {1, 1, 1}}, {dem::Alignment::near_axis, up, 0}};
  const auto arcs = dem::random_insertion({{arc_of(11, 1e-3, 0.2), 30}}, rules, {});
  for (const auto& state : arcs[0].fibers) {
    const V r = state.poses.back().position - state.poses.front().position;
    BOOST_TEST(std::abs(std::abs(dot(r, up)) - norm(r)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(what_does_not_go_in_is_said) {
  dem::InsertionRules rules{room};
  rules.attempts = 200;
  const auto mentions = [](const char* text) {
    return [text](const std::exception& e) { return std::string(e.what()).find(text) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(dem::random_insertion({{chain_of(20, 1e-3), 4000}}, rules, {}), dem::NoRoom,
                        mentions("of 4000"));
  BOOST_CHECK_EXCEPTION(dem::random_insertion({{chain_of(20, 1e-3), 100000}}, rules, {}), dem::NoRoom,
                        mentions("m^3"));
  BOOST_CHECK_THROW(dem::random_insertion({{chain_of(200, 1e-3), 1}}, rules, {}), dem::NoRoom);
  const auto refused = [&](auto change) {
    dem::InsertionRules bad{room};
    change(bad);
    BOOST_CHECK_THROW(dem::random_insertion({{chain_of(3, 1e-3), 1}}, bad, {}), dem::InvalidInput);
  };
  refused([](auto& r) { r.region.high[1] = r.region.low[1]; });
  refused([](auto& r) { r.gap = -1e-9; });
  refused([](auto& r) { r.attempts = 0; });
  refused([](auto& r) { r.orientation.angle = 1.6; });
  refused([](auto& r) { r.orientation.direction = {}; });
  BOOST_CHECK_THROW(dem::random_insertion({{chain_of(3, 1e-3), -1}}, rules, {}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::placed(chain_of(3, 1e-3), dem::FiberStart{{}, {}, {}}), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(the_shortest_rotation_turns_any_direction_into_any) {
  for (const V& a : {V{1, 0, 0}, V{0.3, -2, 0.7}, V{0, 0, -4}}) {
    for (const V& b : {V{1, 0, 0}, V{-1, 0, 0}, V{-0.3, 2, -0.7}, V{0, 5, 1e-9}}) {
      const V turned = rotate(dem::rotation_between(a, b), (1 / norm(a)) * a);
      BOOST_TEST(norm(turned - (1 / norm(b)) * b) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
