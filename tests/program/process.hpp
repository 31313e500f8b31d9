#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The program as its users meet it: arguments in, standard output, standard error and exit status out.
namespace fiberchain::test {

/// A directory of its own that goes when the test ends.
struct Scratch {
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  /// Writes a file in it, and gives its path.
  std::filesystem::path file(const std::string& name, const std::string& content) const;

  std::filesystem::path path;
};

struct Circumstances {
  std::filesystem::path directory = std::filesystem::current_path();    ///< where the program runs
  std::vector<std::pair<std::string, std::string>> environment = {};    ///< set besides what is there
  std::optional<std::filesystem::path> standard_output = std::nullopt;  ///< this file, instead of being kept
  std::optional<std::size_t> largest_file = std::nullopt;               ///< as on a full disk [bytes]
  std::optional<std::size_t> address_space = std::nullopt;              ///< as on a small machine [bytes]
  bool nobody_reads_errors = false;                                     ///< a pipe whose reader has gone
};

struct Outcome {
  int status;  ///< exit status, or 128 + the signal that ended it
  std::string out;
  std::string error;
};

/// Runs the program with these arguments.
Outcome run(const std::vector<std::string>& arguments, const Circumstances& circumstances = {});

/// The program at work, to be stopped.
class Started {
 public:
  explicit Started(const std::vector<std::string>& arguments, const Circumstances& circumstances = {});
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;
  ~Started();  ///< kills it if it is still at work

  void send(int signal) const;
  Outcome finish();  ///< waits for its end

 private:
  Scratch streams_;
  std::filesystem::path out_, error_;
  bool kept_;  ///< standard output is kept
  int child_;
};

/// The whole content of a file; "" if there is none.
std::string content(const std::filesystem::path& path);

/// Number of files under a directory.
std::size_t files_under(const std::filesystem::path& path);

/// Whether a text is one line "fiberchain: error: ...".
bool is_one_error(const std::string& text);

}  // namespace fiberchain::test
