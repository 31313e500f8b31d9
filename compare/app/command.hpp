#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/app/context.hpp"

/// A command of the program as a value: what it takes, what it says of itself, what it does.
namespace fiberchain::app {

/// What was typed: texts by the name of their option; flags and options that were not typed are absent.
class Arguments {
 public:
  Arguments() = default;
  explicit Arguments(std::map<std::string, std::string> texts) : texts_(std::move(texts)) {}

  bool has(const std::string& option) const { return texts_.contains(option); }

  /// The option's text, "" if it was not typed.
  std::string text(const std::string& option) const {
    const auto found = texts_.find(option);
    return found == texts_.end() ? "" : found->second;
  }

 private:
  std::map<std::string, std::string> texts_;
};

enum class OptionKind { text, flag, required };

struct Option {
  std::string name;  ///< "--load"; a name without dashes is taken by its place
  std::string type;  ///< "LIST", "DIR", ... as help shows it
  std::string help;
  OptionKind kind = OptionKind::text;
  std::string alias = {};  ///< another name for the same
};

struct Command {
  std::string name;  ///< "run", or "tables static": a command of a group
  std::string description;
  std::string footer;  ///< below the options: an example, at least
  std::vector<Option> options;
  int (*run)(const Arguments&, Context&);  ///< its exit status; errors are thrown
};

}  // namespace fiberchain::app
