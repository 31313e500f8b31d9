// Claims against measures: every claim of data/published has one measure, and its rule sets the verdict.
#include "compare/study/validation.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <iterator>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(validation_test)

using namespace fiberchain::compare;

namespace {

std::vector<Measured> one(const ValidationInput&) { return {{1.25, {1.25}}}; }

Claim claim(const std::string& id) {
  return {.id = id,
          .subject = "pendulum",
          .feature = "swing",
          .kind = ReferenceKind::published,
          .quantity = "period",
          .value = 1,
          .tolerance = 0.5,
          .scale = ToleranceScale::unit,
          .basis = "theory",
          .range = ClaimedRange("< 1.2"),
          .reading = "as printed",
          .condition = "-",
          .otherwise = std::nullopt,
          .unit = "s",
          .source = "Huygens 1673",
          .page_or_figure = "p. 1",
          .statement = "isochronous",
          .evidence = "found {:.1f} s"};
}

std::vector<Claim> claims_of_the_project() {
  return read_all_published(std::string(FIBERCHAIN_SOURCE_DIR) + "/data");
}

/// A row of the claim as if everything came out as expected; `expected` where a measure would compute it.
ValidationRow expected_row(const Claim& claim) {
  Claim bare = claim;
  bare.evidence = "none";
  const bool computed = std::isnan(claim.value);
  Measured measured{.value = computed ? 100 : claim.value, .spread = 3};
  if (computed) measured.expected = 100;
  if (claim.otherwise) measured.otherwise = claim.otherwise->value;
  return row_of(bare, measured);
}

/// Whether a change of a row's number by `part` of its tolerance fails the matrix or flips the verdict.
bool is_noticed(const ValidationRow& row, double part, bool otherwise) {
  ValidationRow planted = row;
  if (otherwise) {
    planted.otherwise->measured += part * planted.otherwise->tolerance;
  } else {
    planted.measured += part * planted.tolerance;
  }
  planted = judged(planted);
  return !*planted.as_expected || planted.verdict != row.verdict;
}

bool is_noticed_both_ways(const ValidationRow& row) {
  return is_noticed(row, 2, false) && is_noticed(row, -2, false) &&
         (!row.otherwise || (is_noticed(row, 2, true) && is_noticed(row, -2, true)));
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
  const auto claims = claims_of_the_project();
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
  const auto rows = validation_rows({{claim("a"), claim("b")}, 1}, {{"pendulum", pendulum_checks}});
  BOOST_REQUIRE(rows.size() == 2);
  BOOST_TEST(rows[0].id == "a");
  BOOST_TEST(rows[1].id == "b");
  BOOST_TEST(rows[0].source == "Huygens 1673, p. 1: isochronous");
  BOOST_TEST(rows[0].evidence == "found 1.2 s");
}

BOOST_AUTO_TEST_CASE(a_measure_that_returns_too_few_is_refused) {
  static const Checks checks{{{"a", "b"}, one}};
  const auto few = []() -> const Checks& { return checks; };
  BOOST_CHECK_THROW(validation_rows({{claim("a"), claim("b")}, 1}, {{"pendulum", few}}), InputError);
}

BOOST_AUTO_TEST_CASE(the_verdict_follows_from_the_value_and_the_claim) {
  const auto row = [](double value) { return row_of(claim("a"), {value, {value}}); };
  BOOST_TEST((row(1.1).verdict == Verdict::holds));
  BOOST_TEST((row(1.3).verdict == Verdict::disputed));
  BOOST_TEST(*row(1.3).as_expected);
  BOOST_TEST(!*row(1.6).as_expected);
}

BOOST_AUTO_TEST_CASE(what_is_expected_and_what_is_measured_belong_together) {
  Claim conditional = claim("a"), computed = claim("a");
  conditional.condition = "by night", conditional.otherwise = {2, 0.1};
  computed.value = std::nan("");
  BOOST_TEST((row_of(conditional, {.value = 1, .evidence = {1.0}, .otherwise = 2.05}).verdict ==
              Verdict::holds_only_if));
  BOOST_CHECK_THROW(row_of(conditional, {1, {1.0}}), InputError);
  BOOST_CHECK_THROW(row_of(claim("a"), {.value = 1, .evidence = {1.0}, .otherwise = 2}), InputError);
  BOOST_CHECK_THROW(row_of(computed, {1, {1.0}}), InputError);
  BOOST_CHECK_THROW(row_of(claim("a"), {.value = 1, .evidence = {1.0}, .expected = 1}), InputError);
}

BOOST_AUTO_TEST_CASE(other_runs_are_judged_by_the_claim_alone) {
  const ValidationRow row = row_by_claim(claim("a"), {1.9, {1.9}});
  BOOST_TEST((row.verdict == Verdict::disputed));
  BOOST_TEST(!row.as_expected.has_value());
  BOOST_TEST(std::isnan(row.expected));
}

// In every row of every feature, on both sides of its condition.
BOOST_AUTO_TEST_CASE(a_planted_change_of_twice_the_tolerance_is_noticed_in_every_row) {
  for (const Claim& claim : claims_of_the_project()) {
    const ValidationRow row = expected_row(claim);
    BOOST_TEST(*row.as_expected, claim.id);
    BOOST_TEST(is_noticed_both_ways(row), claim.id);
    BOOST_TEST(!is_noticed(row, 0.9, false), claim.id);
  }
}

// The same with what is really measured, where that takes no time.
BOOST_AUTO_TEST_CASE(a_planted_change_is_noticed_in_measured_rows) {
  const ValidationInput input{claims_of_the_project(), 2};
  for (const std::string_view name : {"beams", "static", "damping"}) {
    const auto subject = std::ranges::find(validation_subjects(), name, &ValidationSubject::name);
    for (const ValidationRow& row : validation_rows(input, {*subject})) {
      BOOST_TEST(*row.as_expected, row.id);
      BOOST_TEST(is_noticed_both_ways(row), row.id);
    }
  }
}

// What passes is on one side of its claim: a verdict cannot depend on the machine.
BOOST_AUTO_TEST_CASE(an_expected_value_and_its_tolerance_decide_the_verdict) {
  for (const Claim& claim : claims_of_the_project()) {
    if (!claim.range) continue;
    BOOST_TEST(claim.range->decides(claim.value - claim.tolerance, claim.value + claim.tolerance), claim.id);
    if (!claim.otherwise) continue;
    const auto [value, tolerance] = *claim.otherwise;
    BOOST_TEST(claim.range->decides(value - tolerance, value + tolerance), claim.id);
  }
}

BOOST_AUTO_TEST_CASE(every_row_of_the_paper_has_a_claim_and_is_found_from_the_paper) {
  std::ifstream file(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/published/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  for (const Claim& claim : claims_of_the_project()) {
    if (!claim.id.starts_with("paper-")) continue;
    BOOST_TEST(claim.range.has_value(), claim.id);
    BOOST_TEST((readme.find("`" + claim.id + "`") != std::string::npos), claim.id);
  }
}

BOOST_AUTO_TEST_CASE(a_tolerance_is_in_its_scale) {
  Claim relative = claim("a");
  relative.value = std::nan("");
  relative.scale = ToleranceScale::value;
  BOOST_TEST(row_of(relative, {.value = 5, .evidence = {5.0}, .expected = -4.0}).tolerance == 2);
  relative.scale = ToleranceScale::spread;
  BOOST_TEST(row_of(relative, {.value = 5, .evidence = {5.0}, .expected = 4, .spread = 3}).tolerance == 1.5);
}

BOOST_AUTO_TEST_CASE(an_evidence_text_with_more_fields_than_measured_is_refused) {
  BOOST_CHECK_THROW(row_of(claim("a"), {1.0}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
