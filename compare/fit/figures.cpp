#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compare/fit/table.hpp"

namespace fiberchain::compare {
namespace {

const char* formula(DampingLaw law) {
  switch (law) {
    case DampingLaw::exponential:
      return "{/:Italic a} e^{-{/:Italic b r_f}}";
    case DampingLaw::power:
      return "{/:Italic a r_f}^{-{/:Italic b}}";
    default:
      return "(β_1^2/√20)/({/:Italic r_f} + {/:Italic c})^2";
  }
}

std::string label(const DampingModel& model) {
  switch (model.kind) {
    case FitKind::published:
      return "paper's Eq 20";
    case FitKind::derived:
      return std::string(formula(model.law)) + ", {/:Italic c} = 1/2";
    default:
      return fmt::format("{}, {}", formula(model.law), name(model.kind));
  }
}

/// What is drawn of the eight: each law once as the paper fitted, once in the logarithm, and the paper's own.
bool shown(const DampingModel& model) {
  return model.kind != FitKind::derived &&
         !(model.law == DampingLaw::shifted_square && model.kind == FitKind::unweighted);
}

Dash dash_of(const DampingModel& model) {
  if (model.kind == FitKind::published) return Dash::dotted;
  return model.kind == FitKind::unweighted ? Dash::dashed : Dash::solid;
}

int color_of(const DampingModel& model) {
  return model.kind == FitKind::published ? 4 : 1 + static_cast<int>(model.law);
}

Series points_series(std::string name, const std::vector<DampingDatum>& points, int color) {
  Series s{std::move(name), {}, {}, Mark::points};
  s.color = color;
  for (const DampingDatum& p : points) s.add(p.aspect_ratio, p.slope);
  return s;
}

/// A law over r_f = 3 ... 100, above what a logarithmic axis shows.
Series law_series(const DampingFit& fit) {
  Series s{label(fit.model), {}, {}, Mark::line, dash_of(fit.model)};
  s.color = color_of(fit.model);
  for (int i = 0; i <= 200; ++i) {
    const double r_f = 3 * std::pow(100.0 / 3, i / 200.0);
    const double y = damping_law(fit.model.law, fit.parameters, r_f);
    if (y < 1e-5) break;
    s.add(r_f, y);
  }
  return s;
}

Figure laws_figure(const FitStudy& study) {
  Figure figure{"Damping of the fiber against aspect ratio, and laws fitted to it",
                {"{/:Italic r_f}", true, std::pair{3.0, 100.0}},
                {"ξ_f/ξ_b", true, std::pair{1e-5, 0.1}},
                {}};
  for (const DampingFit& fit : study.fits) {
    if (shown(fit.model)) figure.series.push_back(law_series(fit));
  }
  figure.series.push_back(points_series("chain, fitted", study.points, 0));
  if (!study.held_out.empty()) figure.series.push_back(points_series("chain, held out", study.held_out, 5));
  return figure;
}

Figure departure_figure(const FitStudy& study) {
  Figure figure{"Departure of the fitted laws from the linear chain",
                {"{/:Italic r_f}", true, std::pair{3.0, 500.0}},
                {"|law/chain - 1| (%)", true, std::pair{1e-4, 200.0}},
                {}};
  for (const DampingFit& fit : study.fits) {
    if (!shown(fit.model)) continue;
    Series s{label(fit.model), {}, {}, Mark::line, dash_of(fit.model)};
    s.color = color_of(fit.model);
    for (std::size_t i = 0; i < study.chain.slope.size(); ++i) {
      const double r_f = study.chain.range.first + static_cast<double>(i);
      s.add(r_f, 100 * std::abs(damping_law(fit.model.law, fit.parameters, r_f) / study.chain.slope[i] - 1));
    }
    figure.series.push_back(s);
  }
  return figure;
}

Figure choices_figure(const FitStudy& study) {
  Figure figure{
      "{/:Italic a} and {/:Italic b} of the exponential under choices that the paper does not state",
      {"{/:Italic a}"},
      {"{/:Italic b}"},
      {}};
  for (const FitKind kind : {FitKind::unweighted, FitKind::logarithmic}) {
    Series s{std::string(name(kind)), {}, {}, Mark::points};
    for (const ChoiceOutcome& outcome : study.choices) {
      if (outcome.choice.weighting != kind) continue;
      s.add(outcome.fit.parameters[0], outcome.fit.parameters[1]);
    }
    figure.series.push_back(s);
  }
  Series paper{"paper, within 5 %", {}, {}, Mark::line};
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}) {
    paper.add(kPaperA * (1 + 0.05 * x), kPaperB * (1 + 0.05 * y));
  }
  figure.series.push_back(paper);
  return figure;
}

}  // namespace

std::vector<std::pair<std::string, Figure>> fit_figures(const FitStudy& study) {
  return {{"fit-laws", laws_figure(study)},
          {"fit-departure", departure_figure(study)},
          {"fit-choices", choices_figure(study)}};
}

}  // namespace fiberchain::compare
