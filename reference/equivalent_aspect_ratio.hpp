#pragma once

#include <string_view>
#include <vector>

namespace fiberchain::reference {

/// Bretherton constant of a straight rigid chain of touching spheres in free-draining flow (each with the
/// drag 6 pi mu R and the torque 8 pi mu R^3 of the undisturbed flow): (N^2 - 1)/(N^2 + 3), exact in every
/// linear flow. From the balance of torques: sum x_i^2 = R^2 N (N^2 - 1)/3 turns with the flow of the line,
/// the spheres' own torque, worth 4 R^2 N/3, with half the vorticity. Throws InvalidArgument unless 1 <=
/// spheres <= 1000000.
double free_draining_bretherton(int spheres);

/// Its equivalent aspect ratio, sqrt((N^2 + 1)/2). Throws as above.
double free_draining_aspect_ratio(int spheres);

/// An equivalent aspect ratio r_e of the period of a rigid straight cylinder of aspect ratio r.
struct AspectRatioCorrelation {
  std::string_view name;
  double (*function)(double aspect_ratio);  ///< r_e(r); throws InvalidArgument outside low ... high
  double low;                               ///< smallest r the formula makes sense for
  double high;                              ///< largest r the formula makes sense for
  std::string_view range;                   ///< what low and high say
  std::string_view source;
};

/// Cox 1971: 1.24 r/sqrt(ln r).
double cox_aspect_ratio(double aspect_ratio);
/// Goldsmith and Mason 1967: 0.742 r - 0.0017 r^2.
double goldsmith_mason_aspect_ratio(double aspect_ratio);
/// Harris and Pittman 1975: 1.14 r^0.844.
double harris_pittman_aspect_ratio(double aspect_ratio);
/// Zhang, Smith, Jack and Montgomery-Smith 2011: 3.5e-5 r^3 - 0.00467 r^2 + 0.764 r + 0.404.
double zhang_aspect_ratio(double aspect_ratio);

/// All of them. Of the primary sources only the abstract of Zhang et al. was seen; each entry says where its
/// formula was found. The ranges their authors fitted were not seen, so low and high say where the form can
/// hold at all: 1 <= r_e <= r and r_e grows with r. That is a necessary condition, not a statement of the
/// authors.
const std::vector<AspectRatioCorrelation>& aspect_ratio_correlations();

}  // namespace fiberchain::reference
