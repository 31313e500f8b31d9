#include <algorithm>
#include <utility>

#include "dem/assembly/assembly_state.hpp"
#include "dem/assembly/held_spheres.hpp"

// What grips give to spheres over the steps, and the state of grips between runs.
namespace fiberchain::dem {
namespace {

void add_impulse(WallLoad& sum, double factor, const WallLoad& more) {
  sum.force = sum.force + factor * more.force;
  sum.moment = sum.moment + factor * more.moment;
}

}  // namespace

std::vector<HeldSpheres::Now> HeldSpheres::sums(const std::vector<Held>& spheres) const {
  std::vector<Now> all(grips_.size());
  for (const Held& held : spheres) {
    Now& now = all[held.grip];
    now.center = now.center + (1.0 / static_cast<double>(grips_[held.grip].spheres.size())) * held.place;
    now.work += held.work;
  }
  for (const Held& held : spheres) {
    Now& now = all[held.grip];
    now.load.force = now.load.force - (1 / step_) * held.force;
    now.load.moment =
        now.load.moment - (1 / step_) * (cross(held.place - now.center, held.force) + held.moment);
  }
  return all;
}

void HeldSpheres::end_kick() {
  const std::vector<Now> all = sums(spheres_);
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    Record& record = records_[g];
    add_impulse(record.impulse, step_, all[g].load);
    record.force_peak = std::max(record.force_peak, norm(all[g].load.force));
    record.moment_peak = std::max(record.moment_peak, norm(all[g].load.moment));
    record.work += all[g].work;
  }
}

std::vector<HeldSpheres::Now> HeldSpheres::now(const Assembly::State& s) const {
  std::vector<Held> spheres = spheres_;
  for (const HeldFiber& fiber : fibers_) {
    const FiberBlock& block = s.blocks[fiber.block];
    const GroupKind& kind = s.kinds[fiber.group];
    const auto all =
        spheres_of(s, fiber, block.snapshot(kind, s.rows, s.loads.of(s.part_of(block)), s.gradient.data()));
    const HeldKick kick = held_kick(kind, all, changes(fiber, all, false),
                                    is_solved(s) ? KickMatrix::bonds : KickMatrix::masses,
                                    bond_parts(kind, block.histories(), fiber.lane));
    for (const int n : fiber.spheres) {
      const int i = spheres[n].at.sphere;
      account(spheres[n], kick.impulse[i], all[i], kick.change[i]);
    }
  }
  return sums(spheres);
}

bool HeldSpheres::correct(const Assembly::State& s, int block, int lane,
                          std::vector<MovingSphere<double, 3>>& spheres, ChainState<3>& state) const {
  for (const int f : of_block_[block]) {
    const HeldFiber& fiber = fibers_[f];
    if (fiber.lane != lane) continue;
    const std::int64_t first = s.first_row(fiber.group, fiber.fiber);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      spheres[i].velocity = s.rows.velocity(first + static_cast<std::int64_t>(i));
      spheres[i].spin = s.rows.spin(first + static_cast<std::int64_t>(i));
    }
    const std::vector<HeldChange> held = changes(fiber, spheres, false);
    if (held.empty()) return false;
    const HeldKick kick =
        held_kick(s.kinds[fiber.group], spheres, held, is_solved(s) ? KickMatrix::bonds : KickMatrix::masses,
                  bond_parts(s.kinds[fiber.group], s.blocks[fiber.block].histories(), lane));
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        state.velocity[i][c] = spheres[i].velocity[c] + 0.5 * kick.change[i][c];
        state.spin[i][c] = spheres[i].spin[c] + 0.5 * kick.change[i][3 + c];
      }
    }
    return true;
  }
  return false;
}

void HeldSpheres::begin_accounts(const Assembly::State& s) {
  if (!any()) return;
  const std::vector<Now> all = now(s);
  for (std::size_t g = 0; g < grips_.size(); ++g) records_[g].work = -0.5 * all[g].work;
  begin_interval(s);
}

void HeldSpheres::begin_interval(const Assembly::State& s) {
  if (!any()) return;
  const std::vector<Now> all = now(s);
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    Record& record = records_[g];
    record.impulse = {};
    add_impulse(record.impulse, -0.5 * step_, all[g].load);
    record.force_peak = norm(all[g].load.force);
    record.moment_peak = norm(all[g].load.moment);
    record.interval_begin = s.time();
  }
}

std::vector<WallSample> HeldSpheres::samples(const Assembly::State& s) const {
  std::vector<WallSample> samples;
  if (!any()) return samples;
  const std::vector<Now> all = now(s);
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    const Record& record = records_[g];
    const WallLoad& load = all[g].load;
    const double interval = s.time() - record.interval_begin;
    WallLoad mean = load;
    if (interval > 0.5 * step_) {
      mean = {};
      add_impulse(mean, 1 / interval, record.impulse);
      add_impulse(mean, 0.5 * step_ / interval, load);
    }
    samples.push_back({mean, std::max(record.force_peak, norm(load.force)),
                       std::max(record.moment_peak, norm(load.moment)), record.work + 0.5 * all[g].work,
                       all[g].center});
  }
  return samples;
}

double HeldSpheres::work(const Assembly::State& s) const {
  double sum = 0;
  for (const WallSample& sample : samples(s)) sum += sample.work;
  return sum;
}

std::vector<double> HeldSpheres::saved() const {
  std::vector<double> all;
  for (const Held& held : spheres_) all.insert(all.end(), held.body.c, held.body.c + 3);
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    const Record& r = records_[g];
    for (const auto& v : {r.impulse.force, r.impulse.moment}) all.insert(all.end(), v.c, v.c + 3);
    all.insert(all.end(),
               {r.force_peak, r.moment_peak, r.interval_begin, r.work, motions_[g].active ? 1.0 : 0.0});
  }
  return all;
}

void HeldSpheres::restore(const double* from) {
  for (Held& held : spheres_) std::copy_n(from, 3, held.body.c), from += 3;
  for (std::size_t g = 0; g < grips_.size(); ++g) {
    Record& r = records_[g];
    for (Vec<double, 3>* v : {&r.impulse.force, &r.impulse.moment}) std::copy_n(from, 3, v->c), from += 3;
    r.force_peak = from[0], r.moment_peak = from[1], r.interval_begin = from[2], r.work = from[3];
    motions_[g].active = from[4] > 0;
    from += 5;
  }
}

std::vector<double> HeldSpheres::applied_loads(const Assembly::State& s) const {
  std::vector<double> all;
  for (const Held& held : spheres_) {
    const Grip& grip = grips_[held.grip];
    if (!grip.loads()) continue;
    const double part = motions_[held.grip].load;
    const std::int64_t number = s.first_sphere(held.at.group, held.at.fiber) + held.at.sphere;
    all.push_back(static_cast<double>(number));
    for (int c = 0; c < 3; ++c) all.push_back(part * grip.force[c]);
    for (int c = 0; c < 3; ++c) all.push_back(part * grip.moment[c]);
  }
  return all;
}

}  // namespace fiberchain::dem
