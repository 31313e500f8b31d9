#include "compare/app/child_process.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <thread>

namespace fiberchain::app {
namespace {

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Files: no pipe can block, whatever the child writes first.
Stream unnamed_file() {
  Stream file(std::tmpfile(), &std::fclose);
  if (!file) throw std::runtime_error(fmt::format("no temporary file for a run: {}", std::strerror(errno)));
  return file;
}

std::string all_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  std::array<char, 65536> block;
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), file)) text.append(block.data(), n);
  return text;
}

pid_t spawn_self(const std::vector<std::string>& arguments, std::FILE* out, std::FILE* errors) {
  std::vector<char*> words = {const_cast<char*>("fiberchain")};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(out), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(errors), STDERR_FILENO);
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, "/proc/self/exe", &actions, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw std::runtime_error(fmt::format("cannot run this program again: {}", std::strerror(failed)));
  return child;
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, const std::function<int()>& asked_to_stop) {
  constexpr auto pause = std::chrono::milliseconds(20);
  const Stream out = unnamed_file(), errors = unnamed_file();
  const pid_t child = spawn_self(arguments, out.get(), errors.get());
  int status = 0, sent = 0;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR)
      throw std::runtime_error(fmt::format("a run was lost: {}", std::strerror(errno)));
    if (const int signal = asked_to_stop(); signal != 0 && sent == 0) {
      sent = signal;
      ::kill(child, signal);
    }
    std::this_thread::sleep_for(pause);
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, all_of(out.get()), all_of(errors.get())};
}

}  // namespace fiberchain::app
