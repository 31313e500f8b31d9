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
  explicit Arguments(std::map<std::string, std::string> texts,
                     std::map<std::string, std::vector<std::string>> lists = {})
      : texts_(std::move(texts)), lists_(std::move(lists)) {}

  bool has(const std::string& option) const { return texts_.contains(option); }

  /// The option's text, "" if it was not typed.
  std::string text(const std::string& option) const {
    const auto found = texts_.find(option);
    return found == texts_.end() ? "" : found->second;
  }

  /// All texts of an option that may come several times, in their order.
  std::vector<std::string> texts(const std::string& option) const {
    const auto found = lists_.find(option);
    return found == lists_.end() ? std::vector<std::string>() : found->second;
  }

 private:
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::vector<std::string>> lists_;
};

/// Of a text that may come several times (--set), and of one or more that are taken by their place.
enum class OptionKind { text, flag, required, several, places };

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
