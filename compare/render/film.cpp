#include "compare/render/film.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <vector>

#include "compare/figures/gnuplot.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

/// Runs ffmpeg without input, its messages to a file; its exit status.
int ffmpeg_status(const std::vector<std::string>& arguments, const std::filesystem::path& messages) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0666);
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, "ffmpeg", &actions, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw FigureError(fmt::format("cannot run ffmpeg: {}", std::strerror(failed)));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw FigureError(fmt::format("ffmpeg was lost: {}", std::strerror(errno)));
  }
  return status;
}

}  // namespace

bool has_ffmpeg() { return is_on_path("ffmpeg"); }

void make_film(const std::filesystem::path& pattern, std::int64_t first, int frame_rate,
               const std::filesystem::path& film) {
  const std::filesystem::path staged = film.string() + ".part", messages = film.string() + ".log";
  const int status =
      ffmpeg_status({"ffmpeg", "-y", "-loglevel", "error", "-framerate", fmt::format("{}", frame_rate),
                     "-start_number", fmt::format("{}", first), "-i", pattern.string(), "-vf",
                     "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-f", "mp4", staged.string()},
                    messages);
  std::error_code error;
  if (status != 0) {
    std::filesystem::remove(staged, error);
    throw FigureError(
        fmt::format("ffmpeg failed (status {}): its messages are in {}", status, messages.string()));
  }
  std::filesystem::remove(messages, error);
  std::filesystem::rename(staged, film, error);
  if (error) throw FigureError(fmt::format("cannot write {}: {}", film.string(), error.message()));
}

}  // namespace fiberchain::compare
