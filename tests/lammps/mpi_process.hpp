#pragma once

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

// Runs of fiberchain-mpi.
namespace fiberchain::test::mpi {

namespace fs = std::filesystem;

struct Scratch {
  Scratch() : path(fs::temp_directory_path() / fmt::format("fiberchain-mpi-{}-{}", ::getpid(), number++)) {
    fs::create_directories(path);
  }
  ~Scratch() { fs::remove_all(path); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void file(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }

  static inline int number = 0;
  fs::path path;
};

inline std::string content(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// As root of a container, on fewer cores than ranks.
inline std::string mpirun(int ranks, const std::string& arguments) {
  return fmt::format(
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "OMPI_MCA_btl_vader_single_copy_mechanism=none "
      "exec {} --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 --mca btl self,vader -np {} {} {}",
      FIBERCHAIN_MPIEXEC, ranks, FIBERCHAIN_MPI_PROGRAM, arguments);
}

struct Outcome {
  int status;
  std::string error;
};

inline Outcome go(const Scratch& scratch, int ranks, const std::string& arguments) {
  const std::string line =
      fmt::format("cd '{}' && ({}) > out.txt 2> error.txt", scratch.path.string(), mpirun(ranks, arguments));
  const int ended = std::system(line.c_str());
  return {WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended), content(scratch.path / "error.txt")};
}

}  // namespace fiberchain::test::mpi
