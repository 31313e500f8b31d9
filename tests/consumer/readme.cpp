#include <cstdio>

#include "dem/run/run_scene.hpp"

int main(int, char** arguments) {
  using namespace fiberchain::dem;
  const SceneResult result = run_scene(arguments[1], {.directory = arguments[2], .threads = 2});
  const auto& packing = std::get<PackingEndState>(result);
  std::printf("%ld contacts, 95 %% of the fibers below %.2f mm, bonds bent by %.4f rad\n",
              static_cast<long>(packing.last.contacts), 1e3 * packing.last.height, packing.last.bending_mean);
  return packing.finished() ? 0 : 1;
}
