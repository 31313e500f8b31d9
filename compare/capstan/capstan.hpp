#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/capstan/drum.hpp"
#include "compare/figures/figure.hpp"
#include "compare/study/jobs.hpp"
#include "dem/record/table.hpp"

// The ratio of the tensions at both ends of a fiber that slides about a drum, against exp(mu phi) and against
// a rod that is thick and bends (reference/capstan.hpp).
namespace fiberchain::compare {

struct CapstanPoint {
  CapstanCase asked;
  double ratio;                      ///< of the tensions, mean over the way that is measured
  double spread;                     ///< largest departure of it from the mean, over the mean
  double euler;                      ///< exp(mu phi)
  double expected;                   ///< of the rod that bends and is thick
  int contacts;                      ///< at the end
  double run_time;                   ///< [s]
  std::string status = "converged";  ///< or not_begun, or why it diverged
};

/// What is varied.
struct CapstanSweep {
  std::vector<DrumSurface> surface{DrumSurface::smooth, DrumSurface::wall, DrumSurface::ring,
                                   DrumSurface::spheres};
  std::vector<double> friction{0.1, 0.3};
  std::vector<double> turning{0.5, 1, 2, 4};  ///< over pi
  std::vector<double> drum{39};
  std::vector<double> bending{0.1};
  std::vector<double> spacing{1};
};

struct CapstanOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

std::string_view name(DrumSurface surface);

/// Those that the surfaces can have. @throws InputError where none is left
std::vector<CapstanCase> capstan_cases(const CapstanSweep& sweep);

CapstanPoint capstan_point(const CapstanCase& asked);

std::vector<CapstanPoint> capstan_points(const std::vector<CapstanCase>& cases,
                                         const CapstanOptions& options = {});

dem::Table capstan_table(const std::vector<CapstanPoint>& points);  ///< a row a case
Figure capstan_figure(const std::vector<CapstanPoint>& points);     ///< ratio over exp(mu phi)

}  // namespace fiberchain::compare
