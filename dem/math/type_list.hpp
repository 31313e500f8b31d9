#pragma once

#include <cstddef>
#include <type_traits>

namespace fiberchain::dem {

/// Types that tables are made of at compile time.
template <class... Types>
struct TypeList {
  static constexpr int size = sizeof...(Types);
};

/// Number of a type in a list; the list's size where it is not there.
template <class Type, class... Types>
constexpr int index_in(TypeList<Types...>) {
  int index = 0;
  const bool found = ((std::is_same_v<Type, Types> || (++index, false)) || ...);
  return found ? index : TypeList<Types...>::size;
}

}  // namespace fiberchain::dem
