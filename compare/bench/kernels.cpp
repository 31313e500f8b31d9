#include "compare/bench/kernels.hpp"

#include <algorithm>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

using dem::InstructionSet;
using dem::Physics;

constexpr int steps_a_run = 400;

/// Whether no other instruction set takes a lone chain of this physics faster.
bool is_fastest_alone(const std::vector<KernelTime>& times, const KernelTime& time) {
  return std::ranges::none_of(
      times, [&](const KernelTime& t) { return t.physics == time.physics && t.lone < time.lone; });
}

}  // namespace

std::vector<KernelTime> kernel_times(const BenchOptions& options) {
  std::vector<KernelTime> times;
  std::vector<std::function<void()>> runs;
  const auto all = dem::available_instruction_sets();
  for (const InstructionSet set : options.quick ? std::vector{all.front(), all.back()} : all) {
    for (const Physics& physics : dem::built_physics) {
      const int lanes = dem::chain_kernel(physics, set).width;
      const auto counted = std::ranges::find(times, physics, &KernelTime::physics);
      const OperationCount count = counted == times.end() ? operations_of_bond_step(physics) : counted->count;
      times.push_back({physics, set, lanes, 0, 0, count});
      runs.push_back(swinging_chains(physics, set, lanes, steps_a_run));
      runs.push_back(swinging_chains(physics, set, 1, steps_a_run));
    }
  }
  const auto timings =
      time_in_turns(runs, options.quick ? TimingBudget{0.004, 5, 9} : TimingBudget{0.03, 9, 60});
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double bond_steps = static_cast<double>(steps_a_run) * kernel_bonds;
    times[i].ensemble = timings[2 * i].least / (bond_steps * times[i].lanes);
    times[i].lone = timings[2 * i + 1].least / bond_steps;
  }
  return times;
}

KernelBound bound_of(const OperationCount& count, const CorePeak& peak) {
  const double instructions = count.additions + count.multiplications - (peak.fused ? count.fusable : 0);
  return {instructions * peak.multiply_add + count.sines * peak.sine + count.arc_tangents * peak.arc_tangent,
          count.divisions * peak.divide + count.square_roots * peak.square_root};
}

std::optional<KernelTarget> target_of(const dem::Physics& p) {
  if (!(p == dem::Physics{p.dimension, dem::BondForm::incremental, true, false, false})) return std::nullopt;
  return p.dimension == 2 ? KernelTarget{2e-9, 15e-9} : KernelTarget{10e-9, 60e-9};
}

std::vector<MeasuredPeak> measured_peaks(const std::vector<KernelTime>& times, const BenchOptions& options) {
  std::vector<MeasuredPeak> peaks;
  const auto known = [&](InstructionSet set) {
    return std::ranges::any_of(peaks, [&](const MeasuredPeak& p) { return p.set == set; });
  };
  for (const KernelTime& time : times) {
    if (!known(time.set))
      peaks.push_back({time.set, measured_peak(time.set, options.quick ? TimingBudget{0.01, 3, 9}
                                                                       : TimingBudget{0.1, 5, 40})});
  }
  return peaks;
}

dem::Table peak_table(const std::vector<MeasuredPeak>& peaks) {
  return tabulate(peaks, [](const MeasuredPeak& p) -> dem::NamedRow {
    return {{"instruction_set", std::string(dem::name(p.set))},
            {"multiply_add_ns", 1e9 * p.peak.multiply_add},
            {"divide_ns", 1e9 * p.peak.divide},
            {"square_root_ns", 1e9 * p.peak.square_root},
            {"sine_ns", 1e9 * p.peak.sine},
            {"arc_tangent_ns", 1e9 * p.peak.arc_tangent}};
  });
}

std::vector<KernelTime> widest_or_wanted(const std::vector<KernelTime>& times) {
  std::vector<KernelTime> shown;
  for (const KernelTime& t : times) {
    if (t.set == dem::best_instruction_set() || (target_of(t.physics) && is_fastest_alone(times, t)))
      shown.push_back(t);
  }
  return shown;
}

dem::Table kernel_table(const std::vector<KernelTime>& times, const std::vector<MeasuredPeak>& peaks) {
  const InstructionSet best = dem::best_instruction_set();
  return tabulate(times, [&](const KernelTime& t) -> dem::NamedRow {
    const auto peak = std::ranges::find(peaks, t.set, &MeasuredPeak::set);
    const KernelBound bound = bound_of(t.count, peak->peak);
    const auto target = t.set == best ? target_of(t.physics) : std::nullopt;
    const auto alone = is_fastest_alone(times, t) ? target_of(t.physics) : std::nullopt;
    return {{"physics", text(t.physics)},
            {"instruction_set", std::string(dem::name(t.set))},
            {"lanes", std::int64_t{t.lanes}},
            {"bond_step_ns", 1e9 * t.ensemble},
            {"bond_step_target_ns", target ? dem::Cell{1e9 * target->ensemble} : dem::Cell{}},
            {"lone_bond_step_ns", 1e9 * t.lone},
            {"lone_target_ns", alone ? dem::Cell{1e9 * alone->lone} : dem::Cell{}},
            {"additions", t.count.additions},
            {"multiplications", t.count.multiplications},
            {"fusable", t.count.fusable},
            {"divisions", t.count.divisions},
            {"square_roots", t.count.square_roots},
            {"sines", t.count.sines},
            {"arc_tangents", t.count.arc_tangents},
            {"arithmetic_bound_ns", 1e9 * bound.arithmetic},
            {"divider_bound_ns", 1e9 * bound.divider},
            {"bound_fraction", bound.least() / t.ensemble}};
  });
}

}  // namespace fiberchain::compare
