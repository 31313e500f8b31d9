#include "dem/files/numbers.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

/// Mapping "start_from" as typed.
struct StartFromKeys {
  std::string file;
  std::string frame = "last";
  StartClock clock = StartFile{}.clock;
};

KeyTable<StartFromKeys> start_from_keys() {
  KeyTable<StartFromKeys> table;
  table
      .word(
          "file", &StartFromKeys::file, "path",
          "NAME.checkpoint or NAME.h5 of a run before, from the scene's directory; its fibers are the first "
          "of their kind's `count` or `starts`")
      .required();
  table
      .word("frame", &StartFromKeys::frame, "`last`, or a whole number from 0",
            "frame of the trajectory, which knows places and velocities of the spheres only")
      .only_with("a trajectory, NAME.h5",
                 [](const StartFromKeys& keys) { return keys.file.ends_with(".h5"); });
  table.choice("clock", &StartFromKeys::clock,
               Words<StartClock>{{"as_in_file", StartClock::as_in_file}, {"zero", StartClock::zero}},
               "what time the run begins at, by which walls, batches, flow and duration count: that of the "
               "file, or 0");
  return table;
}

void store_start_from(const StrictMapping& mapping, const StartFromKeys& keys, PackingScene& scene) {
  StartFile start{.path = std::filesystem::path(mapping.file()).parent_path() / keys.file,
                  .clock = keys.clock};
  if (keys.frame != "last") {
    start.frame = parse_integer(keys.frame);
    if (!start.frame || *start.frame < 0)
      mapping.fail("frame", "is not allowed; allowed: last, or a whole number from 0");
  }
  scene.start_from = std::move(start);
}

}  // namespace

void declare_start_from(KeyTable<PackingScene>& table) {
  table
      .mapping(
          "start_from", start_from_keys(), &store_start_from,
          "go on from where a run before was, with what this scene says; `start_from: FILE` is short for "
          "`{file: FILE}`")
      .otherwise("fibers come as `fibers` and `filling` say");
}

}  // namespace fiberchain::dem
