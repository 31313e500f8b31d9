// fiberchain_kernels: every inner loop by every instruction set, a lone chain, one bond's law and tangent,
// and the elimination along a chain, under Google Benchmark. Counter ns is per bond-step (bond, block) and
// lane.
#include <benchmark/benchmark.h>

#include "compare/bench/swing.hpp"
#include "dem/bond/tangent.hpp"
#include "dem/equilibrium/balance.hpp"

namespace {

namespace dem = fiberchain::dem;
namespace compare = fiberchain::compare;

/// Items done so far over time, as time of one.
void report(benchmark::State& state, double items) {
  state.counters["each"] = benchmark::Counter(items * static_cast<double>(state.iterations()),
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void inner_loop(benchmark::State& state, dem::Physics physics, dem::InstructionSet set, int chains) {
  constexpr int steps = 200;
  const auto march = compare::swinging_chains(physics, set, chains, steps);
  for (auto _ : state) march();
  report(state, static_cast<double>(steps) * compare::kernel_bonds * chains);
}

template <int Dim>
dem::BondKinematics<double, Dim> bent_bond() {
  const auto chain = dem::straight_chain<Dim>(compare::kernel_fiber());
  dem::Poses<Dim> poses = chain.poses;
  dem::ChainVector<Dim> motion(poses.size(), dem::SphereVector<Dim>::Constant(1e-5));
  for (std::size_t i = 0; i < motion.size(); ++i) motion[i] *= static_cast<double>(i);
  dem::move(chain, dem::Boundary<Dim>{{0}, {}}, poses, motion);
  return dem::bond_kinematics(chain, poses, 3);
}

template <int Dim>
void bond_law(benchmark::State& state) {
  const auto law = dem::bond_parameters(compare::kernel_fiber());
  auto k = bent_bond<Dim>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(k);
    benchmark::DoNotOptimize(dem::bond_loads(k, dem::bond_stress(law, k.separation, k.rotation)));
  }
  report(state, 1);
}

template <int Dim>
void chain_tangent(benchmark::State& state) {
  const auto chain = dem::straight_chain<Dim>(compare::kernel_fiber());
  const dem::Boundary<Dim> boundary{{0}, {}};
  for (auto _ : state) benchmark::DoNotOptimize(dem::stiffness(chain, chain.poses, boundary));
  report(state, compare::kernel_bonds);
}

template <int Dim>
void block_solve(benchmark::State& state) {
  const auto chain = dem::straight_chain<Dim>(compare::kernel_fiber());
  const auto K = dem::stiffness(chain, chain.poses, dem::Boundary<Dim>{{0}, {}});
  const dem::ChainVector<Dim> forces(chain.poses.size(), dem::SphereVector<Dim>::Constant(1.0));
  for (auto _ : state) {
    auto matrix = K;
    auto motion = forces;
    dem::solve_in_place(matrix, motion);
    benchmark::DoNotOptimize(motion.data());
  }
  report(state, compare::kernel_bonds);
}

void register_inner_loops() {
  for (const auto set : compare::instruction_sets()) {
    for (const dem::Physics& physics : dem::built_physics) {
      const std::string name = compare::text(physics) + "/" + std::string(dem::name(set));
      const int lanes = dem::lane_kernel(physics, set).width;
      benchmark::RegisterBenchmark((name + "/ensemble").c_str(), inner_loop, physics, set, lanes);
      if (lanes > 1) benchmark::RegisterBenchmark((name + "/lone").c_str(), inner_loop, physics, set, 1);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  register_inner_loops();
  benchmark::RegisterBenchmark("bond law/planar", bond_law<2>);
  benchmark::RegisterBenchmark("bond law/spatial", bond_law<3>);
  benchmark::RegisterBenchmark("tangent of a chain/planar", chain_tangent<2>);
  benchmark::RegisterBenchmark("tangent of a chain/spatial", chain_tangent<3>);
  benchmark::RegisterBenchmark("elimination along a chain/planar", block_solve<2>);
  benchmark::RegisterBenchmark("elimination along a chain/spatial", block_solve<3>);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
