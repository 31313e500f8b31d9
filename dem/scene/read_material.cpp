#include "dem/scene/read_material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dem/files/nearest_word.hpp"
#include "dem/record/data_directory.hpp"
#include "dem/scene/key_table.hpp"
#include "dem/scene/material_ranges.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/yaml_document.hpp"

namespace fiberchain::dem {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestMaterial = 64 * 1024;

void check_range(const StrictMapping& mapping, const MaterialValue& value) {
  if (!value.range || (value.range->front() <= value.value && value.value <= value.range->back())) return;
  mapping.fail("range", fmt::format("does not hold the value, {:g}", value.value));
}

/// What every value has.
KeyTable<MaterialValue> value_keys(const std::string& unit, const ValueRange& allowed) {
  KeyTable<MaterialValue> table;
  table.quantity("value", unit, &MaterialValue::value, allowed, "the value").required();
  table.interval("range", unit, &MaterialValue::range, "range that holds it");
  table.quantity("temperature", "K", &MaterialValue::temperature, kPositive, "its temperature").required();
  table.word("source", &MaterialValue::source, "word", "key of sources.yaml").required();
  table.word("note", &MaterialValue::note, "text", "what is odd");
  return table;
}

using Member = std::optional<MaterialValue> MaterialData::*;

void declare(KeyTable<MaterialData>& keys, const std::string& key, Member member,
             const KeyTable<MaterialValue>& table) {
  const auto store = [member](const StrictMapping& mapping, const MaterialValue& value, MaterialData& to) {
    check_range(mapping, value);
    to.*member = value;
  };
  keys.mapping(key, table, store, "see data/materials/README.md");
}

KeyTable<MaterialValue> loss_keys() {
  KeyTable<MaterialValue> table = value_keys("1", kLossFactor);
  table.interval("band", "Hz", &MaterialValue::band, "where it was measured");
  table.flag("total", &MaterialValue::total, "a thermoelastic part may be in it");
  return table;
}

KeyTable<MaterialValue> conductivity_keys() {
  KeyTable<MaterialValue> table = value_keys("W/(m K)", kPositive);
  table.flag("along", &MaterialValue::along, "along the fiber, not across");
  return table;
}

KeyTable<MaterialData> material_keys() {
  using M = MaterialData;
  KeyTable<M> keys;
  keys.word("name", &M::name, "the file's name", "name").required();
  keys.word("description", &M::description, "text", "what it is").required();
  KeyTable<MaterialValue> temperature;
  temperature.quantity("value", "K", &MaterialValue::value, kPositive, "of the set").required();
  keys.mapping(
          "temperature", temperature,
          [](const StrictMapping&, const MaterialValue& value, M& to) { to.temperature = value.value; },
          "of the set")
      .required();
  declare(keys, "youngs_modulus", &M::youngs_modulus, value_keys("Pa", kPositive));
  declare(keys, "poisson_ratio", &M::poisson_ratio, value_keys("1", kPoissonRatio));
  declare(keys, "shear_modulus", &M::shear_modulus, value_keys("Pa", kPositive));
  declare(keys, "transverse_modulus", &M::transverse_modulus, value_keys("Pa", kPositive));
  declare(keys, "density", &M::density, value_keys("kg/m^3", kPositive));
  declare(keys, "loss_factor", &M::loss_factor, loss_keys());
  declare(keys, "shear_loss_factor", &M::shear_loss_factor, loss_keys());
  declare(keys, "thermal_expansion", &M::thermal_expansion, value_keys("1/K", kFinite));
  declare(keys, "heat_capacity", &M::heat_capacity, value_keys("J/(kg K)", kPositive));
  declare(keys, "conductivity", &M::conductivity, conductivity_keys());
  keys.one_of({"poisson_ratio", "shear_modulus"}, "neither is known");
  return keys;
}

fs::path materials_directory() {
  const DataSearch search = find_data("materials");
  if (search.found) return *search.found / "materials";
  throw SceneError("no directory 'materials' with the materials in " + search.tried);
}

}  // namespace

std::optional<ThermalProperties> thermal_properties(const MaterialData& material) {
  const auto &alpha = material.thermal_expansion, &c = material.heat_capacity, &k = material.conductivity;
  if (!alpha || !c || !k || k->along) return std::nullopt;
  return ThermalProperties{alpha->value, material.temperature, c->value, k->value};
}

MaterialDamping damping_of(const MaterialData& material) {
  MaterialDamping damping;
  damping.thermoelastic = thermal_properties(material);
  const auto &loss = material.loss_factor, &shear = material.shear_loss_factor;
  if (loss && !(loss->total && damping.thermoelastic)) {
    damping.loss_factor = loss->value;
    damping.band = loss->band;
  }
  if (shear) damping.shear_loss_factor = shear->value;
  if (shear && !damping.band) damping.band = shear->band;
  return damping;
}

MaterialData parse_material(const SceneText& file, std::shared_ptr<const Units> units) {
  const StrictMapping top(file.text, file.name, std::move(units));
  MaterialData material = material_keys().read_strictly(top);
  if (fs::path(file.name).stem() != material.name)
    top.fail("name", fmt::format("'{}' is not the file's", printable(material.name)));
  material.file = file;
  return material;
}

MaterialData find_material(const std::string& name, const fs::path& beside,
                           std::shared_ptr<const Units> units) {
  if (name.ends_with(".yaml"))
    return parse_material(read_scene_text(beside.parent_path() / name, kLargestMaterial), std::move(units));
  const std::vector<std::string> names = material_names();
  if (!std::ranges::binary_search(names, name)) {
    throw SceneError(
        fmt::format("unknown material '{}'; {} (`fiberchain materials` lists them; a path must "
                    "end in .yaml)",
                    printable(name), suggestion(name, names)));
  }
  return parse_material(read_scene_text(materials_directory() / (name + ".yaml"), kLargestMaterial),
                        std::move(units));
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(materials_directory())) {
    const fs::path& path = entry.path();
    if (path.extension() == ".yaml" && path.stem() != "sources") names.push_back(path.stem().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace fiberchain::dem
