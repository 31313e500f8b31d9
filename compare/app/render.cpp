#include <fmt/format.h>

#include "compare/app/commands.hpp"
#include "compare/app/options.hpp"
#include "compare/figures/gnuplot.hpp"
#include "compare/render/picture.hpp"
#include "compare/study/errors.hpp"
#include "dem/record/output.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::pair<std::string, compare::Shade>> kShades = {
    {"vertical_speed", compare::Shade::vertical_speed}, {"bending_angle", compare::Shade::bending_angle}};

/// Exactly two numbers, or nothing if the option was not typed.
std::optional<std::pair<double, double>> pair_of(const Arguments& arguments, const std::string& option) {
  if (!arguments.has(option)) return std::nullopt;
  std::vector<double> values;
  read_list(arguments, option, {}, values);
  if (values.size() != 2)
    throw compare::InputError(
        fmt::format("{}: '{}' wants two numbers, joined by a comma", option, arguments.text(option)));
  return std::pair{values[0], values[1]};
}

compare::PictureOptions picture_options(const Arguments& arguments) {
  compare::PictureOptions options;
  std::vector<compare::Shade> shades = {options.shade};
  read_choices(arguments, "--color", shades, kShades);
  if (shades.size() != 1)
    throw compare::InputError(
        fmt::format("--color: '{}' is more than one choice", arguments.text("--color")));
  options.shade = shades.front();
  options.range = pair_of(arguments, "--range");
  if (options.range && !(options.range->first < options.range->second))
    throw compare::InputError(fmt::format("--range: '{}' does not rise", arguments.text("--range")));
  read_number(arguments, "--azimuth", {.low = -360, .high = 360}, options.view.azimuth);
  read_number(arguments, "--elevation", {.low = 0, .high = 89}, options.view.elevation);
  read_number(arguments, "--width", {.low = 160, .high = 8192}, options.width);
  read_number(arguments, "--height", {.low = 100, .high = 8192}, options.height);
  return options;
}

/// Number of the frame asked for.
/// @throws compare::InputError if the trajectory has no such frame
std::int64_t frame_of(const Arguments& arguments, const dem::TrajectoryReader& trajectory) {
  const std::int64_t last = trajectory.frames() - 1;
  if (last < 0) throw compare::InputError(arguments.text("FILE") + ": holds no frame yet");
  if (!arguments.has("--frame") || arguments.text("--frame") == "last") return last;
  int frame = 0;
  read_number(arguments, "--frame", {.low = 0, .high = static_cast<double>(last)}, frame);
  return frame;
}

dem::TrajectoryReader open_trajectory(const std::filesystem::path& path) {
  try {
    return dem::TrajectoryReader(path);
  } catch (const dem::ReadError& error) {
    throw compare::InputError(error.what());
  }
}

int run_render(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  compare::PictureOptions options = picture_options(arguments);
  options.threads = output.jobs;
  const std::filesystem::path path = arguments.text("FILE");
  const dem::TrajectoryReader trajectory = open_trajectory(path);
  const std::int64_t n = frame_of(arguments, trajectory);
  if (!compare::has_gnuplot())
    throw compare::FigureError(
        "gnuplot, which sets the texts, is not installed (Debian package gnuplot-nox)");
  const dem::OutputDirectory directory(output.out.value_or("results"));
  const dem::TrajectoryFrame frame = trajectory.read(n);
  const compare::Picture picture = compare::draw(frame, options, context.provenance);
  const std::string color = arguments.has("--color") ? arguments.text("--color") : kShades.front().first;
  const std::string name = fmt::format("{}-{:04}-{}.png", path.stem().string(), n, color);
  directory.write({{name, picture.png}});
  context.log->info("wrote {}", (directory.path() / name).string());
  context.out << fmt::format(
      "frame {} of {}, step {}, time {:.6g} s, {} spheres, color scale from {:.6g} to {:.6g} {}\n", n,
      trajectory.frames(), frame.step, frame.time, frame.position.size(), picture.range.first,
      picture.range.second, options.shade == compare::Shade::vertical_speed ? "m/s" : "rad");
  return kSuccess;
}

}  // namespace

Command render_command() {
  return {.name = "render",
          .description = "draw a frame of a trajectory to PNG, without a display",
          .footer =
              "Example:\n  fiberchain render packing/packing.h5 --frame last --color vertical_speed --range "
              "-0.5,0.5",
          .options = {{"FILE", "", "trajectory (H5MD), also of a run in progress", OptionKind::required},
                      {"--frame", "N", "number of the frame from 0, or last [last]"},
                      {"--color", "NAME", "vertical_speed or bending_angle [vertical_speed]"},
                      {"--range", "LOW,HIGH",
                       "ends of the color scale, m/s or rad [those of the data, without their "
                       "lowest and highest half percent]"},
                      {"--azimuth", "DEGREES", "of the camera about the vertical, from the x axis [-60]"},
                      {"--elevation", "DEGREES", "of the camera above the horizontal [18]"},
                      {"--width", "PIXELS", "of the picture [1280]"},
                      {"--height", "PIXELS", "of the picture [800]"},
                      {"--out", "DIR", "directory for the picture [results]"},
                      {"--jobs", "N", "threads [all cores]"}},
          .run = &run_render};
}

}  // namespace fiberchain::app
