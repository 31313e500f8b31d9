#include "compare/app/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fiberchain::app {
namespace {

bool is_in(const Command& command, const Group& group) { return command.name.starts_with(group.name + " "); }

/// The first words that can be typed.
std::vector<std::string> first_words(const std::vector<Command>& commands, const std::vector<Group>& groups) {
  std::vector<std::string> words;
  for (const Command& command : commands) {
    if (command.name.find(' ') == std::string::npos) words.push_back(command.name);
  }
  for (const Group& group : groups) words.push_back(group.name);
  return words;
}

std::vector<std::string> second_words(const Group& group, const std::vector<Command>& commands) {
  std::vector<std::string> words;
  for (const Command& command : commands) {
    if (is_in(command, group)) words.push_back(command.name.substr(group.name.size() + 1));
  }
  return words;
}

std::vector<std::string> names_of(const Option& option) {
  std::vector<std::string> names;
  if (option.name.starts_with('-')) names.push_back(option.name);
  if (!option.alias.empty()) names.push_back(option.alias);
  return names;
}

std::vector<std::string> names_of_all(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options) {
    for (const std::string& name : names_of(option)) names.push_back(name);
  }
  names.emplace_back("--help");
  return names;
}

/// In single quotes of a shell.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string bash_completion(const std::vector<Command>& commands, const std::vector<Group>& groups) {
  std::string group_cases, option_cases;
  for (const Group& group : groups) {
    group_cases +=
        fmt::format("    {}) command=\"$command ${{COMP_WORDS[2]}}\" first=3 words={} ;;\n", group.name,
                    in_quotes(fmt::format("{} --help", fmt::join(second_words(group, commands), " "))));
  }
  for (const Command& command : commands)
    option_cases += fmt::format("    {}) words={} ;;\n", in_quotes(command.name),
                                in_quotes(fmt::format("{}", fmt::join(names_of_all(command), " "))));
  return fmt::format(R"(# Completion of fiberchain for bash: source this file.
_fiberchain() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} first=2 words=''
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{} --help --version' -- "$current")
    return
  fi
  case $command in
{}  esac
  if ((COMP_CWORD < first)); then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    return
  fi
  words='--help'
  case $command in
{}  esac
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}
complete -o filenames -F _fiberchain fiberchain
)",
                     fmt::join(first_words(commands, groups), " "), group_cases, option_cases);
}

std::string zsh_completion(const std::vector<Command>& commands, const std::vector<Group>& groups) {
  // zsh runs completions of bash; it has no mapfile
  std::string script = bash_completion(commands, groups);
  const std::string mapfile = "mapfile -t COMPREPLY < <(", array = "COMPREPLY=($(";
  for (std::size_t at = 0; (at = script.find(mapfile, at)) != std::string::npos;) {
    script.replace(at, mapfile.size(), array);
    script.insert(script.find('\n', at), ")");
  }
  script.erase(0, script.find('\n') + 1);
  return "#compdef fiberchain\n# Completion of fiberchain for zsh: source this file.\nautoload -Uz "
         "bashcompinit && bashcompinit\n" +
         script;
}

std::string fish_completion(const std::vector<Command>& commands, const std::vector<Group>& groups) {
  std::string text = "# Completion of fiberchain for fish: source this file.\n";
  const std::string first = "__fish_use_subcommand";
  for (const Group& group : groups) {
    text += fmt::format("complete -c fiberchain -f -n {} -a {} -d {}\n", first, group.name,
                        in_quotes(group.description));
    const std::string words = fmt::format("{}", fmt::join(second_words(group, commands), " "));
    for (const Command& command : commands) {
      if (!is_in(command, group)) continue;
      const std::string condition = fmt::format(
          "__fish_seen_subcommand_from {}; and not __fish_seen_subcommand_from {}", group.name, words);
      text += fmt::format("complete -c fiberchain -f -n {} -a {} -d {}\n", in_quotes(condition),
                          command.name.substr(group.name.size() + 1), in_quotes(command.description));
    }
  }
  for (const Command& command : commands) {
    const std::size_t space = command.name.find(' ');
    if (space == std::string::npos)
      text += fmt::format("complete -c fiberchain -f -n {} -a {} -d {}\n", first, command.name,
                          in_quotes(command.description));
    std::string condition = "__fish_seen_subcommand_from " + command.name.substr(0, space);
    if (space != std::string::npos)
      condition += "; and __fish_seen_subcommand_from " + command.name.substr(space + 1);
    for (const Option& option : command.options) {
      for (const std::string& name : names_of(option)) {
        text +=
            fmt::format("complete -c fiberchain -n {} -l {} {}-d {}\n", in_quotes(condition), name.substr(2),
                        option.kind == OptionKind::flag ? "" : "-r ", in_quotes(option.help));
      }
    }
  }
  return text;
}

}  // namespace fiberchain::app
