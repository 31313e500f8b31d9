// The paper's bisection with Simpson's rule (Eqs 13-15): right within the error it reports, of fourth order.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/elastica.hpp"

BOOST_AUTO_TEST_SUITE(elastica_paper_test)

namespace ref = fiberchain::reference;

BOOST_AUTO_TEST_CASE(within_its_reported_error) {
  for (int i = 0; i <= 60; ++i) {
    const double load = std::pow(10.0, -6 + 9 * i / 60.0);
    const ref::TipState exact = ref::elastica_closed_form(load);
    const ref::PaperElastica paper = ref::elastica_paper(load);
    const double rounding = 4e-16;
    BOOST_TEST(std::abs(paper.tip.y - exact.y) <= paper.error.y + rounding * (1 + exact.y),
               "y at load " << load);
    BOOST_TEST(std::abs(paper.tip.x - exact.x) <= paper.error.x + rounding * (1 + exact.x),
               "x at load " << load);
    BOOST_TEST(std::abs(paper.tip.angle - exact.angle) <= paper.error.angle + rounding * 2,
               "angle at " << load);
    // and the estimate is no mere safe number: where Simpson's error dominates it is 2^4 - 1 times it
    if (load > 1 && load < 100) BOOST_TEST(paper.error.y < 30 * std::abs(paper.tip.y - exact.y));
  }
}

BOOST_AUTO_TEST_CASE(accurate_over_the_paper_s_loads) {
  for (const double load : {0.05, 0.5, 1.0, 2.5, 6.0, 10.0}) {
    const ref::TipState exact = ref::elastica_closed_form(load);
    const ref::PaperElastica paper = ref::elastica_paper(load, 1000);
    BOOST_TEST(std::abs(paper.tip.y / exact.y - 1) < 1e-10);
    BOOST_TEST(std::abs(paper.tip.x / exact.x - 1) < 1e-10);
    BOOST_TEST(paper.bracket_width < 1e-15);
    BOOST_TEST(paper.bisections > 40);
  }
}

BOOST_AUTO_TEST_CASE(order_four_in_the_panel) {
  const double load = 3.7;
  const ref::TipState exact = ref::elastica_closed_form(load);
  const double coarse = std::abs(ref::elastica_paper(load, 40).tip.y - exact.y);
  const double fine = std::abs(ref::elastica_paper(load, 80).tip.y - exact.y);
  const double order = std::log2(coarse / fine);
  BOOST_TEST_MESSAGE("observed order " << order);
  BOOST_TEST(order > 3.9);
  BOOST_TEST(order < 4.1);
}

BOOST_AUTO_TEST_CASE(as_printed_the_angle_is_lost_near_vertical) {
  const double near_vertical = 100;
  const ref::TipState exact = ref::elastica_closed_form(near_vertical);
  const ref::PaperElastica printed = ref::elastica_paper_singular(near_vertical);
  const ref::PaperElastica regular = ref::elastica_paper(near_vertical);
  BOOST_TEST(std::abs(printed.tip.angle - exact.angle) > 1e-5);
  BOOST_TEST(std::abs(regular.tip.angle - exact.angle) < 1e-9);
  const ref::TipState gentle = ref::elastica_closed_form(0.8);
  BOOST_TEST(std::abs(ref::elastica_paper_singular(0.8).tip.y - gentle.y) < 1e-10);
}

BOOST_AUTO_TEST_CASE(no_load_no_deflection) {
  const ref::PaperElastica rest = ref::elastica_paper(0);
  BOOST_TEST(rest.tip.y == 0);
  BOOST_TEST(rest.tip.x == 0);
  BOOST_TEST(rest.tip.angle == 0);
}

BOOST_AUTO_TEST_SUITE_END()
