// Claims against measures: every claim of data/published has one measure, and its rule sets the verdict.
#include "compare/study/validation.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(validation_test)

using namespace fiberchain::compare;

namespace {

std::vector<Measured> one(const ValidationInput&) { return {{1.25, {1.25}}}; }

Claim claim(const std::string& id, VerdictRule rule = VerdictRule::must_hold) {
  return {.id = id,
          .subject = "pendulum",
          .feature = "swing",
          .kind = ReferenceKind::published,
          .quantity = "period",
          .value = 1,
          .tolerance = 0.5,
          .scale = ToleranceScale::unit,
          .rule = rule,
          .unit = "s",
          .source = "Huygens 1673",
          .page_or_figure = "p. 1",
          .statement = "isochronous",
          .evidence = "found {:.1f} s",
          .dispute = "too large a swing"};
}

const Checks& pendulum_checks() {
  static const Checks checks{{{"b"}, one}, {{"a"}, one}};
  return checks;
}

std::string error_of(const std::vector<Claim>& claims, const Checks& checks) {
  try {
    check_complete(claims, "pendulum", checks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(claims_and_measures_of_the_project_are_the_same_ids) {
  const auto claims = read_all_published(std::string(FIBERCHAIN_SOURCE_DIR) + "/data");
  std::size_t of_subjects = 0;
  for (const ValidationSubject& subject : validation_subjects()) {
    BOOST_CHECK_NO_THROW(check_complete(claims, subject.name, subject.checks()));
    of_subjects += static_cast<std::size_t>(std::ranges::count(claims, subject.name, &Claim::subject));
  }
  BOOST_TEST(of_subjects == claims.size());  // no file without a subject
}

BOOST_AUTO_TEST_CASE(a_claim_without_a_measure_is_named) {
  BOOST_TEST(error_of({claim("a"), claim("b")}, {{{"a"}, one}}) ==
             "claim 'b' of pendulum.csv must have one measure, has 0");
  BOOST_TEST(error_of({claim("a")}, {{{"a"}, one}, {{"a"}, one}}) ==
             "claim 'a' of pendulum.csv must have one measure, has 2");
}

BOOST_AUTO_TEST_CASE(a_measure_without_a_claim_is_named) {
  BOOST_TEST(error_of({claim("a")}, {{{"a", "b"}, one}}) == "measure 'b' has no claim in pendulum.csv");
  Claim elsewhere = claim("b");
  elsewhere.subject = "spring";
  BOOST_TEST(error_of({claim("a"), elsewhere}, {{{"a", "b"}, one}}) ==
             "measure 'b' has no claim in pendulum.csv");
}

BOOST_AUTO_TEST_CASE(rows_come_in_the_order_of_the_claims) {
  const auto rows = validation_rows({{claim("a"), claim("b")}, 1}, {"pendulum", pendulum_checks});
  BOOST_REQUIRE(rows.size() == 2);
  BOOST_TEST(rows[0].id == "a");
  BOOST_TEST(rows[1].id == "b");
  BOOST_TEST(rows[0].source == "Huygens 1673, p. 1: isochronous");
  BOOST_TEST(rows[0].evidence == "found 1.2 s");
}

BOOST_AUTO_TEST_CASE(a_measure_that_returns_too_few_is_refused) {
  static const Checks checks{{{"a", "b"}, one}};
  const auto few = []() -> const Checks& { return checks; };
  BOOST_CHECK_THROW(validation_rows({{claim("a"), claim("b")}, 1}, {"pendulum", few}), InputError);
}

BOOST_AUTO_TEST_CASE(the_rule_sets_the_verdict) {
  using enum VerdictRule;
  const auto verdict = [](VerdictRule rule, double value) {
    return row_of(claim("a", rule), {value, {value}}).verdict;
  };
  BOOST_TEST((verdict(must_hold, 1.5) == Verdict::holds));
  BOOST_TEST((verdict(must_hold, 1.6) == Verdict::fails));
  BOOST_TEST((verdict(disputed, 1.0) == Verdict::disputed));
  BOOST_TEST((verdict(either, 0.5) == Verdict::holds));
  const ValidationRow row = row_of(claim("a", either), {0.4, {0.4}});
  BOOST_TEST((row.verdict == Verdict::disputed));
  BOOST_TEST(row.evidence == "found 0.4 s. too large a swing");
  BOOST_TEST(std::isnan(row.tolerance));
}

BOOST_AUTO_TEST_CASE(a_tolerance_is_in_its_scale) {
  Claim relative = claim("a");
  relative.scale = ToleranceScale::value;
  BOOST_TEST(row_of(relative, {.value = 5, .evidence = {5.0}, .expected = -4.0}).tolerance == 2);
  relative.scale = ToleranceScale::spread;
  BOOST_TEST(row_of(relative, {.value = 5, .evidence = {5.0}, .spread = 3}).tolerance == 1.5);
}

BOOST_AUTO_TEST_CASE(an_evidence_text_with_more_fields_than_measured_is_refused) {
  BOOST_CHECK_THROW(row_of(claim("a"), {1.0}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
