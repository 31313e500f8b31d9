#include <fmt/format.h>

#include "compare/app/commands.hpp"
#include "compare/app/open_trajectory.hpp"
#include "compare/app/options.hpp"
#include "compare/figures/gnuplot.hpp"
#include "compare/render/film.hpp"
#include "compare/render/picture.hpp"
#include "compare/study/errors.hpp"
#include "dem/record/output.hpp"

namespace fiberchain::app {
namespace {

constexpr int kFilmRate = 15;  ///< pictures a second

std::vector<std::pair<std::string, std::string>> shade_choices() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const compare::Shade& shade : compare::shades()) all.emplace_back(shade.name, shade.name);
  return all;
}

std::string shade_words() {
  std::vector<std::string> names;
  for (const compare::Shade& shade : compare::shades()) names.push_back(shade.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

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
  options.shade = choice(arguments, "--color", options.shade, shade_choices());
  options.range = pair_of(arguments, "--range");
  if (options.range && !(options.range->first < options.range->second))
    throw compare::InputError(fmt::format("--range: '{}' does not rise", arguments.text("--range")));
  read_number(arguments, "--azimuth", {.low = -360, .high = 360}, options.view.azimuth);
  read_number(arguments, "--elevation", {.low = 0, .high = 89}, options.view.elevation);
  read_number(arguments, "--width", {.low = 160, .high = 8192}, options.width);
  read_number(arguments, "--height", {.low = 100, .high = 8192}, options.height);
  return options;
}

/// Those of --frame or --frames: the last without both.
std::vector<std::int64_t> asked_frames(const Arguments& arguments, const dem::TrajectoryReader& trajectory) {
  if (arguments.has("--frame") && arguments.has("--frames"))
    throw compare::InputError("--frame and --frames exclude each other");
  if (arguments.has("--frames")) return frames_of(arguments, "--frames", trajectory);
  const std::vector<std::int64_t> frames = frames_of(arguments, "--frame", trajectory);
  return arguments.has("--frame") ? frames : std::vector<std::int64_t>{frames.back()};
}

/// One color scale and one box for all of these frames.
void share_scale(const dem::TrajectoryReader& trajectory, const std::vector<std::int64_t>& frames,
                 compare::PictureOptions& options) {
  const compare::Shade& shade = compare::shade_named(options.shade);
  std::optional<std::pair<double, double>> range = options.range;
  for (const std::int64_t n : frames) {
    const dem::TrajectoryFrame frame = trajectory.read(n);
    if (frame.position.empty()) continue;
    const compare::Bounds shown = compare::shown_bounds({&frame, 1}, options.walls);
    options.shown = options.shown ? compare::joined(*options.shown, shown) : shown;
    if (options.range) continue;
    const auto own = compare::shade_range({&frame, 1}, shade);
    range = range ? std::pair{std::min(range->first, own.first), std::max(range->second, own.second)} : own;
  }
  options.range = range;
}

/// What color scales leave out, in words.
std::string beyond_words(const compare::Picture& picture) {
  if (picture.below + picture.above == 0) return "";
  return fmt::format(", {} spheres below it and {} above", picture.below, picture.above);
}

std::string picture_name(const std::filesystem::path& file, const std::string& number,
                         const compare::PictureOptions& options) {
  return fmt::format("{}-{}-{}.png", file.stem().string(), number, options.shade);
}

void need_gnuplot() {
  if (compare::has_gnuplot()) return;
  throw compare::FigureError("gnuplot, which sets the texts, is not installed (Debian package gnuplot-nox)");
}

void film_frames(const dem::OutputDirectory& directory, const std::filesystem::path& path, std::int64_t first,
                 const compare::PictureOptions& options, const Context& context) {
  if (!compare::has_ffmpeg()) {
    context.log->info("no film: ffmpeg is not installed (Debian package ffmpeg)");
    return;
  }
  const std::filesystem::path film =
      directory.path() / fmt::format("{}-{}.mp4", path.stem().string(), options.shade);
  compare::make_film(directory.path() / picture_name(path, "%04d", options), first, kFilmRate, film);
  context.log->info("wrote {}", film.string());
}

int run_render(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  compare::PictureOptions options = picture_options(arguments);
  options.threads = output.jobs;
  const std::filesystem::path path = arguments.text("FILE");
  const dem::TrajectoryReader trajectory = open_trajectory(arguments);
  const std::vector<std::int64_t> frames = asked_frames(arguments, trajectory);
  need_gnuplot();
  const dem::OutputDirectory directory(output.out.value_or("results"));
  options.walls = trajectory.walls();
  if (frames.size() > 1) share_scale(trajectory, frames, options);
  const std::string unit = compare::shade_named(options.shade).unit;
  for (const std::int64_t n : frames) {
    const dem::TrajectoryFrame frame = trajectory.read(n);
    if (options.shade == "contact_force" && !frame.has_contacts)
      throw compare::InputError(fmt::format("--color: {} has no contacts (output.contacts)", path.string()));
    const compare::Picture picture = compare::draw(frame, options, context.provenance);
    const std::string name = picture_name(path, fmt::format("{:04}", n), options);
    directory.write({{name, picture.png}});
    context.log->info("wrote {}", (directory.path() / name).string());
    context.out << fmt::format(
        "frame {} of {}, step {}, time {:.6g} s, {} spheres, color scale from {:.6g} to {:.6g}{}{}{}\n", n,
        trajectory.frames(), frame.step, frame.time, frame.position.size(), picture.range.first,
        picture.range.second, unit.empty() ? "" : " ", unit, beyond_words(picture));
  }
  if (frames.size() > 1) film_frames(directory, path, frames.front(), options, context);
  return kSuccess;
}

}  // namespace

Command render_command() {
  return {
      .name = "render",
      .description = "draw frames of a trajectory to PNG, and a film of them, without a display",
      .footer =
          "Example:\n  fiberchain render packing/packing.h5 --frame last --color vertical_speed --range "
          "-0.5,0.5\n  fiberchain render drum/drum.h5 --frames all --color velocity\n\nWalls are drawn as "
          "panes, the box is cut to what is there. Several frames have one color scale; of them "
          "ffmpeg, where it is installed, makes NAME-COLOR.mp4.",
      .options = {{"FILE", "", "trajectory (H5MD), also of a run in progress", OptionKind::required},
                  {"--frame", "N", "number of the frame from 0, or last [last]"},
                  {"--frames", "N", "several: all, or FROM..TO"},
                  {"--color", "NAME", shade_words() + " [vertical_speed]"},
                  {"--range", "LOW,HIGH",
                   "ends of the color scale [those of the data, without their lowest and highest half "
                   "percent]; triangles at them tell of values beyond"},
                  {"--azimuth", "DEGREES", "of the camera about the vertical, from the x axis [-60]"},
                  {"--elevation", "DEGREES", "of the camera above the horizontal [18]"},
                  {"--width", "PIXELS", "of the picture [1280]"},
                  {"--height", "PIXELS", "of the picture [800]"},
                  {"--out", "DIR", "directory for the picture [results]"},
                  {"--jobs", "N", "threads [all cores]"}},
      .run = &run_render};
}

}  // namespace fiberchain::app
