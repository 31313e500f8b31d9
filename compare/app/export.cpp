#include <fmt/format.h>
#include <unistd.h>

#include "compare/app/commands.hpp"
#include "compare/app/open_trajectory.hpp"
#include "compare/app/options.hpp"
#include "dem/files/atomic_file.hpp"
#include "dem/files/file_error.hpp"
#include "dem/record/output.hpp"
#include "dem/trajectory/atom_files.hpp"
#include "dem/trajectory/vtk.hpp"

namespace fiberchain::app {
namespace {

struct AtomFormat {
  const char* suffix;
  std::string (*frame)(const dem::TrajectoryFrame&);  ///< null for VTK, which is many files
};

const std::vector<std::pair<std::string, AtomFormat>> kFormats = {
    {"lammps", {".lammpstrj", &dem::lammps_frame}},
    {"xyz", {".xyz", &dem::extended_xyz_frame}},
    {"vtk", {".pvd", nullptr}}};

void append(const std::filesystem::path& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "ab");
  const bool good = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (file == nullptr || std::fclose(file) != 0 || !good) throw dem::WriteError(path, "no room");
}

/// NAME.pvd and the files it names, as a run writes them.
void write_vtk(const dem::TrajectoryReader& trajectory, const std::vector<std::int64_t>& frames,
               const std::filesystem::path& directory, const std::string& name) {
  dem::VtkSeries series(directory, name,
                        {.provenance = trajectory.provenance(), .walls = trajectory.walls()});
  for (const std::int64_t n : frames) series.append(trajectory.read(n));
}

int run_export(const Arguments& arguments, Context& context) {
  const AtomFormat format = choice(arguments, "--format", kFormats.front().second, kFormats);
  const dem::TrajectoryReader trajectory = open_trajectory(arguments);
  const std::vector<std::int64_t> frames = frames_of(arguments, "--frames", trajectory);
  const dem::OutputDirectory directory(arguments.has("--out") ? arguments.text("--out") : "results");
  const std::string name = std::filesystem::path(arguments.text("FILE")).stem().string();
  const std::filesystem::path path = directory.path() / (name + format.suffix);
  if (format.frame == nullptr) {
    write_vtk(trajectory, frames, directory.path(), name);
  } else {
    dem::AtomicFile file(path);
    for (const std::int64_t n : frames) append(file.staged(), format.frame(trajectory.read(n)));
    file.close();
    file.take_place();
  }
  context.log->info("wrote {}", path.string());
  context.out << fmt::format("{} frames of {}\n", frames.size(), trajectory.frames());
  return kSuccess;
}

}  // namespace

Command export_command() {
  return {.name = "export",
          .description = "write a trajectory for OVITO, VMD, ASE or ParaView",
          .footer = "Example:\n  fiberchain export packing/packing.h5 --format lammps",
          .options = {{"FILE", "", "trajectory (H5MD), also of a run in progress", OptionKind::required},
                      {"--format", "NAME", "lammps (dump), xyz (extended) or vtk (PolyData) [lammps]"},
                      {"--frames", "N", "number of a frame from 0, FROM..TO, last or all [all]"},
                      {"--out", "DIR", "directory for the file [results]"}},
          .run = &run_export};
}

}  // namespace fiberchain::app
