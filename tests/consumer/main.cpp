#include <cmath>
#include <cstdio>
#include <filesystem>

#include "dem/analysis/observables.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/run/run_scene.hpp"
#include "dem/scene/build_packing.hpp"

using namespace fiberchain::dem;

double bond_damping_of(double loss_factor, int aspect_ratio);  // material.cpp

/// Bond damping from a material's loss factor, against xi_f = (beta_1^2 / sqrt(20)) xi_b / (r_f + 1/2)^2,
/// which a chain without shear meets within 1 / r_f^2.
bool calibrates_a_material() {
  const double loss_factor = 0.04, beta = 1.8751040687;
  const double expected = 0.5 * loss_factor * std::sqrt(20.0) * std::pow(40.5 / beta, 2),
               found = bond_damping_of(loss_factor, 40);
  std::printf("bond damping %.9g, closed form %.9g\n", found, expected);
  return std::abs(found / expected - 1) < 0.005;
}

/// Departure of a cantilever's tip at a small load from P L^3 / (3 E I): the chain's own is (3E/(16G) - 1/4)
/// / r_f^2.
bool solves_a_cantilever() {
  const Fiber fiber{isotropic_material(2.6e6, 0.17, 1100), 1.3e-3, 13};
  const double load = 1e-5, expected = (3 * 2 * 1.17 / 16 - 0.25) / (13 * 13);
  const auto rest =
      solve_equilibrium<2>(straight_chain<2>(fiber), {{0}, {{13, {0, load_force(fiber, load)}, {}}}});
  const double measured = rest.poses.back().position[1] / fiber_length(fiber) / (load / 3) - 1;
  std::printf("departure %.9g, expected %.9g\n", measured, expected);
  return std::abs(measured - expected) < 1e-6 * expected;
}

/// Reads a scene, builds it, steps it, and runs it with its files: both see the same energy at the end.
bool runs_a_packing(const std::filesystem::path& path, const std::filesystem::path& directory) {
  const auto scene = std::get<PackingScene>(read_scene(path));
  const PackingStart start = packing_start(scene, 1);
  Assembly assembly(start.groups, start.domain, start.options);
  assembly.march(start.steps);
  const auto end =
      std::get<PackingEndState>(run_scene(path, {.directory = directory, .earlier = EarlierRun::replace}));
  const double own = assembly.energy().kinetic, run = end.last.energy.kinetic;
  std::printf("%ld contacts, kinetic energy %.9g J, by the run %.9g J\n",
              static_cast<long>(assembly.touching()), own, run);
  return own == run && assembly.touching() == end.last.contacts &&
         std::filesystem::exists(directory / "packing.h5");
}

int main(int, char** arguments) {
  return calibrates_a_material() && solves_a_cantilever() && runs_a_packing(arguments[1], arguments[2]) ? 0
                                                                                                        : 1;
}
