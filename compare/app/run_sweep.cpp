#include "compare/app/run_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/app/child_process.hpp"
#include "compare/app/options.hpp"
#include "compare/app/sharded.hpp"
#include "compare/app/stop_signals.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/jobs.hpp"
#include "compare/study/json.hpp"
#include "compare/study/merge.hpp"
#include "dem/files/sha256.hpp"
#include "dem/record/output.hpp"
#include "dem/record/provenance.hpp"
#include "dem/scene/scene.hpp"

namespace fiberchain::app {
namespace {

using Json = nlohmann::ordered_json;

/// A combination, its directory and what came of it.
struct SweepRun {
  std::size_t number;  ///< in the whole sweep, from 0
  std::vector<dem::SceneSetting> settings;
  std::string directory;
  bool begun = false, failed = false, stopped = false;
  Json row = Json::object();  ///< what it ended with, by columns

  std::string name() const {
    std::string words;
    for (const dem::SceneSetting& one : settings)
      words += (words.empty() ? "" : ",") + one.key + "=" + one.value;
    return words;
  }
};

/// A name that every file system takes; with a part of its SHA-256 where it had to be changed.
std::string directory_of(const std::string& name) {
  constexpr std::size_t longest = 100;
  std::string safe = name.substr(0, longest);
  std::ranges::replace_if(
      safe,
      [](unsigned char c) {
        return std::isalnum(c) == 0 &&
               std::string_view("=,.+-_[]").find(static_cast<char>(c)) == std::string_view::npos;
      },
      '_');
  return safe == name ? safe : safe + "-" + dem::sha256(name).substr(0, 8);
}

/// The last line that a program complains in, without its beginning.
std::string complaint_in(const std::string& errors) {
  constexpr std::string_view begin = "fiberchain: error: ";
  const std::size_t at = errors.rfind(begin);
  if (at == std::string::npos) return "";
  const std::size_t from = at + begin.size();
  return errors.substr(from, errors.find('\n', from) - from);
}

std::string reason_of(const ChildEnd& end) {
  const std::string complaint = complaint_in(end.errors);
  if (!complaint.empty()) return complaint;
  return end.status > 128 ? fmt::format("ended by signal {}", end.status - 128)
                          : fmt::format("ended with status {}", end.status);
}

void take_end(SweepRun& run, const ChildEnd& end, bool stopped) {
  const Json document = Json::parse(end.out, nullptr, false);
  if (!document.is_discarded() && document.contains("rows") && !document["rows"].empty())
    run.row = document["rows"][0];
  run.begun = true;
  run.stopped = stopped && end.status > 128;
  run.failed = end.status != 0 && !run.stopped;
  if (run.stopped)
    run.row["status"] = "stopped";
  else if (run.failed)
    run.row["status"] = reason_of(end);
}

std::string csv_field(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20; }, ' ');
  if (text.find_first_of(",\"") == std::string::npos && !text.starts_with('#')) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// As the other tables: a number that is missing is nan, a text is empty.
std::string csv_cell(const Json& row, const std::string& column) {
  if (!row.contains(column)) return column == "status" ? "" : "nan";
  const Json& cell = row[column];
  if (cell.is_null()) return "nan";
  if (cell.is_string()) return csv_field(cell.get<std::string>());
  return cell.is_number_float() ? fmt::format("{}", cell.get<double>()) : cell.dump();
}

/// The columns of all rows, in the order they come in; the status last.
std::vector<std::string> columns_of(const std::vector<SweepRun>& runs) {
  std::vector<std::string> columns;
  for (const SweepRun& run : runs) {
    for (const auto& [name, cell] : run.row.items()) {
      if (name != "status" && std::ranges::find(columns, name) == columns.end()) columns.push_back(name);
    }
  }
  columns.push_back("status");
  return columns;
}

std::string sweep_csv(const std::vector<SweepRun>& runs, const dem::Provenance& provenance) {
  std::string text;
  for (const auto& [key, value] : entries(provenance)) text += fmt::format("# {}: {}\n", key, value);
  const std::vector<std::string> columns = columns_of(runs);
  const bool numbered = !provenance.shard.empty();
  std::string header = numbered ? std::string(compare::case_column) + "," : "";
  for (const dem::SceneSetting& one : runs.front().settings) header += csv_field(one.key) + ",";
  for (const std::string& column : columns) header += column + ",";
  text += header + "directory\n";
  for (const SweepRun& run : runs) {
    if (!run.begun) continue;
    if (numbered) text += fmt::format("{},", run.number + 1);
    for (const dem::SceneSetting& one : run.settings) text += csv_field(one.value) + ",";
    for (const std::string& column : columns) text += csv_cell(run.row, column) + ",";
    text += csv_field(run.directory) + "\n";
  }
  return text;
}

Json sweep_json(const std::vector<SweepRun>& runs, const dem::Provenance& provenance) {
  Json document;
  for (const auto& [key, value] : entries(provenance)) document["provenance"][key] = value;
  document["rows"] = Json::array();
  for (const SweepRun& run : runs) {
    if (!run.begun) continue;
    Json row;
    if (!provenance.shard.empty()) row[compare::case_column] = run.number + 1;
    for (const dem::SceneSetting& one : run.settings) row[one.key] = one.value;
    row.update(run.row);
    row["directory"] = run.directory;
    document["rows"].push_back(std::move(row));
  }
  return document;
}

/// The keys, then what is most asked for.
std::string sweep_markdown(const std::vector<SweepRun>& runs) {
  std::vector<std::string> shown;
  for (const std::string& column : columns_of(runs)) {
    if (shown.size() < 6 || column == "status") shown.push_back(column);
  }
  std::string header = "|", rule = "|", text;
  const auto head = [&](const std::string& name) { header += " " + name + " |", rule += "---|"; };
  for (const dem::SceneSetting& one : runs.front().settings) head(one.key);
  for (const std::string& column : shown) head(column);
  for (const SweepRun& run : runs) {
    if (!run.begun) continue;
    std::string line = "|";
    for (const dem::SceneSetting& one : run.settings) line += " " + one.value + " |";
    for (const std::string& column : shown) {
      const bool real = run.row.contains(column) && run.row[column].is_number_float();
      line += " " +
              (real ? fmt::format("{:.6g}", run.row[column].get<double>()) : csv_cell(run.row, column)) +
              " |";
    }
    text += line + "\n";
  }
  return header + "\n" + rule + "\n" + text;
}

std::vector<std::string> arguments_of(const SweepRun& run, const std::filesystem::path& scene,
                                      const std::filesystem::path& out, int threads, const Arguments& asked,
                                      bool packing) {
  std::vector<std::string> all = {"run",
                                  scene.string(),
                                  "--json",
                                  "--out",
                                  (out / run.directory).string(),
                                  "--jobs",
                                  fmt::format("{}", threads)};
  for (const dem::SceneSetting& one : run.settings) {
    all.push_back("--set");
    all.push_back(one.key + "=" + one.value);
  }
  if (!packing) return all;
  for (const char* flag : {"--resume", "--force"}) {
    if (asked.has(flag)) all.emplace_back(flag);
  }
  if (asked.has("--instruction-set"))
    all.insert(all.end(), {"--instruction-set", asked.text("--instruction-set")});
  return all;
}

/// All combinations, each a scene that can be read.
std::vector<SweepRun> runs_of(const dem::SceneText& scene, const std::vector<SweptKey>& keys) {
  std::vector<SweepRun> runs;
  for (auto& settings : combinations(keys)) {
    with_settings(scene, settings);
    runs.push_back({.number = runs.size(), .settings = std::move(settings), .directory = {}});
    runs.back().directory = directory_of(runs.back().name());
  }
  return runs;
}

int status_of(const std::vector<SweepRun>& runs, int signal, Context& context) {
  const auto failed = std::ranges::count_if(runs, &SweepRun::failed);
  const auto left = std::ranges::count_if(runs, [](const SweepRun& r) { return !r.begun || r.stopped; });
  if (failed > 0) context.log->error("error: {} of {} runs failed, see column status", failed, runs.size());
  if (signal != 0) {
    context.log->info("stopped: {} of {} runs have not ended; --resume goes on with them", left, runs.size());
    return kSignaled + signal;
  }
  return failed > 0 ? kRunFailed : kSuccess;
}

}  // namespace

int run_sweep(const dem::SceneText& scene, const std::vector<SweptKey>& keys, const Arguments& arguments,
              Context& context) {
  const OutputOptions output = output_options(arguments);
  if (arguments.has("--resume") && arguments.has("--force"))
    throw compare::InputError("--resume and --force: give one of them");
  const bool packing = std::holds_alternative<dem::PackingScene>(dem::parse_scene(scene));
  const std::vector<SweepRun> all = runs_of(scene, keys);
  std::vector<SweepRun> runs = chosen(all, deal(all.size(), output, context));
  const std::filesystem::path path = scene.name, out = output.out.value_or("results");
  const dem::OutputDirectory directory(output.directory());  // runs have theirs below `out`, of all shards
  const int at_once = std::min<int>(output.jobs, static_cast<int>(runs.size()));
  const int threads = std::max(1, output.jobs / at_once);
  context.log->info("{} runs, {} at a time", runs.size(), at_once);
  std::mutex mutex;
  const StopSignals signals;
  const std::string table = path.stem().string() + "-sweep.csv";
  const auto write = [&] { directory.write({{table, sweep_csv(runs, context.provenance)}}); };
  compare::Jobs(at_once).run(runs.size(), [&](std::size_t n) {
    if (signals.received() != 0) return;
    const ChildEnd end = run_child(arguments_of(runs[n], path, out, threads, arguments, packing),
                                   [&] { return signals.received(); });
    const std::lock_guard lock(mutex);
    take_end(runs[n], end, signals.received() != 0);
    context.log->info("{} of {}, {}: {}", n + 1, runs.size(), runs[n].name(),
                      runs[n].row.value("status", std::string("finished")));
    write();
  });
  write();
  context.log->info("wrote {}", (directory.path() / table).string());
  if (output.json)
    context.out << dem::to_text(sweep_json(runs, context.provenance));
  else
    context.out << sweep_markdown(runs);
  return status_of(runs, signals.received(), context);
}

}  // namespace fiberchain::app
