#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <iostream>
#include <string>

#include "compare/python/arrays.hpp"
#include "compare/python/bindings.hpp"
#include "compare/python/released.hpp"
#include "compare/python/scene_of.hpp"
#include "compare/scenes/cantilever.hpp"
#include "compare/scenes/flow_report.hpp"
#include "compare/scenes/packing_report.hpp"
#include "compare/scenes/release_report.hpp"
#include "compare/scenes/rod_report.hpp"
#include "compare/static/table.hpp"
#include "compare/study/stopping.hpp"
#include "dem/record/csv.hpp"
#include "dem/run/filling_watch.hpp"
#include "dem/run/run_packing.hpp"

// Scenes run as the program runs them; the study of the static cantilever.
namespace fiberchain::python {
namespace {

using MaybeFiber = std::optional<dem::Fiber>;

py::dict rest_of(dem::CantileverScene scene) {
  const compare::CantileverRest rest = released([&](const dem::StopRequest& asked) {
    scene.march.asked_to_stop = asked;
    return compare::rest_of(scene);
  });
  const double L = dem::fiber_length(scene.fiber);
  std::vector<V> positions;
  std::vector<double> angles;
  for (const compare::Station& at : rest.spheres) {
    positions.push_back({L * at.x, L * at.y, L * at.z});
    angles.push_back(at.angle);
  }
  py::dict all;
  all["kind"] = "cantilever";
  all["positions"] = array_of(std::move(positions));
  all["angles"] = array_of(std::move(angles));
  all["residual"] = rest.residual;
  all["stability"] = std::string(dem::name(rest.stability));
  all["table"] = dict_of(compare::cantilever_table(scene, rest));
  all["shape"] = dict_of(compare::shape_table(rest));
  return all;
}

py::dict rod_of(dem::RodScene scene) {
  const compare::RodRun run = released([&](const dem::StopRequest& asked) {
    scene.path.asked_to_stop = asked;
    return compare::run_rod(scene);
  });
  py::dict all;
  all["kind"] = "rod";
  all["positions"] = positions_of(run.result.last().points.back().poses);
  all["table"] = dict_of(compare::rod_table(scene, run));
  all["path"] = dict_of(compare::rod_path_table(scene, run));
  all["shapes"] = dict_of(compare::rod_shapes_table(scene, run));
  return all;
}

py::dict release_of(dem::ReleaseScene scene) {
  compare::ReleaseRun run = released([&](const dem::StopRequest& asked) {
    scene.motion.asked_to_stop = asked;
    return compare::run_release(scene);
  });
  const double L = dem::fiber_length(scene.fiber);
  py::dict all;
  all["kind"] = "release";
  all["table"] = dict_of(compare::release_table(scene, run));
  all["history"] = dict_of(compare::release_history_table(run));
  all["period"] = run.period;
  all["time_step"] = run.time_step;
  all["failure"] = run.failure;
  for (double& y : run.y) y *= L;
  for (double& z : run.z) z *= L;
  all["time"] = array_of(std::move(run.time));
  all["y"] = array_of(std::move(run.y));
  all["z"] = array_of(std::move(run.z));
  all["energy"] = array_of(std::move(run.energy));
  return all;
}

/// Shapes of a flow's history [m]: (moments, spheres, 3).
py::array shapes_of(const compare::FlowHistory& history, double length) {
  const auto moments = static_cast<py::ssize_t>(history.shapes.size()),
             spheres = moments > 0 ? static_cast<py::ssize_t>(history.shapes[0].spheres.size()) : 0;
  py::array_t<double> all({moments, spheres, py::ssize_t{3}});
  auto at = all.mutable_unchecked<3>();
  for (py::ssize_t n = 0; n < moments; ++n) {
    for (py::ssize_t i = 0; i < spheres; ++i) {
      for (py::ssize_t c = 0; c < 3; ++c)
        at(n, i, c) = length * history.shapes[static_cast<std::size_t>(n)]
                                   .spheres[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)];
    }
  }
  return all;
}

py::dict flow_of(dem::FlowScene scene) {
  const compare::FlowHistory history = released([&](const dem::StopRequest& asked) {
    scene.motion.asked_to_stop = asked;
    return compare::run_flow(scene);
  });
  std::vector<double> times;
  for (const compare::FlowShape& shape : history.shapes) times.push_back(shape.time);
  py::dict all;
  all["kind"] = "flow";
  all["table"] = dict_of(compare::flow_table(scene, history));
  all["history"] = dict_of(compare::flow_history_table(scene, history));
  all["shape_times"] = array_of(std::move(times));
  all["shapes"] = shapes_of(history, dem::fiber_length(scene.fiber));
  all["failure"] = history.record.failure;
  return all;
}

dem::EarlierRun earlier_of(const std::string& word) {
  if (word == "refuse") return dem::EarlierRun::refuse;
  if (word == "resume") return dem::EarlierRun::resume;
  if (word == "replace") return dem::EarlierRun::replace;
  throw dem::InvalidInput("earlier = " + word + " is not allowed; allowed: refuse, resume, replace");
}

py::dict packing_of(const dem::SceneText& text, const dem::PackingScene& scene, const std::string& directory,
                    int threads, const std::string& earlier) {
  const std::filesystem::path path = text.name;
  const dem::EarlierRun choice = earlier_of(earlier);
  const dem::PackingJob job{
      .text = text,
      .scene = scene,
      .files = {directory, path.stem().string()},
      .threads = threads,
      .resume = choice == dem::EarlierRun::resume,
      .provenance = dem::with_scene(dem::collect_provenance({"python"}), path, text.text)};
  const FilesInUse files;
  std::vector<std::string> messages;
  const dem::PackingEndState end = released([&](const dem::StopRequest& asked) {
    bool stopped = false;
    const auto asked_to_stop = [&] { return stopped = stopped || asked(); };
    const auto say = [&](const std::string& words) { messages.push_back(words); };
    dem::OpenedRun opened(job, choice, ": earlier='resume' goes on with it, earlier='replace' begins anew",
                          say, dem::filling_watch(asked_to_stop, say, std::cerr, false));
    const auto state = dem::run_packing_session(job, opened.begin(), {asked_to_stop, say, std::cerr, false});
    if (stopped) throw dem::Interrupted("stopped with a checkpoint");
    return state;
  });
  py::dict all;
  all["kind"] = "packing";
  all["table"] = dict_of(compare::packing_run_table(job, end));
  all["directory"] = directory;
  all["name"] = job.files.name;
  all["messages"] = messages;
  all["failure"] = end.failure;
  return all;
}

py::dict run(const std::string& content, const std::string& name, const Settings& settings,
             const MaybeFiber& fiber, const std::string& directory, int threads, const std::string& earlier) {
  const dem::SceneText text = scene_text(content, name, settings);
  dem::Scene scene = dem::parse_scene(text);
  return dem::located(text, [&]() -> py::dict {
    if (auto* packing = std::get_if<dem::PackingScene>(&scene))
      return packing_of(text, *packing, directory, threads, earlier);
    if (auto* cantilever = std::get_if<dem::CantileverScene>(&scene)) {
      if (fiber) cantilever->fiber = *fiber;
      return rest_of(*cantilever);
    }
    if (auto* release = std::get_if<dem::ReleaseScene>(&scene)) {
      if (fiber) release->fiber = *fiber;
      return release_of(*release);
    }
    if (auto* rod = std::get_if<dem::RodScene>(&scene)) {
      if (fiber) throw dem::InvalidInput("fiber is not allowed: a rod's shape is made with its own");
      return rod_of(*rod);
    }
    auto& flow = std::get<dem::FlowScene>(scene);
    if (fiber) flow.fiber = *fiber;
    return flow_of(flow);
  });
}

std::string read_scene(const std::string& path) { return dem::read_scene_text(path).text; }

py::dict static_table(const std::vector<int>& aspect_ratios, const std::vector<double>& loads,
                      const std::vector<double>& poisson_ratios, const std::vector<std::string>& bonds,
                      int jobs) {
  compare::StaticSweep sweep{.aspect_ratio = aspect_ratios, .poisson_ratio = poisson_ratios, .load = loads};
  sweep.bond.clear();
  for (const std::string& bond : bonds) {
    if (bond != "paper" && bond != "corrected")
      throw dem::InvalidInput("bond_model = " + bond + " is not allowed; allowed: paper, corrected");
    sweep.bond.push_back(bond == "paper" ? dem::BondModel::paper : dem::BondModel::corrected);
  }
  const auto points = released([&](const dem::StopRequest& asked) {
    bool stopped = false;
    compare::StaticOptions options{.jobs = jobs};
    options.stopped = [&] { return asked(); };
    auto all = compare::static_points(compare::cases(sweep), options);
    for (const auto& point : all) stopped = stopped || point.status == compare::not_begun;
    if (stopped) throw dem::Interrupted("stopped");
    return all;
  });
  return dict_of(compare::static_table(points));
}

py::dict read_table(const std::string& path) {
  return dict_of(dem::read_csv(std::filesystem::path(path)).table);
}

}  // namespace

void bind_scenes(py::module_& module) {
  module.def("run", &run, py::arg("text"), py::arg("name"), py::arg("settings"), py::arg("fiber"),
             py::arg("directory"), py::arg("threads"), py::arg("earlier"));
  module.def("read_scene", &read_scene, py::arg("path"));
  module.def("static_table", &static_table, py::arg("aspect_ratios"), py::arg("loads"),
             py::arg("poisson_ratios"), py::arg("bond_models"), py::arg("jobs"));
  module.def("read_table", &read_table, py::arg("path"));
}

}  // namespace fiberchain::python
