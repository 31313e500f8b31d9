#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/fit/table.hpp"

// What the fits say in words.
namespace fiberchain::compare {
namespace {

constexpr double paper_slope_8 = 0.01045, paper_slope_10 = 0.00698;

std::string data_note(const FitStudy& study) {
  const FitSweep& asked = study.asked;
  const std::string quantity = asked.peaks ? fmt::format("released from rest under load, peaks {}..{}",
                                                         asked.peaks->first, asked.peaks->last)
                                           : std::string("released from its first mode");
  return fmt::format(
      "Fitted: xi_f/xi_b of the chain, {}, load {:g}, xi_b = {:g}, nu = {:g}, at aspect ratios {}; held out "
      "and never "
      "fitted: {}. The data are deterministic: the 95 % intervals and covariances show how badly a law fits, "
      "not noise.",
      quantity, asked.load, asked.bond_damping, asked.poisson_ratio, describe(asked.aspect_ratio),
      asked.held_out.empty() ? "none" : describe(asked.held_out));
}

const DampingFit& find(const FitStudy& study, DampingLaw law, FitKind kind) {
  return *std::ranges::find_if(
      study.fits, [&](const DampingFit& fit) { return fit.model.law == law && fit.model.kind == kind; });
}

/// Lowest criterion of a law, either way of fitting.
double criterion(const FitStudy& study, DampingLaw law) {
  return std::min(find(study, law, FitKind::unweighted).information_criterion,
                  find(study, law, FitKind::logarithmic).information_criterion);
}

std::string criterion_note(const FitStudy& study) {
  const double square = criterion(study, DampingLaw::shifted_square);
  return fmt::format(
      "Information criterion: AICc of the density of xi_f/xi_b (fits in the logarithm carry the change of "
      "variables), "
      "less is better. Power law {:.0f} and exponential {:.0f} above the shifted square.",
      criterion(study, DampingLaw::power) - square, criterion(study, DampingLaw::exponential) - square);
}

std::string paper_note(const FitStudy& study) {
  const DampingFit& paper = find(study, DampingLaw::exponential, FitKind::published);
  const auto ratio = [&](int r_f) {
    return damping_law(DampingLaw::exponential, paper.parameters, r_f) /
           linear_chain_slope(r_f, {study.asked.poisson_ratio, study.asked.bond_damping});
  };
  return fmt::format(
      "The paper's Eq 20 is within 5 % of the linear chain at r_f = {}, within 20 % at {}; at r_f = 30 it "
      "gives {:.3f} of "
      "the chain's damping, at 60 {:.4f}. The damping falls as (r_f + 1/2)^-2; an exponential fits it over a "
      "range only.",
      describe(paper.within_5), describe(paper.within_20), ratio(30), ratio(60));
}

std::string choice_text(const ChoiceOutcome& outcome) {
  const FitChoice& c = outcome.choice;
  const bool by_force = c.load.kind == ChoiceLoad::Kind::force;
  return fmt::format("r_f = {}, {} {}, peaks {}..{}, {}: a = {:.5f}, b = {:.4f}, slopes {:.5f} and {:.5f}",
                     describe(c.aspect_ratios), by_force ? "P =" : "load", describe(c.load), c.peaks.first,
                     c.peaks.last, name(c.weighting), outcome.fit.parameters[0], outcome.fit.parameters[1],
                     outcome.slope_8, outcome.slope_10);
}

std::size_t within(const std::vector<ChoiceOutcome>& choices, double tolerance) {
  return static_cast<std::size_t>(
      std::ranges::count_if(choices, [&](const ChoiceOutcome& o) { return distance(o) <= tolerance; }));
}

bool has_papers_slopes(const ChoiceOutcome& o) {
  return std::abs(o.slope_8 / paper_slope_8 - 1) <= 0.02 && std::abs(o.slope_10 / paper_slope_10 - 1) <= 0.02;
}

std::string inference_note(const FitStudy& study) {
  const auto& choices = study.choices;
  std::string text = fmt::format(
      "What the paper fitted is not printed; this is an inference. Of {} choices of aspect ratios, load, "
      "peaks and "
      "weighting, all at xi_b = 1 as in Fig 9, {} come within 2 % of both a = {} and b = {}, {} within 5 %: "
      "a and b alone do not tell them apart.",
      choices.size(), within(choices, 0.02), kPaperA, kPaperB, within(choices, 0.05));
  std::vector<const ChoiceOutcome*> both;
  for (const ChoiceOutcome& o : choices) {
    if (distance(o) <= 0.05 && has_papers_slopes(o)) both.push_back(&o);
  }
  text += fmt::format(
      " {} of those within 5 % also have the paper's slopes {} at r_f = 8 and {} at 10 within 2 %{}",
      both.size(), paper_slope_8, paper_slope_10, both.empty() ? "." : ":\n");
  for (const ChoiceOutcome* o : both) text += "\n- " + choice_text(*o);
  return text;
}

}  // namespace

std::string fit_notes(const FitStudy& study) {
  return fmt::format("{}\n\n{}\n\n{}\n\n{}\n", data_note(study), criterion_note(study), paper_note(study),
                     inference_note(study));
}

}  // namespace fiberchain::compare
