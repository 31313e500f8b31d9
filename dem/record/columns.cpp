#include "dem/record/columns.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "dem/record/columns/benchmark.hpp"
#include "dem/record/columns/capstan.hpp"
#include "dem/record/columns/contact.hpp"
#include "dem/record/columns/damping.hpp"
#include "dem/record/columns/equilibrium.hpp"
#include "dem/record/columns/fit.hpp"
#include "dem/record/columns/flow.hpp"
#include "dem/record/columns/identify.hpp"
#include "dem/record/columns/material.hpp"
#include "dem/record/columns/material_study.hpp"
#include "dem/record/columns/packing.hpp"
#include "dem/record/columns/press.hpp"
#include "dem/record/columns/rod_packing.hpp"
#include "dem/record/columns/rod_path.hpp"
#include "dem/record/columns/rods.hpp"
#include "dem/record/columns/spacing.hpp"
#include "dem/record/columns/validation.hpp"
#include "dem/record/errors.hpp"

namespace fiberchain::dem {
namespace {

template <std::size_t... n>
constexpr auto joined(const Column (&... parts)[n]) {
  std::array<Column, (n + ...)> all{};
  Column* next = all.data();
  ((next = std::ranges::copy(parts, next).out), ...);
  return all;
}

constexpr auto kColumns =
    joined(columns::equilibrium, columns::damping, columns::flow, columns::fit, columns::benchmark,
           columns::validation, columns::packing, columns::material, columns::material_study, columns::press,
           columns::contact, columns::identify, columns::spacing, columns::capstan, columns::rod_path,
           columns::rods, columns::rod_packing);

}  // namespace

std::span<const Column> all_columns() { return kColumns; }

const Column& find_column(std::string_view name) {
  const auto* found = std::ranges::find(kColumns, name, &Column::name);
  if (found == std::end(kColumns)) throw TableError("no column is called '" + std::string(name) + "'");
  return *found;
}

std::string_view to_string(CellKind kind) {
  switch (kind) {
    case CellKind::number:
      return "number";
    case CellKind::integer:
      return "integer";
    case CellKind::text:
      return "text";
  }
  throw TableError("no such kind of cell");
}

}  // namespace fiberchain::dem
