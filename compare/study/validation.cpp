#include "compare/study/validation.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"

namespace fiberchain::compare {
namespace {

std::string evidence_of(const Claim& claim, const std::vector<EvidenceField>& fields) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const EvidenceField& field : fields) {
    std::visit([&](const auto& value) { store.push_back(value); }, field);
  }
  try {
    return fmt::vformat(claim.evidence, store);
  } catch (const fmt::format_error& error) {
    throw InputError(fmt::format("claim '{}': evidence: {}", claim.id, error.what()));
  }
}

std::string source_of(const Claim& claim) {
  if (claim.kind != ReferenceKind::published) return claim.source;
  return claim.source + ", " + claim.page_or_figure + ": " + claim.statement;
}

double tolerance_of(const Claim& claim, double expected, double spread) {
  if (claim.scale == ToleranceScale::value) return claim.tolerance * std::abs(expected);
  if (claim.scale == ToleranceScale::spread) return claim.tolerance * spread;
  return claim.tolerance;
}

/// Row of a claim of rule `either`, which holds or is disputed for the claim's reason.
ValidationRow held_or_disputed(ValidationRow row, const Claim& claim) {
  row = judged(std::move(row));
  if (row.verdict == Verdict::holds) return row;
  row.tolerance = nan;
  row.evidence += ". " + claim.dispute;
  return disputed(std::move(row));
}

}  // namespace

const std::vector<ValidationSubject>& validation_subjects() {
  static const std::vector<ValidationSubject> subjects{
      {"beams", beam_checks},        {"static", static_checks},       {"damping", damping_checks},
      {"friction", friction_checks}, {"stability", stability_checks}, {"flow", flow_checks},
      {"packing", packing_checks}};
  return subjects;
}

ValidationRow row_of(const Claim& claim, const Measured& measured) {
  const double expected = measured.expected.value_or(claim.value);
  ValidationRow row{.id = claim.id,
                    .feature = claim.feature,
                    .reference_kind = claim.kind,
                    .expected = expected,
                    .measured = measured.value,
                    .tolerance = tolerance_of(claim, expected, measured.spread),
                    .unit = claim.unit,
                    .verdict = Verdict::fails,
                    .source = source_of(claim),
                    .evidence = evidence_of(claim, measured.evidence)};
  if (claim.rule == VerdictRule::disputed) return disputed(std::move(row));
  return claim.rule == VerdictRule::either ? held_or_disputed(std::move(row), claim) : judged(std::move(row));
}

void check_complete(const std::vector<Claim>& claims, std::string_view subject, const Checks& checks) {
  std::vector<std::string_view> measured;
  for (const Check& check : checks) measured.insert(measured.end(), check.ids.begin(), check.ids.end());
  for (const Claim& claim : claims) {
    if (claim.subject == subject && std::ranges::count(measured, claim.id) != 1) {
      throw InputError(fmt::format("claim '{}' of {}.csv must have one measure, has {}", claim.id, subject,
                                   std::ranges::count(measured, claim.id)));
    }
  }
  for (const std::string_view id : measured) {
    const auto found = std::ranges::find(claims, id, &Claim::id);
    if (found == claims.end() || found->subject != subject) {
      throw InputError(fmt::format("measure '{}' has no claim in {}.csv", id, subject));
    }
  }
}

std::vector<ValidationRow> validation_rows(const ValidationInput& input, const ValidationSubject& subject) {
  const Checks& checks = subject.checks();
  check_complete(input.claims, subject.name, checks);
  std::vector<std::pair<std::string_view, Measured>> found;
  for (const Check& check : checks) {
    const std::vector<Measured> measured = check.measure(input);
    if (measured.size() != check.ids.size()) {
      throw InputError(fmt::format("the measure of '{}' and its like returned {} values for {} claims",
                                   check.ids.front(), measured.size(), check.ids.size()));
    }
    for (std::size_t i = 0; i < measured.size(); ++i) found.emplace_back(check.ids[i], measured[i]);
  }
  std::vector<ValidationRow> rows;
  for (const Claim& claim : input.claims) {
    if (claim.subject != subject.name) continue;
    rows.push_back(row_of(
        claim, std::ranges::find(found, claim.id, &std::pair<std::string_view, Measured>::first)->second));
  }
  return rows;
}

}  // namespace fiberchain::compare
