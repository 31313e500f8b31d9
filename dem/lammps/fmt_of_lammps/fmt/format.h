#pragma once

#include_next <fmt/format.h>

// LAMMPS's headers name a function of the fmt 7 that is inside of its library and that newer ones do not have. Only its
// functions of std::string are called here: no type of fmt crosses the border.
#if FMT_VERSION >= 90000
namespace fmt {
template <class... Declared, class Format, class... Given>
auto make_args_checked(const Format&, Given&&... given) {
  return make_format_args(given...);
}
}  // namespace fmt
#endif
