#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/measure/fiber_surface.hpp"
#include "compare/packing/history.hpp"
#include "compare/study/jobs.hpp"
#include "compare/study/validation.hpp"
#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

// A plate presses a bed of loose fibers between periodic sides: its pressure against the solid fraction,
// compared with van Wyk's law p = K E (phi^3 - phi_0^3).
namespace fiberchain::compare {

/// A bed that is pressed at constant speed from loose.
struct PressCase {
  int fibers = 100;
  int aspect_ratio = 20;
  double friction = 0.3;  ///< between fibers
  double side = 0.02;     ///< of the periodic cell, of fibers 1 mm thick [m]
  double loose = 0.1;     ///< solid fraction at the start
  double dense = 0.45;    ///< at the end
  double speed = 0.5;     ///< of the plate [m/s]
  std::uint64_t seed = 1;
  std::optional<FiberSurface> surface = std::nullopt;  ///< none: the paper's fibers

  /// Solid fraction from which on the bed carries the plate: below, single fibers are in its way, and what it
  /// feels is their inertia.
  double carries() const { return 0.62 * dense; }
};

/// The bed and the plate at a moment, means over the interval around it.
struct PressSample {
  double solid_fraction;  ///< cylinders of the fibers' length over the room between floor and plate
  double pressure;        ///< on the plate [Pa]
  double floor_pressure;  ///< on the floor [Pa]
};

/// ln p against n ln phi: p = a (phi^n - phi_0^n), a, n and phi_0 by least squares of ln p.
struct PressFit {
  double exponent = 0;          ///< n
  double stiffness = 0;         ///< a over Young's modulus
  double initial_fraction = 0;  ///< phi_0
  double residual = 0;          ///< root mean square of ln p over its fit
  int points = 0;
};

struct PressRun {
  PressCase asked;
  std::vector<PressSample> samples;
  double youngs_modulus = 0;  ///< [Pa]
  double touched = 0;         ///< other fibers that a fiber touches at the end, mean
  double run_time = 0;        ///< [s]
  std::string status;         ///< "finished", or why not
};

dem::PackingScene press_scene(const PressCase& asked);

/// The bed of a comparison before it is pressed.
/// @throws InputError for a spacing that does not divide the aspect ratio, or of spheres
dem::Assembly bed_of_surface(const PressCase& asked, const dem::PackingScene& scene);

PressRun run_press(const PressCase& asked, int samples);
std::vector<PressRun> run_presses(const std::vector<PressCase>& cases, int samples, const Jobs& jobs,
                                  const std::function<void()>& advance = {});

/// Of the samples between these solid fractions.
/// @throws InputError for fewer than five, or a pressure that is not above 0 among them
PressFit fit_press(const std::vector<PressSample>& samples, double youngs_modulus, double from, double to);

/// The part of a run in which the bed carries the plate.
PressFit fit_press(const PressRun& run);

/// Of a quantity over the seeds of a surface.
struct PressedSurface {
  PressCase asked;  ///< of the first seed
  Spread touched;   ///< PressRun::touched
  Spread pressure;  ///< of the plate over E, where the bed is densest: mean of the last tenth of the samples
  Spread fraction;  ///< solid fraction at which the plate's pressure is `light` E
  Spread exponent;  ///< PressFit::exponent
  double run_time;  ///< mean [s]

  static constexpr double light = 1e-4;
};
/// Of comparisons that finished.
std::vector<PressedSurface> pressed_surfaces(const std::vector<PressRun>& runs);
dem::Table pressed_surface_table(const std::vector<PressRun>& runs);  ///< a row a surface

dem::Table press_table(const std::vector<PressRun>& runs);         ///< a row a run
dem::Table press_sample_table(const std::vector<PressRun>& runs);  ///< a row a sample
std::string press_notes(const std::vector<PressRun>& runs);
Figure press_figure(const std::vector<PressRun>& runs);

/// Beds of more fibers on a wider floor and of several seeds are in `tables press`.
std::vector<PressCase> press_cases(int fibers, int aspect_ratio, double friction, double speed, int seeds);

/// The same beds of spheres in a row and of smooth fibers of these diameters a bond.
/// @throws InputError for a spacing that does not divide the aspect ratio
std::vector<PressCase> surface_cases(const std::vector<PressCase>& beds, const std::vector<int>& spacings);

}  // namespace fiberchain::compare
