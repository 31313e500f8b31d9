// Packings: stages and parts of made-up histories, spreads, verdicts, and a small packing that really runs.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/packing/checks.hpp"
#include "compare/packing/softening.hpp"
#include "compare/packing/study.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/published.hpp"
#include "dem/scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(packing_study_test)

namespace compare = fiberchain::compare;
namespace dem = fiberchain::dem;
using compare::PackingRun;
using compare::PackingStage;

namespace {

/// A parabola's fall to the height `lowest` at t = 0.3 s, back to `highest` at 0.5 s, then to 0.05 m at rest.
double height_at(double t, double lowest, double highest) {
  if (t <= 0.3) return lowest + 2 * (0.3 - t) * (0.3 - t) * (1 + t);
  if (t <= 0.5) return lowest + (highest - lowest) * std::pow(std::sin(std::acos(0.0) * (t - 0.3) / 0.2), 2);
  return highest + (0.05 - highest) * (1 - std::exp(-20 * (t - 0.5) * (t - 0.5)));
}

/// Bending with a peak at 0.3 s, a trough at 0.5 s and a plateau.
double bending_at(double t, double peak, double trough, double plateau) {
  if (t <= 0.3) return peak * t / 0.3;
  if (t <= 0.5) return peak + (trough - peak) * (t - 0.3) / 0.2;
  return t < 0.6 ? trough + (plateau - trough) * (t - 0.5) / 0.1 : plateau;
}

PackingRun made_up(compare::PackingCase asked, double peak, double trough, double plateau,
                   double highest = 0.07) {
  PackingRun run{};
  run.asked = asked, run.status = "finished";
  const double dt = 0.01;
  for (int i = 0; i <= 100; ++i) {
    const double t = i * dt;
    compare::PackingSample s{};
    s.time = t, s.bending_angle = bending_at(t, peak, trough, plateau),
    s.mean_height = height_at(t, 0.04, highest);
    s.vertical_speed = (height_at(t + 1e-6, 0.04, highest) - height_at(t - 1e-6, 0.04, highest)) / 2e-6;
    s.solid_fraction = 0.2;
    run.history.push_back(s);
  }
  return run;
}

const compare::ValidationInput& input() {
  static const compare::ValidationInput in{
      compare::read_all_published(std::string(FIBERCHAIN_SOURCE_DIR) + "/data"), 2};
  return in;
}

/// Three seeds each of least damping, most damping, friction and half the step, one of stiff fibers; plateaus
/// as given, 2 % apart between seeds.
std::vector<PackingRun> made_up_runs(double damped_plateau, double friction_plateau, double stiff_highest) {
  std::vector<PackingRun> runs;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const double f = 1 + 0.02 * (static_cast<double>(seed) - 2);
    compare::PackingCase c{.bond_damping = 0.1, .seed = seed};
    runs.push_back(made_up(c, 0.03 * f, 0.007 * f, 0.01 * f));
    c.step_ratio = 0.5;
    runs.push_back(made_up(c, 0.03 * f, 0.007 * f, 0.0101 * f));
    c.step_ratio = 1, c.rolling_friction = 1;
    runs.push_back(made_up(c, 0.03 * f, 0.007 * f, friction_plateau * f));
    c.rolling_friction = 0, c.bond_damping = 4;
    runs.push_back(made_up(c, 0.025 * f, 0.007 * f, damped_plateau * f));
  }
  runs.push_back(made_up({.bond_damping = 0.1, .stiffness = 50}, 0.001, 0.0001, 0.0002, stiff_highest));
  return runs;
}

compare::Verdict verdict_of(const std::vector<compare::ValidationRow>& rows, std::string_view id) {
  const auto row = std::ranges::find(rows, id, &compare::ValidationRow::id);
  BOOST_REQUIRE((row != rows.end()));
  return row->verdict;
}

}  // namespace

BOOST_AUTO_TEST_CASE(stages_are_found_where_the_history_has_them) {
  const PackingRun run = made_up({}, 0.03, 0.007, 0.01);
  const auto time = [&](PackingStage stage) {
    return run.history[find_stage(run.history, stage).value()].time;
  };
  const auto fastest = std::ranges::min_element(run.history, {}, &compare::PackingSample::vertical_speed);
  BOOST_TEST(time(PackingStage::reaching) == fastest->time);
  BOOST_TEST(std::abs(time(PackingStage::densest) - 0.3) < 0.011);
  BOOST_TEST(std::abs(time(PackingStage::expanded) - 0.5) < 0.011);
  BOOST_TEST(time(PackingStage::at_rest) == 1.0);
}

BOOST_AUTO_TEST_CASE(a_stage_that_does_not_come_is_left_out) {
  PackingRun falling = made_up({}, 0.03, 0.007, 0.01);
  falling.history.resize(25);  // still falls
  BOOST_TEST(find_stage(falling.history, PackingStage::reaching).has_value());
  BOOST_TEST(!find_stage(falling.history, PackingStage::densest).has_value());
  BOOST_TEST(!find_stage(falling.history, PackingStage::expanded).has_value());
  for (auto& sample : falling.history) sample.vertical_speed = 0.1;
  BOOST_TEST(!find_stage(falling.history, PackingStage::reaching).has_value());
  BOOST_TEST(!compare::find_stage({}, PackingStage::at_rest).has_value());
}

BOOST_AUTO_TEST_CASE(parts_of_bending_are_peak_trough_and_plateau) {
  PackingRun run = made_up({}, 0.031, 0.0072, 0.0104);
  for (auto& s : run.history) {
    if (s.time > 0.81) s.bending_angle += 0.0002 * std::cos(100 * std::acos(-1.0) * s.time);
  }
  const compare::BendingParts p = compare::bending_parts(run.history);
  BOOST_TEST(p.peak == 0.031);
  BOOST_TEST(std::abs(p.peak_time - 0.3) < 0.005);
  BOOST_TEST(std::abs(p.trough - 0.0072) < 1e-12);
  BOOST_TEST(std::abs(p.trough_time - 0.5) < 0.005);
  BOOST_TEST(std::abs(p.plateau - 0.0104) < 2e-5);
  BOOST_TEST(std::abs(p.unrest - 0.0002 / 0.0104) < 1e-3);
  run.history.resize(9);
  BOOST_CHECK_THROW(compare::bending_parts(run.history), compare::InputError);
}

BOOST_AUTO_TEST_CASE(a_spread_is_that_of_its_values) {
  const std::vector<double> values{3, 7, 5};
  const compare::Spread s = compare::spread_of(values);
  BOOST_TEST(s.count == 3u);
  BOOST_TEST(s.mean == 5);
  BOOST_TEST(std::abs(s.deviation - 2) < 1e-12);
  BOOST_TEST(s.least == 3);
  BOOST_TEST(s.most == 7);
  BOOST_TEST(std::abs(compare::half_width(s) - 4.302653 * 2 / std::sqrt(3.0)) <
             1e-5);  // t of 2 degrees of freedom
  const std::vector<double> single{4};
  BOOST_TEST(std::isnan(compare::half_width(compare::spread_of(single))));
  BOOST_CHECK_THROW(compare::spread_of({}), compare::InputError);
}

BOOST_AUTO_TEST_CASE(runs_are_compared_seed_by_seed) {
  const std::vector<PackingRun> runs = made_up_runs(0.008, 0.01, 0.07);
  const auto groups = compare::seed_groups(runs);
  BOOST_TEST(groups.size() == 5u);
  BOOST_TEST(groups[0].runs.size() == 3u);
  const compare::Spread d = compare::paired_difference(groups[3], groups[0], &compare::BendingParts::plateau);
  BOOST_TEST(std::abs(d.mean + 0.002) < 1e-12);
  BOOST_TEST(std::abs(d.deviation - 0.02 * 0.002) < 1e-9);
}

BOOST_AUTO_TEST_CASE(softened_contacts_are_tabled_by_their_modulus_over_the_seeds) {
  const auto cases =
      compare::softening_cases({.moduli = {1, 0.03}, .stiffness = 7, .fibers = 1200, .seeds = 2});
  BOOST_REQUIRE(cases.size() == 4u);
  const dem::PackingScene own = packing_scene(cases[1]), soft = packing_scene(cases[2]);
  BOOST_TEST(!own.domain.contacts.youngs_modulus.has_value());
  BOOST_TEST(*soft.domain.contacts.youngs_modulus == 0.03 * 7 * 2.6e6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(soft.kinds[0].fiber.material.youngs_modulus == 7 * 2.6e6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(soft.domain.wall_youngs_modulus == own.domain.wall_youngs_modulus);
  BOOST_TEST((cases[2].seed == 1 && cases[3].seed == 2));
  BOOST_TEST(cases[0].side == 0.12);  // four times as many as on 0.06
  std::vector<PackingRun> runs;
  for (const auto& asked : cases) {
    runs.push_back(made_up(asked, 0.03, 0.007, 0.01));
    const double odd = asked.seed == 2 ? 1 : 0;
    runs.back().history.back().solid_fraction = 0.2 + 0.02 * odd;
    runs.back().end.overlap_peak = asked.contact_modulus == 1 ? 0.04 : 0.3 + odd;
  }
  runs[1].status = "blew up";
  const dem::Table table = compare::softening_table(runs);
  BOOST_REQUIRE(table.rows().size() == 2u);
  BOOST_TEST(table.number(0, "seeds") == 1);
  BOOST_TEST(table.number(0, "solid_fraction") == 0.2);
  BOOST_TEST(table.number(1, "contact_modulus") == 0.03);
  BOOST_TEST(table.number(1, "solid_fraction") == 0.21, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(table.number(1, "solid_fraction_deviation") == 0.02 / std::sqrt(2.0),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(table.number(1, "bending_plateau") == 0.01, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(table.number(1, "overlap_peak") == 1.3);
  const compare::Figure figure = compare::softening_figure(runs);
  BOOST_REQUIRE(figure.series.size() == 6u);  // means and seeds of three quantities
  BOOST_TEST(figure.series[0].y[1] == 1.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(figure.series[1].x.size() == 3u);
}

BOOST_AUTO_TEST_CASE(verdicts_follow_the_runs) {
  using enum compare::Verdict;
  const auto lower = compare::packing_statements(input(), made_up_runs(0.008, 0.0085, 0.045));
  for (const char* id : {"paper-fig12-fall", "paper-fig12-rise", "paper-fig12-plateau", "paper-fig12-damping",
                         "paper-fig11-expansion", "paper-fig11-rods", "packing-half-step"}) {
    BOOST_TEST((verdict_of(lower, id) == holds), id);
  }
  BOOST_TEST((verdict_of(lower, "paper-fig12-damping-peak") == holds_only_if));
  BOOST_TEST((verdict_of(lower, "paper-fig12-friction") == holds_only_if));
  BOOST_TEST((verdict_of(lower, "paper-fig12-friction-peak") == disputed));  // it changes nothing there
  const auto alike = compare::packing_statements(input(), made_up_runs(0.01, 0.007, 0.07));
  BOOST_TEST((verdict_of(alike, "paper-fig12-damping") == disputed));
  BOOST_TEST((verdict_of(alike, "paper-fig12-damping-peak") == holds_only_if));
  BOOST_TEST((verdict_of(alike, "paper-fig12-friction") == disputed));
  BOOST_TEST((verdict_of(alike, "paper-fig11-rods") == disputed));
}

BOOST_AUTO_TEST_CASE(a_history_without_a_trough_or_a_step_that_matters_is_noticed) {
  std::vector<PackingRun> runs = made_up_runs(0.008, 0.01, 0.05);
  for (PackingRun& run : runs) {
    for (auto& s : run.history) s.bending_angle = 0.01 * s.time;  // its largest is its last
  }
  const auto rows = compare::packing_statements(input(), runs);
  BOOST_TEST((verdict_of(rows, "paper-fig12-fall") == compare::Verdict::disputed));
  BOOST_TEST((verdict_of(rows, "paper-fig12-rise") == compare::Verdict::disputed));
  std::vector<PackingRun> coarse = made_up_runs(0.008, 0.01, 0.05);
  for (PackingRun& run : coarse) {
    if (run.asked.step_ratio == 0.5) {
      for (auto& s : run.history) s.bending_angle *= 1.1;
    }
  }
  BOOST_TEST((verdict_of(compare::packing_statements(input(), coarse), "packing-half-step") ==
              compare::Verdict::fails));
}

BOOST_AUTO_TEST_CASE(the_scene_file_holds_the_packing_of_fig_11) {
  const auto scene = std::get<dem::PackingScene>(dem::parse_scene(
      dem::read_scene_text(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/packing.yaml")));
  const auto own = compare::packing_scene(compare::figure_cases({}).front());
  const dem::Fiber &a = scene.kinds.at(0).fiber, &b = own.kinds.at(0).fiber;
  BOOST_TEST(scene.kinds.size() == 1u);
  BOOST_TEST(scene.kinds[0].count == own.kinds[0].count);
  BOOST_TEST(std::abs(a.material.youngs_modulus / b.material.youngs_modulus - 1) < 1e-12);
  BOOST_TEST(std::abs(a.material.shear_modulus / b.material.shear_modulus - 1) < 1e-12);
  BOOST_TEST(std::abs(a.material.density - b.material.density) < 1e-9);
  BOOST_TEST(std::abs(a.diameter - b.diameter) < 1e-15);
  BOOST_TEST(a.aspect_ratio == b.aspect_ratio);
  BOOST_TEST(a.bond_damping == b.bond_damping);
  BOOST_TEST(a.rolling_friction == b.rolling_friction);
  for (int c = 0; c < 3; ++c) {
    BOOST_TEST(std::abs(scene.filling.region.low[c] - own.filling.region.low[c]) < 1e-9);
    BOOST_TEST(std::abs(scene.filling.region.high[c] - own.filling.region.high[c]) < 1e-9);
    BOOST_TEST(scene.filling.velocity[c] == own.filling.velocity[c]);
    BOOST_TEST(scene.domain.gravity[c] == own.domain.gravity[c]);
  }
  BOOST_TEST(std::abs(scene.filling.gap - own.filling.gap) < 1e-12);
  BOOST_TEST(scene.filling.seed == own.filling.seed);
  BOOST_TEST(scene.domain.walls.size() == own.domain.walls.size());
  BOOST_TEST(std::abs(scene.domain.wall_youngs_modulus / own.domain.wall_youngs_modulus - 1) < 1e-12);
  BOOST_TEST(scene.domain.contacts.restitution == own.domain.contacts.restitution);
  BOOST_TEST(scene.domain.contacts.friction == own.domain.contacts.friction);
  BOOST_TEST(std::abs(scene.duration - own.duration) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_small_packing_goes_as_the_paper_says_and_keeps_its_energy) {
  const compare::PackingCase asked{.bond_damping = 0.1,
                                   .fibers = 60,
                                   .side = 0.05,
                                   .seed = 5,
                                   .duration = 0.25,
                                   .accounted = true,
                                   .pictured = true};
  const PackingRun run = compare::run_packing(asked, {.samples = 50});
  BOOST_TEST_REQUIRE(run.status == "finished");
  BOOST_TEST(run.history.size() == 51u);
  BOOST_TEST(run.spheres == 60 * 21);
  const compare::BendingParts parts = compare::bending_parts(run.history);
  BOOST_TEST(parts.peak_time > 0.01);
  BOOST_TEST(parts.peak_time < parts.trough_time);
  BOOST_TEST(parts.plateau < 0.7 * parts.peak);
  BOOST_TEST(parts.plateau > 0.1 * parts.peak);
  for (const PackingStage stage : compare::kPackingStages)
    BOOST_TEST(find_stage(run.history, stage).has_value());
  // an error of the step, which falls with it: 2.6e-4 to 3.7e-4 over 8 seeds, 0.8e-4 to 1.2e-4 at half of it
  BOOST_TEST(compare::energy_drift(run) < 4e-4);
  BOOST_TEST(compare::energy_drift(run) > 2e-4);

  const double volume = 60 * 21 * 4.0 / 3 * std::acos(-1.0) * 1e-9;
  double packed = 0;
  for (std::size_t k = 0; k < run.end.solid_fractions.size(); ++k) {
    packed += run.end.solid_fractions[k] * 0.05 * 0.05 * (run.end.edges[k + 1] - run.end.edges[k]);
  }
  BOOST_TEST(std::abs(packed / volume - 1) < 0.01);  // but for what is pressed into the floor
  BOOST_TEST(run.end.orientation.order_along_up < -0.05);
  BOOST_TEST(std::abs(run.start.order_along_up) < 0.2);
  BOOST_TEST(run.pictures.size() == 51u);
  const dem::TrajectoryFrame frame = frame_of(run.pictures.back(), asked);
  BOOST_TEST(frame.position.size() == 60u * 21);
  BOOST_TEST(frame.bonds.size() == 60u * 20);
  double sum = 0;
  for (const auto& x : frame.position) sum += x[2];
  BOOST_TEST(std::abs(sum / (60 * 21) - run.history.back().mean_height) < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
