#pragma once

#include "dem/contact/contact_law.hpp"
#include "dem/contact/kernels/segment_kernel.hpp"

// Contact laws between smooth fibers.
namespace fiberchain::dem {

/// The law for scenes with smooth fibers: it acts on spheres and walls as ever. Throws InvalidInput where it
/// is not built for smooth fibers.
const ContactLaw& smooth_law(const ContactLaw& law);

/// Its loops: between bodies those of segments, which take a SegmentView.
ContactKernel smooth_kernel(const ContactLaw& law, const ContactPhysics& physics, InstructionSet set);

/// Those of segments alone.
const SegmentKernel& segment_kernel(const ContactPhysics& physics, InstructionSet set);

/// k over that of spheres of fibers that touch at right angles, or, where `parallel`, side by side; of a
/// fiber and a sphere, or a wall, what they have.
double stiffness_ratio(const ContactBody& a, const ContactBody& b, bool parallel);

/// The two as one, smooth fibers as they are at right angles: with the radius of a sphere as stiff.
EffectiveBody crossed_body(const ContactBody& a, const ContactBody& b);

}  // namespace fiberchain::dem
