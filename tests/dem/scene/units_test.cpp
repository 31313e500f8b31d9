#include "dem/scene/units.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <string>

BOOST_AUTO_TEST_SUITE(units_test)

namespace {

using fiberchain::dem::UnitError;
using fiberchain::dem::Units;

struct Good {
  const char* text;
  const char* si;
  double value;
};
std::ostream& operator<<(std::ostream& out, const Good& good) { return out << good.text; }

const Good kGood[] = {
    {"2 mm", "m", 2e-3},
    {"-7.5e-1 km", "m", -750},
    {"0.3", "m", 0.3},
    {"+4", "1", 4},
    {"2.6 MPa", "Pa", 2.6e6},
    {"2.6 N/mm^2", "Pa", 2.6e6},
    {"1.7 g/cm3", "kg/m^3", 1700},
    {"1.7 g/cm³", "kg/m^3", 1700},
    {"5 mN", "N", 5e-3},
    {"30 %", "1", 0.3},
    {"90 degree", "rad", 1.5707963267948966},
    {"  3   ms ", "s", 3e-3},
};

struct Bad {
  const char* text;
  const char* si;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.text; }

const Bad kBad[] = {
    {"30 degrees", "1", "another dimension"},
    {"1 rad", "1", "another dimension"},
    {"30 %", "rad", "another dimension"},
    {"2 kg", "m", "another dimension"},          // plainly wrong
    {"2 1/m", "m", "another dimension"},         // UDUNITS would convert a reciprocal
    {"20 degC", "K", "another dimension"},       // an offset is no factor
    {"3 lg(re 1 m)", "m", "another dimension"},  // nor is a logarithm
    {"2 m", "1", "another dimension"},
    {"2 quux", "m", "unknown unit"},
    {"2 3", "m", "another dimension"},
    {"mm", "m", "no number"},
    {"2mm", "m", "no number"},
    {"", "m", "no number"},
    {"1,5 mm", "m", "no number"},
    {"0x10", "1", "no number"},
    {"1e999", "1", "no number"},
};

}  // namespace

BOOST_DATA_TEST_CASE(a_quantity_becomes_si, boost::unit_test::data::make(kGood), good) {
  BOOST_CHECK_CLOSE_FRACTION(Units().to_si(good.text, good.si), good.value, 1e-14);
}

BOOST_DATA_TEST_CASE(what_is_no_quantity_is_refused_with_the_reason, boost::unit_test::data::make(kBad),
                     bad) {
  const Units units;
  BOOST_CHECK_EXCEPTION(units.to_si(bad.text, bad.si), UnitError, [&](const UnitError& error) {
    return std::string(error.what()).find(bad.says) != std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
