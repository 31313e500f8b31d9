// The model of how threads share a step, on schedules that are worked out by hand.
#include "compare/bench/schedule_model.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(schedule_model_test)

namespace compare = fiberchain::compare;
using compare::StepWork;

namespace {

constexpr compare::SharingCosts free_of_cost{1, 0};
const auto near = boost::test_tools::tolerance(1e-12);

}  // namespace

BOOST_AUTO_TEST_CASE(one_thread_does_all_the_work) {
  const StepWork work{{{3, 1, {1, 2}}, {1, 2, {2}}, {0.5, 4, {}}}, 0.7, 0.3};
  BOOST_TEST(compare::modeled_step(work, 1, {1.4, 0.2}) == 12.5, near);
}

BOOST_AUTO_TEST_CASE(parts_of_their_own_are_shared_evenly) {
  StepWork work{std::vector<fiberchain::dem::PartTimes>(12, {1, 2, {}}), 6, 0.5};
  for (const int threads : {2, 3, 4})
    BOOST_TEST(compare::modeled_step(work, threads, free_of_cost) == 42.0 / threads + 0.5, near);
  // five threads: two of them do three parts
  BOOST_TEST(compare::modeled_step(work, 5, free_of_cost) == 9 + 6.0 / 5 + 0.5, near);
}

BOOST_AUTO_TEST_CASE(a_part_is_moved_after_the_contacts_that_reach_it) {
  // both contacts at once, then both motions
  BOOST_TEST(compare::modeled_step({{{1, 1, {1}}, {1, 1, {}}}, 0, 0}, 2, free_of_cost) == 2, near);
  // the second thread waits from 1 to 3 for those of the first part
  BOOST_TEST(compare::modeled_step({{{3, 1, {1}}, {1, 1, {}}}, 0, 0}, 2, free_of_cost) == 4, near);
  // not where they do not reach it: 4 on the first thread
  BOOST_TEST(compare::modeled_step({{{3, 1, {}}, {1, 4, {}}}, 0, 0}, 2, free_of_cost) == 5, near);
  // the second thread works out the contacts of the first's second part, which the third needs
  BOOST_TEST(
      compare::modeled_step({{{2, 2, {}}, {1, 1, {2}}, {1, 1, {}}, {0, 1, {}}}, 0, 0}, 2, free_of_cost) == 5,
      near);
}

BOOST_AUTO_TEST_CASE(sharing_slows_work_and_meeting_takes_time) {
  const StepWork work{{{1, 1, {}}, {1, 1, {}}}, 2, 0.25};
  BOOST_TEST(compare::modeled_step(work, 2, {1.2, 0.1}) == 1.2 * 3 + 0.25 + 0.1, near);
}

BOOST_AUTO_TEST_SUITE_END()
