#include "compare/render/picture.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

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

BOOST_AUTO_TEST_SUITE_END()
