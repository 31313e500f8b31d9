#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "dem/assembly/assembly_state.hpp"

// Fields of the saved state and the kinds of them; assembly_checkpoint.cpp has their table.
namespace fiberchain::dem::field_rules {

using State = Assembly::State;
using Reals = std::vector<double>;
using Integers = std::vector<std::int64_t>;
using Places = std::vector<ContactPlace>;

/// Number of values of a field.
enum class Extent {
  fixed,       ///< that of this assembly's own field
  per_contact  ///< `width` times the number of contacts in the saved state
};

/// A field of the state.
struct FieldRule {
  std::string_view name;
  FieldValues (*get)(State& s, const Places& contacts);
  void (*set)(State& s, const FieldValues& values);  ///< of the right type and number
  int version = 1;
  Extent extent = Extent::fixed;
  std::size_t (*width)(const State& s) = [](const State&) { return std::size_t{1}; };
};

[[noreturn]] void refuse(std::string_view name, const std::string& reason) {
  throw InvalidInput(fmt::format("field '{}' of the saved state {}", name, reason));
}

/// A number of the state itself.
template <auto member>
FieldRule number_field(std::string_view name) {
  using Number = std::remove_cvref_t<decltype(std::declval<State&>().*member)>;
  return {
      .name = name,
      .get = [](State& s, const Places&) -> FieldValues { return std::vector<Number>{s.*member}; },
      .set = [](State& s, const FieldValues& v) { s.*member = std::get<std::vector<Number>>(v).front(); }};
}

/// Rows of all spheres.
template <LaneArray SphereStorage::*member>
FieldRule sphere_field(std::string_view name) {
  return {
      .name = name,
      .get = [](State& s, const Places&) -> FieldValues {
        const LaneArray& rows = s.rows.*member;
        return Reals(rows.data(), rows.data() + rows.size());
      },
      .set = [](State& s,
                const FieldValues& v) { std::ranges::copy(std::get<Reals>(v), (s.rows.*member).data()); }};
}

/// One of the arrays of every block of fibers (FiberBlock::saved_arrays), block after block.
template <std::size_t index>
FieldRule block_field(std::string_view name, int version = 1) {
  return {.name = name,
          .get = [](State& s, const Places&) -> FieldValues {
            Reals all;
            std::size_t numbers = 0;
            for (FiberBlock& block : s.blocks) numbers += block.saved_arrays()[index].size();
            all.reserve(numbers);
            for (FiberBlock& block : s.blocks) {
              const std::span<double> own = block.saved_arrays()[index];
              all.insert(all.end(), own.begin(), own.end());
            }
            return all;
          },
          .set =
              [](State& s, const FieldValues& v) {
                auto from = std::get<Reals>(v).begin();
                for (FiberBlock& block : s.blocks) {
                  const std::span<double> own = block.saved_arrays()[index];
                  std::copy_n(from, own.size(), own.begin());
                  from += static_cast<std::ptrdiff_t>(own.size());
                }
              },
          .version = version};
}

void require_same(std::string_view name, const FieldValues& saved, const FieldValues& own) {
  if (saved != own) refuse(name, "is not that of this assembly");
}

}  // namespace fiberchain::dem::field_rules
