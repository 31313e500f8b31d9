#include "compare/scenes/release_report.hpp"

#include <fmt/format.h>
#include <chrono>
#include <cmath>
#include <numbers>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/peaks.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "dem/scene/build_fiber.hpp"
#include "dem/vibration/choose.hpp"
#include "reference/chain_modes.hpp"

namespace fiberchain::compare {
namespace {

using dem::ReleaseScene;

reference::ChainMode first_mode(const ReleaseScene& scene) {
  const reference::ChainMode mode = reference::first_bending_mode(linear_chain_of(scene.fiber));
  if (!mode.oscillates)
    throw InputError("bond.damping: the first mode is overdamped, there is no vibration to watch");
  return mode;
}

template <int Dim>
ReleasePlan plan_in(const ReleaseScene& scene) {
  const double period = 2 * std::numbers::pi / first_mode(scene).eigenvalue.imag();
  const dem::Release<Dim> release = dem::build_release<Dim>(scene, period);
  dem::ReleaseOptions options = scene.motion;
  std::string reason;
  if (options.integrator == dem::Integrator::automatic) {
    const dem::IntegratorChoice choice = dem::choose_integrator(release, options);
    options.integrator = choice.integrator;
    options.step_ratio = choice.step_ratio;
    reason = choice.reason;
  }
  const double step = dem::release_step(release, options), interval = period / options.samples_per_period;
  const double samples = std::ceil(scene.periods * options.samples_per_period);
  return {options.integrator, reason, step, samples * std::round(interval / step)};
}

/// Why a mean step [s] is not the one asked for, or the one planned where none was; empty where it is.
std::string step_note(const ReleaseScene& scene, const ReleasePlan& plan, double period, double taken) {
  const double t_b = dem::bond_time_step(scene.fiber), interval = period / scene.motion.samples_per_period;
  const bool chosen = scene.motion.integrator == dem::Integrator::automatic || !scene.motion.step_ratio;
  if (plan.integrator == dem::Integrator::cvode) return "";
  const double asked = chosen ? plan.time_step : *scene.motion.step_ratio * t_b;
  if (!(taken < 0.99 * asked)) return "";
  std::string why;
  if (plan.time_step < 0.99 * asked) {
    why = fmt::format("a whole number of them makes a sample interval of {:.4g} t_b", interval / t_b);
  }
  if (taken < 0.99 * plan.time_step) {
    why += fmt::format("{}steps were halved where Newton's method did not converge", why.empty() ? "" : ", ");
  }
  return fmt::format("steps of {:.4g} t_b in the mean in place of {:.4g}: {}", taken / t_b, asked / t_b, why);
}

/// Damping of all peaks after the release; the release itself is no free maximum.
void measure(ReleaseRun& run, const TipHistory& history) {
  const std::vector<Peak> peaks = positive_peaks(history);
  if (peaks.size() < 3) return;
  try {
    const Damping found = damping_from_peaks(peaks, {1, static_cast<int>(peaks.size()) - 1});
    run.damping = found.ratio;
    run.frequency = found.frequency;
  } catch (const InputError&) {  // peaks that grow
  }
}

template <int Dim>
ReleaseRun run_in(const ReleaseScene& scene) {
  const reference::ChainMode mode = first_mode(scene);
  ReleaseRun run{};
  run.period = 2 * std::numbers::pi / mode.eigenvalue.imag();
  run.damping_modes = mode.damping;
  run.damping = run.frequency = nan;
  const dem::Release<Dim> release = dem::build_release<Dim>(scene, run.period);
  dem::ReleaseOptions options = scene.motion;
  options.energy = dem::has_energy(scene);
  const auto begin = std::chrono::steady_clock::now();
  const dem::ReleaseRecord<Dim> record = dem::ring_down<Dim>({release}, options)[0];
  run.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.integrator = record.integrator;
  run.reason = record.reason;
  run.work = record.work;
  run.time_step = record.time_step;
  run.step_note = step_note(scene, plan_in<Dim>(scene), run.period, record.time_step);
  run.failure = record.failure;
  const double L = dem::fiber_length(scene.fiber);
  TipHistory history;
  const double sign = scene.pull.direction[1] > 0 ? 1 : -1;
  for (const dem::TipSample<Dim>& sample : record.samples) {
    run.time.push_back(sample.time);
    run.y.push_back(sample.position[1] / L);
    run.z.push_back(Dim == 3 ? sample.position[Dim - 1] / L : 0.0);
    run.energy.push_back(sample.energy);
    history.time.push_back(sample.time);
    history.y.push_back(sign * run.y.back());
    history.velocity.push_back(sign * sample.velocity[1] / L);
  }
  for (const dem::Pose<double, Dim>& pose : record.last.poses) {
    run.last.push_back(
        {pose.position[0] / L, pose.position[1] / L, Dim == 3 ? pose.position[Dim - 1] / L : 0.0});
  }
  measure(run, history);
  return run;
}

std::string status_of(const ReleaseRun& run) {
  if (!run.failure.empty()) return run.failure;
  const std::string status = run.reason.empty() ? "finished" : run.reason;
  return run.step_note.empty() ? status : status + "; " + run.step_note;
}

}  // namespace

ReleaseRun run_release(const ReleaseScene& scene) {
  return scene.dimension == dem::Dimension::planar ? run_in<2>(scene) : run_in<3>(scene);
}

ReleasePlan plan_release(const ReleaseScene& scene) {
  return scene.dimension == dem::Dimension::planar ? plan_in<2>(scene) : plan_in<3>(scene);
}

dem::Table release_table(const ReleaseScene& scene, const ReleaseRun& run) {
  dem::Table table({"aspect_ratio",
                    "poisson_ratio",
                    "load",
                    "bond",
                    "form",
                    "dimension",
                    "bond_damping",
                    "rolling_friction",
                    "integrator",
                    "time_step",
                    "step_ratio_asked",
                    "step_ratio",
                    "steps",
                    "bond_evaluations",
                    "linear_solves",
                    "fiber_damping",
                    "fiber_damping_modes",
                    "frequency",
                    "run_time",
                    "status"});
  const bool marched =
      run.integrator == dem::Integrator::leapfrog || run.integrator == dem::Integrator::leapfrog_damped;
  const dem::BondForm form = marched ? scene.motion.form : dem::BondForm::total;
  table.append(
      {{"aspect_ratio", scene.fiber.aspect_ratio},
       {"poisson_ratio", dem::poisson_ratio(scene.fiber.material)},
       {"load", scene.pull.load},
       {"bond", std::string(name(scene.fiber.bond_model))},
       {"form", std::string(name(form))},
       {"dimension", std::string(name(scene.dimension))},
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
  return table;
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
  return {fmt::format(
              "Let go from {{/:Italic P L}}^2/{{/:Italic EI}} = {:g}: r_f = {}, {{/Symbol x}}_b = {:g}, {}",
              scene.pull.load, scene.fiber.aspect_ratio, scene.fiber.bond_damping, name(run.integrator)),
          {"time over the first mode's period"},
          {"{/:Italic y}/{/:Italic L}"},
          {chain}};
}

}  // namespace fiberchain::compare
