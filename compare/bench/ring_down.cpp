#include "compare/bench/ring_down.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "dem/motion/kernels/chain_kernel.hpp"

namespace fiberchain::compare {
namespace {

using dem::BondForm;
using dem::Integrator;

/// A chain's bonds times its steps a period beyond which the settings are few: dt ~ t_b, period ~ r_f^2.
constexpr int long_chain = 60;

int lanes() { return dem::chain_kernel(dem::built_physics[0], dem::best_instruction_set()).width; }

/// Largest stable dt / t_b.
double limit_of(const dem::Fiber& fiber, Integrator integrator) {
  return dem::stable_release_step(fiber, integrator) / dem::bond_time_step(fiber);
}

struct StepParts {
  std::vector<double> parts;
  int samples_per_period;
};

void add_explicit(std::vector<RingDownSetting>& all, const dem::Fiber& fiber, Integrator integrator,
                  BondForm form, const StepParts& steps, int side_by_side) {
  std::string method(dem::name(integrator));
  if (form == BondForm::total) method += ", total form";
  if (side_by_side > 1) method += fmt::format(", {} in lanes", side_by_side);
  for (const double part : steps.parts) {
    dem::ReleaseOptions options;
    options.form = form;
    options.integrator = integrator;
    options.step_ratio = part * limit_of(fiber, integrator);
    options.samples_per_period = steps.samples_per_period;
    all.push_back({method, fmt::format("dt = {:.3g} t_b", *options.step_ratio),
                   integrator == Integrator::leapfrog && form == BondForm::incremental && side_by_side == 1,
                   options, side_by_side});
  }
}

/// By steps a period, each a whole number of times in a sample.
void add_stiff(std::vector<RingDownSetting>& all, const dem::Release<2>& release,
               const std::vector<int>& steps_a_period, int side_by_side) {
  std::string method(dem::name(Integrator::leapfrog_stiff));
  if (side_by_side > 1) method += fmt::format(", {} in lanes", side_by_side);
  const double t_b = dem::bond_time_step(release.chain.fiber);
  for (const int steps : steps_a_period) {
    dem::ReleaseOptions options;
    options.integrator = Integrator::leapfrog_stiff;
    options.step_ratio = release.period / (steps * t_b) * (1 + 1e-9);  // a sample's length rounds
    options.samples_per_period = steps % 30 == 0 ? 30 : 50;
    all.push_back({method, fmt::format("dt = T/{}", steps), false, options, side_by_side});
  }
}

PrecisionRow asked_row(const RingDownSetting& setting, const dem::Release<2>& release) {
  return {.method = setting.method,
          .setting = setting.text,
          .aspect_ratio = release.chain.fiber.aspect_ratio,
          .lanes = setting.side_by_side,
          .as_paper = setting.as_paper};
}

PrecisionRow measured(const RingDownSetting& setting, const dem::Release<2>& release,
                      const TimingBudget& budget,
                      const std::function<double(const dem::ReleaseRecord<2>&)>& error) {
  const std::vector<dem::Release<2>> all(static_cast<std::size_t>(setting.side_by_side), release);
  Integrator used = setting.options.integrator;
  PrecisionRow row = measured_row(
      asked_row(setting, release), budget, [&] { return dem::ring_down<2>(all, setting.options); },
      [&](const std::vector<dem::ReleaseRecord<2>>& records) -> Judged {
        const dem::ReleaseRecord<2>& record = records.front();
        if (!record.failure.empty()) throw std::runtime_error(record.failure);
        used = record.integrator;
        return {error(record), record.work};
      });
  if (used != setting.options.integrator) row.setting += fmt::format(" ({})", dem::name(used));
  row.time.least /= setting.side_by_side;
  row.time.median /= setting.side_by_side;
  return row;
}

}  // namespace

std::vector<RingDownSetting> ring_down_settings(const dem::Release<2>& release, bool quick, bool total_too) {
  const dem::Fiber& fiber = release.chain.fiber;
  const bool is_long = fiber.aspect_ratio > long_chain;
  const StepParts steps{quick || is_long ? std::vector{0.95, 0.5} : std::vector{0.95, 0.5, 0.25, 0.125}, 50};
  const StepParts finer{
      quick || is_long ? std::vector{0.95, 0.5} : std::vector{0.95, 0.5, 0.25, 0.125, 0.0625}, 50};
  std::vector<RingDownSetting> all;
  add_explicit(all, fiber, Integrator::leapfrog, BondForm::incremental, steps, 1);
  if (total_too) add_explicit(all, fiber, Integrator::leapfrog, BondForm::total, steps, 1);
  if (!is_long) add_explicit(all, fiber, Integrator::leapfrog, BondForm::incremental, steps, lanes());
  add_explicit(all, fiber, Integrator::leapfrog_damped, BondForm::incremental, finer, 1);
  if (total_too) {
    add_explicit(all, fiber, Integrator::leapfrog_damped, BondForm::total, finer, 1);
  } else if (!is_long) {
    add_explicit(all, fiber, Integrator::leapfrog_damped, BondForm::incremental, finer, lanes());
  }
  const auto stiff_steps = quick ? std::vector{30, 90} : std::vector{30, 90, 270, 810};
  add_stiff(all, release, stiff_steps, 1);
  if (!is_long) add_stiff(all, release, stiff_steps, lanes());
  for (const int steps_a_period : quick ? std::vector{30, 90} : std::vector{10, 30, 90, 270, 810}) {
    dem::ReleaseOptions options;
    options.form = BondForm::total;
    options.integrator = Integrator::implicit;
    options.samples_per_period = steps_a_period;
    all.push_back({"implicit", fmt::format("dt = T/{}", steps_a_period), false, options});
  }
  for (const double tolerance :
       quick ? std::vector{1e-3, 1e-5, 1e-8} : std::vector{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    dem::ReleaseOptions options;
    options.form = BondForm::total;
    options.integrator = Integrator::cvode;
    options.tolerance = tolerance;
    options.samples_per_period = 50;
    all.push_back({"cvode", fmt::format("tolerance {:.0e}", tolerance), false, options});
  }
  for (const double error : quick ? std::vector{1e-3} : std::vector{1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    dem::ReleaseOptions options;
    options.integrator = Integrator::automatic;
    options.error = error;
    options.samples_per_period = 50;
    all.push_back({"auto", fmt::format("error {:.0e}", error), false, options});
  }
  return all;
}

std::vector<RingDownSetting> leapfrog_settings(const dem::Release<2>& release, bool quick) {
  const StepParts parts{quick ? std::vector{0.95} : std::vector{0.95, 0.5}, 50};
  std::vector<RingDownSetting> all;
  for (const Integrator integrator : {Integrator::leapfrog, Integrator::leapfrog_damped})
    add_explicit(all, release.chain.fiber, integrator, BondForm::incremental, parts, 1);
  add_stiff(all, release, quick ? std::vector{30, 90} : std::vector{30, 60, 90, 200, 450}, 1);
  return all;
}

std::vector<PrecisionRow> ring_down_rows(const std::vector<RingDownSetting>& settings,
                                         const dem::Release<2>& release, const TimingBudget& budget,
                                         const std::function<double(const dem::ReleaseRecord<2>&)>& error) {
  std::vector<PrecisionRow> rows;
  for (const RingDownSetting& setting : settings) {
    const auto slow = std::ranges::find_if(rows, [&](const PrecisionRow& row) {
      return row.method == setting.method && row.time.least * row.lanes > patience;
    });
    if (slow == rows.end()) {
      rows.push_back(measured(setting, release, budget, error));
    } else {
      PrecisionRow row = asked_row(setting, release);
      row.status = fmt::format("not run: {} took {:.0f} s", slow->setting, slow->time.least);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace fiberchain::compare
