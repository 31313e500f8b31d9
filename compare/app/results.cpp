#include "compare/app/results.hpp"

#include <algorithm>
#include <exception>

#include "compare/figures/gnuplot.hpp"
#include "compare/study/jobs.hpp"
#include "compare/study/json.hpp"
#include "compare/study/markdown.hpp"
#include "dem/mesh/mesh_shape.hpp"
#include "dem/mesh/mesh_topology.hpp"
#include "dem/record/csv.hpp"
#include "dem/scene/implausible_values.hpp"

namespace fiberchain::app {
namespace {

std::string heading_of(const Results& results) {
  return results.notes.empty() ? results.heading : results.heading + "\n\n" + results.notes;
}

/// {"provenance": ..., "rows": [...]} and the rows of every further table under its name.
nlohmann::ordered_json json_of(const Results& results, const dem::Provenance& provenance) {
  auto document = dem::to_json(results.table, provenance);
  for (const auto& [name, table] : results.more_tables) {
    const bool of_these = name.starts_with(results.name + "-");
    document[of_these ? name.substr(results.name.size() + 1) : name] =
        dem::to_json(table, provenance)["rows"];
  }
  return document;
}

std::vector<dem::OutputFile> table_files(const Results& results, const dem::Provenance& provenance) {
  std::vector<dem::OutputFile> files = {
      {results.name + ".csv", dem::to_csv(results.table, provenance)},
      {results.name + ".md", dem::to_markdown(heading_of(results), results.table, provenance)}};
  for (const auto& [name, table] : results.more_tables)
    files.push_back({name + ".csv", dem::to_csv(table, provenance)});
  return files;
}

void write_files(const dem::OutputDirectory& directory, const std::vector<dem::OutputFile>& files,
                 const Context& context) {
  directory.write(files);
  for (const auto& file : files) context.log->info("wrote {}", (directory.path() / file.name).string());
}

using Drawing = std::function<std::vector<dem::OutputFile>()>;

/// The figures, drawn side by side; of one that could not be drawn, the throwing of its error.
std::vector<Drawing> drawn_figures(const Results& results, const OutputOptions& options,
                                   const Context& context) {
  std::vector<Drawing> drawn(results.figures.size());
  compare::Jobs(options.jobs).run(drawn.size(), [&](std::size_t i) {
    const auto& [name, figure] = results.figures[i];
    try {
      drawn[i] = [files = compare::figure_files(name, figure, context.provenance, options.style)] {
        return files;
      };
    } catch (...) {
      drawn[i] = [error = std::current_exception()]() -> std::vector<dem::OutputFile> {
        std::rethrow_exception(error);
      };
    }
  });
  return drawn;
}

/// Pictures each by itself: what one fails of, gnuplot or a full disk, is a warning.
void draw_pictures(const Results& results, const dem::OutputDirectory& directory,
                   const OutputOptions& options, const Context& context) {
  std::vector<Drawing> drawings = drawn_figures(results, options, context);
  drawings.insert(drawings.end(), results.pictures.begin(), results.pictures.end());
  std::string reason;
  std::size_t failed = 0;
  for (const auto& draw : drawings) {
    try {
      write_files(directory, draw(), context);
    } catch (const std::exception& error) {
      reason = error.what();
      ++failed;
    }
  }
  if (failed == 0) return;
  std::ranges::replace_if(
      reason, [](unsigned char c) { return c < 0x20; }, ' ');
  context.log->warn("warning: {} of {} pictures are missing, all tables are written: {}", failed,
                    drawings.size(), reason);
}

}  // namespace

std::optional<dem::OutputDirectory> open_output(const OutputOptions& options, const Context& context,
                                                Draws draws) {
  if (options.json && !options.out) return std::nullopt;
  dem::OutputDirectory directory(options.directory());
  if (draws == Draws::yes && options.figures && !options.shard) warn_without_gnuplot(context);
  context.leaving = std::make_shared<LeaveNothing>(directory.made() ? directory.path().string() : "");
  return directory;
}

void warn_of_values(const dem::SceneText& text, const Context& context) {
  for (const std::string& warning : dem::implausible_values(text)) context.log->warn("warning: {}", warning);
}

void tell_of_meshes(const dem::Scene& scene, const Context& context) {
  const auto* packing = std::get_if<dem::PackingScene>(&scene);
  if (packing == nullptr) return;
  for (const dem::Wall& wall : packing->domain.walls) {
    const dem::MeshShape* shape = dem::mesh_in(wall);
    if (shape == nullptr) continue;
    for (const std::string& note : dem::notes_on(*shape->mesh, shape->sides == dem::MeshSides::one))
      context.log->info("note: {}: {}", shape->mesh->name, note);
  }
}

void warn_without_gnuplot(const Context& context) {
  if (compare::has_gnuplot()) return;
  context.log->warn(
      "warning: gnuplot is not installed (Debian package gnuplot-nox): tables will be written, no pictures");
}

int status_of_failed(std::int64_t failed, std::string_view things, std::string_view where,
                     const Context& context) {
  if (failed == 0) return kSuccess;
  context.log->error("error: {} {} did not finish, see column status{}{}", failed, things,
                     where.empty() ? "" : " of ", where);
  return kRunFailed;
}

void deliver(const Results& results, const dem::Table& shown, const OutputOptions& options,
             const std::optional<dem::OutputDirectory>& directory, Context& context) {
  context.leaving.reset();
  if (directory) write_files(*directory, table_files(results, context.provenance), context);
  if (options.json) {
    context.out << dem::to_text(json_of(results, context.provenance));
  } else {
    context.out << dem::to_markdown(shown) << (results.notes.empty() ? "" : "\n" + results.notes);
  }
  context.out.flush();
  if (context.stopped != 0) {
    context.log->info("stopped: the rows measured are kept{}",
                      directory && options.figures ? ", no pictures are drawn" : "");
    return;
  }
  if (directory && options.figures) draw_pictures(results, *directory, options, context);
}

}  // namespace fiberchain::app
