#include "compare/render/picture.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "tests/dem/trajectory/frames.hpp"

BOOST_AUTO_TEST_SUITE(picture_test)

using fiberchain::compare::kColors;
using fiberchain::compare::palette_place;

BOOST_AUTO_TEST_CASE(what_is_beyond_the_scale_has_the_color_of_its_end) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double far : {2.0, 1e9, 1e300, 1.7e308, inf}) {
    BOOST_TEST(palette_place(far, {-1, 1}) == kColors - 1);
    BOOST_TEST(palette_place(-far, {-1, 1}) == 0);
  }
  BOOST_TEST(palette_place(std::numeric_limits<double>::quiet_NaN(), {-1, 1}) == 0);
}

BOOST_AUTO_TEST_CASE(colors_rise_with_the_value_on_every_scale) {
  for (const auto& range : {std::pair{-1.0, 1.0}, {3e-300, 5e-300}, {-1.7e308, 1.7e308}, {1e300, 1e301}}) {
    int before = -1;
    for (int i = 0; i < kColors; ++i) {
      const double part = (i + 0.5) / kColors;
      const int place = palette_place(range.first * (1 - part) + range.second * part, range);
      BOOST_TEST(place == i);
      BOOST_TEST(place > before);
      before = place;
    }
  }
}

/// Marks are within the scale, rise, and no two have the same words.
BOOST_AUTO_TEST_CASE(scales_have_marks_that_differ) {
  for (const auto& range : {std::pair{-1.0, 1.0},
                            {-0.053, 0.509},
                            {-0.5005, -0.4995},
                            {3e-9, 8e-9},
                            {0, 2.4e7},
                            {99.9, 100.1},
                            {1e300, 1.7e308},
                            {-1.7e308, 1.7e308},
                            {0, 1e-310}}) {
    const auto [ticks, exponent] = fiberchain::compare::ticks_of(range);
    BOOST_TEST_REQUIRE(ticks.size() >= 2u, range.first);
    BOOST_TEST(ticks.size() <= 8u);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      BOOST_TEST(ticks[i].value >= range.first - 1e-9 * std::abs(range.first));
      BOOST_TEST(ticks[i].value <= range.second * (1 + 1e-9) + 1e-12 * std::abs(range.first));
      if (i == 0) continue;
      BOOST_TEST(ticks[i].value > ticks[i - 1].value);
      BOOST_TEST(ticks[i].words != ticks[i - 1].words);
    }
    if (range.second < 1e300 && range.second > 1e-300) {
      const double read = std::stod(ticks[1].words) * std::pow(10.0, exponent);
      BOOST_TEST(std::abs(read - ticks[1].value) <= 1e-6 * (range.second - range.first));
    }
  }
}

/// Of signed numbers zero is gray, and both signs are as strong at the same size.
BOOST_AUTO_TEST_CASE(signed_numbers_have_a_middle) {
  const auto colors = fiberchain::compare::palette({-1, 3}, true);
  const auto gray = [](const fiberchain::compare::Color& c) {
    return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue});
  };
  BOOST_TEST(gray(colors[16]) < 0.06f);  // at zero, a quarter along
  BOOST_TEST(colors.front().blue > colors.front().red);
  BOOST_TEST(colors.back().red > colors.back().blue + 0.4f);
  BOOST_TEST(gray(colors.front()) < gray(colors.back()));  // a third as strong
}

BOOST_AUTO_TEST_CASE(every_field_is_a_shade) {
  const auto frame = fiberchain::test::with_contacts(fiberchain::test::bent_fibers(4, 6, 3));
  std::vector<std::string> names;
  for (const fiberchain::compare::Shade& shade : fiberchain::compare::shades()) {
    names.push_back(shade.name);
    const std::vector<double> values = shade.values(frame);
    BOOST_TEST(values.size() == frame.position.size(), shade.name);
    BOOST_TEST(std::ranges::all_of(values, [](double value) { return std::isfinite(value); }), shade.name);
  }
  const auto of = [&](const char* name) { return fiberchain::compare::shade_named(name).values(frame); };
  for (const char* name : {"velocity", "velocity_x", "bending_angle", "bond_force", "bond_force_z",
                           "bond_tension", "contact_force", "radius", "fiber"})
    BOOST_TEST(std::ranges::count(names, name) == 1, name);
  BOOST_TEST(of("velocity")[7] == norm(frame.velocity[7]));
  BOOST_TEST(of("velocity_z") == of("vertical_speed"));
  BOOST_TEST(of("bending_angle")[8] == 0.5 * (frame.bonds[6].bending_angle + frame.bonds[7].bending_angle),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(of("contact_force")[7] == norm(frame.contacts[0].force));
  const auto along = frame.position[1] - frame.position[0];
  BOOST_TEST(of("bond_tension")[0] == dot(frame.bonds[0].force, along) / norm(along),
             boost::test_tools::tolerance(1e-12));
}

/// The box is cut to fibers and what has an extent; planes have none, and are cut to it.
BOOST_AUTO_TEST_CASE(pictures_show_what_is_there) {
  auto frame = fiberchain::test::bent_fibers(3, 5, 0);
  frame.periodic[0] = frame.periodic[1] = frame.periodic[2] = false;
  frame.low = {-1, -1, -0.0012}, frame.high = {1, 1, 5};
  const auto shown = fiberchain::compare::shown_bounds({&frame, 1}, {});
  BOOST_TEST(shown.low[2] == frame.low[2]);  // near the floor
  double top = -1;
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    top = std::max(top, frame.position[i][2] + frame.radius[i]);
  BOOST_TEST(shown.high[2] == top);
  frame.walls = {{{}, {1, {}}, true}, {{}, {1, {}}, true}};
  const std::vector<fiberchain::dem::WallSurface> walls = {
      {"plane",
       {{-1, -1, -0.0012}, {1, -1, -0.0012}, {1, 1, -0.0012}, {-1, 1, -0.0012}},
       {{0, 1, 2}, {0, 2, 3}}},
      {"sphere", {{0, 0, 0.3}, {0.01, 0, 0.3}, {0, 0.01, 0.3}}, {{0, 1, 2}}}};
  BOOST_TEST(fiberchain::compare::shown_bounds({&frame, 1}, walls).high[2] == 0.3);
  frame.walls[1].is_there = false;
  BOOST_TEST(fiberchain::compare::shown_bounds({&frame, 1}, walls).high[2] == top);
  const auto scenery = fiberchain::compare::scenery_of(frame, walls, shown);
  BOOST_TEST(scenery.floor.size() >= 2u);
  for (const auto& triangle : scenery.floor) {
    for (const auto& corner : triangle) {
      for (int c = 0; c < 2; ++c) {
        BOOST_TEST(corner[c] <= shown.high[c] + 1e-5);
        BOOST_TEST(corner[c] >= shown.low[c] - 1e-5);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
