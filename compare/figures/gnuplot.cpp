#include "compare/figures/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// An unnamed temporary file: no pipe can block, whatever gnuplot reads and writes first.
File temporary_file() {
  File file(std::tmpfile(), &std::fclose);
  if (!file) throw FigureError(fmt::format("no temporary file for gnuplot: {}", std::strerror(errno)));
  return file;
}

std::string content_of(std::FILE* file) {
  std::string content;
  std::rewind(file);
  std::array<char, 65536> block;
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), file))
    content.append(block.data(), n);
  return content;
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw FigureError(fmt::format("gnuplot was lost: {}", std::strerror(errno)));
  }
  return status;
}

/// Runs "gnuplot -d -" (no start-up files of the user) with these as its standard streams.
int gnuplot_status(std::FILE* input, std::FILE* output, std::FILE* errors) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(input), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(output), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(errors), STDERR_FILENO);
  std::array<char*, 4> arguments = {const_cast<char*>("gnuplot"), const_cast<char*>("-d"),
                                    const_cast<char*>("-"), nullptr};
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failed) {
    throw FigureError(
        fmt::format("cannot run gnuplot, which draws the figures: {} (Debian package gnuplot-nox)",
                    std::strerror(failed)));
  }
  return wait_for(child);
}

}  // namespace

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream places(path ? path : "/bin:/usr/bin");
  for (std::string place; std::getline(places, place, ':');) {
    if (::access(((place.empty() ? "." : place) + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

bool has_gnuplot() { return is_on_path("gnuplot"); }

std::string run_gnuplot(const std::string& script) {
  const File input = temporary_file();
  const File output = temporary_file();
  const File errors = temporary_file();
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() ||
      std::fflush(input.get()) != 0) {
    throw FigureError(fmt::format("no room for gnuplot's script: {}", std::strerror(errno)));
  }
  std::rewind(input.get());
  const int status = gnuplot_status(input.get(), output.get(), errors.get());
  std::string drawn = content_of(output.get());
  if (status != 0 || drawn.empty()) {
    std::string said = content_of(errors.get());
    std::ranges::replace_if(
        said, [](unsigned char c) { return c < 0x20; }, ' ');
    throw FigureError(fmt::format("gnuplot failed (status {}): {}", status, said.substr(0, 400)));
  }
  return drawn;
}

}  // namespace fiberchain::compare
