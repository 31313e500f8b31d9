#include "compare/bench_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

#include "compare/static_point.hpp"
#include "dem/errors.hpp"
#include "dem/motion/lanes/block.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::compare {
namespace {

using dem::InstructionSet;
using dem::Physics;

constexpr int steps_a_run = 400;

template <int Dim>
dem::Chain<Dim> chain_of(const Physics& physics) {
  dem::Fiber fiber = nominal_fiber(kernel_bonds, 0.3, dem::BondModel::paper);
  fiber.bond_damping = physics.damped ? 0.5 : 0.0;
  return physics.curved ? dem::cornered_chain<Dim>(fiber, kernel_bonds / 2) : dem::straight_chain<Dim>(fiber);
}

/// Equal cantilevers swinging under a dead load.
template <int Dim>
std::shared_ptr<dem::MarchingBlock<Dim>> swinging(const Physics& physics, InstructionSet set, int chains) {
  const dem::Chain<Dim> chain = chain_of<Dim>(physics);
  const double drag = physics.drag ? 1e-3 / dem::bond_time_step(chain.fiber) : 0.0;
  const auto n = static_cast<std::size_t>(chains);
  auto block = std::make_shared<dem::MarchingBlock<Dim>>(
      std::vector(n, chain), dem::Clamps{true, false}, std::vector(n, 0.5 * dem::stable_time_step(chain.fiber, drag)),
      std::vector(n, drag), physics, set);
  dem::Load<Dim> end{kernel_bonds, {}, {}};
  end.force[1] = dem::load_force(chain.fiber, 0.5);
  for (int lane = 0; lane < chains; ++lane) block->set_ramp(lane, {}, {{0}, {end}}, 500);
  return block;
}

template <int Dim>
std::function<void()> march_run(const Physics& physics, InstructionSet set, int chains) {
  const auto block = swinging<Dim>(physics, set, chains);
  return [block] {
    block->march(steps_a_run);
    if (!std::isfinite(block->sphere(0, kernel_bonds).pose.position[1])) throw dem::Diverged("a timed chain diverged");
  };
}

std::function<void()> march_run(const Physics& physics, InstructionSet set, int chains) {
  return physics.dimension == 2 ? march_run<2>(physics, set, chains) : march_run<3>(physics, set, chains);
}

std::vector<InstructionSet> sets_of(bool quick) {
  const InstructionSet best = dem::best_instruction_set();
  if (quick) return {InstructionSet::scalar, best};
  std::vector<InstructionSet> all;
  for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set <= best) all.push_back(set);
  }
  return all;
}

}  // namespace

std::string text(const Physics& p) {
  std::string all = fmt::format("{} {}", p.dimension == 2 ? "planar" : "spatial", dem::name(p.form));
  if (p.damped) all += " damped";
  if (p.drag) all += " drag";
  if (p.curved) all += " curved";
  return all;
}

std::vector<KernelTime> kernel_times(const BenchOptions& options) {
  std::vector<KernelTime> times;
  std::vector<std::function<void()>> runs;
  for (const InstructionSet set : sets_of(options.quick)) {
    for (const Physics& physics : dem::built_physics) {
      const int lanes = dem::lane_kernel(physics, set).width;
      times.push_back({physics, set, lanes, 0, 0});
      runs.push_back(march_run(physics, set, lanes));
      runs.push_back(march_run(physics, set, 1));
    }
  }
  const auto timings = time_in_turns(runs, options.quick ? TimingBudget{0.004, 5, 9} : TimingBudget{0.05, 9, 60});
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double bond_steps = static_cast<double>(steps_a_run) * kernel_bonds;
    times[i].ensemble = timings[2 * i].least / (bond_steps * times[i].lanes);
    times[i].lone = timings[2 * i + 1].least / bond_steps;
  }
  return times;
}

KernelBound bound_of(const OperationCount& count, const CorePeak& peak) {
  const auto time = [](long operations, double each) { return static_cast<double>(operations) * each / kernel_bonds; };
  return {count,
          time(count.additions + count.multiplications, peak.multiply_add) + time(count.circular, peak.circular()),
          time(count.divisions, peak.divide) + time(count.square_roots, peak.square_root)};
}

std::optional<KernelTarget> target_of(const Physics& p) {
  if (!p.damped || p.drag || p.curved) return std::nullopt;
  if (p.dimension == 2) return KernelTarget{2e-9, 15e-9};
  if (p.form == dem::BondForm::incremental) return KernelTarget{10e-9, 60e-9};
  return std::nullopt;
}

std::vector<MeasuredPeak> measured_peaks(const std::vector<KernelTime>& times, const BenchOptions& options) {
  std::vector<MeasuredPeak> peaks;
  const auto known = [&](InstructionSet set) {
    return std::ranges::any_of(peaks, [&](const MeasuredPeak& p) { return p.set == set; });
  };
  for (const KernelTime& time : times) {
    if (!known(time.set))
      peaks.push_back({time.set, measured_peak(time.set, options.quick ? TimingBudget{0.01, 3, 9} : TimingBudget{0.1, 5, 40})});
  }
  return peaks;
}

Table peak_table(const std::vector<MeasuredPeak>& peaks) {
  Table table({"instruction_set", "multiply_add_ns", "divide_ns", "square_root_ns", "sine_ns", "cosine_ns", "arc_tangent_ns"});
  for (const MeasuredPeak& p : peaks) {
    table.append({{"instruction_set", std::string(dem::name(p.set))},
                  {"multiply_add_ns", 1e9 * p.peak.multiply_add},
                  {"divide_ns", 1e9 * p.peak.divide},
                  {"square_root_ns", 1e9 * p.peak.square_root},
                  {"sine_ns", 1e9 * p.peak.sine},
                  {"cosine_ns", 1e9 * p.peak.cosine},
                  {"arc_tangent_ns", 1e9 * p.peak.arc_tangent}});
  }
  return table;
}

Table kernel_table(const std::vector<KernelTime>& times, const std::vector<MeasuredPeak>& peaks) {
  Table table({"physics", "instruction_set", "lanes", "bond_step_ns", "bond_step_target_ns", "lone_bond_step_ns",
               "lone_target_ns", "additions", "multiplications", "divisions", "square_roots", "circular_functions",
               "arithmetic_bound_ns", "divider_bound_ns", "bound_fraction"});
  const InstructionSet best = dem::best_instruction_set();
  for (const KernelTime& t : times) {
    const auto peak = std::ranges::find(peaks, t.set, &MeasuredPeak::set);
    const KernelBound bound = bound_of(operations_of_step(t.physics, kernel_bonds), peak->peak);
    const auto target = t.set == best ? target_of(t.physics) : std::nullopt;
    const auto per_bond = [](long n) { return static_cast<double>(n) / kernel_bonds; };
    table.append({{"physics", text(t.physics)},
                  {"instruction_set", std::string(dem::name(t.set))},
                  {"lanes", std::int64_t{t.lanes}},
                  {"bond_step_ns", 1e9 * t.ensemble},
                  {"bond_step_target_ns", target ? Cell{1e9 * target->ensemble} : Cell{}},
                  {"lone_bond_step_ns", 1e9 * t.lone},
                  {"lone_target_ns", target ? Cell{1e9 * target->lone} : Cell{}},
                  {"additions", per_bond(bound.count.additions)},
                  {"multiplications", per_bond(bound.count.multiplications)},
                  {"divisions", per_bond(bound.count.divisions)},
                  {"square_roots", per_bond(bound.count.square_roots)},
                  {"circular_functions", per_bond(bound.count.circular)},
                  {"arithmetic_bound_ns", 1e9 * bound.arithmetic},
                  {"divider_bound_ns", 1e9 * bound.divider},
                  {"bound_fraction", bound.least() / t.ensemble}});
  }
  return table;
}

}  // namespace fiberchain::compare
