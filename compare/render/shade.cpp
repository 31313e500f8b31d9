#include "compare/render/shade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/trajectory/output_fields.hpp"

namespace fiberchain::compare {
namespace {

using dem::FrameBond;
using dem::OutputField;
using dem::TrajectoryFrame;
using Values = std::function<std::vector<double>(const TrajectoryFrame&)>;

std::string in_words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string unit_of(const OutputField& field) {
  return std::string_view(field.unit) == "m s-1" ? "m/s" : field.unit;
}

/// A row of numbers as one: component `c`, the size without.
double number_of(const double* row, int width, int c) {
  if (width == 1) return *row;
  if (c >= 0) return row[c];
  return std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
}

/// A number a row of a field.
std::vector<double> column(const TrajectoryFrame& frame, const OutputField& field, int c) {
  const std::vector<double> all = field.values(frame);
  const auto width = static_cast<std::size_t>(field.width);
  std::vector<double> values(all.size() / width);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = number_of(&all[i * width], field.width, c);
  return values;
}

/// Numbers of the bonds as means of each sphere's.
std::vector<double> at_spheres(const TrajectoryFrame& frame, const std::vector<double>& of_bonds) {
  std::vector<double> values(frame.position.size(), 0);
  std::vector<int> bonds(values.size(), 0);
  for (std::size_t b = 0; b < frame.bonds.size(); ++b) {
    for (const auto i : {static_cast<std::size_t>(frame.bonds[b].first),
                         static_cast<std::size_t>(frame.bonds[b].first) + 1}) {
      values[i] += of_bonds[b];
      ++bonds[i];
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] /= std::max(bonds[i], 1);
  return values;
}

/// Force on a bond's first sphere towards its second [N]: through a periodic side towards it all the same.
std::vector<double> tensions(const TrajectoryFrame& frame) {
  std::vector<double> all;
  for (const FrameBond& bond : frame.bonds) {
    const auto a = static_cast<std::size_t>(bond.first);
    auto r = frame.position[a + 1] - frame.position[a];
    for (int c = 0; c < 3; ++c) {
      const double period = frame.high[c] - frame.low[c];
      if (frame.periodic[c]) r[c] -= period * std::round(r[c] / period);
    }
    all.push_back(dot(bond.force, r) / norm(r));
  }
  return all;
}

/// Sum of the sizes of the forces in a sphere's contacts [N].
std::vector<double> contact_forces(const TrajectoryFrame& frame) {
  std::vector<double> all(frame.position.size(), 0);
  for (const dem::FrameContact& contact : frame.contacts) {
    all[static_cast<std::size_t>(contact.first)] += norm(contact.force);
    if (contact.kind != dem::ContactKind::wall)
      all[static_cast<std::size_t>(contact.second)] += norm(contact.force);
  }
  return all;
}

/// A field's own and its components, where `spread` brings rows to spheres.
template <class Spread>
void add_field(std::vector<Shade>& all, const OutputField& field, const char* of, const Spread& spread) {
  const auto add = [&](const std::string& end, int c, bool is_signed) {
    const std::string name = field.name + end;
    if (std::ranges::any_of(all, [&](const Shade& known) { return known.name == name; })) return;
    all.push_back({name, in_words(name) + of, unit_of(field), is_signed,
                   [&field, spread, c](const TrajectoryFrame& frame) {
                     return spread(frame, column(frame, field, c));
                   }});
  };
  add("", -1, false);
  if (field.width == 1) return;
  for (int c = 0; c < 3; ++c) add(std::string("_") + "xyz"[c], c, true);
}

std::vector<Shade> make_shades() {
  std::vector<Shade> all;
  all.push_back({"vertical_speed", "vertical velocity", "m/s", true, [](const TrajectoryFrame& frame) {
                   std::vector<double> values;
                   for (const auto& v : frame.velocity) values.push_back(v[2]);
                   return values;
                 }});
  for (const OutputField& field : dem::bond_fields) {
    if (std::string_view(field.name) == "bending_angle") add_field(all, field, " of the bonds", at_spheres);
  }
  for (const OutputField& field : dem::sphere_fields)
    add_field(all, field, "", [](const TrajectoryFrame&, std::vector<double> values) { return values; });
  for (const OutputField& field : dem::bond_fields) add_field(all, field, " of the bonds", at_spheres);
  all.push_back({"bond_tension", "tension of the bonds", "N", true,
                 [](const TrajectoryFrame& frame) { return at_spheres(frame, tensions(frame)); }});
  all.push_back({"contact_force", "forces of contacts", "N", false, contact_forces});
  all.push_back({"radius", "radius", "m", false, [](const TrajectoryFrame& frame) { return frame.radius; }});
  all.push_back({"fiber", "number of the fiber", "", false, [](const TrajectoryFrame& frame) {
                   return std::vector<double>(frame.fiber.begin(), frame.fiber.end());
                 }});
  return all;
}

}  // namespace

const std::vector<Shade>& shades() {
  static const std::vector<Shade> all = make_shades();
  return all;
}

const Shade& shade_named(std::string_view name) {
  const auto found = std::ranges::find(shades(), name, &Shade::name);
  if (found == shades().end()) throw dem::InvalidInput(fmt::format("there is no shade '{}'", name));
  return *found;
}

std::pair<double, double> range_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {0, 1};
  std::ranges::sort(values);
  const std::size_t rare = values.size() / 200;
  const double low = values[rare], high = values[values.size() - 1 - rare];
  constexpr double nothing = 1e-9;
  const double most = std::max(std::abs(low), std::abs(high));
  const double least = 1e-3 * std::max(most, nothing);  // what hardly differs looks alike
  if (high - low <= least && most < nothing) return {-1, 1};
  return high - low > least ? std::pair{low, high} : std::pair{low - least, high + least};
}

std::pair<double, double> shade_range(std::span<const TrajectoryFrame> frames, const Shade& shade) {
  std::vector<double> values;
  for (const TrajectoryFrame& frame : frames) {
    const std::vector<double> more = shade.values(frame);
    values.insert(values.end(), more.begin(), more.end());
  }
  const auto [low, high] = range_of(std::move(values));
  return {shade.is_signed || high <= 0 ? low : std::max(low, 0.0), high};
}

}  // namespace fiberchain::compare
