#include "compare/study/merge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <regex>

#include "compare/study/errors.hpp"
#include "dem/files/csv_reader.hpp"
#include "dem/files/numbers.hpp"
#include "dem/record/csv.hpp"

namespace fiberchain::compare {
namespace {

namespace fs = std::filesystem;

struct Part {
  fs::path directory;
  Shard shard;
  std::size_t cases = 0;
  std::map<std::string, TextTable> tables;  ///< by the name of their file
};

std::optional<std::string> entry(const TextTable& table, std::string_view key) {
  const auto found = std::ranges::find(table.provenance, key, &std::pair<std::string, std::string>::first);
  return found == table.provenance.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> case_index(const TextTable& table) {
  const auto found = std::ranges::find(table.columns, case_column);
  if (found == table.columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.columns.begin());
}

TextTable read_table(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path.string() + ": cannot read this file");
  dem::CsvReader reader(file, path.string(), [](const std::string& what) { throw InputError(what); });
  TextTable table;
  auto record = reader.record();
  if (!record) reader.fail("no header: the file holds no table");
  table.columns = *record;
  table.provenance = dem::csv_comments(reader);
  std::erase_if(table.provenance, [](const auto& entry) { return entry.first.empty(); });
  while ((record = reader.record())) {
    if (record->size() != table.columns.size())
      reader.fail(fmt::format("{} fields where the header has {}", record->size(), table.columns.size()));
    table.rows.push_back(std::move(*record));
  }
  return table;
}

/// What a part's provenance says it is: "2/4 of 37 cases".
void take_shard(Part& part, const fs::path& path, const std::string& words) {
  static const std::regex form(R"((\d+/\d+) of (\d+) cases)");
  std::smatch match;
  if (!std::regex_match(words, match, form))
    throw InputError(
        fmt::format("{}: '# shard: {}' is not allowed: want I/N of M cases", path.string(), words));
  part.shard = parse_shard(path.string(), match[1].str());
  part.cases = static_cast<std::size_t>(dem::parse_integer(match[2].str()).value_or(0));
}

Part read_part(const fs::path& directory) {
  if (!fs::is_directory(directory))
    throw InputError(directory.string() + ": there is no such directory; give those that --shard has made");
  Part part{.directory = directory, .shard = {}, .tables = {}};
  for (const auto& file : fs::directory_iterator(directory)) {
    if (file.path().extension() != ".csv") continue;
    TextTable table = read_table(file.path());
    const auto words = entry(table, "shard");
    if (!words) throw InputError(file.path().string() + ": is of no shard: made without --shard");
    const Part before = part;
    take_shard(part, file.path(), *words);
    if (!part.tables.empty() && (before.shard != part.shard || before.cases != part.cases))
      throw InputError(directory.string() + ": has tables of several shards");
    part.tables.emplace(file.path().filename().string(), std::move(table));
  }
  if (part.tables.empty()) throw InputError(directory.string() + ": has no tables");
  return part;
}

/// The command without what may differ from shard to shard: the program's path, where it runs and writes.
std::string asked(std::string command) {
  static const std::regex placing(
      R"( (--shard|--out|--jobs|--threads|--figure-format)[ =]('[^']*'|[^ ]+)| (--json|--no-figures|--no-title|--resume|--force)(?= |$))");
  command = std::regex_replace(command, placing, "");
  const std::size_t space = command.find(' ');
  return space == std::string::npos ? "" : command.substr(space + 1);
}

/// What all tables must agree on, by its key.
std::string common(const TextTable& table, const std::string& key) {
  const std::string text = entry(table, key).value_or("");
  return key == "command" ? asked(text) : text;
}

void check_same(const Part& one, const Part& other) {
  const TextTable& first = one.tables.begin()->second;
  for (const auto& [file, table] : other.tables) {
    for (const char* key : {"commit", "version", "command", "scene_sha256", "set"}) {
      const std::string a = common(first, key), b = common(table, key);
      if (a != b)
        throw InputError(fmt::format("{} of {} is '{}', of {} '{}': parts of one whole have the same", key,
                                     one.directory.string(), a, (other.directory / file).string(), b));
    }
  }
  if (one.cases != other.cases || one.shard.count != other.shard.count)
    throw InputError(fmt::format("{} is shard {} of {} cases, {} shard {} of {}: not of one whole",
                                 one.directory.string(), to_string(one.shard), one.cases,
                                 other.directory.string(), to_string(other.shard), other.cases));
}

/// Every shard once, in their order.
void check_all_there(std::vector<Part>& parts) {
  std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.shard.index; });
  for (std::size_t n = 1; n < parts.size(); ++n) {
    if (parts[n].shard == parts[n - 1].shard)
      throw InputError(fmt::format("shard {} comes twice: {} and {}", to_string(parts[n].shard),
                                   parts[n - 1].directory.string(), parts[n].directory.string()));
  }
  std::vector<std::string> missing;
  auto part = parts.begin();
  for (int index = 1; index <= parts.front().shard.count; ++index) {
    if (part != parts.end() && part->shard.index == index)
      ++part;
    else if (missing.size() < 10)
      missing.push_back(to_string({index, parts.front().shard.count}));
  }
  if (!missing.empty()) throw InputError(fmt::format("shards are missing: {}", fmt::join(missing, ", ")));
}

/// Shards that may be the same machine's differ in the date at least: entries all agree on come first.
std::vector<std::pair<std::string, std::string>> joined_provenance(
    const std::vector<std::pair<const Part*, const TextTable*>>& all) {
  std::vector<std::pair<std::string, std::string>> same, differing;
  for (const auto& [key, value] : all.front().second->provenance) {
    const auto has = [&](const auto& one) { return entry(*one.second, key) == value; };
    if (key != "shard" && std::ranges::all_of(all, has)) same.emplace_back(key, value);
  }
  same.emplace_back("merged_shards", fmt::format("{}", all.front().first->shard.count));
  for (const auto& [part, table] : all) {
    for (const auto& [key, value] : table->provenance) {
      if (key == "shard" || std::ranges::find(same, std::pair(key, value)) != same.end()) continue;
      differing.emplace_back(fmt::format("shard {} {}", to_string(part->shard), key), value);
    }
  }
  same.insert(same.end(), differing.begin(), differing.end());
  return same;
}

/// Columns of all: a sweep's parts may know others where runs failed. Those a part has alone come before the
/// last two, status and directory.
std::vector<std::string> joined_columns(const std::vector<std::pair<const Part*, const TextTable*>>& all) {
  std::vector<std::string> columns = all.front().second->columns;
  for (const auto& [part, table] : all) {
    for (const std::string& column : table->columns) {
      if (std::ranges::find(columns, column) == columns.end())
        columns.insert(columns.end() - std::min<std::ptrdiff_t>(2, std::ssize(columns)), column);
    }
  }
  std::erase(columns, case_column);
  return columns;
}

struct NumberedRow {
  std::size_t number;
  std::vector<std::string> fields;
};

std::size_t case_of(const Part& part, const std::string& file, const std::string& text) {
  const auto number = dem::parse_integer(text);
  if (!number || *number < 1 || static_cast<std::size_t>(*number) > part.cases)
    throw InputError(
        fmt::format("{}: case '{}' is none of 1..{}", (part.directory / file).string(), text, part.cases));
  return static_cast<std::size_t>(*number);
}

/// Which shard has each case.
using Owners = std::map<std::size_t, const Part*>;

TextTable merged_table(const std::vector<std::pair<const Part*, const TextTable*>>& all,
                       const std::string& file, Owners& owners) {
  TextTable merged{joined_provenance(all), joined_columns(all), {}};
  std::vector<NumberedRow> rows;
  for (const auto& [part, table] : all) {
    const auto at = case_index(*table);
    if (!at && all.size() > 1)
      throw InputError(fmt::format("{} has no column {} and is in {} and {}", file, case_column,
                                   all[0].first->directory.string(), all[1].first->directory.string()));
    for (const auto& fields : table->rows) {
      NumberedRow row{at ? case_of(*part, file, fields[*at]) : 0, {}};
      for (const std::string& column : merged.columns) {
        const auto found = std::ranges::find(table->columns, column);
        row.fields.push_back(found == table->columns.end()
                                 ? "nan"
                                 : fields[static_cast<std::size_t>(found - table->columns.begin())]);
      }
      if (at) {
        const auto [owner, is_new] = owners.emplace(row.number, part);
        if (!is_new && owner->second != part)
          throw InputError(fmt::format("case {} is in {} and in {}", row.number,
                                       owner->second->directory.string(), part->directory.string()));
      }
      rows.push_back(std::move(row));
    }
  }
  std::ranges::stable_sort(rows, {}, &NumberedRow::number);
  for (NumberedRow& row : rows) merged.rows.push_back(std::move(row.fields));
  return merged;
}

void check_cases(const std::vector<Part>& parts, const Owners& owners) {
  const std::size_t cases = parts.front().cases;
  for (std::size_t number = 1; number <= cases; ++number) {
    if (!owners.contains(number))
      throw InputError(fmt::format("case {} of {} is in no part: was its shard stopped?", number, cases));
  }
}

/// Pictures that one part alone has: those of a study's parts that it made whole.
std::vector<fs::path> pictures_of(const std::vector<Part>& parts) {
  std::map<std::string, std::vector<fs::path>> by_name;
  for (const Part& part : parts) {
    for (const auto& file : fs::directory_iterator(part.directory)) {
      const auto ending = file.path().extension();
      if (ending == ".svg" || ending == ".png" || ending == ".pdf")
        by_name[file.path().filename().string()].push_back(file.path());
    }
  }
  std::vector<fs::path> alone;
  for (const auto& [name, paths] : by_name) {
    if (paths.size() == 1) alone.push_back(paths.front());
  }
  return alone;
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::vector<std::string> quoted;
  std::ranges::transform(fields, std::back_inserter(quoted), dem::csv_field);
  return fmt::format("{}\n", fmt::join(quoted, ","));
}

}  // namespace

std::string shard_words(const Shard& shard, std::size_t cases) {
  return fmt::format("{} of {} cases", to_string(shard), cases);
}

std::string shard_directory(const Shard& shard) {
  return fmt::format("shard-{}-of-{}", shard.index, shard.count);
}

Merged merge_shards(const std::vector<fs::path>& directories) {
  if (directories.empty()) throw InputError("merge: give the directories of all shards");
  std::vector<Part> parts;
  for (const fs::path& directory : directories) parts.push_back(read_part(directory));
  for (const Part& part : parts) check_same(parts.front(), part);
  check_all_there(parts);
  std::map<std::string, std::vector<std::pair<const Part*, const TextTable*>>> files;
  for (const Part& part : parts) {
    for (const auto& [file, table] : part.tables) files[file].emplace_back(&part, &table);
  }
  Merged merged{{}, pictures_of(parts), parts.front().cases};
  Owners owners;
  for (const auto& [file, tables] : files)
    merged.tables.push_back({file, merged_table(tables, file, owners)});
  check_cases(parts, owners);
  return merged;
}

std::string to_csv(const TextTable& table) {
  std::string text;
  for (const auto& [key, value] : table.provenance) text += fmt::format("# {}: {}\n", key, value);
  text += csv_line(table.columns);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

}  // namespace fiberchain::compare
