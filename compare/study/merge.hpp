#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "compare/study/shard.hpp"
#include "dem/record/output.hpp"

// Tables that shards of a study have written become the tables of the whole.
namespace fiberchain::compare {

/// Column that rows of shards have in front: the number of their case in the whole, from 1.
inline constexpr std::string_view case_column = "case";

/// Provenance entry of a shard's files: "2/4 of 37 cases".
std::string shard_words(const Shard& shard, std::size_t cases);

/// Directory of a shard's files below the one asked for: "shard-2-of-4".
std::string shard_directory(const Shard& shard);

/// A CSV file as text: what is written again has the digits that were read.
struct TextTable {
  std::vector<std::pair<std::string, std::string>> provenance;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct MergedTable {
  std::string file;  ///< its name
  TextTable table;   ///< without case_column
};

struct Merged {
  std::vector<MergedTable> tables;              ///< by name
  std::vector<std::filesystem::path> pictures;  ///< of parts, to be copied
  std::size_t cases;
};

/// The tables of all shards of one command, their rows in the order of the whole. Tables that do not depend
/// on the cases are taken from the one shard that has them. Provenance entries on which all shards agree
/// stay; those that differ stand behind "shard I/N ".
/// @throws InputError naming what does not belong together: a directory without tables of a shard, shards of
///   other commits (both named), commands, scenes or numbers of shards; one that is missing or comes twice; a
///   case that does
Merged merge_shards(const std::vector<std::filesystem::path>& directories);

/// The table as the program writes CSV.
std::string to_csv(const TextTable& table);

}  // namespace fiberchain::compare
