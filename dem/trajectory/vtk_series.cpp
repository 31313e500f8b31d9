#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
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

constexpr const char* kKinds[] = {"spheres", "lines"};

bool is_part(const std::string& name) {
  static const std::regex pattern("(spheres|lines)-[0-9]{12,}\\.vtp");
  return std::regex_match(name, pattern);
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

VtkSeries::VtkSeries(std::filesystem::path directory, std::string name, Entries provenance)
    : directory_(std::move(directory)), name_(std::move(name)), provenance_(std::move(provenance)) {}

VtkSeries VtkSeries::resume(std::filesystem::path directory, std::string name, Entries provenance,
                            std::int64_t last_step) {
  VtkSeries series(std::move(directory), std::move(name), std::move(provenance));
  series.read_series(last_step);
  if (!series.entries_.empty()) series.write_series();
  return series;
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
  replace_file(place / file_name("spheres", frame.step), vtp_spheres(present, provenance_));
  replace_file(place / file_name("lines", frame.step), vtp_lines(present, provenance_));
  entries_.push_back({frame.step, frame.time});
  try {
    write_series();
  } catch (...) {
    entries_.pop_back();
    throw;
  }
}

void VtkSeries::write_series() const {
  for (const char* kind : kKinds) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const Entry& entry : entries_) {
      text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}/{}\"/>\n", entry.time,
                          xml_escaped(name_), file_name(kind, entry.step));
    }
    const bool lines = kind == kKinds[1];
    replace_file(directory_ / (name_ + (lines ? "-lines.pvd" : ".pvd")),
                 text + "</Collection>\n</VTKFile>\n");
  }
}

void VtkSeries::read_series(std::int64_t last_step) {
  const std::filesystem::path path = directory_ / (name_ + ".pvd");
  std::ifstream file(path, std::ios::binary);
  if (!file) return;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.find("type=\"Collection\"") == std::string::npos || text.find("</VTKFile>") == std::string::npos)
    throw ReadError(path, "is no series of VTK files");
  const std::regex pattern(
      "<DataSet timestep=\"([^\"]*)\" part=\"0\" file=\"[^\"]*/spheres-([0-9]+).vtp\"/>");
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
    const auto time = parse_number((*at)[1].str());
    const auto step = parse_integer((*at)[2].str());
    if (!time || !step) throw ReadError(path, "is no series of VTK files that this program wrote");
    if (*step <= last_step) entries_.push_back({*step, *time});
  }
}

}  // namespace fiberchain::dem
