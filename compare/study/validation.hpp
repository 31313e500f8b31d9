#pragma once

#include <functional>
#include <vector>

#include "compare/study/validation_report.hpp"
#include "compare/study/published.hpp"

// The rows of the validation matrix, feature by feature.
namespace fiberchain::compare {

struct ValidationInput {
  std::vector<PublishedValue> published;
  int jobs = 1;
};

/// Elastica and Reissner beam: against published values and against each other.
std::vector<MatrixRow> beam_rows(const ValidationInput& input);

/// The chain's statics: the paper's statements on Figs 3 and 4, exact results, marching against solving.
std::vector<MatrixRow> static_rows(const ValidationInput& input);

/// Damped vibration: the paper's statements on Figs 7 to 9 and Eq 20, the march against linear modes, the closed form.
std::vector<MatrixRow> damping_rows(const ValidationInput& input);

/// Rolling friction: the paper's statements on Fig 10; the incremental form's stretch; the recommended aspect ratio.
std::vector<MatrixRow> rolling_rows(const ValidationInput& input);

/// The largest stable step: theory against runs, the paper's rules for the time step.
std::vector<MatrixRow> stability_rows(const ValidationInput& input);

/// Fibers in flows: Jeffery's orbits, the paper's statements on Fig 5, interactions, buckling, inertia.
std::vector<MatrixRow> flow_rows(const ValidationInput& input);

/// Packings: the paper's statements on Figs 11 and 12, energy, half the step.
std::vector<MatrixRow> packing_rows(const ValidationInput& input);

/// A piece of the matrix that is worked out on its own.
struct ValidationStep {
  std::string_view feature;
  std::vector<MatrixRow> (*rows)(const ValidationInput&);
};

/// Every piece, in the order of the matrix.
const std::vector<ValidationStep>& validation_steps();

/// A row with its verdict set by the tolerance.
MatrixRow exact_row(std::string id, std::string feature, double expected, double measured, double tolerance,
                    std::string source, std::string evidence);

/// The same against another method of our own.
MatrixRow method_row(std::string id, std::string feature, double expected, double measured, double tolerance,
                     std::string source, std::string evidence);

/// A row of a published value, judged by the tolerance. Throws InputError if the value is not in the data.
MatrixRow published_row(const ValidationInput& input, std::string_view id, double measured, double tolerance,
                        std::string evidence);

/// The same where the statement does not hold: disputed, with the evidence.
MatrixRow disputed_row(const ValidationInput& input, std::string_view id, double measured, std::string evidence);

}  // namespace fiberchain::compare
