// Chains against the rods they stand for: orders of both bonds, numbering and paths of the L frame, what is
// refused.
#include "compare/rods/study.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "compare/rods/numbering.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/stopping.hpp"

BOOST_AUTO_TEST_SUITE(rods_study_test)

using namespace fiberchain;
using compare::RodPoint;

BOOST_AUTO_TEST_CASE(chains_converge_with_the_order_of_their_bond) {
  compare::RodSweep sweep;
  sweep.benchmark = {"ring",     "bend",    "weight-lumped",         "weight",       "arc-weight", "follower",
                     "pressure", "l-frame", "column-clamped-hinged", "twisted-ring", "lees-frame"};
  sweep.aspect_ratio = {30};
  sweep.poisson_ratio = {0.41};
  sweep.load_factor = {0.83};
  const auto points = compare::rod_points(compare::cases(sweep));
  BOOST_TEST(points.size() == 22U);
  for (const RodPoint& p : points) {
    BOOST_TEST_CONTEXT(p.asked.benchmark << " " << dem::name(p.asked.setting.bond)) {
      BOOST_TEST(p.status == "converged");
      BOOST_TEST(std::abs(p.order - p.expected) < 0.1, p.order);
      BOOST_TEST(std::abs(p.value - p.reference) <= p.error * (1 + 1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_paper_s_bond_does_not_converge_to_the_rod_without_shear_alone) {
  // with G A left out of its reference the error is another multiple of 1 / r_f^2
  compare::RodSetting setting{dem::BondModel::paper, 40, 0.17, 9.7};
  const auto& follower = compare::rod_benchmark("follower");
  const double sheared = compare::rod_error(follower, setting);
  setting.sheared = false;
  const double rigid = compare::rod_error(follower, setting);
  BOOST_TEST(std::abs(rigid / sheared - 1) > 0.1);
}

BOOST_AUTO_TEST_CASE(an_l_frame_does_not_know_numbers_and_paths) {
  BOOST_TEST(compare::l_frame_numbering_difference() < 1e-11);
  BOOST_TEST(compare::l_frame_path_difference() < 1e-11);
}

BOOST_AUTO_TEST_CASE(what_is_no_rod_is_refused) {
  BOOST_CHECK_THROW(compare::rod_benchmark("rign"), compare::InputError);
  compare::RodSweep sweep;
  sweep.benchmark = {"lees-frame"};
  sweep.aspect_ratio = {13};
  BOOST_CHECK_THROW(compare::cases(sweep), compare::InputError);
}

BOOST_AUTO_TEST_CASE(what_is_stopped_has_not_begun) {
  compare::RodSweep sweep;
  sweep.benchmark = {"ring"};
  const auto points = compare::rod_points(compare::cases(sweep), {.stopped = [] { return true; }});
  for (const RodPoint& p : points) BOOST_TEST(p.status == compare::not_begun);
  BOOST_TEST(compare::rods_table(points).rows().size() == points.size());
}

BOOST_AUTO_TEST_SUITE_END()
