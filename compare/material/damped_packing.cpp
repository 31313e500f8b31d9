#include "compare/material/damped_packing.hpp"

#include <algorithm>
#include <cmath>

#include "compare/measure/bond_spectra_of.hpp"
#include "compare/measure/linear_chain_of.hpp"

namespace fiberchain::compare {
namespace {

double free_damping(const PackingCase& asked) {
  const dem::Fiber fiber = packing_scene(asked).kinds.front().fiber;
  return reference::complex_chain_modes(linear_chain_of(fiber),
                                        reference::bond_moduli(bond_spectra_of(fiber)),
                                        reference::ChainMotion::bending, reference::ChainEnds::free_free, 1)
      .front()
      .decay.damping;
}

}  // namespace

EqualDamping equal_damping(double bond_damping) {
  const double damping = free_damping({.bond_damping = bond_damping});
  double loss = 2 * damping;
  for (int i = 0; i < 4; ++i) loss *= damping / free_damping({.bond_damping = 0, .loss_factor = loss});
  return {damping, loss};
}

std::vector<PackingCase> damped_packings(const DampedPackingPlan& plan) {
  const double loss = equal_damping(plan.bond_damping).loss_factor;
  std::vector<PackingCase> cases;
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    PackingCase elastic{.bond_damping = 0,
                        .fibers = plan.fibers,
                        .side = 0.06 * std::sqrt(plan.fibers / 300.0),
                        .seed = static_cast<std::uint64_t>(seed),
                        .duration = plan.duration,
                        .periodic = true};
    PackingCase viscous = elastic, flat = elastic;
    viscous.bond_damping = plan.bond_damping, flat.loss_factor = loss;
    cases.insert(cases.end(), {elastic, viscous, flat});
  }
  return cases;
}

std::string damper_of(const PackingCase& asked) {
  return asked.loss_factor > 0 ? "flat" : asked.bond_damping > 0 ? "viscous" : "elastic";
}

double settle_time(const PackingRun& run, double part) {
  double most = 0, time = 0;
  for (const PackingSample& sample : run.history) most = std::max(most, sample.speed);
  for (const PackingSample& sample : run.history) {
    if (sample.speed > part * most) time = sample.time;
  }
  return time;
}

}  // namespace fiberchain::compare
