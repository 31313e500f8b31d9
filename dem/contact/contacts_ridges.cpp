#include <algorithm>
#include <cmath>

#include "dem/contact/contacts.hpp"
#include "dem/contact/wall_view.hpp"

// Smooth fibers at walls with edges, meshes and solid boxes: what their segments touch between the nodes.
namespace fiberchain::dem {
namespace {

/// Faces of a box around its center, in the axes of space at t = 0.
TriangleMesh surface_of(const BoxObstacle& box) {
  const Vec<double, 3> side[3] = {box.half[0] * box.along, box.half[1] * box.across,
                                  box.half[2] * cross(box.along, box.across)};
  TriangleSoup soup;
  for (int n = 0; n < 8; ++n)
    soup.vertices.push_back((n & 1 ? 1.0 : -1.0) * side[0] + (n & 2 ? 1.0 : -1.0) * side[1] +
                            (n & 4 ? 1.0 : -1.0) * side[2]);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (const int at : {0, 1 << axis}) {
      const int first = at != 0 ? u : v, second = at != 0 ? v : u;  // counterclockwise from outside
      soup.triangles.push_back({at, at + first, at + u + v});
      soup.triangles.push_back({at, at + u + v, at + second});
    }
  }
  return make_mesh(soup, 1, "box obstacle");
}

}  // namespace

void Contacts::find_walls_ridges() {
  for (std::size_t w = 0; w < domain_.walls.size(); ++w) {
    const Wall& wall = domain_.walls[w];
    EdgedWall edged;
    if (const MeshShape* mesh = mesh_in(wall)) edged.mesh = mesh->mesh;
    if (const auto* box = wall.shape.get_if<BoxObstacle>()) {
      edged.mesh = std::make_shared<const TriangleMesh>(surface_of(*box));
      shapes_[w] = static_cast<int>(law_->shapes.size());  // from now on a mesh
      mesh_walls_.push_back(w);
    }
    if (edged.mesh != nullptr) edged.ridges = ridges_of(*edged.mesh);
    if (std::ranges::count(edged.ridges.is_ridge, 1) == 0) edged = {};
    ridges_.push_back(std::move(edged));
  }
  std::ranges::sort(mesh_walls_);
}

MeshShape Contacts::mesh_at(const Wall& now, std::size_t w, const WallPose& pose) const {
  if (const MeshShape* mesh = mesh_in(now)) return moved(*mesh, pose);
  MeshShape shape{ridges_[w].mesh, MeshSides::one};
  shape.point = now.shape.point();
  return moved(shape, pose);
}

double Contacts::near_gap(std::size_t w) const {
  return has_ridges(w) ? ridge_tilt * 2 * fiber_bodies_.largest_bound() : 0;
}

void Contacts::update_ridges(int k, std::size_t w, UpdateScratch& scratch) {
  const MeshShape shape = mesh_at(domain_.walls[w], w, reference_poses_[w]);
  const TriangleMesh& mesh = *shape.mesh;
  const auto position = [&](std::int64_t i) { return shape.to_mesh(neighbors_.reference_positions()[i]); };
  const auto find = [&](std::int32_t body, std::vector<std::int32_t>& found) {
    if (fiber_bodies_.is_none(body) || fiber_bodies_.end[body] == body) return;
    const SegmentNodes<double> segment = fiber_bodies_.nodes(body, position);
    const double reach = segment.radius + neighbors_.skin();
    const Vec<double, 3> middle = 0.5 * (segment.begin + segment.end);
    mesh.search.near(middle, reach + 0.5 * norm(segment.end - segment.begin), [&](std::int32_t t) {
      for (const std::int32_t e : mesh.edges_of[t]) {
        if (ridges_[w].ridges.is_ridge[e] == 0) continue;
        if (ridge_point(mesh, mesh.edge_feature(e), segment).distance < reach) found.push_back(e);
      }
    });
    std::ranges::sort(found);
    const auto rest = std::ranges::unique(found);
    found.erase(rest.begin(), rest.end());
  };
  parts_[k].ridges[w].update(neighbors_.rebuilt(k), find, scratch.ridges);
}

void Contacts::find_ridge_contacts(Part& part, const SphereStorage& rows, double time) {
  for (std::size_t w = 0; w < ridges_.size(); ++w) {
    const Wall& wall = domain_.walls[w];
    if (!has_ridges(w) || !is_active(wall, time)) continue;
    const MeshShape mesh = mesh_at(wall, w, pose_at(wall, time));
    const RidgeMoment moment{mesh, ridges_[w].ridges, rows, fiber_bodies_, part.walls[w]};
    part.ridges[w].find_contacts(moment, kernel_->width, part.histories);
  }
}

void Contacts::touch_ridges(Part& part, std::size_t w, const ContactView& contacts, double time,
                            ContactTask& task) {
  WallNeighbors& nodes = part.walls[w];
  const NodeRows& rows = part.ridges[w].node_rows();
  RidgeView view{wall_view(static_cast<int>(w), nodes, time), static_cast<std::int32_t>(nodes.count),
                 rows.places.data(), rows.shares.data()};
  view.slots = rows.bodies.data();
  if (nodes.count > 0) segment_kernel_->ridges(contacts, view, task);
  RidgeContacts& near = part.ridges[w].contacts();
  view.touching = static_cast<std::int32_t>(near.count);
  view.places = near.places.data(), view.shares = near.shares.data();
  view.slots = near.bodies.data();
  view.count = static_cast<std::int32_t>(near.bodies.size());
  view.nearest = near.nearest.data();
  view.contact = near.contact.data();
  if (near.count > 0) segment_kernel_->ridges(contacts, view, task);
}

void Contacts::put_ridge_contact(Part& part, const SavedContact& contact) {
  const auto body = static_cast<std::int32_t>(contact.key.first.number);
  const auto w = static_cast<std::size_t>(contact.key.second.number);
  if (!has_ridges(w) || contact.key.slot < ridges_[w].mesh->faces() ||
      contact.key.slot >= ridges_[w].mesh->features() || !part.ridges[w].has(body))
    return;
  part.histories.reserve(1);
  const std::int32_t number = part.histories.take();
  part.histories.put(number, contact);
  part.ridges[w].contacts().insert(body, contact.key.slot, number);
}

TouchingPair<double> Contacts::ridge_pair_at(const SavedContact& c, const std::vector<Wall>& walls,
                                             const SphereStorage& rows, double time, double& arm,
                                             Vec<double, 3>& center) const {
  const auto body = static_cast<std::int32_t>(c.key.first.number);
  const std::int32_t end = fiber_bodies_.end[body];
  const Wall& wall = walls[c.key.second.number];
  const WallPose pose = pose_at(wall, time);
  const WallVelocity motion = velocity_at(wall, time - 0.5 * step_);
  const MeshShape shape = mesh_at(wall, c.key.second.number, pose);
  const RidgePoint at = ridge_point(*shape.mesh, c.key.slot, nodes_in_mesh(fiber_bodies_, rows, shape, body));
  const auto mean = [&](const Vec<double, 3>& a, const Vec<double, 3>& b) { return a + at.place * (b - a); };
  const Vec<double, 3> w = mean(rows.spin(body), rows.spin(end));
  center = mean(rows.position(body), rows.position(end));
  arm = at.distance;
  TouchingPair<double> pair{};
  pair.normal = shape.to_space(at.direction);
  pair.overlap = law_->overlap(c.history);
  pair.velocity = motion.velocity + cross(motion.spin, center + arm * pair.normal - pose.center_now()) -
                  mean(rows.velocity(body), rows.velocity(end)) - cross(arm * w, pair.normal);
  pair.spin = motion.spin - w;
  pair.mean_spin = 0.5 * (w + motion.spin);
  return pair;
}

}  // namespace fiberchain::dem
