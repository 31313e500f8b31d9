#include "dem/scene/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <string>

#include "dem/files/numbers.hpp"

namespace fiberchain::dem {
namespace {

/// UDUNITS keeps the state of its parsers in variables of its own: two threads that are in it at once end in
/// its abort().
std::mutex udunits;

/// The database, which nothing changes once it is read; of a caller who holds the mutex.
const ut_system* database() {
  static const std::unique_ptr<ut_system, void (*)(ut_system*)> system = [] {
    ::ut_set_error_message_handler(&::ut_ignore);  // its messages would go to standard error
    ut_system* const read = ::ut_read_xml(nullptr);
    if (read == nullptr)
      throw UnitError("the database of UDUNITS-2 is missing (Debian package libudunits2-data)");
    return std::unique_ptr<ut_system, void (*)(ut_system*)>(read, &::ut_free_system);
  }();
  return system.get();
}

using Unit = std::unique_ptr<ut_unit, void (*)(ut_unit*)>;
using Converter = std::unique_ptr<cv_converter, void (*)(cv_converter*)>;

Unit parse_unit(const ut_system* system, std::string_view text) {
  return {::ut_parse(system, std::string(text).c_str(), UT_UTF8), &::ut_free};
}

/// To UDUNITS an angle is a number: what a unit is made of tells them apart.
bool is_angle(const ut_unit* unit) {
  char text[256];
  const int size = ::ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);
  return size > 0 && size < static_cast<int>(sizeof text) &&
         std::string_view(text).find("rad") != std::string_view::npos;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kSpace = " \t";
  const auto begin = text.find_first_not_of(kSpace);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

}  // namespace

Units::Units() {
  const std::scoped_lock lock(udunits);
  system_ = database();
}

double Units::to_si(std::string_view text, std::string_view si) const {
  const std::string_view whole = without_blanks(text);
  const std::string_view number = whole.substr(0, whole.find_first_of(" \t"));
  const auto value = parse_number(number);
  if (!value) {
    throw UnitError(si == "1" ? "is no number"
                              : fmt::format("is no number with a unit; write a number in {0} or one with a "
                                            "space and a unit such as '1 {0}'",
                                            si));
  }
  const std::string_view unit = without_blanks(whole.substr(number.size()));
  return unit.empty() ? *value : *value * factor(unit, si);
}

double Units::factor(std::string_view unit, std::string_view si) const {
  const std::scoped_lock lock(udunits);
  const Unit from = parse_unit(system_, unit);
  if (!from) throw UnitError(fmt::format("has an unknown unit; allowed: {} and its like", si));
  const Unit to = parse_unit(system_, si);
  const Converter converter(::ut_get_converter(from.get(), to.get()), &::cv_free);
  // UDUNITS converts reciprocals, logarithms and offset scales too: only a factor will do here.
  const double one = converter ? ::cv_convert_double(converter.get(), 1.0) : std::nan("");
  const bool pure = si == "1" || si == "rad";  // 1/s and rad/s are the same to everybody
  const bool is_factor = !(pure && is_angle(from.get()) != is_angle(to.get())) && std::isfinite(one) &&
                         ::cv_convert_double(converter.get(), 0.0) == 0.0 &&
                         std::abs(::cv_convert_double(converter.get(), 2.0) - 2 * one) <= 1e-12 * one;
  if (!is_factor)
    throw UnitError(fmt::format("has a unit of another dimension; allowed: {} and its like", si));
  return one;
}

}  // namespace fiberchain::dem
