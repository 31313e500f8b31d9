#pragma once

#include <compare>
#include <cstdint>

namespace fiberchain::dem {

/// What a contact may join: a sphere, the straight segment between two spheres of a fiber, a facet of a wall
/// (a wall that is given by one shape is one facet).
enum class PrimitiveKind : std::uint8_t { facet, sphere, segment };

struct Primitive {
  PrimitiveKind kind;
  std::int64_t number;  ///< among those of its kind

  bool operator==(const Primitive&) const = default;
};

constexpr Primitive sphere_primitive(std::int64_t number) { return {PrimitiveKind::sphere, number}; }
constexpr Primitive facet_primitive(std::int64_t number) { return {PrimitiveKind::facet, number}; }
constexpr Primitive segment_primitive(std::int64_t number) { return {PrimitiveKind::segment, number}; }
constexpr bool is_sphere(const Primitive& p) { return p.kind == PrimitiveKind::sphere; }
/// Of a fiber's bodies: no facet.
constexpr bool is_of_fiber(const Primitive& p) { return p.kind != PrimitiveKind::facet; }
constexpr bool is_facet(const Primitive& p) { return p.kind == PrimitiveKind::facet; }

/// Segments follow behind all spheres.
inline constexpr std::int64_t first_segment = std::int64_t{1} << 48;

/// A primitive as one number for files and orders: a sphere's own; -1 - n of facet n; first_segment + n of
/// segment n. A double holds it.
constexpr std::int64_t to_number(const Primitive& p) {
  if (p.kind == PrimitiveKind::facet) return -1 - p.number;
  return p.kind == PrimitiveKind::segment ? first_segment + p.number : p.number;
}

constexpr Primitive primitive_of(std::int64_t number) {
  if (number < 0) return facet_primitive(-1 - number);
  return number >= first_segment ? Primitive{PrimitiveKind::segment, number - first_segment}
                                 : sphere_primitive(number);
}

/// A contact of an assembly: its two primitives, and which of their points of contact it is where they have
/// more than one.
struct ContactKey {
  Primitive first, second;
  std::int32_t slot = 0;

  bool operator==(const ContactKey&) const = default;
};

/// By the first, by the second, by the slot: the order in which contacts are saved and listed.
constexpr std::strong_ordering operator<=>(const ContactKey& a, const ContactKey& b) {
  if (const auto order = to_number(a.first) <=> to_number(b.first); order != 0) return order;
  if (const auto order = to_number(a.second) <=> to_number(b.second); order != 0) return order;
  return a.slot <=> b.slot;
}

}  // namespace fiberchain::dem
