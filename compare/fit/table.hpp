#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/fit/choices.hpp"
#include "compare/fit/fit.hpp"
#include "compare/study/jobs.hpp"
#include "dem/record/table.hpp"

// The damping law fitted: what is measured for it, its tables, figures and what they say in words.
namespace fiberchain::compare {

/// What the laws are fitted to. Nominal fiber, incremental bonds, the paper's dashpots.
struct FitSweep {
  std::vector<int> aspect_ratio;  ///< fitted; by default 5 ... 30
  std::vector<int> held_out{40, 60};
  double poisson_ratio = 0.3;
  double bond_damping = 1;  ///< xi_b
  double load = 0.01;       ///< P L^2 / (E I)
  std::optional<PeakRange> peaks =
      std::nullopt;  ///< of a static release; without, a release from the first mode, load up to 0.01
  FitSweep();
};

struct FitStudy {
  FitSweep asked;
  std::vector<DampingDatum> points, held_out;
  ChainCurve chain;
  std::vector<DampingFit> fits;
  std::vector<ChoiceOutcome> choices;
};

/// Measures and fits; the choices at the paper's xi_b = 1. Throws InputError for what cannot be measured or
/// fitted, naming the aspect ratio.
FitStudy fit_study(const FitSweep& asked, const Jobs& jobs);

/// A row per law and way to fit.
dem::Table fit_table(const FitStudy& study);

/// A row per law, way to fit and aspect ratio.
dem::Table fit_residual_table(const FitStudy& study);

/// A row per choice, nearest to the paper's a and b first.
dem::Table fit_choice_table(const FitStudy& study);

/// What the tables say and what they do not, as paragraphs of Markdown.
std::string fit_notes(const FitStudy& study);

/// Figures by file name: fit-laws, fit-departure (from the linear chain), fit-choices.
std::vector<std::pair<std::string, Figure>> fit_figures(const FitStudy& study);

}  // namespace fiberchain::compare
