#include "tests/program/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fiberchain::test {
namespace {

namespace fs = std::filesystem;

void open_as(int descriptor, const fs::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
}

void break_pipe(int descriptor) {
  int ends[2];
  if (::pipe(ends) != 0 || ::dup2(ends[1], descriptor) < 0) ::_exit(126);
  ::close(ends[0]), ::close(ends[1]);
}

/// In the child: never returns.
[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const Circumstances& circumstances, const fs::path& out,
                                 const fs::path& error) {
  open_as(STDOUT_FILENO, out);
  circumstances.nobody_reads_errors ? break_pipe(STDERR_FILENO) : open_as(STDERR_FILENO, error);
  for (const auto& [name, value] : circumstances.environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (::chdir(circumstances.directory.c_str()) != 0) ::_exit(126);
  if (circumstances.largest_file) {
    const rlimit limit{*circumstances.largest_file, *circumstances.largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (circumstances.address_space) {
    const rlimit limit{*circumstances.address_space, *circumstances.address_space};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  std::vector<char*> words = {const_cast<char*>(FIBERCHAIN_PROGRAM)};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(FIBERCHAIN_PROGRAM, words.data());
  ::_exit(127);
}

}  // namespace

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "fiberchain-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
  path = name;
}

Scratch::~Scratch() { fs::remove_all(path); }

fs::path Scratch::file(const std::string& name, const std::string& content) const {
  fs::create_directories((path / name).parent_path());
  std::ofstream(path / name, std::ios::binary) << content;
  return path / name;
}

Started::Started(const std::vector<std::string>& arguments, const Circumstances& circumstances)
    : out_(circumstances.standard_output.value_or(streams_.path / "out")),
      error_(streams_.path / "error"),
      kept_(!circumstances.standard_output),
      child_(::fork()) {
  if (child_ == 0) become_program(arguments, circumstances, out_, error_);
}

Started::~Started() {
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

void Started::send(int signal) const { ::kill(child_, signal); }

Outcome Started::finish() {
  int status = 0;
  if (child_ < 0 || ::waitpid(child_, &status, 0) != child_) throw std::runtime_error("the program was lost");
  child_ = -1;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, kept_ ? content(out_) : "", content(error_)};
}

Outcome run(const std::vector<std::string>& arguments, const Circumstances& circumstances) {
  return Started(arguments, circumstances).finish();
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t files_under(const fs::path& path) {
  const auto is_file = [](const fs::directory_entry& entry) { return entry.is_regular_file(); };
  return static_cast<std::size_t>(
      std::count_if(fs::recursive_directory_iterator(path), fs::recursive_directory_iterator(), is_file));
}

bool is_one_error(const std::string& text) {
  const bool one_line = std::ranges::count(text, '\n') == 1 && text.ends_with('\n');
  return one_line && text.starts_with("fiberchain: error: ") && text.size() < 500;
}

}  // namespace fiberchain::test
