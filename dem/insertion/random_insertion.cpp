#include "dem/insertion/random_insertion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "dem/insertion/placement.hpp"
#include "dem/insertion/random_numbers.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;
using std::numbers::pi;

double sphere_volume(double radius) { return 4.0 / 3 * pi * radius * radius * radius; }

void check(const std::vector<InsertionCount>& counts, const InsertionRules& rules) {
  const auto refuse = [](const std::string& what) { throw InvalidInput(what); };
  double needed = 0, available = 1, diameter = 0;
  for (int a = 0; a < 3; ++a) {
    const double length = rules.region.high[a] - rules.region.low[a];
    if (!(length > 0 && std::isfinite(length)))
      refuse(fmt::format("region's side {} m is not allowed: it must be above 0", length));
    available *= length;
  }
  for (const InsertionCount& c : counts) {
    check(c.chain.fiber);
    if (c.count < 0) refuse(fmt::format("count = {} is not allowed: it must be at least 0", c.count));
    diameter = std::max(diameter, c.chain.fiber.diameter);
    needed += static_cast<double>(c.count * (c.chain.fiber.aspect_ratio + 1)) *
              sphere_volume(sphere_radius(c.chain.fiber));
  }
  if (needed > available) {
    throw NoRoom(fmt::format(
        "fibers of {:.3g} m^3 do not go into a region of {:.3g} m^3: look at their diameter, {:g} m "
        "at most, their aspect_ratio and count, and at filling.region",
        needed, available, diameter));
  }
  const InsertionOrientation& o = rules.orientation;
  if (!(o.angle >= 0 && o.angle <= pi / 2))
    refuse(fmt::format("angle = {} is not allowed: it must be 0 to pi/2", o.angle));
  if (!(norm(o.direction) > 0 && std::isfinite(norm(o.direction)))) refuse("direction must point somewhere");
  if (!(rules.gap >= 0 && std::isfinite(rules.gap)))
    refuse(fmt::format("gap = {} is not allowed: it must be at least 0", rules.gap));
  if (rules.attempts < 1)
    refuse(fmt::format("attempts = {} is not allowed: it must be at least 1", rules.attempts));
}

/// Uniform over all rotations (Shoemake, Graphics Gems III, 1992).
Quaternion<double> any_rotation(const std::array<double, 4>& u) {
  const double a = std::sqrt(1 - u[0]), b = std::sqrt(u[0]), s = 2 * pi * u[1], t = 2 * pi * u[2];
  return {b * std::cos(t), {a * std::sin(s), a * std::cos(s), b * std::sin(t)}};
}

V direction_of(const InsertionOrientation& o, const std::array<double, 4>& u) {
  // equal areas of the sphere are equal heights over its equator
  const double height = o.alignment == Alignment::near_axis
                            ? std::copysign(1 - u[0] * (1 - std::cos(o.angle)), u[3] - 0.5)
                            : (2 * u[0] - 1) * std::sin(o.angle);
  const double across = std::sqrt(std::max(0.0, (1 - height) * (1 + height)));
  return rotate(rotation_between({0, 0, 1}, o.direction),
                V{across * std::cos(2 * pi * u[1]), across * std::sin(2 * pi * u[1]), height});
}

Quaternion<double> rotation_for(const Chain<3>& chain, const InsertionOrientation& o,
                                const std::array<double, 4>& u) {
  if (o.alignment == Alignment::isotropic) return any_rotation(u);
  const V along = end_to_end(chain.poses);
  return rotation_between(along, direction_of(o, u)) * rotation((2 * pi * u[2] / norm(along)) * along);
}

/// Places fibers one by one.
class Inserter {
 public:
  Inserter(const InsertionRules& rules, const Domain& domain, double largest_radius, std::int64_t spheres)
      : rules_(rules),
        domain_(domain),
        grid_(rules.region, domain.period, largest_radius, rules.gap, spheres) {}

  void add(const V& center, double radius) { grid_.add(center, radius); }

  /// Nothing if the fiber finds no place within the attempts.
  std::optional<ChainState<3>> insert(const Chain<3>& chain, std::uint64_t number,
                                      const std::function<void(std::int64_t)>& watch) {
    const double radius = sphere_radius(chain.fiber);
    for (std::int64_t attempt = 0; attempt < rules_.attempts; ++attempt) {
      if (attempt % 64 == 0) watch(attempt);
      const auto t = static_cast<std::uint64_t>(attempt);
      const Quaternion<double> turn =
          rotation_for(chain, rules_.orientation, uniform_numbers(rules_.seed, {number, t, 0}));
      ChainState<3> state = placed(chain, turn, {}, rules_.velocity);
      if (!move_inside(state.poses, radius, uniform_numbers(rules_.seed, {number, t, 1})) ||
          !fits(state.poses, radius))
        continue;
      for (const auto& pose : state.poses) grid_.add(pose.position, radius);
      return state;
    }
    return std::nullopt;
  }

 private:
  bool spans(int a) const {
    const double period = domain_.period[a];
    return period > 0 && rules_.region.high[a] - rules_.region.low[a] >= period * (1 - 1e-12);
  }

  /// Uniformly among the positions in the region; false if the fiber is longer than the region.
  bool move_inside(Poses<3>& poses, double radius, const std::array<double, 4>& u) const {
    V shift{};
    for (int a = 0; a < 3; ++a) {
      double low = rules_.region.low[a], high = rules_.region.high[a];
      if (spans(a)) {
        high = low + domain_.period[a];
      } else {
        double least = 0, most = 0;
        for (const auto& pose : poses) {
          least = std::min(least, pose.position[a]);
          most = std::max(most, pose.position[a]);
        }
        low += radius - least;
        high -= radius + most;
        if (high < low) return false;
      }
      shift[a] = low + u[static_cast<std::size_t>(a)] * (high - low);
    }
    for (auto& pose : poses) pose.position = pose.position + shift;
    return true;
  }

  bool fits(const Poses<3>& poses, double radius) const {
    for (const auto& pose : poses) {
      for (const Wall& wall : domain_.walls) {
        if (distance_to(wall, pose.position, rules_.time) < radius + rules_.gap) return false;
      }
      if (!grid_.free(pose.position, radius)) return false;
    }
    return clear_of_its_images(poses, radius);
  }

  /// A fiber longer than the period could meet itself from behind.
  bool clear_of_its_images(const Poses<3>& poses, double radius) const {
    const double reach = 2 * radius + rules_.gap;
    const double length = 2 * radius * static_cast<double>(poses.size());
    bool may = false;
    for (int a = 0; a < 3; ++a) may = may || (spans(a) && domain_.period[a] < length + reach);
    for (std::size_t i = 0; may && i < poses.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const V direct = poses[j].position - poses[i].position;
        const V r = grid_.nearest(poses[i].position, poses[j].position);
        if (norm(r - direct) > reach && norm(r) < reach) return false;
      }
    }
    return true;
  }

  const InsertionRules& rules_;
  const Domain& domain_;
  InsertionGrid grid_;
};

/// Neighbors in space become neighbors in memory: fibers in the order of their middles along the region's
/// longest side.
void sort_by_place(std::vector<ChainState<3>>& fibers, const Box& region) {
  int longest = 0;
  for (int a = 1; a < 3; ++a) {
    if (region.high[a] - region.low[a] > region.high[longest] - region.low[longest]) longest = a;
  }
  std::ranges::stable_sort(fibers, {}, [&](const ChainState<3>& fiber) {
    double sum = 0;
    for (const auto& pose : fiber.poses) sum += pose.position[longest];
    return sum;
  });
}

}  // namespace

double distance_to(const Wall& wall, const V& point, double time) {
  return is_active(wall, time) ? gap_to(wall, point, time) : std::numeric_limits<double>::infinity();
}

PlacedSpheres spheres_of(const std::vector<FiberGroup>& groups) {
  PlacedSpheres spheres;
  for (const FiberGroup& group : groups) {
    for (const ChainState<3>& state : group.fibers) {
      for (const auto& pose : state.poses) spheres.position.push_back(pose.position);
    }
    spheres.radius.resize(spheres.position.size(), sphere_radius(group.chain.fiber));
  }
  return spheres;
}

std::vector<FiberGroup> random_insertion(const std::vector<InsertionCount>& counts,
                                         const InsertionRules& rules, const Domain& domain,
                                         const PlacedSpheres& present, const InsertionWatch& watch,
                                         Shortfall shortfall) {
  check(counts, rules);
  double largest = 0;
  auto spheres = static_cast<std::int64_t>(present.radius.size());
  for (const double radius : present.radius) largest = std::max(largest, radius);
  std::vector<FiberGroup> groups;
  std::vector<std::int64_t> first;  // number of a group's first fiber
  std::int64_t fibers = 0;
  for (const InsertionCount& c : counts) {
    largest = std::max(largest, sphere_radius(c.chain.fiber));
    spheres += c.count * (c.chain.fiber.aspect_ratio + 1);
    groups.push_back({c.chain, {}});
    first.push_back(rules.first_number + fibers);
    fibers += c.count;
  }
  std::vector<std::size_t> order(counts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t g) { return fiber_length(counts[g].chain.fiber); });

  Inserter filler(rules, domain, largest, spheres);
  for (std::size_t i = 0; i < present.radius.size(); ++i) filler.add(present.position[i], present.radius[i]);
  std::int64_t done = 0;
  for (const std::size_t g : order) {
    for (std::int64_t i = 0; i < counts[g].count; ++i, ++done) {
      const auto tell = [&](std::int64_t attempt) {
        if (watch) watch({done, fibers, attempt});
      };
      auto state = filler.insert(counts[g].chain, static_cast<std::uint64_t>(first[g] + i), tell);
      if (!state && shortfall == Shortfall::accept) break;
      if (!state) {
        throw NoRoom(
            fmt::format("fiber {} of {} found no place in {} attempts: between walls and other fibers, the "
                        "region ({:.3g} m x {:.3g} m x "
                        "{:.3g} m) is too small or too full for fibers {:.3g} m long; make it larger or "
                        "taller, or fill in batches (batches.no_room says what those without room do)",
                        done + 1, fibers, rules.attempts, rules.region.high[0] - rules.region.low[0],
                        rules.region.high[1] - rules.region.low[1],
                        rules.region.high[2] - rules.region.low[2], fiber_length(counts[g].chain.fiber)));
      }
      groups[g].fibers.push_back(std::move(*state));
    }
    sort_by_place(groups[g].fibers, rules.region);
  }
  return groups;
}

}  // namespace fiberchain::dem
