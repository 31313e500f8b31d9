#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compare/study/jobs.hpp"
#include "compare/study/published.hpp"
#include "compare/study/shard.hpp"
#include "compare/study/validation_report.hpp"

/// The validation matrix: claims are data (published.hpp), their measures are tables of id and function, one
/// a subject.
namespace fiberchain::compare {

struct ValidationInput {
  std::vector<Claim> claims;
  Jobs jobs = 1;
  std::optional<Shard> shard = {};  ///< measurements that are made; without it all
};

/// A number or word that a field of the claim's evidence text shows.
using EvidenceField = std::variant<double, int, std::string>;

struct Measured {
  double value;                           ///< in the unit of the claim
  std::vector<EvidenceField> evidence{};  ///< fields of the claim's text, in order
  std::optional<double> expected{};       ///< value of a reference that is computed, not published
  double spread = 0;                      ///< of the runs, where the claim's tolerance is a multiple of it
  std::optional<double> otherwise{};      ///< value where the claim's condition does not hold
};

/// Measurement of claims that share their runs.
struct Check {
  std::vector<std::string> ids;
  std::vector<Measured> (*measure)(const ValidationInput& input);  ///< one for each id
  double cost = 0;                                                 ///< processor time, about; 0: below 1 [s]
};

using Checks = std::vector<Check>;

/// Both, one after the other.
Checks merged(Checks first, const Checks& second);

/// Elastica and Reissner beam: against published values and against each other.
const Checks& beam_checks();

/// The chain's statics: the paper's statements on Figs 3 and 4 and the aspect ratios it recommends, exact
/// results, marching against solving.
const Checks& static_checks();

/// Damped vibration: the paper's statements on Figs 7 to 9 and Eq 20, the march against linear modes, the
/// closed form.
const Checks& damping_checks();

/// Rolling friction: the paper's statements on Fig 10; the incremental form's stretch.
const Checks& friction_checks();

/// Contacts alone: impacts by Chung & Ooi's tests, adhesion.
const Checks& contact_checks();

/// Materials: the paper's statement on damping in a complex domain, chains in time against complex moduli.
const Checks& material_checks();

/// The largest stable step: theory against runs, the paper's rules for the time step.
const Checks& stability_checks();

/// Fibers in flows: Jeffery's orbits, the paper's statements on Fig 5, interactions, buckling, inertia.
const Checks& flow_checks();

/// Packings: the paper's statements on Figs 11 and 12, energy, half the step.
const Checks& packing_checks();

/// Beds under a plate: van Wyk's exponent.
const Checks& press_checks();

/// Bonds that break: rods of uniform curvature that are let go.
const Checks& breaking_checks();

/// Fibers cut into bonds longer than thick: orders, modes, damping, time step, bonds saved.
const Checks& spacing_checks();

/// Packings of stiff rods: solid fraction, contacts, both surfaces.
const Checks& rod_packing_checks();

/// Rods in space: orders, published figures, numbering and paths.
const Checks& rods_checks();
/// Fibers that slide about a drum: ratio of their tensions.
const Checks& capstan_checks();

/// A subject of the matrix, which has a file of claims and a table of measures.
struct ValidationSubject {
  std::string_view name;  ///< of the file, and on the command line
  const Checks& (*checks)();
};

/// Every subject, in the order of the matrix.
const std::vector<ValidationSubject>& validation_subjects();

/// Whether the subject's claims and its measures are the same ids.
/// @throws InputError naming a claim without a measure or a measure without a claim
void check_complete(const std::vector<Claim>& claims, std::string_view subject, const Checks& checks);

/// Who watches the matrix while it is measured.
struct ValidationWatch {
  std::function<void()> advance = [] {};                 ///< called after each measurement, from any thread
  std::function<bool()> stopped = [] { return false; };  ///< then no other is begun
};

/// Rows of the subjects in their order, each subject's in the order of its claims. All are measured side by
/// side, the dearest first. When stopped, of the subjects that were measured whole. Of a shard, rows of its
/// measurements, which are dealt by their costs.
/// @throws InputError as above, or where a measure does not return a value for each id
///   or does not fill the claim's evidence text
std::vector<ValidationRow> validation_rows(const ValidationInput& input,
                                           const std::vector<ValidationSubject>& subjects,
                                           const ValidationWatch& watch = {});

/// Measurements that rows of these subjects take, or a shard of them.
std::size_t measurements(const std::vector<ValidationSubject>& subjects,
                         const std::optional<Shard>& shard = {});

/// The claim's row, judged.
/// @throws InputError if the evidence text has more fields than were measured, or if what is expected and
///   what is measured do not belong together
ValidationRow row_of(const Claim& claim, const Measured& measured);

/// The same for runs that are not those of the matrix: of a published claim nothing is expected, its verdict
/// follows from the measured value alone, and these runs are its condition if it has one.
ValidationRow row_by_claim(const Claim& claim, const Measured& measured);

}  // namespace fiberchain::compare
