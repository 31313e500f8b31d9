#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/bench/row.hpp"
#include "dem/vibration/release.hpp"

// The time integrators of dem/ at all their settings, on one release.
namespace fiberchain::compare {

struct RingDownSetting {
  std::string method;  ///< as PrecisionRow has it
  std::string text;    ///< its setting
  bool as_paper = false;
  dem::ReleaseOptions options{};
  int side_by_side = 1;  ///< equal chains in lanes; the time is that of one
};

/// Leapfrogs by parts of their largest stable step, alone and in lanes; leapfrog-stiff and implicit by steps
/// a period; CVODE by tolerance. `total_too`: the leapfrogs by total strain as well, which differ where the
/// deflection is large.
std::vector<RingDownSetting> ring_down_settings(const dem::Release<2>& release, bool quick, bool total_too);

/// The leapfrogs alone: explicit by parts of their largest stable step, with bonds solved for by parts of the
/// first period.
std::vector<RingDownSetting> leapfrog_settings(const dem::Release<2>& release, bool quick);

/// A method is not asked for finer settings than the first that took this long [s]: each costs several times
/// more.
inline constexpr double patience = 10;

/// Every setting in its order, measured; `error` judges the record of the free end. A setting that is past
/// patience has a row too, and says so.
std::vector<PrecisionRow> ring_down_rows(const std::vector<RingDownSetting>& settings,
                                         const dem::Release<2>& release, const TimingBudget& budget,
                                         const std::function<double(const dem::ReleaseRecord<2>&)>& error);

}  // namespace fiberchain::compare
