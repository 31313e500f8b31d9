#include "dem/run/session_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "dem/run/overlaps.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem {
namespace {

void say_if_any(const std::string& words, const Say& say) {
  if (!words.empty()) say(words);
}

}  // namespace

std::string step_words(const StepChoice& choice, const PackingScene& scene) {
  const std::string off = std::isfinite(choice.restitution_error)
                              ? fmt::format("off by up to {:.2g}", choice.restitution_error)
                              : "not to be found";
  const bool stiff = !std::isfinite(choice.bonds);
  const std::string bonds =
      stiff ? fmt::format("{:.4g} of bending {:.4g} s, {:.4g} of an impact {:.4g} s, turning {:.4g} s",
                          bending_part, choice.bending, impact_part, choice.impact, choice.turning)
            : fmt::format("bonds {:.4g} s, bond damping {:.4g} s", choice.bonds, choice.damped_bonds);
  const std::string limits =
      fmt::format(": {}, contacts {:.4g} s; restitution {} where single spheres meet at {:.3g} m/s", bonds,
                  choice.contacts, off, choice.speed);
  if (scene.step) return fmt::format("given; {:.4g} s would be chosen; stable{}", choice.step, limits);
  if (choice.set_by == "speed") {
    return fmt::format(
        "{} of the smallest radius at {:.3g} m/s, which fibers and walls may come to; stable{}", chosen_path,
        choice.speed, limits);
  }
  if (choice.set_by == "restitution") {
    return fmt::format("restitution within {:g} at {:.3g} m/s; stable{}", scene.restitution_error,
                       choice.speed, limits);
  }
  if (stiff && choice.set_by != "contacts")
    return fmt::format("bonds solved within the step, set by {}; each alone{}", choice.set_by, limits);
  return fmt::format("{} of what is stable, set most by {}; each alone{}", chosen_part, choice.set_by,
                     limits);
}

std::string mass_words(const PackingScene& scene) {
  double mass = 0, cylinders = 0;
  std::vector<std::int64_t> carried(scene.kinds.size(), 0);
  for (const CarriedFibers& group : scene.carried) carried[group.kind] += group.fibers;
  for (std::size_t k = 0; k < scene.kinds.size(); ++k) {
    const PackingFiberKind& kind = scene.kinds[k];
    const auto fibers = static_cast<double>(kind.count + std::ssize(kind.starts) + carried[k]);
    Fiber own = kind.fiber;
    own.mass = MassModel::cylinder;
    mass += fibers * fiber_mass(kind.fiber);
    cylinders += fibers * fiber_mass(own);
  }
  return fmt::format("{:.4g} kg, {:.3g} of the fibers' own", mass, mass / cylinders);
}

void say_how_deep(const RunMoment& last, double longest_path, const Say& say) {
  say(
      fmt::format("overlap over the smaller radius: largest {:.2g}, mean of the contacts {:.2g}{}; longest "
                  "path of a step {:.2g} of the smallest",
                  last.overlap_peak, last.overlap_mean,
                  presses_at_rest(last) ? " at rest" : " at the end, in motion", longest_path));
  say_if_any(impact_warning(last), say);
  say_if_any(rest_warning(last), say);
}

}  // namespace fiberchain::dem
