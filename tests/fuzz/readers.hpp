#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What the program reads from files, each with sound files to begin from.
namespace fiberchain::test {

struct Reader {
  std::string name;
  std::vector<std::string> seeds;  ///< contents of sound files
  void (*read)(
      const std::filesystem::path& place);  ///< reads `place`/input; a refusal is an error of the library
};

/// Readers of scenes, of fibers' starts, checkpoints, trajectories and VTK series; `place` is a directory for
/// the files they are made from.
std::vector<Reader> readers(const std::filesystem::path& place);

/// The seed with some bytes changed, taken away, doubled or put in: from other seeds, or from words that mean
/// something to a reader. The same random numbers make the same file.
class Mutation {
 public:
  explicit Mutation(unsigned long seed) : state_(seed) {}
  std::string of(const Reader& reader);

 private:
  std::size_t below(std::size_t limit);
  void change(std::string& bytes, const Reader& reader);
  unsigned long state_;
};

}  // namespace fiberchain::test
