#include <array>

#include "compare/app/commands.hpp"
#include "compare/app/completion.hpp"
#include "compare/app/manual.hpp"
#include "compare/app/options.hpp"
#include "compare/study/errors.hpp"

// What the program says of itself, in the forms that systems install.
namespace fiberchain::app {
namespace {

int run_manual(const Arguments&, Context& context) {
  context.out << manual_page(all_commands());
  return kSuccess;
}

struct Shell {
  std::string name;
  std::string (*script)(const std::vector<Command>&, const std::vector<Group>&);
};

int run_completion(const Arguments& arguments, Context& context) {
  const std::array<Shell, 3> shells = {
      {{"bash", &bash_completion}, {"fish", &fish_completion}, {"zsh", &zsh_completion}}};
  for (const Shell& shell : shells) {
    if (shell.name != arguments.text("SHELL")) continue;
    context.out << shell.script(all_commands(), all_groups());
    return kSuccess;
  }
  throw compare::InputError("SHELL: '" + arguments.text("SHELL") +
                            "' is not known; allowed: bash, fish, zsh");
}

}  // namespace

Command manual_command() {
  return {.name = "manual",
          .description = "print the manual page fiberchain(1)",
          .footer = "Example:\n  fiberchain manual | man -l -",
          .options = {},
          .run = &run_manual};
}

Command completion_command() {
  return {.name = "completion",
          .description = "print a script by which a shell completes commands and options",
          .footer = "Example:\n  source <(fiberchain completion bash)",
          .options = {{"SHELL", "", "bash, fish or zsh", OptionKind::required}},
          .run = &run_completion};
}

}  // namespace fiberchain::app
