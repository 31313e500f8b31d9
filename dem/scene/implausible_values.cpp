#include "dem/scene/implausible_values.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "dem/files/numbers.hpp"
#include "dem/scene/scene_settings.hpp"
#include "dem/scene/units.hpp"

namespace fiberchain::dem {
namespace {

/// What a quantity can be, from the softest and lightest to the stiffest and heaviest that there is.
struct Plausible {
  const char* key;
  const char* unit;
  double low, high;
  const char* what;
  const char* bare;  ///< unit that a number without one may be meant in
};

constexpr Plausible kPlausible[] = {
    {"youngs_modulus", "Pa", 1e3, 2e12, "Young's moduli are from 1 kPa (gels) to 2 TPa (carbon nanotubes)",
     "MPa"},
    {"shear_modulus", "Pa", 3e2, 1e12, "shear moduli are from 0.3 kPa to 1 TPa", "MPa"},
    {"density", "kg/m^3", 1, 3e4, "densities are from 1 kg/m^3 (aerogels) to 3e4 kg/m^3", "g/cm^3"},
    {"diameter", "m", 1e-8, 0.1, "fibers have diameters from 10 nm to 0.1 m", "mm"},
    {"viscosity", "Pa s", 1e-6, 1e9, "viscosities are from 1e-6 Pa s (gases) to 1e9 Pa s (pitch)", "mPa s"},
    {"gravity", "m/s^2", 1e-9, 1e7, "accelerations are from 1e-9 to 1e7 m/s^2 (centrifuges)", nullptr},
    {"velocity", "m/s", 1e-12, 1e4, "bodies that touch move at up to 1e4 m/s", nullptr},
    {"duration", "s", 1e-12, 1e7, "runs are from 1 ps to 1e7 s", nullptr},
};

/// Units that differ from a likely one by the case of their first letter.
struct Slip {
  const char *typed, *called, *meant;
};
constexpr Slip kSlips[] = {{"mPa", "millipascal", "MPa"},
                           {"mN", "millinewton", "MN"},
                           {"Mm", "megameter", "mm"},
                           {"Mg", "megagram", "mg"}};

/// What may have been meant: another unit, if the value is plausible in it.
std::string suggestion(const std::string& typed, const Plausible& range, const Units& units) {
  const auto fits = [&](const std::string& text) {
    try {
      const double value = std::abs(units.to_si(text, range.unit));
      return value >= range.low && value <= range.high;
    } catch (const UnitError&) {
      return false;
    }
  };
  if (parse_number(typed)) {
    if (!range.bare || !fits(typed + " " + range.bare)) return "";
    return fmt::format("; {} {} meant?", typed, range.bare);
  }
  for (const Slip& slip : kSlips) {
    const std::size_t at = typed.find(slip.typed);
    if (at == std::string::npos) continue;
    std::string other = typed;
    other.replace(at, std::string(slip.typed).size(), slip.meant);
    if (fits(other)) return fmt::format("; {}, {} meant?", slip.called, slip.meant);
  }
  return "";
}

class Search {
 public:
  explicit Search(const std::string& name) : name_(name) {}

  void look_at(const YAML::Node& node, const std::string& path, const std::string& key) {
    if (node.IsMap()) {
      for (const auto& entry : node) {
        const std::string name = entry.first.as<std::string>("");
        look_at(entry.second, path.empty() ? name : path + "." + name, name);
      }
    } else if (node.IsSequence()) {
      for (const auto& entry : node) look_at(entry, path, key);
    } else if (node.IsScalar()) {
      for (const Plausible& range : kPlausible) {
        if (key == range.key) compare(node, path, range);
      }
    }
  }

  std::vector<std::string> found;

 private:
  void compare(const YAML::Node& node, const std::string& path, const Plausible& range) {
    const std::string typed = node.Scalar();
    double value = 0;
    try {
      value = units_.to_si(typed, range.unit);
    } catch (const UnitError&) {
      return;  // a word, or an error of its own
    }
    const double size = std::abs(value);
    if (size == 0 || !std::isfinite(size) || (size >= range.low && size <= range.high)) return;
    const int line = node.Mark().line;
    const std::string where = node.Mark().is_null() ? name_ : fmt::format("{}:{}", name_, line + 1);
    found.push_back(fmt::format("{}: {}: {} is {:.4g} {}{} ({})", where, path, typed, value, range.unit,
                                suggestion(typed, range, units_), range.what));
  }

  const std::string& name_;
  Units units_;
};

}  // namespace

std::vector<std::string> implausible_values(const SceneText& text) {
  Search search(text.name);
  search.look_at(settled_document(text), "", "");
  return search.found;
}

}  // namespace fiberchain::dem
