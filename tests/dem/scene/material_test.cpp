// Materials as files and as keys of scenes: what they say arrives, what is wrong is refused with its place.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <thread>

#include "dem/material/flat_loss.hpp"
#include "dem/scene/read_material.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(material_test)

namespace dem = fiberchain::dem;
using boost::test_tools::tolerance;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::string kData = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/materials/";

dem::ReleaseScene release(const std::string& fiber, const std::string& more = "") {
  return std::get<dem::ReleaseScene>(
      dem::parse_scene({"s.yaml", "scene: release\nfiber: {diameter: 0.3 mm, aspect_ratio: 13, " + fiber +
                                      "}\nload: {reduced: 0.1}\n" + more}));
}

template <class Read>
std::string said(const Read& read) {
  try {
    read();
    return "";
  } catch (const dem::SceneError& error) {
    return error.what();
  }
}

const char* const kOwn = "youngs_modulus: 3 GPa, poisson_ratio: 0.17, density: 1100";
const char* const kSteel =
    "name: m\ndescription: d\ntemperature: {value: 290 K}\nyoungs_modulus: {value: 212 GPa, temperature: 290 "
    "K, source: a}\n";

struct Fault {
  std::string text, says;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.says; }

const std::string kValue = "{value: 0.1, temperature: 290 K, source: a";
const Fault kFileFaults[] = {
    {kSteel + std::string("stiffness: 3\n"), "m.yaml:5: unknown key 'stiffness'"},
    {kSteel + std::string("loss_factor: ") + kValue + ", bend: 3}\n",
     "m.yaml:5: unknown key 'loss_factor.bend'; did you mean 'band'?"},
    {kSteel + std::string("loss_factor: {value: -1, temperature: 290 K, source: a}\n"),
     "m.yaml:5: loss_factor.value: '-1' is out of range; allowed: a number at least 0 and at most 10"},
    {kSteel + std::string("loss_factor: ") + kValue + ", range: [0.2, 0.3]}\n",
     "m.yaml:5: loss_factor.range: does not hold the value, 0.1"},
    {kSteel + std::string("loss_factor: {value: 0.1, temperature: 290 K}\n"),
     "m.yaml:5: loss_factor: key 'source' is missing"},
    {kSteel + std::string("conductivity: {value: 3 W/m, temperature: 290 K, source: a}\n"),
     "m.yaml:5: conductivity.value: '3 W/m' has a unit of another dimension"},
    {kSteel + std::string("poisson_ratio: ") + kValue +
         "}\nshear_modulus: {value: 3 GPa, temperature: 290 K, source: a}\n",
     "must have exactly one of poisson_ratio, shear_modulus"},
    {std::string(kSteel).replace(6, 1, "n"), "m.yaml:1: name: 'n' is not the file's"},
};

const Fault kSceneFaults[] = {
    {"material: carbon-stel",
     "s.yaml:2: fiber.material: unknown material 'carbon-stel'; did you mean 'carbon-steel'?"},
    {"material: cotton", "s.yaml:2: fiber: needs poisson_ratio or shear_modulus: material 'cotton' has none"},
    {"material: wheat-straw", "s.yaml:2: fiber: key 'density' is missing: material 'wheat-straw' has none"},
    {"material: copper, transverse_modulus: 3 GPa",
     "fiber.transverse_modulus: is of use only with shear_modulus"},
    {std::string(kOwn) + ", material_damping: from-material",
     "s.yaml:2: fiber.material_damping: from-material is of use only with key 'material'"},
    {std::string(kOwn) + ", material_damping: {}", "fiber.material_damping: names no damping"},
    {std::string(kOwn) + ", material_damping: {loss_factor: 0.1}", "fiber.material_damping: band is missing"},
    {std::string(kOwn) +
         ", material_damping: {band: [1, 10], spectrum: {bending: [{strength: 0.1, time: 1}]}}",
     "band and branches are of use only with a loss factor"},
    {std::string(kOwn) + ", material_damping: {thermoelastic: true}",
     "thermoelastic needs expansion, temperature, heat_capacity, conductivity, which no material gives"},
    {std::string(kOwn) + ", material_damping: {loss_factor: 0.1, band: [10, 1]}",
     "fiber.material_damping.band: must rise"},
    {std::string(kOwn) + ", material_damping: {loss_factor: 0.1, bands: [10, 1]}",
     "unknown key 'fiber.material_damping.bands'; did you mean 'band'?"},
    {std::string(kOwn) + ", material_damping: true",
     "fiber.material_damping: must be a mapping with keys of from_material"},
    {"material: carbon-steel, material_damping: from-material", "fiber.material_damping: band is missing"},
    {"material: carbon-fiber, material_damping: from-material",
     "neither a loss factor nor the data of thermoelastic damping"},
    {"material: carbon-fiber, material_damping: {thermoelastic: true}",
     "thermoelastic needs conductivity, which the file of material 'carbon-fiber' does not have"},
};

const char* const kDamped = ", material_damping: {loss_factor: 0.03, band: [10 Hz, 10 kHz]}";

const Fault kNotTogether[] = {
    {"bond: {rolling_friction: 0.1}\n", "bond.rolling_friction: is not built together with material_damping"},
    {"time: {integrator: implicit}\n",
     "time: material_damping is built for integrator: leapfrog and leapfrog-stiff"},
    {"time: {integrator: cvode}\n", "time: material_damping is built for"},
    {"time: {integrator: leapfrog-damped}\n", "time: material_damping is built for"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_file_is_read_and_its_sources_are_named) {
  const std::string sources = text_of(kData + "sources.yaml");
  const auto names = dem::material_names();
  BOOST_TEST(names.size() >= 20u);
  for (const std::string& name : names) {
    const dem::MaterialData data = dem::find_material(name);
    BOOST_TEST(data.name == name);
    BOOST_REQUIRE(data.youngs_modulus.has_value());
    for (const auto* value : {&data.youngs_modulus, &data.poisson_ratio, &data.shear_modulus, &data.density,
                              &data.transverse_modulus, &data.loss_factor, &data.shear_loss_factor,
                              &data.thermal_expansion, &data.heat_capacity, &data.conductivity}) {
      if (*value) BOOST_TEST(("\n" + sources).find("\n" + (*value)->source + ":") != std::string::npos, name);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_file_says_what_it_says) {
  const dem::MaterialData bamboo = dem::find_material("bamboo");
  BOOST_TEST(bamboo.shear_loss_factor.value().value == 0.025);
  BOOST_TEST(bamboo.loss_factor->band.value().low == 20);
  BOOST_TEST(bamboo.loss_factor->band->high == 2e4, tolerance(1e-15));
  BOOST_TEST(bamboo.youngs_modulus->range.value()[1] == 32.49e9, tolerance(1e-15));
  const dem::MaterialData steel = dem::find_material(kData + "carbon-steel.yaml");
  const dem::ThermalProperties thermal = dem::thermal_properties(steel).value();
  BOOST_TEST(thermal.temperature == 290);
  // Delta = E alpha^2 T/(rho c), by hand
  BOOST_TEST(dem::relaxation_strength(thermal, 212e9, 7800) == 212e9 * 12e-6 * 12e-6 * 290 / (7800.0 * 486),
             tolerance(1e-12));
  BOOST_TEST(!dem::thermal_properties(dem::find_material("carbon-fiber")).has_value());
}

BOOST_AUTO_TEST_CASE(a_total_loss_factor_does_not_add_to_thermoelasticity) {
  const dem::MaterialDamping copper = dem::damping_of(dem::find_material("copper"));
  BOOST_TEST((copper.thermoelastic.has_value() && !copper.loss_factor.has_value()));
  const dem::MaterialDamping steel = dem::damping_of(dem::find_material("carbon-steel"));
  BOOST_TEST((steel.thermoelastic.has_value() && steel.loss_factor == 2e-4));
}

BOOST_DATA_TEST_CASE(a_wrong_file_is_refused, boost::unit_test::data::make(kFileFaults), fault) {
  const std::string error = said([&] { dem::parse_material({"m.yaml", fault.text}); });
  BOOST_TEST(error.find(fault.says) != std::string::npos, error);
}

BOOST_DATA_TEST_CASE(wrong_keys_are_refused, boost::unit_test::data::make(kSceneFaults), fault) {
  const std::string error = said([&] { release(fault.text); });
  BOOST_TEST(error.find(fault.says) != std::string::npos, error);
}

BOOST_DATA_TEST_CASE(what_is_not_built_is_refused, boost::unit_test::data::make(kNotTogether), fault) {
  const std::string error = said([&] { release(std::string(kOwn) + kDamped, fault.text); });
  BOOST_TEST(error.find(fault.says) != std::string::npos, error);
}

BOOST_AUTO_TEST_CASE(flows_and_packings_in_a_fluid_refuse_it) {
  const std::string fiber = std::string("diameter: 2 mm, aspect_ratio: 6, ") + kOwn + kDamped;
  const std::string flow = "scene: flow\nfiber: {" + fiber +
                           "}\nfluid: {viscosity: 10, flow: shear, rate: 2}\nstart: {direction: [0, 1, "
                           "0]}\nduration: 1\n";
  BOOST_TEST(said([&] {
               dem::parse_scene({"s.yaml", flow});
             }).find("fiber.material_damping: is not built for a fiber in a fluid") != std::string::npos);
  const std::string packing = "scene: packing\nfibers: [{" + fiber +
                              ", count: 2}]\nperiodic: {x: 30 mm, y: 30 mm}\nfilling: {region: {z: [1 mm, 30 "
                              "mm]}}\nfluid: {viscosity: 1e-3}\nsteps: 10\n";
  BOOST_TEST(said([&] {
               dem::parse_scene({"s.yaml", packing});
             }).find("fluid: is not built together with material_damping") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_material_alone_sets_moduli_and_density_and_damps_nothing) {
  const dem::Fiber fiber = release("material: spruce").fiber;
  BOOST_TEST(fiber.material.youngs_modulus == 9.7e9, tolerance(1e-15));
  BOOST_TEST(fiber.material.shear_modulus == 1.15e9, tolerance(1e-15));
  BOOST_TEST(fiber.material.density == 405);
  BOOST_TEST(fiber.branches.empty());
  const dem::Fiber own = release("material: spruce, youngs_modulus: 8 GPa, poisson_ratio: 0.25").fiber;
  BOOST_TEST(own.material.youngs_modulus == 8e9);
  BOOST_TEST(own.material.shear_modulus == 8e9 / 2.5, tolerance(1e-15));
  BOOST_TEST(own.material.density == 405);
}

BOOST_AUTO_TEST_CASE(E_is_the_storage_modulus_where_it_was_measured) {
  const dem::ReleaseScene scene =
      release(std::string(kOwn) +
              ", material_damping: {loss_factor: 0.1, shear_loss_factor: 0.2, band: [7 Hz, 7 "
              "kHz], modulus_frequency: 50 Hz}");
  const dem::Fiber& fiber = scene.fiber;
  const double omega = 2 * std::numbers::pi * 50;
  BOOST_TEST(fiber.material.youngs_modulus * dem::storage_modulus(fiber.branches.stretch, omega) == 3e9,
             tolerance(1e-12));
  BOOST_TEST(fiber.material.shear_modulus * dem::storage_modulus(fiber.branches.twist, omega) == 3e9 / 2.34,
             tolerance(1e-12));
  for (const double f : {7.0, 100.0, 7000.0}) {
    const double w = 2 * std::numbers::pi * f, ripple = scene.damping.ripple * (1 + 1e-6);
    BOOST_TEST(std::abs(dem::loss_factor(fiber.branches.bend, w) / 0.1 - 1) <= ripple);
    BOOST_TEST(std::abs(dem::loss_factor(fiber.branches.shear, w) / 0.2 - 1) <= ripple);
  }
  BOOST_TEST((scene.damping.ripple > 0.001 && scene.damping.ripple <= dem::good_ripple));
  BOOST_TEST(dem::contact_elasticity(fiber.material).youngs_modulus == 3e9);
  BOOST_TEST(dem::contact_elasticity(fiber.material).poisson_ratio == 0.17, tolerance(1e-12));
  const dem::Fiber middle = release(std::string(kOwn) + kDamped).fiber;
  BOOST_TEST(middle.material.youngs_modulus *
                     dem::storage_modulus(middle.branches.bend, 2 * std::numbers::pi * std::sqrt(1e5)) ==
                 3e9,
             tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(thermoelasticity_is_of_bending_and_peaks_where_it_should) {
  const dem::Fiber fiber =
      release("material: brass, material_damping: from-material", "bond: {model: corrected}\n").fiber;
  BOOST_TEST((fiber.branches.stretch.empty() && fiber.branches.twist.empty()));
  BOOST_TEST(fiber.material.youngs_modulus == 112e9);
  BOOST_TEST(fiber.branches.shear.size() == fiber.branches.bend.size());  // the corrected bond's
  const dem::MaterialData brass = dem::find_material("brass");
  const double R = 0.15e-3, D = brass.conductivity->value / (8530 * brass.heat_capacity->value);
  const double peak = 1.841184 * 1.841184 * D / (R * R);  // [rad/s]
  const double delta =
      112e9 * std::pow(brass.thermal_expansion->value, 2) * 293 / (8530 * brass.heat_capacity->value);
  // Zener: Delta/2 at the peak, within what the further modes add
  BOOST_TEST(dem::loss_factor(fiber.branches.bend, peak) == delta / 2, tolerance(0.02));
  BOOST_TEST(dem::loss_factor(fiber.branches.bend, peak) > dem::loss_factor(fiber.branches.bend, 1.3 * peak));
  BOOST_TEST(dem::loss_factor(fiber.branches.bend, peak) > dem::loss_factor(fiber.branches.bend, peak / 1.3));
}

BOOST_AUTO_TEST_CASE(a_spectrum_is_taken_as_given) {
  const dem::Fiber fiber =
      release(std::string(kOwn) +
              ", material_damping: {spectrum: {youngs_modulus: [{strength: 0.3, time: 2 ms}], shear_modulus: "
              "[{strength: 0.2, time: 5 us}], bending: [{strength: 0.1, time: 1}]}}")
          .fiber;
  BOOST_REQUIRE_EQUAL(fiber.branches.stretch.size(), 1u);
  BOOST_TEST(fiber.branches.stretch[0].time == 2e-3, tolerance(1e-15));
  BOOST_TEST(fiber.branches.twist.at(0).strength == 0.2);
  BOOST_TEST(fiber.branches.bend.size() == 2u);
  BOOST_TEST(fiber.material.youngs_modulus == 3e9);  // relaxed: no band says where else it was measured
}

BOOST_AUTO_TEST_CASE(scenes_are_read_by_many_threads_at_once) {
  std::vector<std::jthread> threads;
  std::vector<double> moduli(4);
  for (double& modulus : moduli) {
    threads.emplace_back([&modulus] {
      for (int i = 0; i < 5; ++i) modulus = release("material: copper").fiber.material.youngs_modulus;
    });
  }
  threads.clear();
  for (const double modulus : moduli) BOOST_TEST(modulus == 120e9);
}

BOOST_AUTO_TEST_SUITE_END()
