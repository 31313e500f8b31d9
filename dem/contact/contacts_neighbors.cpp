#include <algorithm>
#include <limits>
#include <utility>

#include "dem/contact/contacts.hpp"

// Neighbor pairs, inner pairs and wall neighbors of all parts, kept up to date.
namespace fiberchain::dem {
namespace {

/// Of the displacement that the Verlet criterion allows: with less left it pays to update the list, ...
constexpr double kWorthwhile = 0.2;
/// ... for all spheres displaced by more than this.
constexpr double kStays = 0.4;

/// Gap of the inner pairs over the skin: those are pruned again whenever one of the others might touch.
constexpr double kInnerSkin = 0.18;

}  // namespace

void Contacts::rebuild_neighbor_list(const SphereStorage& rows, double time, ThreadPool& pool) {
  std::vector<Vec<double, 3>> positions(spheres());
  for (std::int64_t i = 0; i < spheres(); ++i) positions[i] = rows.position(i);
  rebuild_neighbor_list(std::move(positions), time, pool);
}

void Contacts::rebuild_neighbor_list(std::vector<Vec<double, 3>> positions, double time, ThreadPool& pool) {
  const std::vector<SavedContact> contacts = saved();
  for (Part& part : parts_) {
    part.histories.reset();
    part.pairs.clear();
    for (std::size_t w = 0; w < part.walls.size(); ++w) {
      part.walls[w].count = 0;
      if (is_mesh(w)) part.walls[w] = {}, part.meshes[w].clear();
      if (has_ridges(w)) part.ridges[w].clear(), part.ridges[w].contacts().clear();
    }
  }
  reference_time_ = time;
  keep_wall_poses(time);
  neighbors_.build(std::move(positions), pool);
  update_parts(pool);
  restore(contacts);
}

double Contacts::update_neighbor_list(const SphereStorage& rows, ThreadPool& pool) {
  const double limit = 0.5 * skin_;
  const double left = limit - neighbors_.farthest_moved(rows, pool);
  if (left > kWorthwhile * limit) return left;
  neighbors_.update(rows, kStays * limit, pool);
  update_parts(pool);
  return (1 - kStays) * limit;
}

void Contacts::update_parts(ThreadPool& pool) {
  scratch_.resize(static_cast<std::size_t>(pool.threads()));
  pool.parallel_for(parts().count(), [&](int k, int thread) { update_part(k, scratch_[thread]); });
  std::vector<std::vector<int>> reached;
  for (const Part& part : parts_) reached.push_back(part.pairs.reached);
  reach_ = PartDependencies(std::move(reached));
  measure_turn_reach();
}

void Contacts::update_part(int k, UpdateScratch& scratch) {
  Part& part = parts_[k];
  const auto pad = static_cast<std::int32_t>(spheres());
  part.pairs.update(neighbors_, k, part.histories, kernel_->width, pad, scratch.pairs);
  part.inner.stale = true;
  for (std::size_t w = 0; w < domain_.walls.size(); ++w)
    is_mesh(w) ? update_mesh(k, w, scratch) : update_wall(k, w, scratch);
  for (std::size_t w = 0; w < ridges_.size(); ++w) {
    if (has_ridges(w)) update_ridges(k, w, scratch);
  }
}

void Contacts::update_wall(int k, std::size_t w, UpdateScratch& scratch) {
  Part& part = parts_[k];
  const WallShape shape = domain_.walls[w].shape.moved(reference_poses_[w]);
  Vec<double, 3> last{};
  double gap = -std::numeric_limits<double>::infinity();
  const auto is_near = [&](std::int32_t i) {
    const Vec<double, 3>& place = neighbors_.reference_positions()[i];
    const double reach = radius_[i] + neighbors_.skin();
    // a gap is a distance: it shrinks by no more than the way from the last sphere looked at
    if (const double left = gap - reach; left > 0 && dot(place - last, place - last) < left * left)
      return false;
    gap = shape.nearest(place).distance, last = place;
    return gap < reach;
  };
  part.walls[w].update(neighbors_.rebuilt(k), is_near, part.histories, kernel_->width,
                       static_cast<std::int32_t>(spheres()) + 2, scratch.wall);
}

double Contacts::inner_cutoff() const { return law_reach_ + kInnerSkin * skin_; }

void Contacts::prune(Part& part, std::int32_t part_end, const SphereStorage& rows) {
  InnerPairList& inner = part.inner;
  inner.prune(view(part, rows), static_cast<std::int32_t>(part.pairs.first.size()), inner_cutoff(), *kernel_,
              static_cast<std::int32_t>(spheres()));
  const std::size_t halo = inner.halo_count(part_end),
                    touching = static_cast<std::size_t>(inner.count) + lanes_beyond;
  // a segment has two spheres
  const std::size_t forces = fiber_bodies_.smooth ? 2 * halo : halo;
  if (part.halo.size() < forces) part.halo.resize(forces);
  if (fiber_bodies_.smooth) reserve_segments(part);
  if (part.touching.size() < touching) part.touching.resize(touching);
}

void Contacts::add_displacements(const std::vector<double>& paths, double time) {
  if (!mesh_poses_.empty()) add_mesh_ways(time);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    InnerPairList& inner = parts_[k].inner;
    parts_[k].path += paths[k];
    double longest = paths[k];
    for (const int later : reach_.reached(static_cast<int>(k))) longest = std::max(longest, paths[later]);
    inner.displacement_since += paths[k] + longest;
    inner.stale = inner.stale || !(inner.displacement_since < (1 - 1e-9) * (inner_cutoff() - law_reach_));
  }
}

}  // namespace fiberchain::dem
