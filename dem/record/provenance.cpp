#include "dem/record/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include "dem/files/numbers.hpp"
#include "dem/files/sha256.hpp"
#include "dem/record/build_info.hpp"

namespace fiberchain::dem {
namespace {

/// The argument as a shell would have to be given it.
std::string shell_quoted(const std::string& argument) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%^";
  if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos) return argument;
  std::string quoted = "'";
  for (const char c : argument) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string utc_date() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const auto fixed = epoch ? parse_integer(epoch) : std::nullopt;
  const std::time_t now = fixed ? static_cast<std::time_t>(*fixed) : std::time(nullptr);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace

Provenance collect_provenance(const std::vector<std::string>& command_line) {
  std::vector<std::string> quoted;
  std::ranges::transform(command_line, std::back_inserter(quoted), shell_quoted);
  Provenance provenance;
  provenance.version = kVersion;
  provenance.commit = kCommit;
  provenance.command = fmt::format("{}", fmt::join(quoted, " "));
  provenance.compiler = kCompiler;
  provenance.flags = kFlags;
  provenance.cpu = cpu_model();
  provenance.date = utc_date();
  return provenance;
}

Provenance with_scene(Provenance provenance, const std::filesystem::path& scene, const std::string& text) {
  provenance.scene = scene.string();
  provenance.scene_sha256 = sha256(text);
  return provenance;
}

std::vector<std::pair<std::string, std::string>> entries(const Provenance& p) {
  std::vector<std::pair<std::string, std::string>> all = {
      {"program", "fiberchain"}, {"version", p.version}, {"commit", p.commit},
      {"command", p.command},    {"scene", p.scene},     {"scene_sha256", p.scene_sha256},
      {"set", p.settings},       {"shard", p.shard},     {"compiler", p.compiler},
      {"flags", p.flags},        {"cpu", p.cpu},         {"date", p.date}};
  std::erase_if(all, [](const auto& entry) { return entry.second.empty(); });
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  for (auto& [key, value] : all) std::ranges::replace_if(value, is_control, '?');
  return all;
}

}  // namespace fiberchain::dem
