#include "compare/packing/case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "dem/analysis/observables.hpp"
#include "dem/model/errors.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

using Vec3 = dem::Vec<double, 3>;
using States = std::vector<dem::ChainState<3>>;

const Vec3 kUp{0, 0, 1};
constexpr double kSlab = 0.005;  // thickness of the slabs of the solid fraction [m]
constexpr int kPolarClasses = 18;

void sample_bending(const dem::Assembly& assembly, PackingSample& sample) {
  dem::Mean mean;
  for (const auto& bonds : assembly.bonds(0)) {
    for (const dem::BondState& bond : bonds) {
      mean.sum += bond.bending_angle, ++mean.count;
      sample.largest_bending = std::max(sample.largest_bending, bond.bending_angle);
    }
  }
  sample.bending_angle = mean.value();
}

void sample_motion(const States& states, PackingSample& sample) {
  double upward = 0, squares = 0;
  std::int64_t count = 0;
  for (const dem::ChainState<3>& state : states) {
    for (const Vec3& v : state.velocity) upward += v[2], squares += dot(v, v), ++count;
  }
  sample.vertical_speed = upward / static_cast<double>(count);
  sample.speed = std::sqrt(squares / static_cast<double>(count));
}

PackingSample sample_of(const dem::Assembly& assembly, const States& states, double floor,
                        const std::vector<std::int32_t>& fiber_of_sphere) {
  PackingSample sample{};
  sample.time = assembly.time(), sample.energy = assembly.energy();
  sample_bending(assembly, sample);
  sample_motion(states, sample);
  const dem::PlacedSpheres spheres = assembly.placed();
  const dem::Heights heights = dem::heights(spheres, kUp);
  sample.mean_height = heights.mean, sample.height = heights.quantile;
  sample.solid_fraction = dem::solid_fractions(spheres, kUp, floor, {0, heights.quantile}).front();
  sample.coordination = dem::coordination(assembly.contacts(), fiber_of_sphere).per_sphere;
  dem::Orientations orientations(kUp);
  orientations.add(states);
  sample.order = orientations.order_along_up();
  return sample;
}

OrientationProfile orientation_of(const States& states) {
  dem::Orientations o(kUp, kPolarClasses);
  o.add(states);
  return {o.against_isotropic(), o.order(), o.order_along_up(), o.mean_polar_angle()};
}

PackingPicture picture_of(const dem::Assembly& assembly, const States& states) {
  PackingPicture picture{assembly.steps(), assembly.time(), {}};
  for (const dem::ChainState<3>& state : states) {
    for (std::size_t i = 0; i < state.poses.size(); ++i) {
      const Vec3& x = state.poses[i].position;
      picture.spheres.push_back({static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]),
                                 static_cast<float>(state.velocity[i][2])});
    }
  }
  return picture;
}

PackingEnd end_of(const dem::Assembly& assembly, const States& states, double floor,
                  const std::vector<std::int32_t>& fiber_of_sphere) {
  PackingEnd end;
  const dem::PlacedSpheres spheres = assembly.placed();
  const double top = dem::heights(spheres, kUp).highest + spheres.radius.front();
  for (int k = 0; k <= std::ceil(top / kSlab); ++k) end.edges.push_back(k * kSlab);
  end.solid_fractions = dem::solid_fractions(spheres, kUp, floor, end.edges);
  end.orientation = orientation_of(states);
  const auto contacts = assembly.contacts();
  const dem::Coordination c = dem::coordination(contacts, fiber_of_sphere);
  end.contacts_per_fiber = c.per_fiber, end.neighbors_per_fiber = c.neighbors_per_fiber;
  end.touching_spheres = c.touching_spheres;
  end.wall_contacts = static_cast<double>(c.with_walls) / assembly.fibers(0);
  for (const dem::ContactState& contact : contacts) {
    end.largest_overlap = std::max(end.largest_overlap, contact.overlap / spheres.radius.front());
  }
  end.overlap_mean = assembly.sample().overlap_mean(), end.overlap_peak = assembly.deepest_overlap();
  return end;
}

void sample_packing(const dem::PackingScene& scene, const PackingWatch& watch,
                    const std::function<void()>& advance, PackingRun& run) {
  dem::PackingStart start = dem::packing_start(scene, watch.threads);
  const std::vector<std::int32_t> fiber_of_sphere = dem::fiber_numbers(start.groups);
  const double floor = floor_area(scene);
  run.step = start.options.step.value(), run.step_set_by = start.choice.set_by;
  const std::int64_t steps = start.steps;
  dem::Assembly assembly = dem::make_assembly(std::move(start));
  run.spheres = assembly.spheres();
  for (int k = 0; k <= watch.samples; ++k) {
    assembly.march(steps * k / watch.samples - assembly.steps());
    const States states = assembly.states(0);
    run.history.push_back(sample_of(assembly, states, floor, fiber_of_sphere));
    run.steps = assembly.steps();
    if (run.asked.pictured) run.pictures.push_back(picture_of(assembly, states));
    if (k == 0) run.start = orientation_of(states);
    if (k == watch.samples) run.end = end_of(assembly, states, floor, fiber_of_sphere);
    if (advance) advance();
  }
}

}  // namespace

dem::TrajectoryFrame frame_of(const PackingPicture& picture, const PackingCase& asked) {
  const dem::PackingScene scene = packing_scene(asked);
  const dem::Fiber& fiber = scene.kinds.front().fiber;
  dem::TrajectoryFrame frame{};
  frame.time = picture.time, frame.step = picture.step;
  frame.low = scene.scene_box.low, frame.high = scene.scene_box.high;
  frame.periodic[0] = frame.periodic[1] = asked.periodic;
  const int n = fiber.aspect_ratio + 1;
  for (std::size_t i = 0; i < picture.spheres.size(); ++i) {
    const SpherePlace& s = picture.spheres[i];
    frame.position.push_back({s.x, s.y, s.z});
    frame.velocity.push_back({0, 0, s.vertical_speed});
    frame.radius.push_back(dem::sphere_radius(fiber));
    frame.fiber.push_back(static_cast<std::int32_t>(i / n));
    if (i % n + 1 < static_cast<std::size_t>(n)) frame.bonds.push_back({static_cast<std::int64_t>(i), {}, 0});
  }
  return frame;
}

PackingRun run_packing(const PackingCase& asked, const PackingWatch& watch,
                       const std::function<void()>& advance) {
  PackingRun run{};
  run.asked = asked;
  const auto begin = std::chrono::steady_clock::now();
  try {
    sample_packing(packing_scene(asked), watch, advance, run);
    run.status = "finished";
  } catch (const dem::Diverged& error) {
    run.status = error.what();
  }
  run.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return run;
}

std::vector<PackingRun> run_packings(const std::vector<PackingCase>& cases, const PackingWatch& watch,
                                     const Jobs& jobs, const std::function<void()>& advance) {
  std::vector<double> work;
  for (const PackingCase& c : cases) work.push_back(c.fibers / packing_scene(c).step.value());
  std::vector<PackingRun> runs(cases.size());
  jobs.run_dearest_first(work, [&](std::size_t i) { runs[i] = run_packing(cases[i], watch, advance); });
  return runs;
}

}  // namespace fiberchain::compare
