#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <iostream>
#include <optional>

#include "dem/lammps/bench.hpp"
#include "dem/lammps/engine.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/interrupted.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/record/build_info.hpp"
#include "dem/record/errors.hpp"
#include "dem/record/provenance.hpp"
#include "dem/run/filling_watch.hpp"
#include "dem/run/run_packing.hpp"
#include "dem/scene/located_error.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/scene_settings.hpp"
#include "dem/trajectory/h5md.hpp"

// fiberchain-mpi: packings on LAMMPS over many ranks, by the scenes and with the files of fiberchain.
namespace {

using namespace fiberchain::dem;

constexpr int kSuccess = 0, kBadInput = 2, kRunFailed = 3, kSignaled = 128;

constexpr const char* kHelp =
    "fiberchain-mpi: packings on LAMMPS over many ranks\n"
    "\n"
    "  mpirun -np N fiberchain-mpi run SCENE.yaml [--out DIR] [--resume | --force] [--set KEY=VALUE]... "
    "[--tiles]\n"
    "  mpirun -np N fiberchain-mpi bench SCENE.yaml [--steps N] [--after N] [--copies N] [--set "
    "KEY=VALUE]...\n"
    "  mpirun -np N fiberchain-mpi --in SCRIPT [--scene SCENE.yaml] [--tiles]\n"
    "\n"
    "  --out DIR      directory of NAME.h5, NAME-log.csv, NAME.checkpoint [results]\n"
    "  --resume       go on from the last checkpoint in it, on any number of ranks\n"
    "  --force        begin anew, in place of a run in it\n"
    "  --set K=V      a key of the scene in place of what the file says\n"
    "  --tiles        boxes of as many spheres for each rank, in place of equal boxes\n"
    "  --steps N      of each measurement of bench: cost on 1, 2, 4, ... N ranks over fiberchain's own "
    "[1000]\n"
    "  --after N      steps before, by which fibers may have met [0]\n"
    "  --copies N     of the scene side by side, for the cost of more spheres on one rank [10]\n"
    "  --in SCRIPT    an input of LAMMPS; with --scene the fibers are there when it begins\n"
    "\n"
    "What of a scene it does not have is refused by the key's name. As linked it is under LAMMPS's license, "
    "GPL-2.\n";

struct Options {
  std::string scene, script, out = "results";
  mpi::BenchOptions costs = {};
  bool run = false, bench = false, resume = false, force = false, tiles = false, help = false,
       version = false;
  std::vector<SceneSetting> settings;
};

/// @throws InputError for what is no number from 0 (of steps before), or 1, to 10^9
std::int64_t count_of(const std::string& word, const std::string& typed) {
  std::int64_t number = -1;
  const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
  const std::int64_t least = word == "--after" ? 0 : 1;
  if (error != std::errc() || end != typed.data() + typed.size() || number < least || number > 1000000000)
    throw InputError(
        fmt::format("{}: '{}' is not allowed: give a number from {} to 1000000000", word, typed, least));
  return number;
}

Options options_of(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t n = 0; n < words.size(); ++n) {
    const std::string& word = words[n];
    const auto value = [&] {
      if (n + 1 == words.size()) throw InputError(word + " wants a value (see --help)");
      return words[++n];
    };
    const bool first = !options.run && !options.bench && options.scene.empty();
    if ((word == "run" || word == "bench") && first) {
      (word == "run" ? options.run : options.bench) = true;
    } else if (word == "--steps" || word == "--after" || word == "--copies") {
      const std::int64_t number = count_of(word, value());
      if (word == "--copies") options.costs.copies = static_cast<int>(number);
      if (word != "--copies") (word == "--steps" ? options.costs.steps : options.costs.after) = number;
    } else if (word == "--out") {
      options.out = value();
    } else if (word == "--in") {
      options.script = value();
    } else if (word == "--scene") {
      options.scene = value();
    } else if (word == "--set") {
      const std::string typed = value();
      const std::size_t equals = typed.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError(fmt::format("--set: '{}' is not allowed: give KEY=VALUE", typed));
      options.settings.push_back({typed.substr(0, equals), typed.substr(equals + 1)});
    } else if (word == "--resume" || word == "--force" || word == "--tiles" || word == "--help" ||
               word == "--version") {
      (word == "--resume"  ? options.resume
       : word == "--force" ? options.force
       : word == "--tiles" ? options.tiles
       : word == "--help"  ? options.help
                           : options.version) = true;
    } else if ((options.run || options.bench) && options.scene.empty() && !word.starts_with('-')) {
      options.scene = word;
    } else {
      throw InputError(fmt::format("'{}' is not allowed (see --help)", word));
    }
  }
  if (options.help || options.version) return options;
  if ((options.run || options.bench) == !options.script.empty())
    throw InputError("give run SCENE.yaml, bench SCENE.yaml or --in SCRIPT (see --help)");
  if (options.script.empty() && options.scene.empty())
    throw InputError("run and bench: give a scene (see --help)");
  if (options.resume && options.force) throw InputError("--resume and --force: give one of them");
  return options;
}

volatile std::sig_atomic_t received = 0;

extern "C" void receive(int signal) { received = signal; }

void say(const std::string& words) { std::cerr << "fiberchain-mpi: " << words << std::endl; }

PackingScene packing_of(const SceneText& text) {
  const Scene scene = parse_scene(text);
  if (const auto* packing = std::get_if<PackingScene>(&scene)) return *packing;
  throw InputError(text.name + ": is no packing: fiberchain runs it");
}

EarlierRun earlier_of(const Options& options) {
  if (options.resume) return EarlierRun::resume;
  return options.force ? EarlierRun::replace : EarlierRun::refuse;
}

void say_end(const PackingEndState& end) {
  say(fmt::format("step {} of {}, t = {:.6g} s: {} contacts, height {:.9g} m, bending {:.6g} rad, {:.3g} s",
                  end.last.step, end.steps, end.last.time, end.last.contacts, end.last.height,
                  end.last.bending_mean, end.run_time));
}

/// Rank 0 of a run, while the others serve.
int run(const Options& options, const SceneText& text, const PackingScene& scene, mpi::Engine& engine,
        Provenance provenance) {
  const std::filesystem::path path = text.name;
  provenance.version += " on LAMMPS";
  provenance.settings = in_words(text.settings);
  const PackingJob job{.text = text,
                       .scene = scene,
                       .files = {options.out, path.stem().string()},
                       .threads = 1,
                       .resume = options.resume,
                       .provenance = with_scene(std::move(provenance), path, text.text)};
  const auto asked_to_stop = [] { return received != 0; };
  OpenedRun opened(job, earlier_of(options), ": --resume goes on with it, --force begins anew", say,
                   filling_watch(asked_to_stop, say, std::cerr, false));
  RunBegin begin = opened.begin();
  if (begin.assembly.integrator() != Integrator::leapfrog)
    throw InvalidKey(
        "motion.integrator",
        "motion.integrator = automatic is not allowed here: it chooses bonds that are solved for, which "
        "want a fiber whole on one rank");
  const PackingEndState end = run_packing_session(
      job, std::move(begin),
      {.asked_to_stop = asked_to_stop,
       .say = say,
       .terminal = std::cerr,
       .watched = false,
       .march = [&](Assembly& assembly, std::int64_t steps) { engine.march(assembly, steps); }});
  if (!end.failure.empty()) throw Diverged(end.failure);
  say_end(end);
  if (const auto spread = engine.spread(); spread.most > 0)
    say(fmt::format("{} spheres on the fullest rank, {} ghosts on all", spread.most, spread.ghosts));
  if (end.finished()) return kSuccess;
  say(fmt::format("stopped; --resume goes on from step {}", end.checkpointed));
  return kSignaled + received;
}

int report(const std::exception& error, int status) {
  std::string message = error.what();
  std::ranges::replace_if(
      message, [](unsigned char c) { return c < 0x20; }, ' ');
  std::cerr << "fiberchain-mpi: error: " << message << std::endl;
  return status;
}

/// Exit status of what goes wrong, which all ranks meet alike or rank 0 alone; one of them says it.
template <class Work>
int guarded(bool says, const Work& work) {
  const auto failed = [&](const std::exception& error, int status) {
    return says ? report(error, status) : status;
  };
  try {
    return work();
  } catch (const InputError& error) {
    return failed(error, kBadInput);
  } catch (const SceneError& error) {
    return failed(error, kBadInput);
  } catch (const InvalidInput& error) {
    return failed(error, kBadInput);
  } catch (const Interrupted& error) {
    return failed(error, kSignaled + received);
  } catch (const std::exception& error) {
    return failed(error, kRunFailed);
  }
}

int work(const std::vector<std::string>& words, int me) {
  const Options options = options_of({words.begin() + 1, words.end()});
  if (options.help || options.version) {
    if (me == 0)
      std::cout << (options.help ? std::string(kHelp)
                                 : fmt::format("fiberchain-mpi {} (commit {})\n", kVersion, kCommit));
    return kSuccess;
  }
  std::optional<SceneText> text;
  PackingScene scene;
  if (!options.scene.empty()) {
    text = read_scene_text(options.scene);
    text->settings = options.settings;
    scene = packing_of(*text);
  }
  const auto go = [&] {
    if (options.bench) {
      const std::string table = mpi::scaling_table(MPI_COMM_WORLD, scene, options.costs);
      if (me == 0) std::cout << table;
      return kSuccess;
    }
    mpi::Engine engine(MPI_COMM_WORLD, scene, options.tiles ? mpi::Sharing::tiles : mpi::Sharing::bricks);
    int status = kSuccess;
    if (me != 0) {
      if (text) engine.serve();
    } else if (text) {
      status = guarded(true, [&] {
        return located(*text, [&] {
          if (options.run) return run(options, *text, scene, engine, collect_provenance(words));
          engine.send_out(make_assembly(packing_start(scene, 1)));
          return kSuccess;
        });
      });
      engine.dismiss();
    }
    MPI_Bcast(&status, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (status == kSuccess && !options.script.empty()) engine.run_script(options.script);
    return status;
  };
  return text ? located(*text, go) : go();
}

}  // namespace

int main(int count, char** arguments) {
  MPI_Init(&count, &arguments);
  leave_hdf5_as_it_is_at_exit();
  int me = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  std::signal(SIGINT, receive), std::signal(SIGTERM, receive);
  std::signal(SIGPIPE, SIG_IGN), std::signal(SIGXFSZ, SIG_IGN);
  const int status = guarded(me == 0, [&] { return work({arguments, arguments + count}, me); });
  MPI_Finalize();
  return status;
}
