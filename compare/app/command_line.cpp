#include "compare/app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>
#include <sstream>

#include "compare/study/errors.hpp"
#include "dem/files/nearest_word.hpp"
#include "dem/record/build_info.hpp"

namespace fiberchain::app {
namespace {

/// A command as CLI11 knows it, and where it puts what is typed.
struct Registered {
  Command command;
  CLI::App* app;
  std::map<std::string, std::string> texts;
  std::map<std::string, bool> flags;
  std::map<std::string, std::vector<std::string>> lists;
};

void add_option(Registered& entry, const Option& option) {
  const std::string names = option.alias.empty() ? option.name : option.name + "," + option.alias;
  if (option.kind == OptionKind::flag) {
    entry.app->add_flag(names, entry.flags[option.name], option.help);
    return;
  }
  if (option.kind == OptionKind::places) {
    entry.app->add_option(names, entry.lists[option.name], option.help)->type_name(option.type)->required();
    return;
  }
  if (option.kind == OptionKind::several) {
    entry.app->add_option(names, entry.lists[option.name], option.help)
        ->type_name(option.type)
        ->allow_extra_args(false);
    return;
  }
  CLI::Option* added = entry.app->add_option(names, entry.texts[option.name], option.help);
  added->type_name(option.type)->required(option.kind == OptionKind::required);
}

/// The group's app for "tables static", made when its first command comes; the program itself for "run".
CLI::App& parent_of(CLI::App& program, const std::string& name) {
  for (const Group& group : all_groups()) {
    if (!name.starts_with(group.name + " ")) continue;
    const auto known = program.get_subcommands([&](CLI::App* app) { return app->get_name() == group.name; });
    if (!known.empty()) return *known.front();
    return *program.add_subcommand(group.name, group.description)->footer(group.footer);
  }
  return program;
}

std::vector<std::unique_ptr<Registered>> register_commands(CLI::App& program) {
  std::vector<std::unique_ptr<Registered>> all;
  for (const Command& command : all_commands()) {
    CLI::App& parent = parent_of(program, command.name);
    CLI::App* app =
        parent.add_subcommand(command.name.substr(command.name.find(' ') + 1), command.description);
    app->footer(command.footer);
    all.push_back(std::make_unique<Registered>(Registered{command, app, {}, {}, {}}));
    for (const Option& option : command.options) add_option(*all.back(), option);
  }
  return all;
}

Arguments arguments_of(const Registered& entry) {
  std::map<std::string, std::string> typed;
  for (const auto& [name, text] : entry.texts) {
    if (entry.app->count(name) > 0) typed[name] = text;
  }
  for (const auto& [name, set] : entry.flags) {
    if (set) typed[name] = "";
  }
  return Arguments(std::move(typed), entry.lists);
}

/// The names of the commands below an app.
std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

[[noreturn]] void ask_for_command(const CLI::App& program) {
  const auto groups = program.get_subcommands();
  const CLI::App& asked = groups.empty() ? program : *groups.front();
  const std::string of = groups.empty() ? "" : fmt::format(" of '{}'", asked.get_name());
  throw compare::InputError(
      fmt::format("give a command{}: {} (see --help)", of, fmt::join(command_names(asked), ", ")));
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Refuses an option of one value that is there a second time, by whichever of its names.
void check_given_once(const CLI::App& app, const std::string& name, std::set<const CLI::Option*>& seen) {
  const CLI::Option* option = app.get_option(name);
  const bool is_single = option->get_expected_max() == 1;
  if (seen.insert(option).second || !is_single) return;
  throw compare::InputError(fmt::format("{}: given twice; give it once", option->get_name(false, true)));
}

/// Refuses a command or an option that nobody knows with the one that may have been meant, before CLI11 takes
/// what follows it for something else.
void check_words(const CLI::App& program, const std::vector<std::string>& arguments) {
  const CLI::App* app = &program;
  auto word = arguments.begin();
  for (; word != arguments.end() && !word->starts_with('-'); ++word) {
    const std::vector<std::string> names = command_names(*app);
    if (names.empty()) break;
    const auto known = app->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == *word; });
    if (known.empty()) {
      throw compare::InputError(fmt::format("unknown command '{}{}': {} (see --help)",
                                            app == &program ? "" : app->get_name() + " ", *word,
                                            dem::suggestion(*word, names)));
    }
    app = known.front();
  }
  std::set<const CLI::Option*> seen;
  for (; word != arguments.end(); ++word) {
    const std::string name = word->substr(0, word->find('='));
    if (!name.starts_with("--") || name == "--") continue;
    const std::vector<std::string> names = option_names(*app);
    if (std::ranges::find(names, name) != names.end()) {
      check_given_once(*app, name, seen);
      continue;
    }
    throw compare::InputError(fmt::format("unknown option '{}' of '{}': {} (see --help)", name,
                                          app->get_name(), dem::suggestion(name, names)));
  }
}

}  // namespace

Request parse_command_line(const std::vector<std::string>& arguments) {
  CLI::App program("Sphere-chain DEM for flexible fibers, held against continuum references.", "fiberchain");
  program.set_version_flag("--version",
                           fmt::format("fiberchain {} (commit {})", dem::kVersion, dem::kCommit));
  program.footer("Example:\n  fiberchain tables static --help");
  const auto commands = register_commands(program);
  check_words(program, arguments);
  try {
    program.parse(
        std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes them last to first
  } catch (const CLI::Success& asked) {                                   // --help, --version
    std::ostringstream text;
    program.exit(asked, text, text);
    return {std::nullopt, {}, text.str()};
  } catch (const CLI::ParseError& error) {
    throw compare::InputError(std::string(error.what()) + " (see --help)");
  }
  for (const auto& entry : commands) {
    if (*entry->app) return {entry->command, arguments_of(*entry), ""};
  }
  ask_for_command(program);
}

}  // namespace fiberchain::app
