#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Where a result comes from. Every result file carries it.
namespace fiberchain::dem {

struct Provenance {
  std::string version;        ///< of the program, as in CHANGELOG.md
  std::string commit;         ///< git commit of the build, "-dirty" if its tree was changed, or "unknown"
  std::string command;        ///< command line, shell-quoted where it needs to be
  std::string scene;          ///< path of the scene file, "" if there is none
  std::string scene_sha256;   ///< SHA-256 of its content as `sha256sum` prints it, "" if there is none
  std::string settings = {};  ///< "key=value; ..." in place of what the scene says, "" if there are none
  std::string shard = {};     ///< "2/4 of 37 cases" of a part of a study, "" of a whole one
  std::string compiler;       ///< name and version
  std::string flags;          ///< its flags
  std::string cpu;            ///< model of the processor that ran it
  std::string date;           ///< UTC, ISO 8601
};

/// Provenance of this build running that command line now. SOURCE_DATE_EPOCH, if set, stands for the
/// date, so that results can be reproduced to the byte.
Provenance collect_provenance(const std::vector<std::string>& command_line);

/// The same with the scene file's path and the hash of the text that was read from it.
Provenance with_scene(Provenance provenance, const std::filesystem::path& scene, const std::string& text);

/// Key and value of every field that is set, in the order above; control characters replaced by '?'.
std::vector<std::pair<std::string, std::string>> entries(const Provenance& provenance);

}  // namespace fiberchain::dem
