#include "dem/record/output.hpp"

#include <memory>
#include <utility>

#include "dem/files/atomic_file.hpp"
#include "dem/record/errors.hpp"

namespace fiberchain::dem {

OutputDirectory::OutputDirectory(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  made_ = std::filesystem::create_directories(path_, error);
  if (!error && !std::filesystem::is_directory(path_))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw OutputError(path_.string(), error.message());
  // the one sure way to know that files can be made here and have some room
  AtomicFile probe(path_ / "probe", std::string(4096, '.'));
}

void OutputDirectory::write(const std::vector<OutputFile>& files) const {
  std::vector<std::unique_ptr<AtomicFile>> staged;
  for (const OutputFile& file : files) {
    staged.push_back(std::make_unique<AtomicFile>(path_ / file.name, file.content));
  }
  for (const auto& file : staged) file->take_place();
  flush_directory(path_);
}

}  // namespace fiberchain::dem
