#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Where the pieces of a report are from: directories of results, then the figures that come with the
/// program.
namespace fiberchain::compare {

struct SourceDirectory {
  std::filesystem::path path;
  std::string label;  ///< as the report names it
};

struct SourceFile {
  std::filesystem::path path;
  std::string label;  ///< directory's, a slash, the file's name
};

/// Directories in the order in which they are looked through.
using Sources = std::vector<SourceDirectory>;

/// The first directory's file of that name; nothing if none has it.
std::optional<SourceFile> find_source(const Sources& sources, const std::string& name);

/// All trajectories (*.h5) of the first directory that has any, in alphabetical order.
std::vector<SourceFile> find_trajectories(const Sources& sources);

/// The whole content.
/// @throws InputError naming a file that cannot be read
std::string read_source(const std::filesystem::path& path);

/// Which run has made a file, as the file itself says.
struct Origin {
  std::string file;                            ///< its label
  std::string version, commit, date, command;  ///< "" where the file does not say
};

/// Provenance in the content of an SVG (<metadata>), PNG (tEXt) or CSV (comments) of ours.
Origin origin_of(const std::string& label, const std::string& content);

/// The same from entries of key and value.
Origin origin_of(const std::string& label, const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace fiberchain::compare
