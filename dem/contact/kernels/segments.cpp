#include "dem/contact/kernels/ridges.hpp"
#include "dem/contact/kernels/segment_kernel.hpp"
#include "dem/contact/laws/smooth_hertz.hpp"
#include "dem/simd/compiled_set.hpp"

namespace fiberchain::dem {
namespace {

constexpr ContactPhysics segment_physics(bool rolling, bool accounted) {
  return {.uniform = false, .periodic = true, .rolling = rolling, .accounted = accounted};
}

template <class Real, bool rolling, bool accounted>
constexpr SegmentKernel segment_kernel_of() {
  constexpr ContactPhysics P = segment_physics(rolling, accounted);
  return {prune_bodies<Real>, contact_bodies<SmoothHertz, P, Real>, contact_ridges<SmoothHertz, P, Real>};
}

}  // namespace

template <>
const SegmentKernel* SegmentKernels<compiled_set>::table() {
  static constexpr SegmentKernel kernels[segment_combinations] = {
      segment_kernel_of<CompiledReal, false, false>(), segment_kernel_of<CompiledReal, true, false>(),
      segment_kernel_of<CompiledReal, false, true>(), segment_kernel_of<CompiledReal, true, true>()};
  return kernels;
}

}  // namespace fiberchain::dem
