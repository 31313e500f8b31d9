#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>

#include "dem/trajectory/h5md.hpp"
#include "tests/dem/trajectory/damaged_hdf5.hpp"
#include "tests/fuzz/readers.hpp"

// Files that are nearly sound, read as long as is asked for:
//   fuzz_readers [SECONDS [SEED [DIRECTORY]]]
// Every one is read or refused by one of the library's errors. Anything else ends this program, and
// DIRECTORY/input is the file at fault.

int main(int count, char** words) {
  namespace fs = std::filesystem;
  fiberchain::dem::leave_hdf5_as_it_is_at_exit();
  const double seconds = count > 1 ? std::atof(words[1]) : 10;
  const unsigned long seed = count > 2 ? std::strtoul(words[2], nullptr, 10) : 1;
  const fs::path place = count > 3 ? fs::path(words[3]) : fs::temp_directory_path() / "fiberchain-fuzz";
  fs::create_directories(place);
  fiberchain::test::Mutation mutation(seed);
  const auto readers = fiberchain::test::readers(place);
  const auto begin = std::chrono::steady_clock::now();
  long files = 0;
  for (double passed = 0; passed < seconds; ++files) {
    const auto& reader = readers[static_cast<std::size_t>(files) % readers.size()];
    std::ofstream(place / "input", std::ios::binary) << mutation.of(reader);
    try {
      reader.read(place);
    } catch (const std::exception& error) {
      std::printf("%s: file %ld of seed %lu (%s) is neither read nor refused: %s\n", reader.name.c_str(),
                  files, seed, (place / "input").c_str(), error.what());
      return 1;
    }
    passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  std::printf("%ld files, seed %lu: each read or refused\n", files, seed);
}
