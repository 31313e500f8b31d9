#include "compare/app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "compare/build_info.hpp"
#include "compare/errors.hpp"
#include "compare/ranges.hpp"

namespace fiberchain::app {
namespace {

using compare::parse_integers;
using compare::parse_numbers;
using compare::parse_words;
using dem::io::Interval;

/// Options as typed; empty where they were not.
struct Typed {
  std::string aspect_ratios;
  std::string poisson_ratios;
  std::string loads;
  std::string bonds;
  std::string methods;
  std::string forms;
  std::string dimensions;
  std::string bond_dampings;
  std::string dashpots;
  std::string peaks;
  std::string out;
  std::string data;
  std::string jobs;
  std::string scene;
  bool json = false;
};

constexpr const char* kListHelp =
    "\nLists and ranges: 10,13   5..60   5..60:5 (step)   0.05..10:log:12 (number of values)";

/// Reads an option's words, each the name of a value, if it was typed.
template <class Value>
void read_choices(std::string_view option, const std::string& text, std::vector<Value>& chosen,
                  const std::vector<std::pair<std::string, Value>>& values) {
  if (text.empty()) return;
  std::vector<std::string> words;
  for (const auto& [word, value] : values) words.push_back(word);
  chosen.clear();
  for (const std::string& word : parse_words(option, text, words)) {
    chosen.push_back(values[static_cast<std::size_t>(std::ranges::find(words, word) - words.begin())].second);
  }
}

OutputOptions output_options(const Typed& typed) {
  OutputOptions options;
  options.json = typed.json;
  if (!typed.out.empty()) options.out = typed.out;
  if (!typed.data.empty()) options.data = typed.data;
  options.jobs = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  if (!typed.jobs.empty()) {
    const std::vector<int> jobs = parse_integers("--jobs", typed.jobs, {.low = 1, .high = 1024});
    if (jobs.size() != 1) throw compare::InputError("--jobs: '" + typed.jobs + "' is no single number");
    options.jobs = jobs[0];
  }
  return options;
}

compare::StaticSweep static_sweep(const Typed& typed) {
  using compare::StaticMethod;
  using dem::BondForm;
  using dem::BondModel;
  compare::StaticSweep sweep;
  if (!typed.aspect_ratios.empty()) {
    sweep.aspect_ratio = parse_integers("--aspect-ratio", typed.aspect_ratios, {.low = 1, .high = 1e5});
  }
  if (!typed.poisson_ratios.empty()) {
    const Interval allowed{.low = -1, .high = 0.5, .low_open = true};
    sweep.poisson_ratio = parse_numbers("--poisson-ratio", typed.poisson_ratios, allowed);
  }
  if (!typed.loads.empty()) {
    sweep.load = parse_numbers("--load", typed.loads, {.low = 0, .high = 1000, .low_open = true});
  }
  read_choices<BondModel>("--bond", typed.bonds, sweep.bond,
                          {{"paper", BondModel::paper}, {"corrected", BondModel::corrected}});
  read_choices<StaticMethod>("--method", typed.methods, sweep.method,
                             {{"solve", StaticMethod::solve}, {"march", StaticMethod::march}});
  read_choices<BondForm>("--form", typed.forms, sweep.form,
                         {{"total", BondForm::total}, {"incremental", BondForm::incremental}});
  read_choices<int>("--dimension", typed.dimensions, sweep.dimension, {{"planar", 2}, {"spatial", 3}});
  return sweep;
}

compare::PeakRange peak_range(const std::string& text, compare::PeakRange usual) {
  if (text.empty()) return usual;
  const std::vector<int> peaks = parse_integers("--peaks", text, {.low = 0, .high = 10000});
  if (peaks.size() < 2 || peaks.back() - peaks.front() + 1 != static_cast<int>(peaks.size())) {
    throw compare::InputError("--peaks: '" + text + "' is not allowed: give a range a..b of at least two peaks");
  }
  return {peaks.front(), peaks.back()};
}

compare::DampingSweep damping_sweep(const Typed& typed) {
  using dem::BondForm;
  using dem::BondModel;
  using dem::DashpotLaw;
  compare::DampingSweep sweep;
  if (!typed.aspect_ratios.empty()) {
    sweep.aspect_ratio = parse_integers("--aspect-ratio", typed.aspect_ratios, {.low = 2, .high = 1e4});
  }
  if (!typed.poisson_ratios.empty()) {
    const Interval allowed{.low = -1, .high = 0.5, .low_open = true};
    sweep.poisson_ratio = parse_numbers("--poisson-ratio", typed.poisson_ratios, allowed);
  }
  if (!typed.bond_dampings.empty()) {
    sweep.bond_damping = parse_numbers("--bond-damping", typed.bond_dampings, {.low = 0, .high = 1e6, .low_open = true});
  }
  if (!typed.loads.empty()) {
    sweep.load = parse_numbers("--load", typed.loads, {.low = 0, .high = 10, .low_open = true});
  }
  read_choices<BondModel>("--bond", typed.bonds, sweep.bond,
                          {{"paper", BondModel::paper}, {"corrected", BondModel::corrected}});
  read_choices<BondForm>("--form", typed.forms, sweep.form,
                         {{"total", BondForm::total}, {"incremental", BondForm::incremental}});
  read_choices<DashpotLaw>("--dashpots", typed.dashpots, sweep.dashpots,
                           {{"bond_damping", DashpotLaw::bond_damping},
                            {"retardation_time", DashpotLaw::retardation_time},
                            {"bending_only", DashpotLaw::bending_only}});
  sweep.peaks = peak_range(typed.peaks, sweep.peaks);
  return sweep;
}

/// Whether any case was asked for; without, the figures' own are run.
bool chose_damping_cases(const Typed& typed) {
  const auto& t = typed;
  return !(t.aspect_ratios + t.poisson_ratios + t.bond_dampings + t.loads + t.bonds + t.forms + t.dashpots).empty();
}

void add_json(CLI::App& command, Typed& typed) {
  command.add_flag("--json", typed.json,
                   "print the rows as one JSON object, and nothing else, to standard output");
}

void add_output(CLI::App& command, Typed& typed) {
  add_json(command, typed);
  command
      .add_option("--out", typed.out,
                  "directory for the results; with --json none are written unless given [results]")
      ->type_name("DIR");
  command.add_option("--jobs", typed.jobs, "threads [all cores]")->type_name("N");
}

void add_data(CLI::App& command, Typed& typed) {
  command
      .add_option("--data", typed.data, "data directory, in place of FIBERCHAIN_DATA or the program's own")
      ->type_name("DIR");
}

void add_list(CLI::App& command, const std::string& option, std::string& text, const std::string& help) {
  command.add_option(option, text, help)->type_name("LIST");
}

CLI::App* add_columns(CLI::App& program, Typed& typed) {
  CLI::App* columns =
      program.add_subcommand("columns", "list every column of the tables: type, unit, meaning");
  columns->footer("Example:\n  fiberchain columns --json");
  add_json(*columns, typed);
  return columns;
}

CLI::App* add_run(CLI::App& program, Typed& typed) {
  CLI::App* run = program.add_subcommand("run", "run one scene");
  run->footer("Example:\n  fiberchain run data/scenes/cantilever.yaml --out results");
  run->add_option("SCENE", typed.scene, "scene file (YAML)")->required()->type_name("");
  add_output(*run, typed);
  return run;
}

CLI::App* add_tables_static(CLI::App& tables, Typed& typed) {
  CLI::App* command =
      tables.add_subcommand("static", "departure of the chain from the Elastica and its causes (Figs 3, 4)");
  command->footer(
      "Example:\n  fiberchain tables static --aspect-ratio 10,13 --poisson-ratio 0.17 --load 0.5,6 --json\n" +
      std::string(kListHelp));
  const compare::StaticSweep usual;
  add_list(*command, "--aspect-ratio", typed.aspect_ratios,
           fmt::format("r_f = L/d, number of bonds [{}]", fmt::join(usual.aspect_ratio, ",")));
  add_list(*command, "--poisson-ratio", typed.poisson_ratios,
           fmt::format("Poisson's ratio [{}]", fmt::join(usual.poisson_ratio, ",")));
  add_list(*command, "--load", typed.loads,
           fmt::format("dead load at the free end, P L^2/(E I) [{}]", fmt::join(usual.load, ",")));
  add_list(*command, "--bond", typed.bonds, "bond law: paper, corrected [paper]");
  add_list(*command, "--method", typed.methods, "way to the equilibrium: solve, march [solve]");
  add_list(*command, "--form", typed.forms, "form of the bond law: total, incremental (march only) [total]");
  add_list(*command, "--dimension", typed.dimensions, "planar, spatial [planar]");
  add_output(*command, typed);
  return command;
}

CLI::App* add_tables_damping(CLI::App& tables, Typed& typed) {
  CLI::App* command =
      tables.add_subcommand("damping", "damping of the fiber by that of the bonds and what it is made of (Figs 6 to 9)");
  command->footer(
      "Without a choice of cases those of the figures are run.\n"
      "Example:\n  fiberchain tables damping --aspect-ratio 13 --poisson-ratio 0.17 --bond-damping 0.7 --load 0.05 --json\n" +
      std::string(kListHelp));
  add_list(*command, "--aspect-ratio", typed.aspect_ratios, "r_f = L/d, number of bonds [10]");
  add_list(*command, "--poisson-ratio", typed.poisson_ratios, "Poisson's ratio [0.3]");
  add_list(*command, "--bond-damping", typed.bond_dampings,
           "xi_b; with --dashpots retardation_time the time over t_b [1]");
  add_list(*command, "--load", typed.loads, "load before the release, P L^2/(E I) [0.05]");
  add_list(*command, "--dashpots", typed.dashpots,
           "what sets the dashpots: bond_damping, retardation_time, bending_only [bond_damping]");
  add_list(*command, "--bond", typed.bonds, "bond law: paper, corrected [paper]");
  add_list(*command, "--form", typed.forms, "form of the bond law: total, incremental [incremental]");
  add_list(*command, "--peaks", typed.peaks, "peaks of fiber_damping_paper; 0 is the point of release [1..10]");
  add_output(*command, typed);
  return command;
}

CLI::App* add_validate(CLI::App& program, Typed& typed) {
  CLI::App* validate =
      program.add_subcommand("validate", "hold the program against exact and published values");
  validate->footer(
      "Example:\n  fiberchain validate --out results\nExit status 1 if a row that must hold does not.");
  add_data(*validate, typed);
  add_output(*validate, typed);
  return validate;
}

}  // namespace

Request parse_command_line(const std::vector<std::string>& arguments) {
  Typed typed;
  CLI::App program("Sphere-chain DEM for flexible fibers, held against continuum references.", "fiberchain");
  program.set_version_flag("--version",
                           fmt::format("fiberchain {} (commit {})", compare::kVersion, compare::kCommit));
  program.footer("Example:\n  fiberchain tables static --help");
  CLI::App* columns = add_columns(program, typed);
  CLI::App* run = add_run(program, typed);
  CLI::App* tables = program.add_subcommand("tables", "make the paper's tables and figures");
  tables->footer("Example:\n  fiberchain tables static --load 0.05..10:log:12");
  CLI::App* tables_static = add_tables_static(*tables, typed);
  CLI::App* tables_damping = add_tables_damping(*tables, typed);
  CLI::App* validate = add_validate(program, typed);
  try {
    program.parse(
        std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes them last to first
  } catch (const CLI::Success& asked) {                                   // --help, --version
    std::ostringstream text;
    program.exit(asked, text, text);
    return Message{text.str()};
  } catch (const CLI::ParseError& error) {
    throw compare::InputError(std::string(error.what()) + " (see --help)");
  }
  if (*columns) return ColumnsOptions{typed.json};
  if (*run) return RunOptions{typed.scene, output_options(typed)};
  if (*tables_static) return TablesStaticOptions{static_sweep(typed), output_options(typed)};
  if (*tables_damping) {
    return TablesDampingOptions{damping_sweep(typed), chose_damping_cases(typed), output_options(typed)};
  }
  if (*validate) return ValidateOptions{output_options(typed)};
  throw compare::InputError(*tables ? "which table? static or damping (see --help)"
                                    : "which command? columns, run, tables or validate (see --help)");
}

}  // namespace fiberchain::app
