#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "compare/app/commands.hpp"
#include "compare/app/options.hpp"
#include "compare/report/page.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/published.hpp"
#include "dem/files/file_error.hpp"
#include "dem/record/csv.hpp"
#include "dem/record/data_directory.hpp"
#include "dem/record/output.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::app {
namespace {

namespace fs = std::filesystem;

/// The data directory that has `part`.
/// @throws compare::InputError naming where it was looked for
fs::path data_with(const std::string& part, const std::optional<fs::path>& asked) {
  const dem::DataSearch search = dem::find_data(part, asked);
  if (search.found) return *search.found;
  throw compare::InputError("no directory '" + part + "' in " + search.tried);
}

/// A command that the report runs itself, in this process.
struct QuickRun {
  Command command;
  std::map<std::string, std::string> arguments;
};

std::vector<QuickRun> quick_runs(const std::string& out, const std::string& jobs,
                                 const std::optional<fs::path>& data) {
  const std::map<std::string, std::string> shared{{"--out", out}, {"--jobs", jobs}};
  const auto with = [&](std::map<std::string, std::string> own) {
    own.insert(shared.begin(), shared.end());
    return own;
  };
  const fs::path scene = data_with("scenes", data) / "scenes" / "packing-small.yaml";
  std::map<std::string, std::string> validate;
  if (data) validate["--data"] = data->string();
  return {{run_command(), with({{"SCENE", scene.string()}, {"--force", ""}, {"--no-figures", ""}})},
          {tables_static_command(), with({})},
          {tables_damping_command(), with({})},
          {validate_command(), with(validate)}};
}

/// Runs them with their results in `out`; what they print is not of the page. True if none was stopped.
/// A run that fails leaves its part of the page to what comes with the program.
bool run_quick(const std::vector<QuickRun>& runs, Context& context) {
  std::ostream nowhere(nullptr);
  for (const QuickRun& quick : runs) {
    std::string words;
    for (const auto& [option, text] : quick.arguments)
      words += " " + (option.starts_with("--") ? option + (text.empty() ? "" : " " + text) : text);
    context.log->info("runs {}{}", quick.command.name, words);
    Context own{context.provenance, nowhere, context.bar, context.log, context.watched};
    own.provenance.command = "fiberchain " + quick.command.name + words;
    const int status = quick.command.run(Arguments(quick.arguments), own);
    context.stopped = status > kSignaled ? status - kSignaled : own.stopped;
    if (context.stopped != 0) return false;
    if (status > kCheckFailed)
      context.log->warn("warning: {} ended with status {}: see above", quick.command.name, status);
  }
  return true;
}

compare::Sources sources_of(const std::vector<std::string>& directories, const fs::path& data) {
  compare::Sources sources;
  for (const std::string& directory : directories) {
    if (!fs::is_directory(directory)) throw compare::InputError("--from: " + directory + " is no directory");
    sources.push_back({directory, directory});
  }
  sources.push_back({data / "figures", "data/figures"});
  return sources;
}

/// Rows of every validation.csv, whose files are put among the report's tables.
void read_matrix(const compare::Sources& sources, const std::vector<compare::Claim>& claims,
                 compare::Report& report) {
  std::vector<dem::Table> tables;
  for (const compare::SourceDirectory& directory : sources) {
    const auto file = compare::find_source({directory}, "validation.csv");
    if (!file) continue;
    dem::CsvDocument document = dem::read_csv(file->path);
    report.tables.push_back(compare::origin_of(file->label, document.comments));
    tables.push_back(std::move(document.table));
  }
  report.matrix = compare::matrix_entries(claims, tables);
}

/// The first trajectory that can be shown; why another cannot is said.
std::optional<compare::ReportPacking> find_packing(const compare::Sources& sources, const Context& context) {
  for (const compare::SourceFile& file : compare::find_trajectories(sources)) {
    try {
      const dem::TrajectoryReader trajectory(file.path);
      return compare::ReportPacking{.view = compare::packing_view(trajectory),
                                    .name = file.path.stem().string(),
                                    .origin = compare::origin_of(file.label, trajectory.provenance())};
    } catch (const dem::ReadError& error) {
      context.log->warn("warning: {}", error.what());
    } catch (const compare::InputError& error) {
      context.log->warn("warning: {}: {}", file.label, error.what());
    }
  }
  return std::nullopt;
}

std::vector<std::string> notes_on(const compare::Report& report) {
  std::vector<std::string> notes;
  const compare::MatrixCounts counts = compare::counts_of(report.matrix);
  if (counts.not_measured == counts.all)
    notes.push_back(
        "Nothing was measured for this page: it shows the figures that come with the program and the claims "
        "that it is held against. The command fiberchain report measures them, when it is given neither "
        "--no-run "
        "nor --from.");
  else if (counts.not_measured > 0)
    notes.push_back(fmt::format("{} of {} rows were not measured.", counts.not_measured, counts.all));
  if (!report.packing)
    notes.push_back("No packing to turn: there is no trajectory (NAME.h5) among the results.");
  return notes;
}

/// Where all of it is from, in a line a directory.
void tell_sources(const compare::Report& report, const Context& context) {
  std::map<std::string, int> files;
  const auto count = [&](const compare::Origin& origin) {
    ++files[fs::path(origin.file).parent_path().string()];
  };
  const auto count_figures = [&](const std::vector<compare::ReportFigure>& figures) {
    for (const compare::ReportFigure& figure : figures) count(figure.origin);
  };
  for (const compare::Origin& origin : report.tables) count(origin);
  for (const compare::PaperFigure& figure : report.paper) count_figures(figure.figures);
  for (const compare::ReportSection& section : report.sections) count_figures(section.figures);
  if (report.packing) count(report.packing->origin);
  for (const auto& [directory, number] : files)
    context.log->info("{} {} from {}", number, number == 1 ? "file" : "files", directory);
}

void tell_missing(const std::vector<std::string>& missing, const Context& context) {
  for (const std::string& caption : missing) context.log->info("not made: {}", caption);
}

/// Longest page that mail and browsers take without complaint.
constexpr std::size_t kMostBytes = 15'000'000;

int run_report(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  std::optional<fs::path> asked;
  if (arguments.has("--data")) asked = arguments.text("--data");
  const fs::path templates = data_with("report", asked) / "report";
  const fs::path figures = data_with("figures", asked);
  const auto claims = compare::read_all_published(compare::find_data_directory(asked));
  std::vector<std::string> directories = arguments.texts("--from");
  sources_of(directories, figures);
  const dem::OutputDirectory directory(output.out.value_or("results"));
  if (directories.empty() && !arguments.has("--no-run")) {
    const std::string out = directory.path().string();
    if (!run_quick(quick_runs(out, std::to_string(output.jobs), asked), context))
      return kSignaled + context.stopped;
    directories = {out};
  }
  const compare::Sources sources = sources_of(directories, figures);
  compare::Report report{.provenance = context.provenance,
                         .matrix = {},
                         .paper = compare::paper_figures(sources),
                         .sections = compare::report_sections(sources),
                         .packing = find_packing(sources, context),
                         .tables = {},
                         .notes = {}};
  read_matrix(sources, claims, report);
  report.notes = notes_on(report);
  const std::string page = compare::to_html(report, templates);
  directory.write({{"report.html", page}});
  tell_sources(report, context);
  for (const compare::PaperFigure& figure : report.paper) tell_missing(figure.missing, context);
  for (const compare::ReportSection& section : report.sections) tell_missing(section.missing, context);
  if (page.size() > kMostBytes)
    context.log->warn("warning: the page has {:.3g} MB", 1e-6 * static_cast<double>(page.size()));
  const compare::MatrixCounts counts = compare::counts_of(report.matrix);
  context.log->info("{} rows: {} hold, {} hold only if, {} disputed, {} fail, {} not measured", counts.all,
                    counts.holds, counts.holds_only_if, counts.disputed, counts.failed, counts.not_measured);
  context.out << (directory.path() / "report.html").string() << "\n";
  return counts.failed == 0 ? kSuccess : kCheckFailed;
}

}  // namespace

Command report_command() {
  return {
      .name = "report",
      .description = "write one page of HTML that shows what holds, with all in it",
      .footer =
          "Example:\n  fiberchain report --out report\n"
          "  fiberchain report --from validation --from tables --from packing\n"
          "Without --from it runs what is quick: packing-small.yaml, tables static and damping, validate "
          "(two "
          "minutes on\n"
          "two cores), with their results beside the page. What no directory has is taken from "
          "data/figures; the page\n"
          "says of each file where it is from. The packing is the first trajectory found. Exit status 1 if a "
          "measured\nvalue is not as expected.",
      .options =
          {{"--from", "DIR",
            "directory with results of validate, tables, bench, stability or run; may be given several "
            "times",
            OptionKind::several},
           {"--no-run", "", "run nothing: what comes with the program only, and the claims",
            OptionKind::flag},
           {"--out", "DIR", "directory for report.html [results]"},
           {"--data", "DIR", "data directory, in place of FIBERCHAIN_DATA or the program's own"},
           {"--jobs", "N", "threads [all cores]", OptionKind::text, "--threads"}},
      .run = &run_report};
}

}  // namespace fiberchain::app
