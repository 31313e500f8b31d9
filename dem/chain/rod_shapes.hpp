#pragma once

#include <vector>

#include "dem/chain/chain.hpp"

// Stress-free shapes of rods besides those of straight_chain<3> and cornered_chain<3>.
namespace fiberchain::dem {

/// An arc as arc_chain's, from the origin along x in the x-y plane, which may come round: a full ring and
/// more. fiber.rest_angle is the angle of a bond. Throws InvalidInput for a fiber that makes no sense.
Chain<3> arc_rod(const Fiber& fiber);

/// Members that join the points one after the other, rigidly: each is straight, made of bonds along it, and a
/// point between two members is a sphere whose axes are the first one's. The first member's axes are turned
/// out of the global ones about the normal of x and its direction; each next is turned out of the one before
/// the same way (without twist). Throws InvalidInput unless every distance is a whole number of bond lengths
/// (to 1e-6 of one) and their sum is the fiber's aspect ratio.
Chain<3> rod_through(const Fiber& fiber, const std::vector<Vec<double, 3>>& points);

/// The rod turned by q about the origin and moved, as a whole.
Chain<3> placed(Chain<3> chain, const Quaternion<double>& q, const Vec<double, 3>& moved);

}  // namespace fiberchain::dem
