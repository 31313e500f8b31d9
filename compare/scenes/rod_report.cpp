#include "compare/scenes/rod_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "compare/study/tabulate.hpp"

namespace fiberchain::compare {
namespace {

using dem::RodPath;
using dem::RodPoint;
using dem::RodScene;
using dem::SingularKind;
using dem::SingularPoint;

/// A point of a path as its tables have it.
struct RodEntry {
  int branch;
  int number;
  const RodPoint* point;
  const SingularPoint* singular = nullptr;
};

/// Path points and singular points of the path, then of its branch.
std::vector<RodEntry> entries(const RodRun& run) {
  std::vector<RodEntry> all;
  const auto add = [&](const RodPath& path, int branch) {
    auto next = path.singular.begin();
    for (int i = 0; i < static_cast<int>(path.points.size()); ++i) {
      all.push_back({branch, i, &path.points[static_cast<std::size_t>(i)]});
      for (; next != path.singular.end() && next->after == i; ++next) {
        all.push_back({branch, i, &next->point, &*next});
      }
    }
  };
  add(run.result.path, 0);
  if (run.result.branch) add(*run.result.branch, 1);
  return all;
}

dem::NamedRow end_cells(const RodScene& scene, const RodPoint& point) {
  const double length = dem::fiber_length(scene.fiber);
  const auto& end = point.poses.back().position;
  return {{"load_factor", point.factor},
          {"end_x", end[0] / length},
          {"end_y", end[1] / length},
          {"end_z", end[2] / length},
          {"elastic_energy", point.elastic_energy},
          {"stability", std::string(name(point.stability))}};
}

/// The load factor of the first singular point of a kind, and how many there are.
std::pair<dem::Cell, std::int64_t> first_of(const RodPath& path, SingularKind kind) {
  const auto found = std::ranges::find(path.singular, kind, &SingularPoint::kind);
  const std::int64_t count = std::ranges::count(path.singular, kind, &SingularPoint::kind);
  return {found == path.singular.end() ? dem::Cell(dem::Missing{}) : dem::Cell(found->point.factor), count};
}

/// Those of the entries whose shape is recorded.
std::vector<RodEntry> recorded(const RodScene& scene, const RodRun& run) {
  std::vector<RodEntry> chosen;
  const auto wanted = [&](const RodPath& path, int number) {
    const auto last = static_cast<std::int64_t>(path.points.size()) - 1;
    if (scene.shapes == 0) return false;
    if (scene.shapes == 1) return number == last;
    // the shapes' numbers are the nearest to an even spread from the first to the last
    const std::int64_t gaps = std::min<std::int64_t>(scene.shapes - 1, std::max<std::int64_t>(last, 1));
    const std::int64_t k = (number * gaps + last / 2) / std::max<std::int64_t>(last, 1);
    return (k * last + gaps / 2) / gaps == number;
  };
  for (const RodEntry& entry : entries(run)) {
    const RodPath& path = entry.branch == 0 ? run.result.path : *run.result.branch;
    if (entry.singular || wanted(path, entry.number)) chosen.push_back(entry);
  }
  return chosen;
}

std::string rod_title(const RodScene& scene, std::string_view what) {
  return fmt::format("{}, {{/:Italic r_f}} = {:.4g}", what, dem::slenderness(scene.fiber));
}

}  // namespace

RodRun run_rod(const RodScene& scene) {
  const auto begin = std::chrono::steady_clock::now();
  RodRun run{dem::run_scene(scene), 0};
  run.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return run;
}

dem::Table rod_table(const RodScene& scene, const RodRun& run) {
  const RodPath& path = run.result.path;
  const auto [limit, limits] = first_of(path, SingularKind::limit_point);
  const auto [bifurcation, bifurcations] = first_of(path, SingularKind::bifurcation);
  const std::size_t branch = run.result.branch ? run.result.branch->points.size() : 0;
  const int iterations =
      path.newton_iterations + (run.result.branch ? run.result.branch->newton_iterations : 0);
  const dem::NamedRow asked = {{"aspect_ratio", std::llround(dem::slenderness(scene.fiber))},
                               {"poisson_ratio", dem::known(dem::poisson_ratio(scene.fiber.material))},
                               {"bond", std::string(name(scene.fiber.bond_model))},
                               {"dimension", std::string(name(scene.dimension))}};
  const dem::NamedRow way = {{"path_points", static_cast<std::int64_t>(path.points.size() + branch)},
                             {"limit_points", limits},
                             {"first_limit", limit},
                             {"bifurcations", bifurcations},
                             {"first_bifurcation", bifurcation},
                             {"iterations", std::int64_t{iterations}},
                             {"run_time", run.run_time}};
  return table_of(joined(joined(asked, end_cells(scene, run.result.last().points.back())), way));
}

dem::Table rod_path_table(const RodScene& scene, const RodRun& run) {
  const double length = dem::fiber_length(scene.fiber);
  dem::Table table({"path_branch", "path_point", "path_event", "load_factor", "path_length",
                    "probe_displacement", "end_x", "end_y", "end_z", "elastic_energy", "path_work",
                    "iterations", "stability", "negative_eigenvalues", "crossing"});
  for (const RodEntry& entry : entries(run)) {
    const RodPoint& point = *entry.point;
    const dem::NamedRow own = {
        {"path_branch", std::int64_t{entry.branch}},
        {"path_point", std::int64_t{entry.number}},
        {"path_event", entry.singular ? std::string(name(entry.singular->kind)) : std::string()},
        {"path_length", point.arc},
        {"probe_displacement", point.probe / length}};
    dem::NamedRow row = joined(own, end_cells(scene, point));
    if (entry.singular) {
      row.emplace_back("crossing", std::int64_t{entry.singular->crossing});
    } else {
      row.emplace_back("path_work", point.work);
      row.emplace_back("iterations", std::int64_t{point.iterations});
      row.emplace_back("negative_eigenvalues", std::int64_t{point.negative});
    }
    table.append(row);
  }
  return table;
}

dem::Table rod_shapes_table(const RodScene& scene, const RodRun& run) {
  const double length = dem::fiber_length(scene.fiber);
  dem::Table table({"path_branch", "path_point", "path_event", "load_factor", "sphere", "position_x",
                    "position_y", "position_z"});
  for (const RodEntry& entry : recorded(scene, run)) {
    for (std::size_t i = 0; i < entry.point->poses.size(); ++i) {
      const auto& at = entry.point->poses[i].position;
      table.append({{"path_branch", std::int64_t{entry.branch}},
                    {"path_point", std::int64_t{entry.number}},
                    {"path_event", entry.singular ? std::string(name(entry.singular->kind)) : std::string()},
                    {"load_factor", entry.point->factor},
                    {"sphere", static_cast<std::int64_t>(i)},
                    {"position_x", at[0] / length},
                    {"position_y", at[1] / length},
                    {"position_z", at[2] / length}});
    }
  }
  return table;
}

Figure rod_path_figure(const RodScene& scene, const RodRun& run) {
  const double length = dem::fiber_length(scene.fiber);
  Series path{.label = "path", .x = {}, .y = {}, .mark = Mark::line},
      branch{.label = "branch", .x = {}, .y = {}, .mark = Mark::line},
      limits{.label = "limit points", .x = {}, .y = {}, .mark = Mark::points},
      bifurcations{.label = "bifurcations", .x = {}, .y = {}, .mark = Mark::points};
  for (const RodEntry& entry : entries(run)) {
    Series& own = entry.singular ? (entry.singular->kind == SingularKind::limit_point ? limits : bifurcations)
                  : entry.branch == 0 ? path
                                      : branch;
    own.add(entry.point->probe / length, entry.point->factor);
  }
  Figure figure{.title = rod_title(scene, "Path of equilibria"),
                .x = {.label = "displacement of the probe / {/:Italic L}"},
                .y = {.label = "load factor"},
                .series = {path}};
  for (Series* more : {&branch, &limits, &bifurcations}) {
    if (!more->x.empty()) figure.series.push_back(*more);
  }
  return figure;
}

Figure rod_shapes_figure(const RodScene& scene, const RodRun& run) {
  const double length = dem::fiber_length(scene.fiber);
  Figure figure{.title = rod_title(scene, "Shapes of the rod"),
                .x = {.label = "{/:Italic x}/{/:Italic L}"},
                .y = {.label = "{/:Italic y}/{/:Italic L}"},
                .series = {}};
  figure.legend_title = "load factor";
  figure.ordered = figure.equal_axes = true;
  for (const RodEntry& entry : recorded(scene, run)) {
    Series shape{.label = fmt::format("{:.4g}", entry.point->factor), .x = {}, .y = {}, .mark = Mark::line};
    for (const auto& pose : entry.point->poses)
      shape.add(pose.position[0] / length, pose.position[1] / length);
    figure.series.push_back(std::move(shape));
  }
  return figure;
}

}  // namespace fiberchain::compare
