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
          .quantity = "a quantity",
          .expected = expected,
          .measured = measured,
          .tolerance = tolerance,
          .unit = "1",
          .claim = std::nullopt,
          .condition = "-",
          .otherwise = std::nullopt,
          .as_expected = std::nullopt,
          .verdict = Verdict::fails,
          .reading = "-",
          .basis = "-",
          .source = "somewhere",
          .evidence = "measured so"};
}

/// A value that is expected to a tenth, claimed to be above 1.
ValidationRow claimed(double measured) {
  ValidationRow claimed = row(measured, measured, 0.1);
  claimed.claim = ClaimedRange("> 1");
  return claimed;
}

ValidationRow conditional(double measured, double otherwise) {
  ValidationRow conditional = claimed(measured);
  conditional.condition = "in the shade";
  conditional.otherwise = MeasuredOtherwise{otherwise, otherwise, 0.1};
  return conditional;
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

BOOST_AUTO_TEST_CASE(a_verdict_on_a_claim_follows_from_the_measured_value) {
  BOOST_TEST((judged(claimed(1.5)).verdict == Verdict::holds));
  BOOST_TEST((judged(claimed(0.5)).verdict == Verdict::disputed));
  BOOST_TEST((judged(claimed(std::nan(""))).verdict == Verdict::disputed));
  BOOST_TEST(*judged(claimed(0.5)).as_expected);
}

BOOST_AUTO_TEST_CASE(a_condition_counts_where_the_claim_needs_it) {
  BOOST_TEST((judged(conditional(1.5, 0.5)).verdict == Verdict::holds_only_if));
  BOOST_TEST((judged(conditional(1.5, 1.2)).verdict == Verdict::holds));
  BOOST_TEST((judged(conditional(0.5, 1.2)).verdict == Verdict::disputed));
  ValidationRow unmeasured = conditional(1.5, 0.5);
  unmeasured.otherwise.reset();
  BOOST_TEST((judged(unmeasured).verdict == Verdict::holds_only_if));
}

BOOST_AUTO_TEST_CASE(what_is_measured_otherwise_must_be_as_expected_too) {
  ValidationRow off = conditional(1.5, 0.5);
  off.otherwise->measured = 0.7;
  BOOST_TEST(!*judged(off).as_expected);
  off.otherwise->measured = std::nan("");
  BOOST_TEST(!*judged(off).as_expected);
}

BOOST_AUTO_TEST_CASE(runs_of_which_nothing_is_expected_are_judged_by_the_claim) {
  const ValidationRow found = judged_by_claim(claimed(1.5));
  BOOST_TEST((found.verdict == Verdict::holds));
  BOOST_TEST(!found.as_expected.has_value());
  BOOST_CHECK_THROW(judged_by_claim(row(1, 1, 0.1)), dem::TableError);
}

BOOST_AUTO_TEST_CASE(the_matrix_fails_where_a_row_is_not_as_expected) {
  const ValidationRow good = judged(row(1, 1, 0.1)), wrong_claim = judged(claimed(0.5));
  ValidationRow off = claimed(0.5);
  off.measured = 0.75;
  BOOST_TEST(all_as_expected({good, wrong_claim}));
  BOOST_TEST(!all_as_expected({good, judged(row(1, 2, 0.1))}));
  BOOST_TEST(!all_as_expected({good, wrong_claim, judged(off)}));
}

BOOST_AUTO_TEST_CASE(a_claimed_range_is_one_of_its_forms) {
  const auto has = [](const char* text, double value) { return ClaimedRange(text).contains(value); };
  BOOST_TEST((has("1..2", 1) && has("1..2", 2) && !has("1..2", 0.999) && !has("1..2", 2.001)));
  BOOST_TEST((has("< 3.3", 3.2) && !has("< 3.3", 3.3) && has("<= 3.3", 3.3)));
  BOOST_TEST((has("> -1", 0) && !has("> -1", -1) && has(">= -1", -1)));
  BOOST_TEST((has("not 0.95..1.05", 1.06) && !has("not 0.95..1.05", 1.05)));
  BOOST_TEST(!has("< 3.3", std::nan("")));
  BOOST_TEST(!has("not 1..2", std::nan("")));
  for (const char* text : {"", "1", "2..1", "1..1", "above 1", "<1", "1..", "> nan", "< inf", "1..2 "}) {
    BOOST_CHECK_THROW(ClaimedRange{text}, InputError);
  }
}

BOOST_AUTO_TEST_CASE(a_range_decides_what_lies_on_one_side_of_it) {
  BOOST_TEST((ClaimedRange("1..2").decides(1.2, 1.8) && ClaimedRange("1..2").decides(2.5, 3)));
  BOOST_TEST((!ClaimedRange("1..2").decides(1.8, 2.2) && !ClaimedRange("1..2").decides(0, 3)));
  BOOST_TEST((ClaimedRange("not 1..2").decides(3, 4) && !ClaimedRange("not 1..2").decides(0, 3)));
  BOOST_TEST((ClaimedRange("> 1").decides(0, 1) && !ClaimedRange("> 1").decides(0, 1.1)));
}

BOOST_AUTO_TEST_CASE(rows_become_a_table_with_unique_ids) {
  const ValidationRow first = judged(row(1, 1.125, 0.25));
  const dem::Table table = to_table({first});
  BOOST_TEST(table.number(0, "difference") == 0.125);
  BOOST_TEST(table.text(0, "verdict") == "holds");
  BOOST_TEST(table.text(0, "as_expected") == "yes");
  BOOST_TEST(table.text(0, "claim") == "-");
  BOOST_TEST(table.text(0, "reference_kind") == "published");
  BOOST_CHECK_THROW(to_table({first, first}), dem::TableError);
}

BOOST_AUTO_TEST_SUITE_END()
