#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/material/modulus_rise.hpp"
#include "compare/material/points.hpp"
#include "compare/measure/bond_spectra_of.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/study/published.hpp"
#include "compare/study/validation.hpp"
#include "dem/material/flat_loss.hpp"

namespace fiberchain::compare {
namespace {

constexpr int kModes = 5;

MetalValues aluminium() { return metal_values("aluminium"); }

double farther(double from, double now) { return std::abs(now) > std::abs(from) ? now : from; }

/// ln of the ratio of largest to smallest, halved: +- so much about the middle.
double spread_of_modes(const std::vector<ModePoint>& points, Damper damper) {
  double least = 1e300, most = 0;
  for (const ModePoint& p : points) {
    if (p.damper != damper) continue;
    least = std::min(least, p.marched.damping), most = std::max(most, p.marched.damping);
  }
  return (most - least) / (most + least);
}

const ModePoint& point_of(const std::vector<ModePoint>& points, Damper damper, int mode) {
  return *std::ranges::find_if(points,
                               [&](const ModePoint& p) { return p.damper == damper && p.mode == mode; });
}

/// The three fibers' modes in time: the paper's statement, flat modes, each against its root.
std::vector<Measured> modes_in_time(const ValidationInput& in) {
  const auto points = mode_points(three_fibers(aluminium(), 13), kModes, in.jobs);
  const auto ratio = [&](Damper damper, int mode) {
    const ModePoint& p = point_of(points, damper, mode);
    return p.marched.damping / p.root.damping;
  };
  const auto growth = [&](Damper damper, bool root) {
    const ModePoint &first = point_of(points, damper, 1), &last = point_of(points, damper, kModes);
    return root ? last.root.damping / first.root.damping : last.marched.damping / first.marched.damping;
  };
  double flat = 0, wire = 0;
  for (int n = 1; n <= 3; ++n) {
    flat = farther(flat, ratio(Damper::flat, n) - 1);
    wire = farther(wire, ratio(Damper::thermoelastic, n) - 1);
  }
  return {{ratio(Damper::flat, 3), {flat, wire}},
          {.value = growth(Damper::viscous, false) / growth(Damper::flat, false),
           .evidence = {growth(Damper::viscous, false), growth(Damper::flat, false),
                        growth(Damper::thermoelastic, false)},
           .expected = growth(Damper::viscous, true) / growth(Damper::flat, true)},
          {spread_of_modes(points, Damper::flat), {spread_of_modes(points, Damper::viscous)}}};
}

/// Both forms, two lengths, modes 1 to 3, three spectra: the farthest of zeta in time from its root.
std::vector<Measured> against_roots(const ValidationInput& in) {
  struct Run {
    dem::Fiber fiber;
    reference::ComplexChainMode mode;
    dem::BondForm form;
    double off = 0;
  };
  std::vector<Run> runs;
  for (const int aspect_ratio : {7, 13}) {
    const ThreeFibers fibers = three_fibers(aluminium(), aspect_ratio);
    for (const dem::Fiber& fiber : {fibers.flat, fibers.thermoelastic, with_loss_factor(fibers, 0.1).flat}) {
      for (const auto& mode : bending_modes_of(fiber, 3)) {
        for (const auto form : {dem::BondForm::incremental, dem::BondForm::total})
          runs.push_back({fiber, mode, form});
      }
    }
  }
  in.jobs.run(runs.size(), [&](std::size_t i) {
    dem::ReleaseOptions options;
    options.form = runs[i].form;
    runs[i].off =
        marched_decay(runs[i].fiber, runs[i].mode, options).damping / runs[i].mode.decay.damping - 1;
  });
  double worst = 0;
  for (const Run& run : runs) worst = farther(worst, run.off);
  return {{worst, {static_cast<int>(runs.size())}}};
}

/// Six metals: zeta_1 in time and zeta_1 to zeta_5 by roots, against the exact thermoelastic modulus.
std::vector<Measured> wires(const ValidationInput& in) {
  WireSweep sweep;
  sweep.aspect_ratio = 13, sweep.diameters = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}, sweep.marched_every = 2;
  double marched = 0, roots = 0;
  int branches = 0;
  for (const WirePoint& p : wire_points(sweep, in.jobs)) {
    if (p.marched) marched = farther(marched, *p.marched / p.series - 1);
    const dem::Fiber elastic = metal_wire(p.metal, p.diameter, sweep.aspect_ratio);
    const auto own = bending_modes_of(with_thermoelasticity(elastic, p.metal, 100 * p.frequency), kModes);
    const auto exact = exact_thermoelastic_modes(elastic, p.metal, kModes);
    for (int n = 0; n < kModes; ++n)
      roots = farther(roots, own[n].decay.damping / exact[n].decay.damping - 1);
    branches = std::max(branches, p.branches);
  }
  return {{marched}, {roots, {branches}}};
}

/// Rise of K' over three decades, by the branches and by Kramers and Kronig from their loss factor alone.
Measured rise(double loss) {
  const dem::FrequencyBand band{7, 7e3};
  const dem::FlatLoss flat = dem::flat_loss(loss, band, 5);
  const auto modulus = reference::complex_modulus(prony_terms(flat.series));
  const auto tangent = [&](double w) { return reference::loss_factor(modulus, w); };
  return {
      .value = flat.rise,
      .evidence = {std::pow(1e3, 2 * std::atan(loss) / std::numbers::pi),
                   dem::unrelaxed_modulus(flat.series)},
      .expected = causal_rise(tangent, 2 * std::numbers::pi * band.low, 2 * std::numbers::pi * band.high)};
}

std::vector<Measured> rises(const ValidationInput&) { return {rise(0.02), rise(0.1)}; }

/// Free decay is the complex root, not tan delta/2: mode 2 at a loss factor of 0.1.
std::vector<Measured> free_decay(const ValidationInput&) {
  const dem::Fiber fiber = with_loss_factor(three_fibers(aluminium(), 13), 0.1).flat;
  const auto mode = bending_modes_of(fiber, 2).back();
  const double phase = 2 * std::atan(0.1) / std::numbers::pi;  // K goes as s^phase
  return {{.value = marched_decay(fiber, mode).damping / mode.decay.half_loss_factor,
           .evidence = {std::sin(std::numbers::pi * phase / (2 * (2 - phase))) / 0.05},
           .expected = mode.decay.damping / mode.decay.half_loss_factor}};
}

/// Two modes at once; a cycle of bending by the law.
std::vector<Measured> together(const ValidationInput&) {
  const auto runs = two_modes(with_loss_factor(three_fibers(aluminium(), 13), 0.02), 8);
  double off = 0;
  for (const TwoModes& run : runs) off = farther(off, run.in_company / run.root - 1);
  return {{off, {100 * runs[0].left, 100 * runs[1].left}}};
}

std::vector<Measured> loops(const ValidationInput&) {
  const ThreeFibers fibers = three_fibers(aluminium(), 13);
  const double f = first_frequency(fibers.elastic);
  double off = 0;
  for (const CyclePoint& p : cycle_points(fibers, logarithmic_values(f / 10, 1e3 * f, 9)))
    off = farther(off, p.loop.loss / p.formula - 1);
  return {{off}};
}

/// Bamboo by its file: modes 1 to 5 of a splint in time, 2 zeta over the loss factor; twist by its roots.
std::vector<Measured> bamboo(const ValidationInput& in) {
  const PlantLoss plant = plant_loss("bamboo");
  const dem::Fiber elastic{{plant.youngs_modulus, plant.shear_modulus, plant.density}, 0.01, 20};
  const dem::FrequencyBand band{plant.band_low, plant.band_high};
  dem::Fiber fiber = elastic;
  const dem::PronySeries bending = dem::flat_loss(plant.bending.value, band).series,
                         twist = dem::flat_loss(plant.twist.value, band).series;
  fiber.branches = dem::maxwell_branches({bending, twist, {}}, fiber.bond_model);
  const auto modes = bending_modes_of(fiber, 4);
  std::vector<double> loss(modes.size());
  in.jobs.run(modes.size(), [&](std::size_t i) { loss[i] = 2 * marched_decay(fiber, modes[i]).damping; });
  const dem::Fiber dashpots = with_viscous_damping(elastic, loss[0] / 2);
  const double viscous = 2 * bending_modes_of(dashpots, 4).back().decay.damping;
  const auto turning =
      reference::complex_chain_modes(linear_chain_of(fiber), reference::bond_moduli(bond_spectra_of(fiber)),
                                     reference::ChainMotion::twist, reference::ChainEnds::clamped_free, 1);
  return {{loss.back(),
           {modes.front().decay.frequency / (2 * std::numbers::pi),
            modes.back().decay.frequency / (2 * std::numbers::pi), loss.front(), viscous,
            2 * turning.front().decay.damping}}};
}

}  // namespace

const Checks& material_checks() {
  static const Checks checks{
      {{"paper-complex-domain", "paper-superior", "material-flat-modes"}, modes_in_time, 1},
      {{"material-march-root"}, against_roots, 2},
      {{"material-wire-march", "material-wire-root"}, wires, 2},
      {{"material-rise-0.02", "material-rise-0.1"}, rises},
      {{"material-free-decay"}, free_decay},
      {{"material-two-modes"}, together},
      {{"material-loop"}, loops},
      {{"bamboo-bending"}, bamboo}};
  return checks;
}

}  // namespace fiberchain::compare
