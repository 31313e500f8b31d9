#pragma once

#include <string>
#include <vector>

#include "compare/app/commands.hpp"

/// Scripts by which shells complete the program's commands and options, from what commands say of themselves.
namespace fiberchain::app {

std::string bash_completion(const std::vector<Command>& commands, const std::vector<Group>& groups);
std::string zsh_completion(const std::vector<Command>& commands, const std::vector<Group>& groups);
std::string fish_completion(const std::vector<Command>& commands, const std::vector<Group>& groups);

}  // namespace fiberchain::app
