#pragma once

#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "dem/trajectory/h5md.hpp"
#include "tests/program/process.hpp"

/// Runs of few fibers, for what befalls them.
namespace fiberchain::test {

struct Crowd {
  int fibers;
  const char* top;  ///< of the region they fill
};
inline constexpr Crowd few{31, "50 mm"};

/// Short fibers of 7 spheres that fall into a box; `more` stands at the end of the filling.
inline std::string short_fibers(int steps, const Crowd& crowd, const std::string& more = "") {
  return "scene: packing\n"
         "fibers:\n"
         "  - {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000 "
         "kg/m^3,\n"
         "     bond: {damping: 1}, count: " +
         std::to_string(crowd.fibers) +
         "}\n"
         "filling: {region: {z: [1 mm, " +
         crowd.top + "]}, velocity: [0, 0, -1], seed: 3" + more +
         "}\n"
         "walls: {box: {x: 24 mm, y: 22 mm, lid: open}}\n"
         "gravity: [0, 0, -9.81]\n"
         "contacts: {restitution: 0.5, friction: 0.3}\n"
         "steps: " +
         std::to_string(steps) +
         "\noutput: {samples: 37, frames: 11, checkpoints: 23, vtk: true, energy: true}\n";
}

/// A directory with the scene s.yaml, whose runs go to `out`; 217 spheres unless told.
struct FewFibers : Scratch {
  explicit FewFibers(int steps = 15000, const std::string& more = "", const Crowd& crowd = few) {
    file("s.yaml", short_fibers(steps, crowd, more));
  }

  std::vector<std::string> arguments(std::vector<std::string> more = {}) const {
    std::vector<std::string> all = {"run", "s.yaml", "--out", "out", "--jobs", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Circumstances here() const { return {.directory = path}; }
  Outcome go(const std::vector<std::string>& more = {}) const { return run(arguments(more), here()); }
  std::filesystem::path out(const std::string& name) const { return path / "out" / name; }
};

/// Waits until something is so, or fails after a minute.
inline void wait_until(const std::function<bool()>& so) {
  for (int i = 0; i < 60000 && !so(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (!so()) throw std::runtime_error("waited in vain");
}

/// The log without its comments and without the last two columns, which are of the clock.
inline std::string log_of(const std::filesystem::path& path) {
  std::string kept;
  const std::string text = content(path);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    if (!line.starts_with('#')) kept += line.substr(0, line.rfind(',', line.rfind(',') - 1)) + "\n";
    at = end + 1;
  }
  return kept;
}

/// Whether both hold the same frames, to the bit.
inline bool same_frames(const std::filesystem::path& a, const std::filesystem::path& b) {
  const dem::TrajectoryReader first(a), second(b);
  if (first.steps() != second.steps() || first.times() != second.times()) return false;
  const auto differs = [](const auto& u, const auto& v) {
    return u[0] != v[0] || u[1] != v[1] || u[2] != v[2];
  };
  for (std::int64_t n = 0; n < first.frames(); ++n) {
    const dem::TrajectoryFrame f = first.read(n), g = second.read(n);
    if (f.position.size() != g.position.size() || f.bonds.size() != g.bonds.size()) return false;
    for (std::size_t i = 0; i < f.position.size(); ++i) {
      if (differs(f.position[i], g.position[i]) || differs(f.velocity[i], g.velocity[i])) return false;
    }
    for (std::size_t i = 0; i < f.bonds.size(); ++i) {
      if (f.bonds[i].bending_angle != g.bonds[i].bending_angle) return false;
    }
  }
  return first.scalars(first.frames() - 1) == second.scalars(second.frames() - 1);
}

/// Whether two runs ended alike: last state, log and frames.
inline bool same_end(const FewFibers& a, const FewFibers& b) {
  return !content(a.out("s.checkpoint")).empty() &&
         content(a.out("s.checkpoint")) == content(b.out("s.checkpoint")) &&
         content(a.out("s.pvd")) == content(b.out("s.pvd")) &&
         files_under(a.out("s")) == files_under(b.out("s")) &&
         log_of(a.out("s-log.csv")) == log_of(b.out("s-log.csv")) &&
         same_frames(a.out("s.h5"), b.out("s.h5"));
}

/// Kills a run again and again, each time a while after its next checkpoint, and resumes it; then lets it
/// end. How many of them the kill came in time for.
inline int kill_and_resume(const FewFibers& fibers, const std::vector<int>& milliseconds) {
  int killed = 0;
  for (const int pause : milliseconds) {
    const std::string before = content(fibers.out("s.checkpoint"));
    Started program(fibers.arguments({"--resume"}), fibers.here());
    wait_until([&] { return content(fibers.out("s.checkpoint")) != before || before.empty(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(pause));
    program.send(SIGKILL);
    if (program.finish().status == 128 + SIGKILL) ++killed;
  }
  const Outcome end = fibers.go({"--resume"});
  if (end.status != 0) throw std::runtime_error(end.error);
  return killed;
}

}  // namespace fiberchain::test
