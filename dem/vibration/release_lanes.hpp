#pragma once

#include "dem/vibration/release.hpp"

namespace fiberchain::dem {

/// Marches the releases whose numbers are in `members` side by side, with one of the leapfrogs: chains of one
/// length, `stride` steps between two samples, `samples` of them after the first. Fills their records.
template <int Dim>
void march_releases(const std::vector<Release<Dim>>& all, const std::vector<std::size_t>& members, int stride,
                    int samples, const ReleaseOptions& options, std::vector<ReleaseRecord<Dim>>& records);

/// Follows one release by the implicit midpoint or CVODE, `stride` steps between two samples.
template <int Dim>
ReleaseRecord<Dim> integrate_release(const Release<Dim>& release, int stride, int samples,
                                     const ReleaseOptions& options);

}  // namespace fiberchain::dem
