// `calibrate --material` for every material, and what it tells the users of other codes.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(calibrate_material_test)

using namespace fiberchain::test;
using boost::test_tools::tolerance;
using nlohmann::json;
using Words = std::vector<std::string>;

namespace {

json answer(Words more) {
  Words words = {"calibrate", "--json", "--diameter", "0.3 mm", "--aspect-ratio", "13"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = run(words);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  return json::parse(outcome.out);
}

/// The numbers behind "bond_coeff 1" of a code.
std::vector<double> bond_coeff(const json& all, const std::string& code) {
  std::vector<double> numbers;
  for (const json& row : all["codes"]) {
    const std::string line = row["line"];
    if (row["code"] != code || !line.starts_with("bond_coeff 1 ")) continue;
    std::istringstream words(line.substr(13));
    for (double number = 0; words >> number;) numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_material_has_an_answer) {
  const json materials = json::parse(run({"materials", "--json"}).out)["rows"];
  BOOST_TEST(materials.size() >= 20u);
  for (const json& material : materials) {
    const std::string name = material["material"];
    Words more = {"--material", name};
    if (material["poisson_ratio"].is_null() && material["shear_modulus"].is_null())
      more.insert(more.end(), {"--poisson-ratio", "0.17"});
    if (material["density"].is_null()) more.insert(more.end(), {"--density", "300"});
    const json all = answer(more);
    const json& row = all["rows"][0];
    const double E = material["youngs_modulus"], R = 0.15e-3;
    BOOST_TEST(row["stiffness_stretch"].get<double>() == std::numbers::pi * R * E / 2, tolerance(1e-12));
    BOOST_TEST(row["time_step"].get<double>() > 0);
    const bool damped =
        !material["material_loss_factor"].is_null() || !material["relaxation_strength"].is_null();
    BOOST_TEST(all["modes"].size() == (damped ? 5u : 0u), name);
    BOOST_TEST((damped || row["bond_damping"].is_null()), name);
    for (const json& mode : all["modes"]) BOOST_TEST(mode["mode_damping"].get<double>() > 0);
    if (!damped) continue;
    // weakly damped: zeta is half of bending's loss factor, but for the fit and the bonds' shear, which
    // higher modes have more of (a half of zeta in wood)
    const json& first = all["modes"][0];
    const double parts = first["flat_part"].get<double>() + first["thermoelastic_part"].get<double>();
    BOOST_TEST(first["mode_damping"].get<double>() == parts, tolerance(0.06));
  }
}

BOOST_AUTO_TEST_CASE(a_flat_loss_factor_damps_all_modes_alike_and_dashpots_only_one) {
  const json all = answer({"--youngs-modulus", "3 GPa", "--density", "1100", "--poisson-ratio", "0.17",
                           "--loss-factor", "0.02", "--band", "1 Hz,1 MHz", "--mass", "cylinder"});
  for (const json& mode : all["modes"]) {
    BOOST_TEST(mode["mode_damping"].get<double>() == 0.01, tolerance(0.02));
    BOOST_TEST(std::abs(mode["mode_ripple"].get<double>()) <= 0.015);
    BOOST_TEST(mode["mechanism"] == "loss factor");
  }
  const double first = all["modes"][0]["mode_damping_dashpots"],
               second = all["modes"][1]["mode_damping_dashpots"];
  BOOST_TEST(first == all["modes"][0]["mode_damping"].get<double>(), tolerance(1e-4));
  BOOST_TEST((second > 4 * first && second < 8 * first));
}

BOOST_AUTO_TEST_CASE(lines_for_other_codes_are_the_bonds_own_numbers) {
  const json all = answer({"--material", "nickel", "--damping-ratio", "0.01"});
  const double E = 200e9, nu = 0.31, G = E / (2 * (1 + nu)), rho = 8902, R = 0.15e-3, pi = std::numbers::pi;
  const double m = 4.0 / 3 * pi * R * R * R * rho, J = 0.4 * m * R * R, xi = all["rows"][0]["bond_damping"];
  const double kn = pi * R * E / 2, kt = pi * R * G / 2, twist = pi * R * R * R * G / 4,
               bend = pi * R * R * R * E / 8;
  const auto dashpot = [xi](double inertia, double k) { return xi * std::sqrt(2 * inertia * k); };
  const std::vector<double> lammps = bond_coeff(all, "LAMMPS");
  BOOST_REQUIRE_EQUAL(lammps.size(), 12u);
  const double expected[] = {kn, kt, twist, bend};
  for (int i = 0; i < 4; ++i) BOOST_TEST(lammps[static_cast<std::size_t>(i)] == expected[i], tolerance(1e-8));
  BOOST_TEST(lammps[8] == dashpot(m, kn), tolerance(1e-8));
  BOOST_TEST(lammps[9] == dashpot(m, kt), tolerance(1e-8));
  BOOST_TEST(0.5 * lammps[10] * 2 * R == dashpot(J, bend), tolerance(1e-8));  // its torque is 0.5 groll r w
  BOOST_TEST(0.5 * lammps[11] == dashpot(J, twist), tolerance(1e-8));         // and 0.5 gtwist w
  const std::vector<double> liggghts = bond_coeff(all, "LIGGGHTS");
  BOOST_REQUIRE_EQUAL(liggghts.size(), 9u);
  BOOST_TEST(liggghts[2] == E);
  BOOST_TEST(liggghts[3] == G, tolerance(1e-8));
  BOOST_TEST(liggghts[5] == xi, tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(nothing_is_assumed_of_a_material_that_is_not_named) {
  const std::map<std::string, Words> faults = {
      {"--diameter missing", {"--material", "copper", "--aspect-ratio", "9"}},
      {"did you mean 'copper'?", {"--material", "coper", "--aspect-ratio", "9", "--diameter", "1 mm"}},
      {"has no density: give --density",
       {"--material", "wheat-straw", "--aspect-ratio", "9", "--diameter", "1 mm"}},
      {"--youngs-modulus, --density, --diameter missing",
       {"--loss-factor", "0.02", "--band", "1,1000", "--aspect-ratio", "9"}},
      {"--band: is of use only with a material's own damping",
       {"--damping-ratio", "0.02", "--band", "1,1000", "--aspect-ratio", "9"}}};
  for (const auto& [says, more] : faults) {
    Words words = {"calibrate"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.error.find(says) != std::string::npos, outcome.error);
  }
  const json ratios =
      json::parse(run({"calibrate", "--json", "--damping-ratio", "0.02", "--aspect-ratio", "9"}).out);
  for (const char* column : {"youngs_modulus", "density", "diameter", "stable_time_step"})
    BOOST_TEST(ratios["rows"][0][column].is_null());
  BOOST_TEST(!ratios.contains("codes"));
}

BOOST_AUTO_TEST_SUITE_END()
