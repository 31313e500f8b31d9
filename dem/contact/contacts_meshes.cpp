#include <algorithm>
#include <cmath>
#include <compare>

#include "dem/contact/contacts.hpp"

// Contacts with walls that are meshes: which triangles are near, which are touched.
namespace fiberchain::dem {

void Contacts::update_mesh(int k, std::size_t w, UpdateScratch& scratch) {
  Part& part = parts_[k];
  const MeshShape shape = mesh_at(domain_.walls[w], w, reference_poses_[w]);
  const TriangleMesh& mesh = *shape.mesh;
  const auto find = [&](std::int32_t i, std::vector<std::int32_t>& found) {
    const Vec<double, 3> center = shape.to_mesh(neighbors_.reference_positions()[i]);
    const double reach = radius_[i] + neighbors_.skin() + near_gap(w);
    mesh.search.near(center, reach, [&](std::int32_t t) {
      if (squared_distance_bound(mesh, t, center) < reach * reach) found.push_back(t);
    });
  };
  part.meshes[w].update(neighbors_.rebuilt(k), find, scratch.mesh);
}

void Contacts::find_mesh_contacts(Part& part, const SphereStorage& rows, double time) {
  for (const std::size_t w : mesh_walls_) {
    const Wall& wall = domain_.walls[w];
    if (!is_active(wall, time)) continue;
    const MeshShape now = mesh_at(wall, w, pose_at(wall, time));
    const MeshMoment moment{now, rows, law_reach_ + near_gap(w), part.path + mesh_ways_[w]};
    part.meshes[w].find_contacts(moment, kernel_->width, static_cast<std::int32_t>(spheres()) + 2,
                                 part.walls[w], part.histories);
  }
}

void Contacts::put_mesh_contact(Part& part, const SavedContact& contact) {
  const auto slot = static_cast<std::int32_t>(contact.key.first.number);
  const std::int64_t wall = contact.key.second.number;
  const std::int32_t feature = contact.key.slot;
  const MeshShape mesh = mesh_at(domain_.walls[wall], wall, {});
  if (feature < 0 || feature >= mesh.mesh->features() || !part.meshes[wall].has(slot)) return;
  WallNeighbors& list = part.walls[wall];
  list.slots.resize(list.count), list.contact.resize(list.count), list.features.resize(list.count);
  // most come in their order
  std::size_t at = list.count;
  const auto is_behind = [&](std::size_t n) {
    return list.slots[n] > slot || (list.slots[n] == slot && list.features[n] > feature);
  };
  while (at > 0 && is_behind(at - 1)) --at;
  if (at > 0 && list.slots[at - 1] == slot && list.features[at - 1] == feature) return;
  part.histories.reserve(1);
  const std::int32_t number = part.histories.take();
  part.histories.put(number, contact);
  const auto offset = static_cast<std::ptrdiff_t>(at);
  list.slots.insert(list.slots.begin() + offset, slot);
  list.contact.insert(list.contact.begin() + offset, number);
  list.features.insert(list.features.begin() + offset, feature);
  ++list.count;
}

}  // namespace fiberchain::dem
