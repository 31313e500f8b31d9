#include "dem/contact/contacts.hpp"

#include <algorithm>
#include <limits>

#include "dem/contact/smooth_contacts.hpp"

namespace fiberchain::dem {
namespace {

/// Largest gap of neighbors over the smallest radius: with more lists are long, with less updated often.
constexpr double kSkin = 0.9;

/// Number of a fiber from that of any of its pieces: every second one has its complement, so that spheres on
/// both sides of a broken bond are of different fibers.
constexpr std::int32_t whole(std::int32_t piece) { return piece < 0 ? ~piece : piece; }

}  // namespace

Contacts::Contacts(const Domain& domain, const ContactOptions& options, double step)
    : domain_(domain),
      law_(&law_of(domain.contacts)),
      periods_(periodic_box(domain.period)),
      accounted_(options.account_energy),
      instruction_set_(options.instruction_set),
      step_(step) {
  check(domain.contacts);
  for (const Wall& wall : domain.walls) check(with(domain.contacts, wall.contacts));
  for (const SurfacePair& pair : domain.pairs) check(with(domain.contacts, pair.contacts));
  for (std::size_t w = 0; w < domain.walls.size(); ++w) {
    shapes_.push_back(shape_index(*law_, domain.walls[w]));
    if (is_mesh(w)) mesh_walls_.push_back(w);
  }
  records_.resize(domain.walls.size());
}

double Contacts::law_reach(const std::vector<ContactBody>& bodies) const {
  double reach = 0;
  for (const ContactPair& pair : contact_pairs(domain_, bodies))
    reach = std::max(reach, law_->reach(pair.together(), pair.properties));
  return reach;
}

void Contacts::check_periods(const std::vector<FiberGroup>& more) const {
  std::vector<ContactBody> bodies = bodies_;
  for (const FiberGroup& group : more) bodies.push_back(sphere_body(group.chain, domain_));
  const auto [least, largest] = std::ranges::minmax(bodies, {}, &ContactBody::radius);
  FiberBodies added;
  for (const FiberGroup& group : more) added.add(group.chain, 1);
  const double bound = std::max({largest.radius, fiber_bodies_.largest_bound(), added.largest_bound()});
  check_minimum_image(domain_.period, 2 * bound + kSkin * least.radius + law_reach(bodies));
}

int Contacts::kind_of(const ContactBody& body) {
  const auto found = std::ranges::find(bodies_, body);
  if (found == bodies_.end()) {
    bodies_.push_back(body);
    return static_cast<int>(bodies_.size()) - 1;
  }
  return static_cast<int>(found - bodies_.begin());
}

void Contacts::add(const Chain<3>& chain, int count) {
  const int kind = kind_of(sphere_body(chain, domain_)), n = chain.fiber.aspect_ratio + 1;
  std::int32_t number = fiber_.empty() ? 0 : whole(fiber_.back()) + 1;
  for (int f = 0; f < count; ++f, ++number) {
    fiber_.insert(fiber_.end(), n, number);
    radius_.insert(radius_.end(), n, bodies_[kind].radius);
  }
  fiber_bodies_.add(chain, count);
  if (chain.smooth) law_ = &smooth_law(*law_);
  kind_of_sphere_.resize(fiber_.size() - static_cast<std::size_t>(n) * count);
  kind_of_sphere_.resize(fiber_.size(), kind);
}

void Contacts::part_behind(const std::vector<std::int64_t>& rows) {
  for (std::int32_t& piece : fiber_) piece = whole(piece);
  for (const std::int64_t row : rows) {
    const std::int32_t number = whole(fiber_[row]);
    for (auto at = static_cast<std::size_t>(row) + 1; at < fiber_.size() && whole(fiber_[at]) == number; ++at)
      fiber_[at] = ~fiber_[at];
  }
  neighbors_.set_fibers(fiber_);
  if (!fiber_bodies_.smooth) return;
  fiber_bodies_.parted = rows;
  fiber_bodies_.build(SphereStorage::pads);
}

double Contacts::brought_between(std::int64_t first, std::int64_t second) const {
  const Part& part = parts_[neighbors_.parts().of(static_cast<std::int32_t>(first))];
  for (std::size_t p = 0; p < part.pairs.count; ++p) {
    if (part.pairs.first[p] != first || part.pairs.second[p] != second || part.pairs.contact[p] == 0)
      continue;
    const SavedContact contact = part.histories.at(
        part.pairs.contact[p], {fiber_bodies_.primitive(first), fiber_bodies_.primitive(second)});
    return law_->normal_energy(parameters_of(contact), contact.history) -
           0.5 * step_ * closing_power(contact);
  }
  return 0;
}

void Contacts::cut(int count) {
  ContactAccumulators sum;
  double deepest = 0;
  for (const Part& part : parts_) sum += part.sums, deepest = std::max(deepest, part.deepest);
  parts_ = std::vector<Part>(count);
  for (Part& part : parts_) {
    part.walls.resize(domain_.walls.size());
    part.meshes.resize(domain_.walls.size());
    part.ridges.resize(ridges_.size());
    part.wall_loads.resize(domain_.walls.size());
    part.wall_brought.resize(domain_.walls.size());
    part.halo_of_part.resize(count);
    part.histories.accounted = accounted_;
  }
  parts_[0].sums = sum;
  parts_[0].deepest = deepest;
}

void Contacts::pad(SphereStorage& rows) const {
  // a pair too far apart to touch, and a sphere far from every wall
  const std::int64_t n = spheres();
  for (int c = 0; c < 3; ++c) {
    const double period = domain_.period[c];
    rows.position_row(n + 1)[c] = period > 0 ? 0.5 * period : 1e6 * radius_[0];
  }
  rows.position_row(n + 2)[radius_offset] = -std::numeric_limits<double>::max();
}

void Contacts::set_parameters() {
  pair_parameters_.clear();
  wall_parameters_.clear();
  const auto append = [&](std::vector<double>& table, const ContactBody& body, const ContactBody& other) {
    table.resize(table.size() + law_->parameters_size);
    const ContactPair pair = contact_pair(domain_, body, other);
    law_->parameters(pair.together(), pair.properties, step_, &*table.end() - law_->parameters_size);
  };
  for (const ContactBody& body : bodies_) {
    for (const ContactBody& other : bodies_) append(pair_parameters_, body, other);
  }
  for (const Wall& wall : domain_.walls) {
    for (const ContactBody& body : bodies_) append(wall_parameters_, body, wall_body(domain_, wall));
  }
  law_reach_ = law_reach(bodies_);
  skin_ = kSkin * *std::ranges::min_element(radius_);
}

void Contacts::begin(SphereStorage& rows, Partition parts, double time, ThreadPool& pool) {
  const std::vector<SavedContact> contacts = saved();
  set_parameters();
  const bool periodic = std::ranges::any_of(domain_.period.c, [](double p) { return p > 0; });
  const ContactPhysics physics{bodies_.size() == 1, periodic, rolls(domain_), accounted_};
  if (fiber_bodies_.smooth && ridges_.empty()) find_walls_ridges();
  cut(parts.count());
  fiber_bodies_.build(SphereStorage::pads);
  if (fiber_bodies_.smooth) {
    smooth_kernel_ = smooth_kernel(*law_, physics, instruction_set_);
    kernel_ = &smooth_kernel_;
    segment_kernel_ = &segment_kernel(physics, instruction_set_);
    neighbors_ = NeighborList({fiber_bodies_.bound, fiber_, domain_.period}, skin_ + law_reach_,
                              std::move(parts), *kernel_, fiber_bodies_);
  } else {
    kernel_ = &law_->kernel(physics, instruction_set_);
    neighbors_ =
        NeighborList({radius_, fiber_, domain_.period}, skin_ + law_reach_, std::move(parts), *kernel_);
  }
  kind_of_sphere_.resize(spheres() + SphereStorage::pads, 0);
  pad(rows);
  rebuild_neighbor_list(rows, time, pool);
  restore(contacts);
}

}  // namespace fiberchain::dem
