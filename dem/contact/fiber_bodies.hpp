#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "dem/chain/chain.hpp"
#include "dem/contact/contact_key.hpp"
#include "dem/contact/kernels/segment_view.hpp"
#include "dem/contact/segment_geometry.hpp"

namespace fiberchain::dem {

/// Of fibers of one kind.
struct BodyGroup {
  int spheres, fibers;
  double radius, bound;  ///< as FiberBodies'
  int apart;             ///< likewise
  bool smooth;
};

/// The bodies by which fibers touch each other: spheres, of smooth fibers segments between neighboring ones,
/// each with the number of its first sphere. The last sphere of a smooth fiber is no body. Where a bond has
/// broken there is no segment: both pieces end round, and a sphere left alone is a body again. Empty where
/// all are spheres.
struct FiberBodies {
  std::vector<BodyGroup> groups;                  ///< in order
  std::vector<std::int32_t> before, end, behind;  ///< spheres: nodes of each (SegmentNodes); end -1: none
  std::vector<std::int32_t>
      apart;                   ///< bodies of a fiber that are this many numbers apart or fewer do not touch
  std::vector<double> radius;  ///< [m]
  std::vector<double> bound;   ///< of a sphere around each body, from its middle [m]
  bool smooth = false;         ///< some are segments
  std::vector<std::int64_t> parted = {};  ///< spheres behind which bonds have broken, by rising number

  /// More fibers behind those there.
  void add(const Chain<3>& chain, int count);
  /// Of all fibers, and `pads` more spheres behind them in before, end and behind.
  void build(int pads);
  double largest_bound() const;  ///< [m]

  /// By which a node meets what lies ahead of its fiber, or behind.
  std::int64_t body_of(std::int64_t node) const { return is_none(node) ? node - 1 : node; }
  bool is_none(std::int64_t body) const { return end[body] < 0; }
  Primitive primitive(std::int64_t body) const {
    const bool is_segment = std::cmp_less(body, end.size()) && end[body] != body;
    return is_segment ? segment_primitive(body) : sphere_primitive(body);
  }
  BodyNodes view() const { return {before.data(), end.data(), behind.data()}; }
  /// With spheres that stand at position(sphere).
  template <class Position>
  SegmentNodes<double> nodes(std::int64_t body, const Position& position) const {
    return {position(before[body]), position(body), position(end[body]), position(behind[body]),
            radius[body]};
  }

 private:
  void part();
};

/// By how many numbers bodies of a fiber may be apart and do not touch: as far as a fiber that touched itself
/// would have to bend with a radius below its own, pi R along it; the neighbor of a sphere.
int bodies_apart(const Chain<3>& chain);

}  // namespace fiberchain::dem
