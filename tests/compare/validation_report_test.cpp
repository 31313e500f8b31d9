#include "compare/study/validation_report.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(validation_report_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::compare;

namespace {

ValidationRow row(double expected, double measured, double tolerance) {
  return {.id = "x",
          .feature = "a feature",
          .reference_kind = ReferenceKind::published,
          .expected = expected,
          .measured = measured,
          .tolerance = tolerance,
          .unit = "1",
          .verdict = Verdict::fails,
          .source = "somewhere",
          .evidence = "measured so"};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tolerance_decides_on_both_sides) {
  BOOST_TEST((judged(row(1, 1.25, 0.25)).verdict == Verdict::holds));
  BOOST_TEST((judged(row(1, 0.75, 0.25)).verdict == Verdict::holds));
  BOOST_TEST((judged(row(1, 1.26, 0.25)).verdict == Verdict::fails));
  BOOST_TEST((judged(row(1, 0.74, 0.25)).verdict == Verdict::fails));
}

BOOST_AUTO_TEST_CASE(a_number_that_is_none_fails) {
  BOOST_TEST((judged(row(1, std::nan(""), 0.25)).verdict == Verdict::fails));
  BOOST_TEST((judged(row(std::nan(""), 1, 0.25)).verdict == Verdict::fails));
  BOOST_TEST((judged(row(1, 1, std::nan(""))).verdict == Verdict::fails));
}

BOOST_AUTO_TEST_CASE(only_published_claims_can_be_disputed_and_only_with_evidence) {
  BOOST_TEST((disputed(row(1, 2, 0.1)).verdict == Verdict::disputed));
  ValidationRow exact = row(1, 2, 0.1);
  exact.reference_kind = ReferenceKind::exact;
  BOOST_CHECK_THROW(disputed(exact), dem::TableError);
  ValidationRow bare = row(1, 2, 0.1);
  bare.evidence = "";
  BOOST_CHECK_THROW(disputed(bare), dem::TableError);
}

BOOST_AUTO_TEST_CASE(the_matrix_holds_unless_a_row_fails) {
  ValidationRow good = judged(row(1, 1, 0.1));
  ValidationRow wrong_claim = disputed(row(1, 2, 0.1));
  ValidationRow bad = judged(row(1, 2, 0.1));
  BOOST_TEST(all_hold({good, wrong_claim}));
  BOOST_TEST(!all_hold({good, wrong_claim, bad}));
}

BOOST_AUTO_TEST_CASE(rows_become_a_table_with_unique_ids) {
  const ValidationRow first = judged(row(1, 1.125, 0.25));
  const dem::Table table = to_table({first});
  BOOST_TEST(table.number(0, "difference") == 0.125);
  BOOST_TEST(table.text(0, "verdict") == "holds");
  BOOST_TEST(table.text(0, "reference_kind") == "published");
  BOOST_CHECK_THROW(to_table({first, first}), dem::TableError);
}

BOOST_AUTO_TEST_SUITE_END()
