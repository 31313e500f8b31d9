#include "compare/study/validation.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

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

[[noreturn]] void refuse(const Claim& claim, const char* why) {
  throw InputError(fmt::format("claim '{}': {}", claim.id, why));
}

/// The one value that is expected: the claim's, or that of a reference computed with the measure.
double expected_of(const Claim& claim, const Measured& measured) {
  if (std::isnan(claim.value) != measured.expected.has_value()) {
    refuse(claim, "give an expected value in column value or by its measure, not both or none");
  }
  return measured.expected.value_or(claim.value);
}

std::optional<MeasuredOtherwise> otherwise_of(const Claim& claim, const Measured& measured) {
  if (claim.otherwise.has_value() != measured.otherwise.has_value()) {
    refuse(claim, "otherwise must be expected and measured, or neither");
  }
  if (!claim.otherwise) return std::nullopt;
  return MeasuredOtherwise{claim.otherwise->value, *measured.otherwise, claim.otherwise->tolerance};
}

/// The row before it is judged.
ValidationRow unjudged(const Claim& claim, const Measured& measured) {
  const double expected = expected_of(claim, measured);
  return {.id = claim.id,
          .feature = claim.feature,
          .reference_kind = claim.kind,
          .quantity = claim.quantity,
          .expected = expected,
          .measured = measured.value,
          .tolerance = tolerance_of(claim, expected, measured.spread),
          .unit = claim.unit,
          .claim = claim.range,
          .condition = claim.condition,
          .otherwise = otherwise_of(claim, measured),
          .as_expected = std::nullopt,
          .verdict = Verdict::fails,
          .reading = claim.reading,
          .basis = claim.basis,
          .source = source_of(claim),
          .evidence = evidence_of(claim, measured.evidence)};
}

/// What a check measured, in the order of its ids.
using Found = std::vector<Measured>;

Found measured(const ValidationInput& input, const Check& check) {
  Found found = check.measure(input);
  if (found.size() != check.ids.size()) {
    throw InputError(fmt::format("the measure of '{}' and its like returned {} values for {} claims",
                                 check.ids.front(), found.size(), check.ids.size()));
  }
  return found;
}

/// All checks of the subjects, one after the other, and which of them are to be measured.
struct Measurements {
  std::vector<const Check*> checks;
  std::vector<std::size_t> own;
};

Measurements measurements_of(const std::vector<ValidationSubject>& subjects,
                             const std::optional<Shard>& shard) {
  constexpr double least_cost = 0.3;  // of those that say nothing of it [s]
  Measurements all;
  std::vector<double> costs;
  for (const ValidationSubject& subject : subjects) {
    for (const Check& check : subject.checks()) {
      all.checks.push_back(&check);
      costs.push_back(std::max(check.cost, least_cost));
    }
  }
  all.own = dealt_by_cost(shard.value_or(Shard{}), costs);
  return all;
}

/// What checks have found; none for those of other shards and those that were not begun.
using Findings = std::vector<std::optional<Found>>;

Findings measured(const ValidationInput& input, const Measurements& all, const ValidationWatch& watch) {
  std::vector<double> costs;
  for (const std::size_t n : all.own) costs.push_back(all.checks[n]->cost);
  Findings found(all.checks.size());
  input.jobs.run_dearest_first(costs, [&](std::size_t i) {
    if (watch.stopped()) return;
    const std::size_t n = all.own[i];
    found[n] = measured(input, *all.checks[n]);
    watch.advance();
  });
  return found;
}

/// The rows of a subject whose checks have found this.
void add_rows(const ValidationInput& input, const ValidationSubject& subject, const Findings& found,
              std::vector<ValidationRow>& rows) {
  std::map<std::string_view, const Measured*> by_id;
  for (std::size_t n = 0; n < found.size(); ++n) {
    if (!found[n]) continue;
    const Check& check = subject.checks()[n];
    for (std::size_t i = 0; i < check.ids.size(); ++i) by_id[check.ids[i]] = &(*found[n])[i];
  }
  for (const Claim& claim : input.claims) {
    if (claim.subject != subject.name) continue;
    if (const auto measured = by_id.find(claim.id); measured != by_id.end())
      rows.push_back(row_of(claim, *measured->second));
  }
}

}  // namespace

Checks merged(Checks first, const Checks& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

const std::vector<ValidationSubject>& validation_subjects() {
  static const std::vector<ValidationSubject> subjects{
      {"beams", beam_checks},          {"static", static_checks},     {"damping", damping_checks},
      {"friction", friction_checks},   {"contact", contact_checks},   {"materials", material_checks},
      {"stability", stability_checks}, {"flow", flow_checks},         {"packing", packing_checks},
      {"press", press_checks},         {"breaking", breaking_checks}, {"spacing", spacing_checks},
      {"capstan", capstan_checks},     {"rods", rods_checks},         {"rod_packing", rod_packing_checks}};
  return subjects;
}

ValidationRow row_of(const Claim& claim, const Measured& measured) {
  return judged(unjudged(claim, measured));
}

ValidationRow row_by_claim(const Claim& claim, const Measured& measured) {
  if (!claim.range) return row_of(claim, measured);
  ValidationRow row = unjudged(claim, measured);
  row.expected = row.tolerance = nan;
  row.basis = "-";
  row.otherwise.reset();
  if (row.condition != "-") row.condition = "the runs at hand (evidence)";
  return judged_by_claim(std::move(row));
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

std::size_t measurements(const std::vector<ValidationSubject>& subjects, const std::optional<Shard>& shard) {
  return measurements_of(subjects, shard).own.size();
}

std::vector<ValidationRow> validation_rows(const ValidationInput& input,
                                           const std::vector<ValidationSubject>& subjects,
                                           const ValidationWatch& watch) {
  for (const ValidationSubject& subject : subjects)
    check_complete(input.claims, subject.name, subject.checks());
  const Measurements all = measurements_of(subjects, input.shard);
  const Findings found = measured(input, all, watch);
  std::vector<ValidationRow> rows;
  std::size_t first = 0;
  for (const ValidationSubject& subject : subjects) {
    const std::size_t end = first + subject.checks().size();
    const auto not_begun = [&](std::size_t n) { return n >= first && n < end && !found[n]; };
    if (std::ranges::none_of(all.own, not_begun)) {
      const auto begin = found.begin();
      add_rows(input, subject,
               {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end)}, rows);
    }
    first = end;
  }
  return rows;
}

}  // namespace fiberchain::compare
