#include "dem/scene/read_material_damping.hpp"

#include "dem/scene/material_ranges.hpp"

namespace fiberchain::dem {
namespace {

constexpr const char* kKey = "material_damping";

KeyTable<ThermoelasticKeys> thermoelastic_keys() {
  using T = ThermoelasticKeys;
  const std::string usual = "that of `material`";
  KeyTable<T> table;
  table.quantity("expansion", "1/K", &T::expansion, kFinite, "linear thermal expansion α").otherwise(usual);
  table.quantity("temperature", "K", &T::temperature, kPositive, "temperature T").otherwise(usual);
  table.quantity("heat_capacity", "J/(kg K)", &T::heat_capacity, kPositive, "heat capacity c")
      .otherwise(usual);
  table
      .quantity("conductivity", "W/(m K)", &T::conductivity, kPositive,
                "thermal conductivity k across the fiber")
      .otherwise(usual);
  table
      .quantity("highest_frequency", "Hz", &T::highest_frequency, kPositive,
                "up to which the loss factor is met to 1 %; a lower one may take fewer branches")
      .otherwise("1 / (π t_b), beyond which the chain has no motion");
  return table;
}

KeyTable<MaxwellBranch> branch_keys() {
  KeyTable<MaxwellBranch> table;
  table
      .number("strength", &MaxwellBranch::strength, {.low = 0, .high = 1e6},
              "g, its spring's stiffness over the relaxed one")
      .required();
  table.quantity("time", "s", &MaxwellBranch::time, kPositive, "τ, within which it relaxes").required();
  return table;
}

KeyTable<MaterialRelaxation> spectrum_keys() {
  KeyTable<MaterialRelaxation> table;
  const auto declare = [&](const char* key, PronySeries MaterialRelaxation::*series, const char* meaning) {
    const auto store = [series](const StrictMapping&, const MaxwellBranch& branch, MaterialRelaxation& to) {
      (to.*series).push_back(branch);
    };
    table.list(key, branch_keys(), store, meaning);
  };
  declare("youngs_modulus", &MaterialRelaxation::youngs_modulus, "branches of stretch and bending");
  declare("shear_modulus", &MaterialRelaxation::shear_modulus, "branches of shear and twist");
  declare("bending", &MaterialRelaxation::bending, "branches of bending alone");
  return table;
}

[[noreturn]] void fail(const StrictMapping& fiber, const std::string& message) { fiber.fail(kKey, message); }

ThermalProperties thermal_of(const StrictMapping& fiber, const ThermoelasticKeys& keys,
                             const std::optional<MaterialData>& material) {
  std::vector<std::string> missing;
  const auto value = [&](const char* name, const std::optional<double>& typed,
                         const std::optional<double>& known) {
    if (!typed && !known) missing.emplace_back(name);
    return typed ? *typed : known.value_or(0);
  };
  const auto of = [&](std::optional<MaterialValue> MaterialData::*member) -> std::optional<double> {
    if (!material || !((*material).*member) || ((*material).*member)->along) return std::nullopt;
    return ((*material).*member)->value;
  };
  const ThermalProperties found{
      value("expansion", keys.expansion, of(&MaterialData::thermal_expansion)),
      value("temperature", keys.temperature, material ? std::optional(material->temperature) : std::nullopt),
      value("heat_capacity", keys.heat_capacity, of(&MaterialData::heat_capacity)),
      value("conductivity", keys.conductivity, of(&MaterialData::conductivity))};
  if (missing.empty()) return found;
  fail(fiber, fmt::format("thermoelastic needs {}, which {}", fmt::join(missing, ", "),
                          material ? "the file of material '" + material->name + "' does not have"
                                   : std::string("no material gives: none is named")));
}

void check_source(const StrictMapping& fiber, const MaterialDampingKeys& keys,
                  const std::optional<MaterialData>& material) {
  if (!keys.from_material) return;
  if (!material) fail(fiber, "from-material is of use only with key 'material'");
  const MaterialDamping own = damping_of(*material);
  if (own.loss_factor || own.shear_loss_factor || own.thermoelastic) return;
  fail(fiber, fmt::format("the file of material '{}' has neither a loss factor nor the data of thermoelastic "
                          "damping; give loss_factor and band here",
                          material->name));
}

void check_complete(const StrictMapping& fiber, const MaterialDamping& damping, bool has_spectrum) {
  const bool flat = damping.loss_factor || damping.shear_loss_factor;
  if (flat && !damping.band) {
    fail(fiber,
         "band is missing, within which the loss factor is flat: the material has none; e.g. "
         "band: [10 Hz, 10 kHz]");
  }
  if (!flat && (damping.band || damping.branches))
    fail(fiber, "band and branches are of use only with a loss factor");
  if (!flat && !damping.thermoelastic && !has_spectrum)
    fail(fiber, "names no damping: give loss_factor, thermoelastic, spectrum or from_material");
}

}  // namespace

KeyTable<MaterialDampingKeys> material_damping_keys() {
  using K = MaterialDampingKeys;
  KeyTable<K> table;
  table.flag(
      "from_material", &K::from_material,
      "all damping that the file of `material` has: its loss factors and, where it has the data, "
      "thermoelasticity (alone where the loss factor is a total that may have it in it); what is given "
      "beside it counts in its place. The word `from-material` is short for this alone");
  table
      .number("loss_factor", &K::loss_factor, kLossFactor,
              "loss factor tan δ of Young's modulus, of stretch and bending, flat over `band`")
      .otherwise("none");
  table
      .number("shear_loss_factor", &K::shear_loss_factor, kLossFactor,
              "the same of the shear modulus, of shear and twist")
      .otherwise("`loss_factor`");
  table.interval("band", "Hz", &K::band, "frequencies over which the loss factors are flat")
      .otherwise("that of the loss factor of `material`, where it has one");
  table
      .integer("branches", &K::branches, {.low = 1, .high = most_flat_branches},
               "Maxwell branches of each flat loss factor")
      .otherwise("the fewest that keep it within ±1.5 %");
  table
      .quantity("modulus_frequency", "Hz", &K::modulus_frequency, kNonNegative,
                "frequency at which Young's and the shear modulus were measured: they are storage moduli "
                "there, and the relaxed ones, which equilibria and reduced loads go by, are lower")
      .otherwise("geometric middle of `band`; 0, relaxed, without one");
  table
      .mapping_or_word(
          "thermoelastic", "true", ThermoelasticKeys{}, thermoelastic_keys(),
          [](const StrictMapping&, const ThermoelasticKeys& keys, K& to) { to.thermoelastic = keys; },
          "damping of bending by heat that flows across the fiber (Zener); `true`: with the data of "
          "`material`")
      .otherwise("none");
  table.mapping_into("spectrum", &K::spectrum, spectrum_keys(), "Maxwell branches as given")
      .otherwise("none");
  return table;
}

MaterialDamping damping_of(const StrictMapping& fiber, const MaterialDampingKeys& keys,
                           const std::optional<MaterialData>& material) {
  check_source(fiber, keys, material);
  MaterialDamping damping = keys.from_material ? damping_of(*material) : MaterialDamping{};
  const bool has_spectrum = !keys.spectrum.youngs_modulus.empty() || !keys.spectrum.shear_modulus.empty() ||
                            !keys.spectrum.bending.empty();
  if (keys.loss_factor) damping.loss_factor = keys.loss_factor;
  if (keys.shear_loss_factor) damping.shear_loss_factor = keys.shear_loss_factor;
  if (keys.thermoelastic) {
    damping.thermoelastic = thermal_of(fiber, *keys.thermoelastic, material);
    damping.highest_frequency = keys.thermoelastic->highest_frequency;
  }
  const bool flat = damping.loss_factor || damping.shear_loss_factor;
  if (keys.band) damping.band = keys.band;
  if (flat && !damping.band && material && material->loss_factor) damping.band = material->loss_factor->band;
  damping.branches = keys.branches;
  damping.modulus_frequency = keys.modulus_frequency;
  damping.spectrum = keys.spectrum;
  check_complete(fiber, damping, has_spectrum);
  return damping;
}

}  // namespace fiberchain::dem
