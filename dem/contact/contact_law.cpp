#include "dem/contact/contact_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

template <class... Laws>
std::vector<const ContactLaw*> laws_of(TypeList<Laws...>) {
  return {&contact_law_of<Laws>...};
}

const std::vector<const ContactLaw*>& all_laws() {
  static const std::vector<const ContactLaw*> all = laws_of(ContactLaws{});
  return all;
}

}  // namespace

const ContactLaw& contact_law(std::string_view name) {
  std::string names;
  for (const ContactLaw* law : all_laws()) {
    if (law->name == name) return *law;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", law->name);
  }
  throw InvalidInput(fmt::format("contact law = {} is not allowed; allowed: {}", name, names));
}

std::vector<std::pair<std::string, const ContactLaw*>> contact_law_words() {
  std::vector<std::pair<std::string, const ContactLaw*>> words;
  for (const ContactLaw* law : all_laws()) words.emplace_back(law->name, law);
  return words;
}

const ContactLaw& law_of(const ContactProperties& properties) {
  return properties.law != nullptr ? *properties.law : *all_laws().front();
}

void check(const ContactProperties& properties) {
  const auto require = [](const char* key, double value) {
    if (value >= 0 && std::isfinite(value)) return;
    throw InvalidInput(fmt::format("{} = {} is not allowed: it must be finite and 0 or greater", key, value));
  };
  require("friction", properties.friction);
  require("rolling_friction", properties.rolling_friction);
  require("work_of_adhesion", properties.work_of_adhesion);
  const ContactLaw& law = law_of(properties);
  if (law.adheres && properties.work_of_adhesion == 0)
    throw InvalidInput(
        fmt::format("work_of_adhesion = 0 is not allowed with contact law {}: it must be above 0", law.name));
  if (!law.adheres && properties.work_of_adhesion > 0)
    throw InvalidInput(fmt::format(
        "work_of_adhesion = {} is not allowed with contact law {}, which does not adhere; laws that do: "
        "jkr, dmt",
        properties.work_of_adhesion, law.name));
  const double E = properties.youngs_modulus.value_or(1), nu = properties.poisson_ratio.value_or(0);
  if (!(E > 0 && std::isfinite(E)))
    throw InvalidInput(fmt::format("contact modulus = {} is not allowed: it must be finite and above 0", E));
  if (!(nu > -1 && nu <= 0.5))
    throw InvalidInput(fmt::format(
        "Poisson's ratio of contacts = {} is not allowed: it must be above -1 and at most 0.5", nu));
}

int shape_index(const ContactLaw& law, const Wall& wall) {
  if (mesh_in(wall) != nullptr) return static_cast<int>(law.shapes.size());
  const auto found = std::ranges::find(law.shapes, &wall.shape.type());
  if (found == law.shapes.end()) {
    throw InvalidInput(
        fmt::format("wall shape = {} is not allowed: the loops of contact law {} are not compiled for it",
                    wall.shape.type().name, law.name));
  }
  return static_cast<int>(found - law.shapes.begin());
}

}  // namespace fiberchain::dem
