#include "compare/press/press.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "compare/measure/touching_fibers.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

constexpr double kDiameter = 1e-3, kModulus = 1e7;

/// Cylinders of the fibers' length [m^3].
double volume_of(const PressCase& asked) {
  return asked.fibers * std::numbers::pi / 4 * kDiameter * kDiameter * kDiameter * asked.aspect_ratio;
}

double height_at(const PressCase& asked, double solid_fraction) {
  return volume_of(asked) / (asked.side * asked.side * solid_fraction);
}

/// Least x of a function that falls and rises, by the golden section.
template <class Function>
double least_of(double low, double high, const Function& f) {
  const double part = (std::sqrt(5.0) - 1) / 2;
  double a = high - part * (high - low), b = low + part * (high - low), fa = f(a), fb = f(b);
  for (int i = 0; i < 60; ++i) {
    if (fa < fb) {
      high = b, b = a, fb = fa, a = high - part * (high - low), fa = f(a);
    } else {
      low = a, a = b, fa = fb, b = low + part * (high - low), fb = f(b);
    }
  }
  return (low + high) / 2;
}

/// Mean and mean square departure of ln p - ln(phi^n - phi_0^n).
struct Departure {
  double mean = 0, square = 0;
};
Departure departure_of(const std::vector<PressSample>& samples, double n, double initial) {
  std::vector<double> off;
  for (const PressSample& s : samples)
    off.push_back(std::log(s.pressure) - std::log(std::pow(s.solid_fraction, n) - std::pow(initial, n)));
  Departure all;
  for (const double one : off) all.mean += one / static_cast<double>(off.size());
  for (const double one : off)
    all.square += (one - all.mean) * (one - all.mean) / static_cast<double>(off.size());
  return all;
}

}  // namespace

dem::PackingScene press_scene(const PressCase& asked) {
  dem::Fiber fiber{dem::isotropic_material(kModulus, 0.3, 1000), kDiameter, asked.aspect_ratio};
  fiber.bond_damping = 0.3;
  const double high = height_at(asked, asked.loose), low = height_at(asked, asked.dense);
  dem::PackingScene scene;
  scene.kinds = {{.fiber = fiber, .count = asked.fibers}};
  scene.filling = {.region = {{0, 0, 0}, {asked.side, asked.side, high}}, .gap = 1e-5, .seed = asked.seed};
  dem::Domain& around = scene.domain;
  around.period = {asked.side, asked.side, 0};
  around.contacts = {.restitution = 0.3, .friction = asked.friction};
  around.wall_youngs_modulus = kModulus;
  dem::Wall floor{dem::Plane{{}, {0, 0, 1}}}, plate{dem::Plane{{0, 0, high}, {0, 0, -1}}};
  plate.velocity = {0, 0, -asked.speed};
  floor.contacts.friction = plate.contacts.friction = 0.1;  // the bed is not held by them
  around.walls = {floor, plate};
  scene.scene_box = {{0, 0, 0}, {asked.side, asked.side, high}};
  scene.duration = (high - low) / asked.speed;
  return scene;
}

PressRun run_press(const PressCase& asked, int samples) {
  const auto clock = std::chrono::steady_clock::now();
  PressRun run{.asked = asked, .samples = {}, .youngs_modulus = kModulus, .status = "finished"};
  const dem::PackingScene scene = press_scene(asked);
  const double area = asked.side * asked.side, high = height_at(asked, asked.loose);
  try {
    dem::Assembly assembly =
        asked.surface ? bed_of_surface(asked, scene) : dem::make_assembly(dem::packing_start(scene, 1));
    const auto steps = static_cast<std::int64_t>(std::ceil(scene.duration / assembly.step() * (1 - 1e-12)));
    for (int n = 1; n <= samples; ++n) {
      const double before = assembly.time();
      assembly.march(steps * n / samples - assembly.steps());
      const double height = high - asked.speed * (before + assembly.time()) / 2;
      const auto walls = assembly.wall_samples();
      run.samples.push_back({volume_of(asked) / (area * height), walls[1].mean.force[2] / area,
                             -walls[0].mean.force[2] / area});
      assembly.begin_wall_interval();
    }
    run.touched = fibers_touched(touching_fibers(assembly));
  } catch (const dem::Diverged& error) {
    run.status = error.what();
  }
  run.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return run;
}

std::vector<PressRun> run_presses(const std::vector<PressCase>& cases, int samples, const Jobs& jobs,
                                  const std::function<void()>& advance) {
  std::vector<PressRun> runs(cases.size());
  std::vector<double> costs;
  for (const PressCase& c : cases)
    costs.push_back(static_cast<double>(c.fibers) * (c.aspect_ratio + 1) / c.speed);
  jobs.run_dearest_first(costs, [&](std::size_t n) {
    runs[n] = run_press(cases[n], samples);
    if (advance) advance();
  });
  return runs;
}

PressFit fit_press(const std::vector<PressSample>& all, double youngs_modulus, double from, double to) {
  std::vector<PressSample> samples;
  std::ranges::copy_if(all, std::back_inserter(samples), [&](const PressSample& s) {
    return s.solid_fraction >= from && s.solid_fraction <= to;
  });
  if (samples.size() < 5)
    throw InputError(fmt::format("{} samples of a press are not enough", samples.size()));
  for (const PressSample& s : samples) {
    if (!(s.pressure > 0)) throw InputError(fmt::format("a press with a pressure of {} Pa", s.pressure));
  }
  const double most = samples.front().solid_fraction * (1 - 1e-6);
  const auto best_initial = [&](double n) {
    return least_of(0, most, [&](double initial) { return departure_of(samples, n, initial).square; });
  };
  const double n = least_of(0.5, 12, [&](double exponent) {
    return departure_of(samples, exponent, best_initial(exponent)).square;
  });
  const double initial = best_initial(n);
  const Departure off = departure_of(samples, n, initial);
  return {n, std::exp(off.mean) / youngs_modulus, initial, std::sqrt(off.square),
          static_cast<int>(samples.size())};
}

PressFit fit_press(const PressRun& run) {
  return fit_press(run.samples, run.youngs_modulus, run.asked.carries(), run.asked.dense);
}

std::vector<PressCase> press_cases(int fibers, int aspect_ratio, double friction, double speed, int seeds) {
  const PressCase usual;
  std::vector<PressCase> cases;
  for (int seed = 1; seed <= seeds; ++seed) {
    PressCase c{.fibers = fibers,
                .aspect_ratio = aspect_ratio,
                .friction = friction,
                .speed = speed,
                .seed = static_cast<std::uint64_t>(seed)};
    // as high over the fibers' length
    c.side = usual.side * std::sqrt(fibers / static_cast<double>(usual.fibers));
    cases.push_back(c);
  }
  return cases;
}

}  // namespace fiberchain::compare
