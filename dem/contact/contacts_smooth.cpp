#include <algorithm>

#include "dem/contact/contacts.hpp"
#include "dem/contact/laws/smooth_hertz.hpp"

// Contacts between smooth fibers, one by one.
namespace fiberchain::dem {

TouchingPair<double> Contacts::fiber_pair_at(const SavedContact& c, const SphereStorage& rows, double& arm,
                                             Vec<double, 3>& center) const {
  const std::int64_t first = c.key.first.number, second = c.key.second.number;
  const auto position = [&](std::int64_t sphere) { return rows.position(sphere); };
  const SegmentNodes<double> a = fiber_bodies_.nodes(first, position);
  SegmentNodes<double> b = fiber_bodies_.nodes(second, position);
  const Vec<double, 3> between = 0.5 * ((b.begin + b.end) - (a.begin + a.end)),
                       shift = nearest_image(periods_, between) - between;
  for (Vec<double, 3>* node : {&b.before, &b.begin, &b.end, &b.behind}) *node = *node + shift;
  const SegmentContact<double> at = segment_contact(a, b);
  const Vec<double, 3> r = separation(a, b, at.first, at.second);
  const auto mean = [&](std::int64_t body, double place, const auto& of) {
    const Vec<double, 3> begin = of(body), end = of(fiber_bodies_.end[body]);
    return begin + place * (end - begin);
  };
  const auto velocity = [&](std::int64_t sphere) { return rows.velocity(sphere); };
  const auto spin = [&](std::int64_t sphere) { return rows.spin(sphere); };
  const Vec<double, 3> w1 = mean(first, at.first, spin), w2 = mean(second, at.second, spin);
  TouchingPair<double> pair{};
  pair.normal = (1 / norm(r)) * r;
  arm = norm(r) * a.radius / (a.radius + b.radius);
  center = along(a, at.first);
  pair.overlap = law_->overlap(c.history);
  pair.velocity = mean(second, at.second, velocity) - mean(first, at.first, velocity) -
                  cross(arm * w1 + (norm(r) - arm) * w2, pair.normal);
  pair.spin = w2 - w1;
  pair.mean_spin = 0.5 * (w1 + w2);
  return pair;
}

bool Contacts::is_there(const ContactKey& key) const {
  const PairList& pairs = parts_[neighbors_.parts().of(key.first.number)].pairs;
  const auto end = pairs.first.begin() + static_cast<std::ptrdiff_t>(pairs.count);
  auto at = std::lower_bound(pairs.first.begin(), end, key.first.number);
  for (; at != end && *at == key.first.number; ++at) {
    const auto n = static_cast<std::size_t>(at - pairs.first.begin());
    if (pairs.second[n] == key.second.number) return pairs.contact[n] != 0;
  }
  return false;
}

SavedContact Contacts::handed_on(const ContactKey& key, const std::vector<SavedContact>& before) const {
  SavedContact best{key};
  if (is_facet(key.second)) return best;
  double deepest = 0;
  for (std::int64_t a = key.first.number - 1; a <= key.first.number + 1; ++a) {
    for (std::int64_t b = key.second.number - 1; b <= key.second.number + 1; ++b) {
      const ContactKey near{segment_primitive(a), segment_primitive(b), 0};
      const auto found = std::ranges::lower_bound(before, near, {}, &SavedContact::key);
      if (a < 0 || near == key || found == before.end() || found->key != near) continue;
      const bool shares = a == key.first.number || b == key.second.number;
      if (!shares && is_there(near)) continue;
      const double depth = from_numbers<SmoothHertz::History<double>>(found->history).sqrt_overlap,
                   weight = shares ? 2 * depth : depth;
      if (weight > deepest) deepest = weight, best = *found;
    }
  }
  best.key = key;
  return best;
}

void Contacts::set_shares(SavedContact& before, const SavedContact& now) {
  const auto share = from_numbers<SmoothHertz::History<double>>(now.history);
  auto history = from_numbers<SmoothHertz::History<double>>(before.history);
  history.share_less_one = share.share_less_one;
  history.stiffer = share.stiffer;
  to_numbers(history, before.history);
}

double Contacts::held_by_segments(const std::vector<std::int64_t>& rows) {
  shares_before_.clear();
  if (!fiber_bodies_.smooth || rows.empty()) return 0;
  double energy = 0;
  const auto is_of = [&](const Primitive& body, std::int64_t before, std::int64_t behind) {
    return body.kind == PrimitiveKind::segment && std::ranges::any_of(rows, [&](std::int64_t row) {
             return body.number >= row - before && body.number <= row + behind;
           });
  };
  each_place([&](const ContactPlace& place) {
    const auto& [first, second] = std::pair(place.key.first, place.key.second);
    const SavedContact contact = saved(place);
    if (is_of(first, 0, 0) || is_of(second, 0, 0)) {
      energy += energy_of(contact) + 0.5 * step_ * closing_power(contact);
    } else if (is_of(first, 1, 1) || is_of(second, 1, 1)) {
      const auto history = from_numbers<SmoothHertz::History<double>>(contact.history);
      shares_before_.emplace_back(place.key, SmoothHertz::share_of(history));
    }
  });
  std::ranges::sort(shares_before_);
  return energy;
}

double Contacts::brought_behind(const std::vector<std::int64_t>& rows) const {
  double energy = 0;
  if (!fiber_bodies_.smooth) {
    for (const std::int64_t row : rows) energy += brought_between(row, row + 1);
    return energy;
  }
  std::vector<std::int64_t> ends;
  for (const std::int64_t row : rows) {
    for (const std::int64_t node : {row, row + 1}) ends.push_back(fiber_bodies_.body_of(node));
  }
  const auto is_end = [&](const Primitive& body) {
    return is_of_fiber(body) && std::ranges::find(ends, body.number) != ends.end();
  };
  each_place([&](const ContactPlace& place) {
    const bool of_wall = is_facet(place.key.second);
    if (of_wall && is_sphere(place.key.first)) return;  // as before
    if (!is_end(place.key.first) && !is_end(place.key.second)) return;
    const SavedContact contact = saved(place);
    const double normal = law_->normal_energy(parameters_of(contact), contact.history);
    const auto was =
        std::ranges::lower_bound(shares_before_, place.key, {}, &std::pair<ContactKey, double>::first);
    if (was == shares_before_.end() || was->first != place.key) {
      energy += normal - 0.5 * step_ * closing_power(contact);
    } else {
      const auto history = from_numbers<SmoothHertz::History<double>>(contact.history);
      energy += normal * (1 - was->second / std::max(SmoothHertz::share_of(history), 1e-300));
    }
  });
  return energy;
}

}  // namespace fiberchain::dem
