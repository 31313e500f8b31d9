#include "compare/scenes/release_report.hpp"

#include <fmt/format.h>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "compare/measure/bond_spectra_of.hpp"
#include "compare/measure/first_mode_damping.hpp"
#include "compare/measure/first_mode_filter.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/scene/build_fiber.hpp"
#include "dem/vibration/choose.hpp"
#include "reference/chain_modes.hpp"

namespace fiberchain::compare {
namespace {

using dem::ReleaseScene;

reference::ChainMode first_mode(const ReleaseScene& scene) {
  reference::ChainMode mode = reference::first_bending_mode(linear_chain_of(scene.fiber));
  if (!mode.oscillates)
    throw InputError("bond.damping: the first mode is overdamped, there is no vibration to watch");
  if (!scene.fiber.branches.empty()) {
    const reference::FreeDecay decay = bending_modes_of(scene.fiber, 1).front().decay;
    mode.eigenvalue = decay.eigenvalue;
    mode.frequency = decay.frequency;
    mode.damping = decay.damping;
  }
  return mode;
}

/// The scene's options with the integrator and step that are chosen where it leaves them; why these.
template <int Dim>
std::pair<dem::ReleaseOptions, std::string> options_of(const ReleaseScene& scene,
                                                       const dem::Release<Dim>& release) {
  dem::ReleaseOptions options = scene.motion;
  if (options.integrator != dem::Integrator::automatic) return {options, ""};
  const dem::IntegratorChoice choice = dem::choose_integrator(release, options);
  options.integrator = choice.integrator;
  options.step_ratio = choice.step_ratio;
  return {options, choice.reason};
}

template <int Dim>
ReleasePlan plan_in(const ReleaseScene& scene) {
  const double period = 2 * std::numbers::pi / first_mode(scene).eigenvalue.imag();
  const dem::Release<Dim> release = dem::build_release<Dim>(scene, period);
  const auto [options, reason] = options_of(scene, release);
  const double step = dem::release_step(release, options), interval = period / options.samples_per_period;
  const double samples = std::ceil(scene.periods * options.samples_per_period);
  return {options.integrator, reason, step, samples * std::round(interval / step)};
}

/// Why a mean step [s] is not the one asked for, or the one planned where none was; empty where it is.
std::string step_note(const ReleaseScene& scene, dem::Integrator integrator, double planned, double period,
                      double taken) {
  const double t_b = dem::bond_time_step(scene.fiber), interval = period / scene.motion.samples_per_period;
  const bool chosen = scene.motion.integrator == dem::Integrator::automatic || !scene.motion.step_ratio;
  if (integrator == dem::Integrator::cvode) return "";
  const double asked = chosen ? planned : *scene.motion.step_ratio * t_b;
  if (!(taken < 0.99 * asked)) return "";
  std::string why;
  if (planned < 0.99 * asked) {
    why = fmt::format("a whole number of them makes a sample interval of {:.4g} t_b", interval / t_b);
  }
  if (taken < 0.99 * planned) {
    why += fmt::format("{}steps were halved where Newton's method did not converge", why.empty() ? "" : ", ");
  }
  return fmt::format("steps of {:.4g} t_b in the mean in place of {:.4g}: {}", taken / t_b, asked / t_b, why);
}

/// Frequency from one crossing of zero downward to the next, of which higher modes make none; by the filtered
/// motion where it is long enough [rad/s].
double frequency_of(const TipHistory& history, double of_mode) {
  const double seen = history.time.empty() ? 0 : history.time.back() * of_mode / (2 * std::numbers::pi);
  const TipHistory motion = seen > 2 * filter_reach + 3 ? first_mode_part(history, of_mode) : history;
  std::vector<double> crossings;
  for (std::size_t i = 1; i < motion.y.size(); ++i) {
    const double before = motion.y[i - 1], after = motion.y[i];
    if (!(before > 0 && after <= 0)) continue;
    crossings.push_back(std::lerp(motion.time[i - 1], motion.time[i], before / (before - after)));
  }
  if (crossings.size() < 2) return nan;
  return 2 * std::numbers::pi * static_cast<double>(crossings.size() - 1) /
         (crossings.back() - crossings.front());
}

/// @returns why there is no fiber_damping; empty where there is
std::string measure(ReleaseRun& run, const ReleaseScene& scene, const reference::ChainMode& mode,
                    const TipHistory& history) {
  const bool dashpots = mode.damping > 1e-12;  // rolling friction damps no mode of the linear chain
  if (!dashpots && scene.fiber.rolling_friction == 0) return "nothing damps the fiber";
  const reference::LinearChain chain = linear_chain_of(scene.fiber);
  const CleanPeaks by_friction = filtered_peaks(2),
                   wanted = dashpots ? clean_peaks(chain, mode) : by_friction,
                   clean = dashpots ? clean_peaks(chain, mode, scene.periods) : by_friction;
  if (wanted.way != CleanPeaks::Way::none &&
      (clean.way == CleanPeaks::Way::none || scene.periods < clean.periods()))
    return fmt::format("the first mode is seen alone in {:.1f} periods", wanted.periods());
  try {
    const Damping found = first_mode_damping(history, clean, mode.eigenvalue.imag()).peaks;
    run.damping = found.ratio;
    run.frequency = found.frequency;
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

template <int Dim>
ReleaseRun run_in(const ReleaseScene& scene) {
  const reference::ChainMode mode = first_mode(scene);
  ReleaseRun run{};
  run.period = 2 * std::numbers::pi / mode.eigenvalue.imag();
  run.damping_modes = mode.damping;
  run.damping = run.frequency = nan;
  const dem::Release<Dim> release = dem::build_release<Dim>(scene, run.period);
  const auto begin = std::chrono::steady_clock::now();
  auto [options, reason] = options_of(scene, release);
  options.energy = dem::has_energy(scene);
  const dem::ReleaseRecord<Dim> record = dem::ring_down<Dim>({release}, options)[0];
  run.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.integrator = record.integrator;
  run.reason = reason;
  run.work = record.work;
  run.time_step = record.time_step;
  run.step_note =
      step_note(scene, options.integrator, dem::release_step(release, options), run.period, record.time_step);
  run.failure = record.failure;
  const double L = dem::fiber_length(scene.fiber);
  TipHistory history;
  const double across = std::hypot(scene.pull.direction[1], scene.pull.direction[2]);
  const std::array<double, 2> along = {across > 0 ? scene.pull.direction[1] / across : 1,
                                       across > 0 ? scene.pull.direction[2] / across : 0};
  for (const dem::TipSample<Dim>& sample : record.samples) {
    run.time.push_back(sample.time);
    run.y.push_back(sample.position[1] / L);
    run.z.push_back(Dim == 3 ? sample.position[Dim - 1] / L : 0.0);
    run.energy.push_back(sample.energy);
    history.time.push_back(sample.time);
    history.y.push_back(along[0] * run.y.back() + along[1] * run.z.back());
    history.velocity.push_back(
        (along[0] * sample.velocity[1] + along[1] * (Dim == 3 ? sample.velocity[Dim - 1] : 0)) / L);
  }
  for (const dem::Pose<double, Dim>& pose : record.last.poses) {
    run.last.push_back(
        {pose.position[0] / L, pose.position[1] / L, Dim == 3 ? pose.position[Dim - 1] / L : 0.0});
  }
  if (run.failure.empty()) run.damping_note = measure(run, scene, mode, history);
  if (!run.damping_note.empty()) run.frequency = frequency_of(history, mode.eigenvalue.imag());
  return run;
}

std::string status_of(const ReleaseRun& run) {
  if (!run.failure.empty()) return run.failure;
  std::string status = run.reason.empty() ? "finished" : run.reason;
  if (!run.step_note.empty()) status += "; " + run.step_note;
  if (!run.damping_note.empty()) status += "; no fiber_damping: " + run.damping_note;
  return status;
}

}  // namespace

ReleaseRun run_release(const ReleaseScene& scene) {
  return scene.dimension == dem::Dimension::planar ? run_in<2>(scene) : run_in<3>(scene);
}

ReleasePlan plan_release(const ReleaseScene& scene) {
  return scene.dimension == dem::Dimension::planar ? plan_in<2>(scene) : plan_in<3>(scene);
}

dem::Table release_table(const ReleaseScene& scene, const ReleaseRun& run) {
  const bool marched = dem::is_leapfrog(run.integrator);
  const dem::BondForm form = marched ? scene.motion.form : dem::BondForm::total;
  return table_of(
      {{"aspect_ratio", std::llround(dem::slenderness(scene.fiber))},
       {"poisson_ratio", dem::known(dem::poisson_ratio(scene.fiber.material))},
       {"load", scene.pull.load},
       {"bond", std::string(name(scene.fiber.bond_model))},
       {"form", std::string(name(form))},
       {"dimension", std::string(name(scene.dimension))},
       {"mass", std::string(name(scene.fiber.mass))},
       {"bond_damping", scene.fiber.bond_damping},
       {"rolling_friction", scene.fiber.rolling_friction},
       {"integrator", std::string(name(run.integrator))},
       {"time_step", run.time_step},
       {"step_ratio_asked", scene.motion.step_ratio ? dem::Cell{*scene.motion.step_ratio} : dem::Cell{}},
       {"step_ratio", run.time_step / dem::bond_time_step(scene.fiber)},
       {"steps", static_cast<std::int64_t>(run.work.steps)},
       {"bond_evaluations", static_cast<std::int64_t>(run.work.bond_evaluations)},
       {"linear_solves", static_cast<std::int64_t>(run.work.linear_solves)},
       {"fiber_damping", dem::known(run.damping)},
       {"fiber_damping_modes", run.damping_modes},
       {"frequency", dem::known(run.frequency)},
       {"run_time", run.run_time},
       {"status", status_of(run)}});
}

dem::Table release_history_table(const ReleaseRun& run) {
  dem::Table table({"time", "tip_y", "tip_z", "energy"});
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    table.append({{"time", run.time[i] / run.period},
                  {"tip_y", run.y[i]},
                  {"tip_z", run.z[i]},
                  {"energy", run.energy[i]}});
  }
  return table;
}

dem::Table release_last_table(const ReleaseRun& run) {
  dem::Table table({"sphere", "position_x", "position_y", "position_z"});
  for (std::size_t i = 0; i < run.last.size(); ++i) {
    table.append({{"sphere", static_cast<std::int64_t>(i)},
                  {"position_x", run.last[i][0]},
                  {"position_y", run.last[i][1]},
                  {"position_z", run.last[i][2]}});
  }
  return table;
}

Figure release_figure(const ReleaseScene& scene, const ReleaseRun& run) {
  Series chain{"free end", {}, run.y, Mark::line};
  for (const double t : run.time) chain.x.push_back(t / run.period);
  return {fmt::format("Let go from {{/:Italic P L}}^2/{{/:Italic EI}} = {:g}: r_f = {}, ξ_b = {:g}, {}",
                      scene.pull.load, dem::slenderness(scene.fiber), scene.fiber.bond_damping,
                      name(run.integrator)),
          {"time over the first mode's period"},
          {"{/:Italic y}/{/:Italic L}"},
          {chain}};
}

}  // namespace fiberchain::compare
