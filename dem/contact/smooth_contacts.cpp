#include "dem/contact/smooth_contacts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/contact/laws/smooth_hertz.hpp"
#include "dem/contact/segment_geometry.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

ContactLaw smooth_hertz() {
  using History = SmoothHertz::History<double>;
  using Parameters = SmoothHertz::Parameters<double>;
  ContactLaw law = contact_law_of<HertzMindlin>;
  law.stored_energy = [](const double* p, const double* h) {
    return SmoothHertz::stored_energy(from_numbers<Parameters>(p), from_numbers<History>(h));
  };
  law.normal_energy = [](const double* p, const double* h) {
    History unsheared = from_numbers<History>(h);
    unsheared.spring = {};
    return SmoothHertz::stored_energy(from_numbers<Parameters>(p), unsheared);
  };
  law.closing_power = [](const double* p, const double* h) {
    return SmoothHertz::closing_power(from_numbers<Parameters>(p), from_numbers<History>(h));
  };
  law.act = [](const double* p, const TouchingPair<double>& pair, double step, const double* h) {
    History history = from_numbers<History>(h);
    return SmoothHertz::act(from_numbers<Parameters>(p), pair, step, history);
  };
  law.exchange_bodies = [](double* h) { to_numbers(SmoothHertz::exchanged(from_numbers<History>(h)), h); };
  return law;
}

}  // namespace

const ContactLaw& smooth_law(const ContactLaw& law) {
  static const ContactLaw smooth = smooth_hertz();
  if (law.name == smooth.name) return smooth;
  throw InvalidInput(
      fmt::format("contact law = {} is not allowed: smooth fibers (surface: smooth) are built for {}",
                  law.name, smooth.name));
}

const SegmentKernel& segment_kernel(const ContactPhysics& physics, InstructionSet set) {
  return kernel_of<SegmentKernels>(set, segment_index(physics));
}

ContactKernel smooth_kernel(const ContactLaw& law, const ContactPhysics& physics, InstructionSet set) {
  ContactKernel kernel = law.kernel(physics, set);
  const SegmentKernel& segments = segment_kernel(physics, set);
  kernel.prune = segments.prune;
  kernel.pairs = segments.pairs;
  return kernel;
}

double stiffness_ratio(const ContactBody& a, const ContactBody& b, bool parallel) {
  if (std::isinf(a.radius) || std::isinf(b.radius) || !(a.smooth || b.smooth)) return 1;
  return crossed_stiffness(a.radius, b.radius, a.smooth ? 0.0 : 1.0, b.smooth ? 0.0 : 1.0,
                           parallel ? 0.0 : 1.0);
}

EffectiveBody crossed_body(const ContactBody& a, const ContactBody& b) {
  EffectiveBody both = effective_body(a, b);
  const double stiffer = stiffness_ratio(a, b, false);
  both.radius *= stiffer * stiffer;
  return both;
}

}  // namespace fiberchain::dem
