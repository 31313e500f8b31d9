#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/app/commands.hpp"

namespace fiberchain::app {

/// What the command line asks for: a command with its arguments, or a text (help, version) to be printed.
struct Request {
  std::optional<Command> command;
  Arguments arguments;
  std::string text;
};

/// Understands the arguments (without the program's name).
/// @throws compare::InputError if they make no sense
Request parse_command_line(const std::vector<std::string>& arguments);

}  // namespace fiberchain::app
