#include "compare/app/manual.hpp"

#include <fmt/format.h>

#include "dem/record/build_info.hpp"

namespace fiberchain::app {
namespace {

/// Text that roff takes as it is: no escapes, no hyphens in place of dashes, no requests at a line's begin.
std::string roff(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    line_begins = c == '\n';
  }
  return out;
}

bool is_positional(const Option& option) { return !option.name.starts_with('-'); }

/// As it is typed, for the line above the options.
std::string synopsis(const Option& option) {
  if (is_positional(option))
    return option.kind == OptionKind::required ? option.name : "[" + option.name + "]";
  const std::string typed = option.type.empty() ? option.name : option.name + " " + option.type;
  return option.kind == OptionKind::required ? typed : "[" + typed + "]";
}

std::string option_entry(const Option& option) {
  std::string head = "\\fB" + roff(option.name) + "\\fR";
  if (!option.alias.empty()) head += ", \\fB" + roff(option.alias) + "\\fR";
  if (!option.type.empty()) head += " \\fI" + roff(option.type) + "\\fR";
  return fmt::format(".TP\n{}\n{}\n", head, roff(option.help));
}

std::string command_section(const Command& command) {
  std::string line = "\\fBfiberchain " + roff(command.name) + "\\fR";
  for (const Option& option : command.options) line += " " + roff(synopsis(option));
  std::string text =
      fmt::format(".SS {}\n{}\n.PP\n{}.\n", roff(command.name), line, roff(command.description));
  for (const Option& option : command.options) text += option_entry(option);
  return text + fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.footer));
}

constexpr std::string_view manual_head = R"(.SH NAME
fiberchain \- sphere-chain DEM for flexible fibers, held against continuum references
.SH SYNOPSIS
.B fiberchain
.I COMMAND
.RI [ OPTIONS ]
.PP
.B fiberchain
.RI [ COMMAND ]
.B \-\-help
.SH DESCRIPTION
Runs scenes of flexible fibers as chains of bonded spheres, makes the tables and figures that hold them against beam and
rod theory, and calibrates bonds for a material. All quantities are in SI units unless a scene gives a unit.
.SH COMMANDS
)";

constexpr std::string_view manual_tail = R"(.SH EXIT STATUS
.TP
.B 0
All is done.
.TP
.B 1
A row of the validation matrix that must hold does not.
.TP
.B 2
The input is wrong: the message names the file, the key, the value and what is allowed. Nothing was written.
.TP
.B 3
A run diverged, did not converge, or a file could not be written; what was written until then is whole.
.TP
.B 128 + N
Stopped by the signal N; \-\-resume goes on.
)";

}  // namespace

std::string manual_page(const std::vector<Command>& commands) {
  std::string text =
      fmt::format(".TH FIBERCHAIN 1 \"\" \"fiberchain {}\" \"User commands\"\n", dem::kVersion);
  text += manual_head;
  for (const Command& command : commands) text += command_section(command);
  return text + std::string(manual_tail);
}

}  // namespace fiberchain::app
