#pragma once

#include <string>
#include <variant>
#include <vector>

#include "compare/app/options.hpp"

namespace fiberchain::app {

/// Help or version: to be printed, and that is all.
struct Message {
  std::string text;
};

using Request = std::variant<Message, ColumnsOptions, RunOptions, TablesStaticOptions, TablesDampingOptions, ValidateOptions>;

/// What the arguments (without the program's name) ask for.
/// @throws compare::InputError if they are not understood
Request parse_command_line(const std::vector<std::string>& arguments);

}  // namespace fiberchain::app
