#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

#include "dem/files/atomic_file.hpp"
#include "dem/files/file_error.hpp"
#include "dem/files/numbers.hpp"
#include "dem/files/xml.hpp"
#include "dem/model/errors.hpp"
#include "dem/trajectory/vtk.hpp"

namespace fiberchain::dem {
namespace {

std::string file_name(const char* kind, std::int64_t step) {
  return fmt::format("{}-{:012}.vtp", kind, step);
}

constexpr const char* kSpheres = "spheres";
constexpr const char* kLines = "lines";
constexpr const char* kContactFiles = "contacts";
constexpr const char* kWallFiles = "walls";
constexpr const char* kKinds[] = {kSpheres, kLines, kContactFiles, kWallFiles};
constexpr const char* kSeriesHead =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<Collection>\n";
constexpr const char* kSeriesTail = "</Collection>\n</VTKFile>\n";

bool is_part(const std::string& name) {
  return std::ranges::any_of(kKinds, [&](const char* kind) {
    const std::size_t head = std::string_view(kind).size() + 1;
    if (!name.starts_with(kind) || !name.ends_with(".vtp") || name.size() < head + 12 + 4) return false;
    const auto step = parse_integer(std::string_view(name).substr(head, name.size() - head - 4));
    return step && *step >= 0 && name == file_name(kind, *step);
  });
}

/// Takes a text off the front of another; false if it does not begin so.
bool take(std::string_view& rest, std::string_view text) {
  if (!rest.starts_with(text)) return false;
  rest.remove_prefix(text.size());
  return true;
}

/// What stands before the next such mark, which is taken too; nothing without one on this line.
std::optional<std::string_view> take_until(std::string_view& rest, std::string_view mark) {
  const std::size_t end = rest.substr(0, rest.find('\n')).find(mark);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view before = rest.substr(0, end);
  rest.remove_prefix(end + mark.size());
  return before;
}

}  // namespace

std::vector<std::filesystem::path> vtk_parts(const std::filesystem::path& place) {
  std::vector<std::filesystem::path> parts;
  std::error_code ignored;  // a folder that is not there holds none
  for (const auto& entry : std::filesystem::directory_iterator(place, ignored)) {
    if (is_part(entry.path().filename().string())) parts.push_back(entry.path());
  }
  std::ranges::sort(parts);
  return parts;
}

VtkSeries::VtkSeries(std::filesystem::path directory, std::string name, VtkHeader header)
    : directory_(std::move(directory)), name_(std::move(name)), header_(std::move(header)) {}

VtkSeries VtkSeries::resume(std::filesystem::path directory, std::string name, VtkHeader header,
                            std::int64_t last_step) {
  VtkSeries series = read(std::move(directory), std::move(name), std::move(header), last_step);
  if (!series.entries_.empty()) series.write_series();
  return series;
}

VtkSeries VtkSeries::read(std::filesystem::path directory, std::string name, VtkHeader header,
                          std::int64_t last_step) {
  VtkSeries series(std::move(directory), std::move(name), std::move(header));
  series.read_series(last_step);
  return series;
}

std::optional<std::int64_t> VtkSeries::last_step() const {
  if (entries_.empty()) return std::nullopt;
  return entries_.back().step;
}

std::optional<std::filesystem::path> VtkSeries::missing_part() const {
  for (const Entry& entry : entries_) {
    for (const char* kind : {kSpheres, kLines}) {
      std::filesystem::path part = directory_ / name_ / file_name(kind, entry.step);
      if (!std::filesystem::exists(part)) return part;
    }
  }
  return std::nullopt;
}

void VtkSeries::append(const TrajectoryFrame& frame) {
  if (!entries_.empty() && frame.step <= entries_.back().step)
    throw InvalidInput(
        fmt::format("a frame of step {} after one of step {}", frame.step, entries_.back().step));
  const std::filesystem::path place = directory_ / name_;
  std::error_code error;
  std::filesystem::create_directories(place, error);
  if (error) throw WriteError(place, error.message());
  const TrajectoryFrame present = present_part(frame);
  const Entries& provenance = header_.provenance;
  replace_file(place / file_name(kSpheres, frame.step), vtp_spheres(present, provenance));
  replace_file(place / file_name(kLines, frame.step), vtp_lines(present, provenance));
  Entry entry{frame.step, frame.time};
  entry.has_contacts = frame.has_contacts;
  if (frame.has_contacts)
    replace_file(place / file_name(kContactFiles, frame.step), vtp_contacts(present, provenance));
  if (!header_.walls.empty()) {
    if (frame.walls_as_before && !entries_.empty()) entry.walls = entries_.back().walls;
    if (entry.walls < 0) {
      replace_file(place / file_name(kWallFiles, frame.step), vtp_walls(frame, header_.walls, provenance));
      entry.walls = frame.step;
    }
  }
  entries_.push_back(entry);
  try {
    write_series();
  } catch (...) {
    entries_.pop_back();
    throw;
  }
}

std::string VtkSeries::line_of(double time, std::int64_t step, const char* kind) const {
  return fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}/{}\"/>\n", time, xml_escaped(name_),
                     file_name(kind, step));
}

void VtkSeries::write_series() const {
  std::string spheres, lines, contacts, walls;
  for (const Entry& entry : entries_) {
    spheres += line_of(entry.time, entry.step, kSpheres);
    lines += line_of(entry.time, entry.step, kLines);
    if (entry.has_contacts) contacts += line_of(entry.time, entry.step, kContactFiles);
    if (entry.walls >= 0) walls += line_of(entry.time, entry.walls, kWallFiles);
  }
  const auto write = [&](const char* end, const std::string& text) {
    replace_file(directory_ / (name_ + end), kSeriesHead + text + kSeriesTail);
  };
  write(".pvd", spheres);
  write("-lines.pvd", lines);
  if (!contacts.empty()) write("-contacts.pvd", contacts);
  if (!walls.empty()) write("-walls.pvd", walls);
}

void VtkSeries::find_others(Entry& entry) const {
  const std::filesystem::path place = directory_ / name_;
  entry.has_contacts = std::filesystem::exists(place / file_name(kContactFiles, entry.step));
  if (header_.walls.empty()) return;
  if (std::filesystem::exists(place / file_name(kWallFiles, entry.step)))
    entry.walls = entry.step;
  else if (!entries_.empty())
    entry.walls = entries_.back().walls;
}

// Every line must be as this program writes it: one that was changed is an error, not left out.
void VtkSeries::read_series(std::int64_t last_step) {
  const std::filesystem::path path = directory_ / (name_ + ".pvd");
  std::ifstream file(path, std::ios::binary);
  if (!file) return;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::string_view rest = text;
  std::size_t line = 4;
  const auto fail = [&] {
    throw ReadError(path, fmt::format("line {} is not as this program wrote it", line));
  };
  if (!take(rest, kSeriesHead)) throw ReadError(path, "is no series of VTK files of this program");
  for (; rest != kSeriesTail; ++line) {
    std::string_view at = rest;
    if (!take(at, "<DataSet timestep=\"")) fail();
    const auto time = take_until(at, "\""), before = take_until(at, "/spheres-"),
               step = take_until(at, ".vtp");
    if (!time || !before || !step) fail();
    const auto seconds = parse_number(*time);
    const auto number = parse_integer(*step);
    if (!seconds || !number) fail();
    Entry entry{*number, *seconds};
    if (!take(rest, line_of(*seconds, *number, kSpheres)) ||
        (!entries_.empty() && entry.step <= entries_.back().step))
      fail();
    if (entry.step > last_step) continue;
    find_others(entry);
    entries_.push_back(entry);
  }
}

}  // namespace fiberchain::dem
