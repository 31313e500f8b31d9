// Nearest points of wall shapes against the least distance of their surface's own points, turned walls
// against shapes where they stand, and how walls move.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "dem/model/domain.hpp"

BOOST_AUTO_TEST_SUITE(wall_shapes_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

namespace {

constexpr double pi = std::numbers::pi;

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

/// A piece of surface over the unit square, which goes on as it is or stays on its rim beyond.
using Patch = std::function<V(double, double)>;

struct Closest {
  V at;
  double distance = std::numeric_limits<double>::infinity();
};

/// The closest point of a piece: on a grid, then on ever smaller ones around the best.
Closest closest_on(const Patch& patch, const V& from) {
  Closest best;
  double u0 = 0.5, v0 = 0.5, half = 0.5;
  for (int round = 0; round < 14; ++round) {
    constexpr int n = 24;
    const double u = u0, v = v0;
    for (int i = -n; i <= n; ++i) {
      for (int j = -n; j <= n; ++j) {
        const double a = u + half * i / n, b = v + half * j / n;
        const V at = patch(a, b);
        if (const double distance = norm(at - from); distance < best.distance)
          best = {at, distance}, u0 = a, v0 = b;
      }
    }
    half *= 0.2;
  }
  return best;
}

Closest closest(const std::vector<Patch>& patches, const V& from) {
  Closest best;
  for (const Patch& patch : patches) {
    const Closest own = closest_on(patch, from);
    if (own.distance < best.distance) best = own;
  }
  return best;
}

struct Frame {
  V x, y, z;
};

/// Odd, right-handed.
Frame odd_frame() {
  const dem::Quaternion<double> q = dem::rotation(V{0.7, -0.4, 1.1});
  return {rotate(q, V{1, 0, 0}), rotate(q, V{0, 1, 0}), rotate(q, V{0, 0, 1})};
}

/// Places all around, by the size of the shape.
std::vector<V> places(double size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.6 * size, 1.6 * size);
  std::vector<V> all;
  for (int n = 0; n < 60; ++n) all.push_back({number(random), number(random), number(random)});
  return all;
}

/// Against all points of the surface; `behind` says on which side a place is.
template <class Shape>
void check_nearest(const Shape& shape, const std::vector<Patch>& patches, double size,
                   const std::function<bool(const V&)>& behind) {
  for (const V& from : places(size)) {
    const Closest best = closest(patches, shape.point + from);
    const double sign = behind(from) ? -1 : 1;
    const auto nearest = shape.nearest(from);
    within(nearest.distance / size, sign * best.distance / size, 1e-9, "distance");
    const V expected = (sign / best.distance) * (best.at - shape.point - from);
    within(norm(nearest.direction - expected), 0, 2e-6 * size / best.distance, "direction");
    within(norm(nearest.direction), 1, 1e-12, "unit");
  }
}

V round(const Frame& f, double radius, double part) {
  return radius * std::cos(2 * pi * part) * f.x + radius * std::sin(2 * pi * part) * f.y;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nearest_points_are_the_nearest_of_the_surface) {
  const Frame f = odd_frame();
  const V at{0.013, -0.027, 0.041};
  const double R = 0.0173;
  for (const double side : {1.0, -1.0}) {
    check_nearest(dem::Sphere{at, R, side}, {[&](double u, double v) {
                    return at + round(f, R * std::sin(pi * u), v) + R * std::cos(pi * u) * f.z;
                  }},
                  R, [&](const V& x) { return side * (R - norm(x)) < 0; });
    check_nearest(dem::Cylinder{at, f.z, R, side},
                  {[&](double u, double v) { return at + round(f, R, v) + (6 * R * (u - 0.5)) * f.z; }}, R,
                  [&](const V& x) { return side * (R - norm(x - dot(x, f.z) * f.z)) < 0; });
  }
  const V half{0.4 * R, 1.1 * R, 0.7 * R};
  std::vector<Patch> faces;
  for (const double sign : {-1.0, 1.0}) {
    const auto corner = [=](double a, double b, double c) {
      for (double* part : {&a, &b, &c}) *part = std::clamp(*part, -1.0, 1.0);
      return at + a * half[0] * f.x + b * half[1] * f.y + c * half[2] * f.z;
    };
    faces.push_back([=](double u, double v) { return corner(sign, 2 * u - 1, 2 * v - 1); });
    faces.push_back([=](double u, double v) { return corner(2 * u - 1, sign, 2 * v - 1); });
    faces.push_back([=](double u, double v) { return corner(2 * u - 1, 2 * v - 1, sign); });
  }
  check_nearest(dem::BoxObstacle{at, half, f.x, f.y}, faces, R, [&](const V& x) {
    return std::abs(dot(x, f.x)) < half[0] && std::abs(dot(x, f.y)) < half[1] &&
           std::abs(dot(x, f.z)) < half[2];
  });
  // funnel, tube, pointed, ring
  const double sizes[][3] = {{1.3, 1.1, 0.35}, {0.9, 0.6, 0.6}, {1.2, 0, 0.8}, {0, 0.4, 1.1}};
  for (const auto& s : sizes) {
    const double L = R * s[0], a = R * s[1], b = R * s[2];
    check_nearest(dem::Cone{at, f.z, L, a, b}, {[&](double u, double v) {
                    const double part = std::clamp(u, 0.0, 1.0);
                    return at + round(f, a + part * (b - a), v) + part * L * f.z;
                  }},
                  R, [](const V&) { return false; });
    const double half_shell = 0.031 * R;
    const dem::Cone thick{at, f.z, L, a, b, half_shell}, thin{at, f.z, L, a, b};
    const V from = R * V{0.3, 0.8, -0.2};
    within(thick.nearest(from).distance, thin.nearest(from).distance - half_shell, 1e-17, "thickness");
  }
}

/// Around faces, edges and corners the normal turns no faster than around a point at this distance, and the
/// gap changes by no more than the way.
BOOST_AUTO_TEST_CASE(a_box_is_one_surface_with_a_normal_that_turns_steadily) {
  const Frame f = odd_frame();
  const dem::BoxObstacle box{{}, {0.011, 0.007, 0.019}, f.x, f.y};
  const double around = 0.0022;
  const int steps = 40000;
  double largest = 0, slack = 0;
  dem::NearestPoint<double> before{};
  V last{};
  for (int n = 0; n <= steps; ++n) {  // crosses all kinds of places, well outside
    const double t = 2 * pi * n / steps;
    V at = 0.03 * V{std::cos(t), std::sin(3 * t), std::sin(2 * t + 0.4)};
    const auto far = box.nearest(at);
    at = at + (far.distance - around) * far.direction;  // a walk along the surface at one distance
    const auto now = box.nearest(at);
    if (far.distance > around) {
      within(now.distance, around, 1e-12, "distance kept");
      if (n > 0 && norm(last) > 0) {
        const double way = norm(at - last);
        largest = std::max(largest, norm(now.direction - before.direction) * around / way);
        slack = std::max(slack, std::abs(now.distance - before.distance) / way);
      }
      before = now, last = at;
    } else {
      last = {};
    }
  }
  BOOST_TEST(largest > 0.5);  // around edges it does turn
  BOOST_TEST(largest < 1 + 1e-3);
  BOOST_TEST(slack < 1e-6);
}

/// A wall that has turned and gone along has the gaps that a place gone back with it had.
BOOST_AUTO_TEST_CASE(turned_walls_are_shapes_where_they_stand) {
  const Frame f = odd_frame();
  const V axis_point{0.3e-2, -1.1e-2, 0.7e-2};
  dem::Wall walls[] = {{dem::Plane{{0.01, 0.02, 0.03}, f.x}},
                       {dem::Cylinder{{0.01, 0.02, 0.03}, f.x, 0.02, -1}},
                       {dem::Sphere{{0.01, 0.02, 0.03}, 0.02}},
                       {dem::BoxObstacle{{0.01, 0.02, 0.03}, {0.004, 0.006, 0.009}, f.y, f.z}},
                       {dem::Cone{{0.01, 0.02, 0.03}, f.x, 0.02, 0.01, 0.004, 1e-4}}};
  for (dem::Wall& wall : walls) {
    wall.velocity = {0.1, -0.2, 0.05};
    wall.motion.about = dem::WallAxis{axis_point, f.z};
    wall.motion.angular_velocity = -13.7;
    wall.motion.oscillation = dem::WallOscillation{f.y, 2.3e-3, 17, 0.4, 0.11};
    wall.motion.course = dem::WallCourse{f.x, dem::monotone_cubic({0, 0.1, 0.3, 0.5}, {0, 0.01, 0.01, -0.02}),
                                         dem::monotone_cubic({0, 0.2, 0.5}, {0, 1.2, 0.3})};
    for (const double t : {0.0, 0.073, 0.21, 0.44}) {
      const auto& o = *wall.motion.oscillation;
      const double ramp = std::min(t / 0.11, 1.0), e = ramp * ramp * (3 - 2 * ramp);
      const V shift = t * wall.velocity + wall.motion.course->place.at(t) * f.x +
                      2.3e-3 * e * (std::sin(2 * pi * 17 * t + 0.4) - std::sin(0.4)) * f.y;
      within(o.at(t), 2.3e-3 * e * (std::sin(2 * pi * 17 * t + 0.4) - std::sin(0.4)), 1e-17, "oscillation");
      const double angle = -13.7 * t + wall.motion.course->angle.at(t);
      const dem::Quaternion<double> back = dem::rotation(-angle * f.z);
      for (const V& place : places(0.03)) {
        const V own = axis_point + rotate(back, place - shift - axis_point);
        within(gap_to(wall, place, t), gap_to({wall.shape}, own, 0), 1e-15, "gap");
        // the surface's velocity is the rate of its places
        const double h = 1e-6;
        const auto where = [&](double time) {
          const dem::WallPose pose = pose_at(wall, time);
          return pose.center + rotate(pose.turn, own - pose.center) + pose.shift;
        };
        const dem::WallVelocity v = velocity_at(wall, t);
        const V expected = (0.5 / h) * (where(t + h) - where(t - h));
        if (t > 0 && norm(own) > 0)
          within(norm(v.velocity + cross(v.spin, place - pose_at(wall, t).center_now()) - expected), 0, 2e-5,
                 "velocity");
        BOOST_TEST(norm(v.velocity) <= largest_speed(wall, 0) * (1 + 1e-12));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_looks_the_same_as_it_turns) {
  const Frame f = odd_frame();
  const V p{0.1, 0.2, -0.3};
  const auto visible = [&](const dem::WallShape& shape, const V& point, const V& axis) {
    dem::Wall wall{shape};
    wall.motion.about = dem::WallAxis{point, axis};
    return turns_visibly(wall);
  };
  BOOST_TEST(!visible(dem::Cylinder{p, f.z, 0.1}, p + 0.7 * f.z, -f.z));
  BOOST_TEST(visible(dem::Cylinder{p, f.z, 0.1}, p + 1e-3 * f.x, f.z));
  BOOST_TEST(visible(dem::Cylinder{p, f.z, 0.1}, p, f.x));
  BOOST_TEST(!visible(dem::Plane{p, f.z}, V{}, f.z));
  BOOST_TEST(visible(dem::Plane{p, f.z}, V{}, f.x));
  BOOST_TEST(!visible(dem::Sphere{p, 0.1}, p - 2.0 * f.y, f.y));
  BOOST_TEST(visible(dem::Sphere{p, 0.1}, V{}, f.y));
  BOOST_TEST(!visible(dem::Cone{p, f.z, 0.2, 0.1, 0.05}, p, f.z));
  BOOST_TEST(visible(dem::BoxObstacle{p, {0.1, 0.1, 0.1}, f.x, f.y}, p, f.z));
}

BOOST_AUTO_TEST_CASE(courses_go_through_their_values_smoothly_and_beyond_none) {
  const std::vector<double> time{0.1, 0.25, 0.3, 0.7, 1.4}, value{1, 3, 3.2, -1, -1};
  const dem::MonotoneCubic course = dem::monotone_cubic(time, value);
  double before = course.at(0), fastest = 0;
  for (std::size_t n = 0; n < time.size(); ++n) within(course.at(time[n]), value[n], 1e-14, "value");
  const double h = 1e-5;
  for (double t = 0; t < 1.6; t += h) {
    const double now = course.at(t);
    BOOST_TEST_REQUIRE(now <= 3.2 + 1e-14);
    BOOST_TEST_REQUIRE(now >= -1.0 - 1e-14);
    fastest = std::max(fastest, std::abs(now - before) / h);
    const double rate = (course.at(t + h) - course.at(t - h)) / (2 * h);
    BOOST_TEST_REQUIRE(std::abs(rate - course.rate_at(t)) < 5e-3 * course.largest_rate());
    before = now;
  }
  within(fastest / course.largest_rate(), 1, 1e-3, "largest rate");
  BOOST_TEST(course.rate_at(0.05) == 0);
  BOOST_TEST(course.rate_at(0.1 + 1e-9) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
