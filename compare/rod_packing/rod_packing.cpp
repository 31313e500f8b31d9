#include "compare/rod_packing/rod_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "compare/measure/fiber_surface.hpp"
#include "compare/measure/stop_motion.hpp"
#include "compare/measure/touching_fibers.hpp"
#include "compare/study/errors.hpp"
#include "dem/contact/periodic_box.hpp"
#include "dem/insertion/random_insertion.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;
using V = dem::Vec<double, 3>;

constexpr double kThickness = 1e-3, kYoungsModulus = 1e7, kSpeed = 0.5;

/// Of a rod with round ends [m^3].
double rod_volume(double aspect_ratio) {
  return pi * kThickness * kThickness * kThickness * (aspect_ratio / 4 + 1.0 / 6);
}

double solid_volume(const RodPackingCase& asked) { return asked.fibers * rod_volume(asked.aspect_ratio); }

/// Edge of the cube in which the rods are loose [m].
double loose_edge(const RodPackingCase& asked) {
  const double about = std::min(0.62, 5.2 / asked.aspect_ratio);
  return std::cbrt(solid_volume(asked) / std::min(0.38 * about, 0.13));
}

dem::Domain cube(const RodPackingCase& asked, double edge) {
  dem::Domain around;
  around.period = {edge, edge, edge};
  around.contacts = {.restitution = 0.3, .friction = asked.friction};
  return around;
}

dem::Fiber rod_fiber(int aspect_ratio) {
  dem::Fiber fiber{dem::isotropic_material(kYoungsModulus, 0.3, 1000), kThickness, aspect_ratio};
  fiber.bond_damping = 0.3;
  return fiber;
}

/// Where a rod begins and ends.
struct Rod {
  V first, last;

  V center() const { return 0.5 * (first + last); }
  V direction() const { return (1 / norm(last - first)) * (last - first); }
};

std::vector<Rod> rods_of(const dem::Assembly& assembly) {
  std::vector<Rod> rods;
  for (const dem::ChainState<3>& state : assembly.states(0))
    rods.push_back({state.poses.front().position, state.poses.back().position});
  return rods;
}

/// By the forces between rods, p = sum f (x_a - x_b) / (3 V) with the centers x of the rods [Pa].
double pressure_of(const dem::Assembly& assembly, double edge) {
  const std::vector<Rod> rods = rods_of(assembly);
  const std::int64_t nodes = assembly.chain(0).fiber.aspect_ratio + 1;
  const dem::PeriodicBox periods = dem::periodic_box({edge, edge, edge});
  double sum = 0;
  for (const dem::ContactState& contact : assembly.contacts()) {
    const Rod &a = rods[static_cast<std::size_t>(contact.key.first.number / nodes)],
              &b = rods[static_cast<std::size_t>(contact.key.second.number / nodes)];
    sum += dot(contact.force, dem::nearest_image(periods, a.center() - b.center()));
  }
  return sum / (3 * edge * edge * edge);
}

/// The rods where they are, their centers in a cube that is smaller by `scale`; as they are, at rest.
dem::FiberGroup contracted(const dem::Assembly& assembly, double scale) {
  dem::FiberGroup group{assembly.chain(0), assembly.states(0)};
  for (dem::ChainState<3>& rod : group.fibers) {
    rod = dem::at_rest<3>(rod.poses);
    const V shift = 0.5 * (scale - 1) * (rod.poses.front().position + rod.poses.back().position);
    for (auto& pose : rod.poses) pose.position = pose.position + shift;
  }
  return group;
}

/// Until nothing is pressed any more, or for `most` looks; the rods are stopped when their kinetic energy has
/// passed a maximum. The pressure then.
double relax(dem::Assembly& assembly, double edge, double pressure, int most) {
  constexpr std::int64_t steps = 50;
  double now = 0, last = 0;
  for (int n = 0; n < most; ++n) {
    assembly.march(steps);
    last = stop_past_peak(assembly, last);
    now = pressure_of(assembly, edge);
    if (now < 0.1 * pressure) break;
  }
  return now;
}

/// Smaller by steps that are halved near the pressure that is asked for, with rest between them.
dem::Assembly packed_rods(const RodPackingCase& asked, double& edge) {
  const double pressure = asked.pressure * kYoungsModulus;
  dem::Assembly assembly = loose_rods(asked);
  edge = loose_edge(asked);
  for (double part = 0.01; part > 3e-4;) {
    const double next = edge * (1 - part);
    dem::Assembly smaller({contracted(assembly, 1 - part)}, cube(asked, next),
                          {.form = dem::BondForm::total, .speed = kSpeed});
    const double now = relax(smaller, next, pressure, asked.looks);
    if (now > 1.05 * pressure && part > 6e-4) {
      part /= 2;
      continue;
    }
    assembly = std::move(smaller), edge = next;
    if (now > 0.95 * pressure) break;
  }
  return assembly;
}

/// Mean |sin| of the angle between two rods.
double mean_sine(const std::vector<Rod>& rods) {
  double sum = 0;
  for (std::size_t a = 0; a < rods.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) sum += norm(cross(rods[a].direction(), rods[b].direction()));
  }
  const auto count = static_cast<double>(rods.size());
  return 2 * sum / (count * (count - 1));
}

void measure_rods(const dem::Assembly& assembly, double edge, RodPacking& packing) {
  const std::vector<Rod> rods = rods_of(assembly);
  packing.coordination = fibers_touched(touching_fibers(assembly));
  packing.solid_fraction = solid_volume(packing.asked) / (edge * edge * edge);
  packing.sine = mean_sine(rods);
  packing.contact_ratio = packing.solid_fraction *
                          excluded_volume_ratio(packing.asked.aspect_ratio, packing.sine) /
                          packing.coordination;
  packing.edge = edge / (packing.asked.aspect_ratio * kThickness);
  packing.overlap = assembly.sample().overlap_mean();
}

}  // namespace

int long_bonds(int aspect_ratio) {
  int spacing = std::clamp(aspect_ratio / 4, 1, 8);
  while (aspect_ratio % spacing != 0) --spacing;
  return spacing;
}

double excluded_volume_ratio(double r, double sine) {
  return (2 * r * r * sine / pi + 2 * r + 4.0 / 3) / (r / 4 + 1.0 / 6);
}

dem::Assembly loose_rods(const RodPackingCase& asked) {
  const double edge = loose_edge(asked);
  const dem::Domain around = cube(asked, edge);
  const dem::InsertionRules rules{
      .region = {{0, 0, 0}, {edge, edge, edge}}, .seed = asked.seed, .attempts = 1000000};
  return {{inserted_fibers(rod_fiber(asked.aspect_ratio), {asked.smooth, asked.spacing}, asked.fibers, rules,
                           around)},
          around,
          {.form = dem::BondForm::total, .speed = kSpeed}};
}

RodPacking pack_rods(const RodPackingCase& asked) {
  const auto clock = std::chrono::steady_clock::now();
  RodPacking packing{.asked = asked, .status = "finished"};
  try {
    double edge = 0;
    const dem::Assembly assembly = packed_rods(asked, edge);
    packing.nodes = assembly.spheres();
    measure_rods(assembly, edge, packing);
  } catch (const dem::Diverged& error) {
    packing.status = error.what();
  }
  packing.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return packing;
}

std::vector<RodPacking> pack_rods(const std::vector<RodPackingCase>& cases,
                                  const RodPackingOptions& options) {
  std::vector<RodPacking> packings(cases.size());
  std::vector<double> costs;
  for (const RodPackingCase& c : cases) costs.push_back(c.fibers * (1.0 + c.aspect_ratio / c.spacing));
  options.jobs.run_dearest_first(costs, [&](std::size_t n) {
    packings[n] = pack_rods(cases[n]);
    options.advance();
  });
  return packings;
}

std::vector<RodPackingCase> rod_packing_cases(const std::vector<int>& aspect_ratios, bool compared,
                                              double friction, int fibers, int seeds) {
  std::vector<RodPackingCase> kinds;
  for (const int r : aspect_ratios) kinds.push_back({.aspect_ratio = r, .spacing = long_bonds(r)});
  if (compared) {
    for (const int spacing : {1, 3, 5}) kinds.push_back({.aspect_ratio = 15, .spacing = spacing});
    kinds.push_back({.aspect_ratio = 15, .smooth = false, .spacing = 1});
  }
  std::vector<RodPackingCase> cases;
  for (RodPackingCase kind : kinds) {
    kind.friction = friction;
    kind.pressure = std::min(1e-5, 1e-5 * std::pow(16.0 / kind.aspect_ratio, 4));  // bends them alike
    kind.fibers = std::max(fibers, 12 * kind.aspect_ratio);  // the cube is wider than a rod is long
    for (int seed = 1; seed <= seeds; ++seed) {
      kind.seed = static_cast<std::uint64_t>(seed);
      cases.push_back(kind);
    }
  }
  return cases;
}

}  // namespace fiberchain::compare
