#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// State of an assembly as named datasets, for checkpoints.
namespace fiberchain::dem {

/// Numbers of one quantity: reals, or counts and indices.
using FieldValues = std::variant<std::vector<double>, std::vector<std::int64_t>>;

/// One quantity of a saved state.
struct StateField {
  int version = 1;  ///< of the meaning and the layout of the values
  FieldValues values;

  bool operator==(const StateField&) const = default;
};

/// All fields by name, sufficient to continue to the bit (Assembly::saved, Assembly::restore).
using SavedState = std::map<std::string, StateField, std::less<>>;

/// Somebody who takes the fields of a state one by one, and somebody who gives them.
using UseField = std::function<void(std::string_view name, const StateField& field)>;
using EachField = std::function<void(const UseField& use)>;

/// Field of the loads of spheres that are not contacts': number of the sphere, force and moment each.
inline constexpr std::string_view applied_loads_field = "applied_loads";
inline constexpr int applied_load_size = 7;

}  // namespace fiberchain::dem
