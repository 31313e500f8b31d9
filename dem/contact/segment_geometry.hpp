#pragma once

#include <cmath>

#include "dem/math/near_one.hpp"
#include "dem/math/vec.hpp"

// Where two smooth fibers touch: the closest points of a segment of each (the straight line between two
// neighboring nodes), how much of the contact is theirs beside the segments next to them, and how stiff it is
// at their angle. Templates on the number type, a double or as many pairs as a Real has lanes.
namespace fiberchain::dem {

/// A segment, from `begin` to `end`, with the nodes next to it along its fiber: `before` is `begin` where the
/// fiber begins there, `behind` is `end` where it ends. A sphere is a segment whose four nodes are one.
template <class Real>
struct SegmentNodes {
  Vec<Real, 3> before, begin, end, behind;
  Real radius;
};

/// Fibers count as parallel within the lower angle and as crossed beyond the upper one, by its sine.
inline constexpr double parallel_sine = 0.01, crossed_sine = 0.05;
/// Least 4 A B / (A + B)^2 of the stiffness, that of equal cylinders at a sine of 0.1.
inline constexpr double least_curvature_ratio = 0.01;
/// Square of the cosine between normal and axis at which a cap is as round as a sphere: 1 / 10.
inline constexpr double cap_steepness = 10;
/// Share of a contact below which it is none of a pair's.
inline constexpr double least_share = 1e-5;

template <class Real>
Real within_one(const Real& x) {
  using std::max, std::min;
  return max(Real(0.0), min(Real(1.0), x));
}

/// Places along both segments, from 0 at their beginnings to 1 at their ends, and what follows from the
/// products.
template <class Real>
struct ClosestPlaces {
  Real first, second;
  Real first_square, second_square, product;  ///< of the segments' vectors [m^2]
  Real onto_first, onto_second;               ///< (a - b).d1, (a - b).d2, of their beginnings a and b [m^2]
};

/// The closest points of two segments (Ericson, Real-Time Collision Detection (2005), 5.1.9); of parallel
/// ones any.
template <class Real>
ClosestPlaces<Real> closest_places(const SegmentNodes<Real>& a, const SegmentNodes<Real>& b) {
  using std::max;
  const Vec<Real, 3> d1 = a.end - a.begin, d2 = b.end - b.begin, r = a.begin - b.begin;
  ClosestPlaces<Real> at;
  at.first_square = dot(d1, d1), at.second_square = dot(d2, d2), at.product = dot(d1, d2);
  at.onto_first = dot(r, d1), at.onto_second = dot(r, d2);
  const Real tiny(1e-290), squares = at.first_square * at.second_square;
  const Real independent = max(squares - at.product * at.product, Real(1e-12) * squares + tiny);
  const Real start =
      within_one((at.product * at.onto_second - at.onto_first * at.second_square) / independent);
  at.second = within_one((at.product * start + at.onto_second) / max(at.second_square, tiny));
  at.first = within_one((at.product * at.second - at.onto_first) / max(at.first_square, tiny));
  return at;
}

template <class Real>
Vec<Real, 3> along(const SegmentNodes<Real>& a, const Real& place) {
  return a.begin + place * (a.end - a.begin);
}

template <class Real>
Vec<Real, 3> separation(const SegmentNodes<Real>& a, const SegmentNodes<Real>& b, const Real& first,
                        const Real& second) {
  return along(b, second) - along(a, first);
}

/// From a point to the closest one between two others, and where its foot is on their line: 0 to 1 between
/// them.
template <class Real>
Vec<Real, 3> to_segment(const Vec<Real, 3>& from, const Vec<Real, 3>& begin, const Vec<Real, 3>& end,
                        Real& foot) {
  using std::max;
  const Vec<Real, 3> d = end - begin, r = begin - from;
  foot = (Real(0.0) - dot(r, d)) / max(dot(d, d), Real(1e-290));
  return r + within_one(foot) * d;
}

/// The farther of two places from where both vectors begin.
template <class Real>
Vec<Real, 3> farther(const Vec<Real, 3>& a, Vec<Real, 3> b) {
  const auto is_farther = dot(a, a) > dot(b, b);
  for (int c = 0; c < 3; ++c) b[c] = select(is_farther, a[c], b[c]);
  return b;
}

/// From a joint to the closest point of a segment of another fiber; beyond its end to that of the next one
/// or, where the fiber is bent towards the joint there, straight on: what lies around a bend is touched by
/// itself. Where the fiber ends, to its end.
template <class Real>
Vec<Real, 3> to_piece(const Vec<Real, 3>& from, const SegmentNodes<Real>& piece) {
  Real foot, other;
  const Vec<Real, 3> own = to_segment(from, piece.begin, piece.end, foot),
                     before = to_segment(from, piece.before, piece.begin, other),
                     behind = to_segment(from, piece.end, piece.behind, other);
  const Vec<Real, 3> on_line = along(piece, foot) - from, at_begin = farther(before, on_line),
                     at_end = farther(behind, on_line);
  const auto is_before = foot<Real(0.0), is_behind = foot> Real(1.0);
  Vec<Real, 3> to;
  for (int c = 0; c < 3; ++c) to[c] = select(is_before, at_begin[c], select(is_behind, at_end[c], own[c]));
  return to;
}

/// Share of a contact that the segment from a joint to `inside` has, the rest being that of the one to
/// `outside`; both add up to 1. `p` goes from the joint to the other fiber, whose closest point lies over one
/// of them, which has it all; over both, where the fiber is bent around it: as far as it is inside of either;
/// or over none, where the fiber is bent away from it: both touch with the joint, and share so that there is
/// no jump to what comes next. All of it where nothing is outside.
template <class Real>
Real share_at_joint(const Vec<Real, 3>& p, const Vec<Real, 3>& joint, const Vec<Real, 3>& inside,
                    const Vec<Real, 3>& outside, const Real& even) {
  using std::abs, std::max;
  const Vec<Real, 3> out = outside - joint;
  const Real a = dot(p, inside - joint), b = dot(p, out), zero(0.0);
  const Real share = (max(a, zero) + max(zero - b, zero) + even) / (abs(a) + abs(b) + Real(2.0) * even);
  return select(dot(out, out) > zero, share, Real(1.0));
}

/// Of the contact of a piece with another one.
template <class Real>
Real share_of(const SegmentNodes<Real>& own, const SegmentNodes<Real>& other, const Real& even) {
  return share_at_joint(to_piece(own.begin, other), own.begin, own.end, own.before, even) *
         share_at_joint(to_piece(own.end, other), own.end, own.begin, own.behind, even);
}

/// Hertz's stiffness k of F = k d^(3/2) by that of bodies with the same A + B and A = B: x^(-1/4) F_2^(-3/2)
/// (Johnson, Contact Mechanics (1985), section 4.2), x = 4 A B / (A + B)^2 from 0.01 to 1. Within 4.4e-4 of
/// the elliptic integrals.
template <class Real>
Real elliptic_stiffness(const Real& ratio) {
  using std::sqrt;
  const Real root = sqrt(sqrt(ratio)), z = Real(1.0) - root;
  return polynomial(z, 1.0, 0.35995958, -0.12468642, 3.24205234, -6.34969631, 6.10374850) / root;
}

/// What the contact of two segments is.
template <class Real>
struct SegmentContact {
  Real first, second;  ///< places along them
  Real share;          ///< of the law's force, 0 to 1; of parallel fibers overlap along them over R1 + R2
  Real stiffness;      ///< k over that of two spheres with these radii
};

/// Roundness along the axis of a body's surface where it is touched, `place` along it and in the direction of
/// r: 0 beside it, 1 on the cap at an end of the fiber, and of a sphere.
template <class Real>
Real roundness(const SegmentNodes<Real>& body, const Real& place, const Vec<Real, 3>& r, const Real& square) {
  using std::max, std::min;
  const Vec<Real, 3> d = body.end - body.begin, on = body.behind - body.end, back = body.begin - body.before;
  const Real zero(0.0), one(1.0), along_axis = dot(r, d), axis_square = dot(d, d);
  const Real steep =
      min(one, Real(cap_steepness) * along_axis * along_axis / max(axis_square * square, Real(1e-290)));
  const Real at_end =
      select(place < one, select(place > zero, zero, select(dot(back, back) > zero, zero, steep)),
             select(dot(on, on) > zero, zero, steep));
  return select(axis_square > zero, at_end, one);
}

/// k / (4/3 E* sqrt(R*)) of bodies whose curvatures are 1/R across the axes and `round`/R along them, R* that
/// of two spheres: sqrt(1/((A + B) R*)) times elliptic_stiffness.
template <class Real>
Real crossed_stiffness(const Real& radius_1, const Real& radius_2, const Real& round_1, const Real& round_2,
                       const Real& square_of_sine) {
  using std::max, std::min, std::sqrt;
  const Real one(1.0), c1 = one / radius_1, c2 = one / radius_2;
  const Real sum = (one + round_1) * c1 + (one + round_2) * c2, d1 = (one - round_1) * c1,
             d2 = (one - round_2) * c2;
  const Real ratio = (sum * sum - (d1 + d2) * (d1 + d2) + Real(4.0) * d1 * d2 * square_of_sine) / (sum * sum);
  return sqrt(Real(2.0) * (c1 + c2) / sum) *
         elliptic_stiffness(min(one, max(ratio, Real(least_curvature_ratio))));
}

/// Crossed fibers touch in the closest points of their segments, once: the shares of neighboring pairs that
/// see the same point add up to 1. Parallel ones touch along the length over which they lie side by side, one
/// contact a diameter of it, in the middle of what two segments have of it. Between both angles one turns
/// into the other.
template <class Real>
SegmentContact<Real> segment_contact(const SegmentNodes<Real>& a, const SegmentNodes<Real>& b) {
  using std::max, std::min, std::sqrt;
  const Real tiny(1e-290), one(1.0), zero(0.0), half(0.5);
  const ClosestPlaces<Real> at = closest_places(a, b);
  const Real radii = a.radius + b.radius;
  const Vec<Real, 3> r = separation(a, b, at.first, at.second);
  const Real square = max(dot(r, r), tiny);
  const Real round_1 = roundness(a, at.first, r, square), round_2 = roundness(b, at.second, r, square);
  const Real squares = max(at.first_square * at.second_square, tiny);
  const Real square_of_sine = max(zero, one - at.product * at.product / squares);
  const Real parallel =
      within_one((Real(crossed_sine) - sqrt(square_of_sine)) * Real(1 / (crossed_sine - parallel_sine))) *
      (one - round_1) * (one - round_2);
  // the second segment's ends along the first one
  const Real inverse = one / max(at.first_square, tiny);
  const Real end_1 = (zero - at.onto_first) * inverse, end_2 = end_1 + at.product * inverse;
  const Real low = max(zero, min(end_1, end_2)), high = min(one, max(end_1, end_2));
  const Real side_by_side = max(zero, high - low) * sqrt(at.first_square);
  const Real middle = within_one(half * (low + high)),
             foot = within_one((middle * at.product + at.onto_second) / max(at.second_square, tiny));
  const Real even = Real(1e-9) * radii * radii;
  const Real share = share_of(a, b, even) * share_of(b, a, even);
  return {at.first + parallel * (middle - at.first), at.second + parallel * (foot - at.second),
          share + parallel * (side_by_side / radii - share),
          crossed_stiffness(a.radius, b.radius, round_1, round_2, square_of_sine)};
}

}  // namespace fiberchain::dem
