#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "dem/scene/key_table.hpp"
#include "dem/scene/scene_error.hpp"

BOOST_AUTO_TEST_SUITE(key_table_test)

namespace dem = fiberchain::dem;

namespace {

enum class Shape { ball, rod };

struct Leg {
  double length = 0.5;  // [m]
};

struct Thing {
  double mass = 2;  // [kg]
  Shape shape = Shape::ball;
  std::optional<double> aspect, stretch;
  int number = 7;
  std::vector<double> legs;
};

dem::KeyTable<Leg> leg_keys() {
  dem::KeyTable<Leg> table;
  table.quantity("length", "m", &Leg::length, dem::kPositive, "length of the leg");
  return table;
}

dem::KeyTable<Thing> thing_keys() {
  dem::KeyTable<Thing> table;
  table.quantity("mass", "kg", &Thing::mass, dem::kPositive, "its mass");
  table.choice("shape", &Thing::shape, dem::Words<Shape>{{"ball", Shape::ball}, {"rod", Shape::rod}},
               "its shape");
  const auto is_rod = [](const Thing& thing) { return thing.shape == Shape::rod; };
  table.number("aspect", &Thing::aspect, dem::kPositive, "length over diameter")
      .required()
      .only_with("shape: rod", is_rod);
  table.number("stretch", &Thing::stretch, dem::kFinite, "strain").otherwise("none");
  table.integer("number", &Thing::number, {.low = 1, .high = 9}, "how many");
  const auto store = [](const dem::StrictMapping&, const Leg& leg, Thing& thing) {
    thing.legs.push_back(leg.length);
  };
  table.list("legs", leg_keys(), store, "its legs").otherwise("none");
  table.one_of({"stretch", "number"}, "it is one");
  return table;
}

Thing read(const std::string& text) { return thing_keys().read_strictly(dem::StrictMapping(text, "t")); }

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "no error";
}

struct Fault {
  const char* text;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.text; }

const Fault kFaults[] = {
    {"mass: 0 kg\n",
     "t:1: mass: '0 kg' is out of range; allowed: a number at least 1e-18 and at most 1e+15, in kg"},
    {"mass: 1\nshape: rod\n", "t:1: key 'aspect' is missing"},
    {"mass: 1\naspect: 3\n", "t:2: aspect: is of use only with shape: rod"},
    {"number: 12\n", "t:1: number: '12' is not allowed; allowed: a whole number at least 1 and at most 9"},
    {"shape: cube\n", "t:1: shape: 'cube' is not allowed; allowed: ball, rod"},
    {"stretch: 1\nnumber: 2\n", "t:1: must have exactly one of stretch, number"},
    {"legs: [{length: 1 m}, {length: 1 s}]\n",
     "t:1: legs[1].length: '1 s' has a unit of another dimension; allowed: m and its like"},
    {"legs: [{lenght: 1 m}]\n", "t:1: unknown key 'legs[0].lenght'; did you mean 'length'?"},
    {"weight: 1\n", "t:1: unknown key 'weight'; allowed: mass, shape, aspect, stretch, number, legs"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(declared_keys_fill_the_value) {
  const Thing thing = read("mass: 3 g\nshape: rod\naspect: 4\nnumber: 5\nlegs: [{length: 2 cm}, {}]\n");
  BOOST_TEST(thing.mass == 3e-3);
  BOOST_TEST((thing.shape == Shape::rod));
  BOOST_TEST(thing.aspect.value() == 4);
  BOOST_TEST(!thing.stretch.has_value());
  BOOST_TEST(thing.number == 5);
  BOOST_TEST(thing.legs == (std::vector<double>{0.02, 0.5}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(keys_left_out_have_the_value_of_the_type) {
  const Thing thing = read("legs: [{length: 1}]\n");
  BOOST_TEST(thing.mass == 2);
  BOOST_TEST((thing.shape == Shape::ball));
  BOOST_TEST(thing.number == 7);
}

BOOST_DATA_TEST_CASE(faults_are_told_by_the_declaration, boost::unit_test::data::make(kFaults), fault) {
  BOOST_TEST(error_of(fault.text) == fault.says);
}

BOOST_AUTO_TEST_CASE(a_declaration_documents_its_key) {
  const std::vector<dem::KeyDeclaration> keys = thing_keys().declarations();
  BOOST_REQUIRE_EQUAL(keys.size(), 6u);
  BOOST_TEST((keys[0].unit == "kg" && keys[0].allowed == "at least 1e-18 and at most 1e+15" &&
              keys[0].otherwise == "2" && !keys[0].must));
  BOOST_TEST((keys[1].allowed == "`ball`, `rod`" && keys[1].otherwise == "ball"));
  BOOST_TEST((keys[2].must && keys[2].meaning == "length over diameter; only with shape: rod"));
  BOOST_TEST(keys[3].otherwise == "with `number`; without both it is one");
  BOOST_TEST((keys[5].list && keys[5].keys.size() == 1 && keys[5].keys[0].otherwise == "0.5"));
}

BOOST_AUTO_TEST_SUITE_END()
