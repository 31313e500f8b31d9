#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/app/options.hpp"
#include "dem/model/fiber.hpp"
#include "dem/motion/physics.hpp"

/// Options of a study's sweep, declared once: help, allowed values, and the member that they fill.
namespace fiberchain::app {

template <class Sweep>
struct SweepOption {
  Option option;
  std::function<void(const Arguments&, Sweep&)> read;
  bool chooses_cases = true;
};

template <class Sweep>
using SweepOptions = std::vector<SweepOption<Sweep>>;

/// A list of numbers.
template <class Sweep, class Number>
SweepOption<Sweep> list_of(const std::string& name, std::vector<Number> Sweep::*member,
                           const dem::ValueRange& allowed, const std::string& help) {
  return {{name, "LIST", help}, [=](const Arguments& arguments, Sweep& sweep) {
            read_list(arguments, name, allowed, sweep.*member);
          }};
}

/// A list of words, each standing for a value.
template <class Sweep, class Value>
SweepOption<Sweep> words_of(const std::string& name, std::vector<Value> Sweep::*member,
                            const std::vector<std::pair<std::string, Value>>& choices,
                            const std::string& help) {
  return {{name, "LIST", help}, [=](const Arguments& arguments, Sweep& sweep) {
            read_choices<Value>(arguments, name, sweep.*member, choices);
          }};
}

/// --peaks: where the damping is measured, whatever the cases are.
template <class Sweep>
SweepOption<Sweep> peaks_of(compare::PeakRange Sweep::*member, const std::string& help) {
  return {
      {"--peaks", "LIST", help},
      [=](const Arguments& arguments, Sweep& sweep) { sweep.*member = peak_range(arguments, sweep.*member); },
      false};
}

inline const std::vector<std::pair<std::string, dem::BondModel>> kBondModels{
    {"paper", dem::BondModel::paper}, {"corrected", dem::BondModel::corrected}};
inline const std::vector<std::pair<std::string, dem::BondForm>> kBondForms{
    {"total", dem::BondForm::total}, {"incremental", dem::BondForm::incremental}};
inline const std::vector<std::pair<std::string, int>> kDimensions{{"planar", 2}, {"spatial", 3}};

/// @throws compare::InputError naming option, value and what is allowed
template <class Sweep>
Sweep read_sweep(const SweepOptions<Sweep>& options, const Arguments& arguments) {
  Sweep sweep;
  for (const SweepOption<Sweep>& option : options) option.read(arguments, sweep);
  return sweep;
}

/// Whether any case was asked for; without, the figures' own are run.
template <class Sweep>
bool chose_cases(const SweepOptions<Sweep>& options, const Arguments& arguments) {
  return std::ranges::any_of(options, [&](const SweepOption<Sweep>& option) {
    return option.chooses_cases && arguments.has(option.option.name);
  });
}

/// These options, then those of shards and of the output.
template <class Sweep>
std::vector<Option> with_shards(const SweepOptions<Sweep>& options) {
  std::vector<Option> all;
  for (const SweepOption<Sweep>& option : options) all.push_back(option.option);
  return with_shards(std::move(all));
}

}  // namespace fiberchain::app
