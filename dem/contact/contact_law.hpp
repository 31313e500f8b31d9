#pragma once

#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "dem/contact/collision.hpp"
#include "dem/contact/contact_body.hpp"
#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/laws/laws.hpp"

// A contact law as an assembly calls it when the program runs: its functions on plain numbers, once a pair of
// bodies or a contact, and the loops it is compiled into. All of it follows from the law's type
// (laws/laws.hpp).
namespace fiberchain::dem {

struct ContactLaw {
  std::string_view name;
  int parameters_size;  ///< numbers of Parameters
  void (*parameters)(const EffectiveBody&, const ContactProperties&, double step, double* numbers);
  ContactStiffness (*stiffness)(const EffectiveBody&, const ContactProperties&, double overlap);
  /// Of a head-on collision at this speed, step and phase (collision.hpp).
  double (*restitution)(const EffectiveBody&, const ContactProperties&, double speed, double step,
                        double phase);
  double (*reach)(const EffectiveBody&, const ContactProperties&);           ///< gap up to which it acts [m]
  double (*overlap)(const double* history);                                  ///< [m]
  double (*stored_energy)(const double* parameters, const double* history);  ///< [J]
  double (*normal_energy)(const double* parameters,
                          const double* history);  ///< without the tangential spring [J]
  double (*closing_power)(const double* parameters, const double* history);  ///< [W]
  void (*exchange_bodies)(double* history);  ///< the history as if the second body were the first
  /// Over a step [s] behind this history, which stays; over none: of the moment that the history is of.
  ContactAction<double> (*act)(const double* parameters, const TouchingPair<double>&, double step,
                               const double* history);
  const ContactKernel& (*kernel)(const ContactPhysics&, InstructionSet);
  std::span<const WallShapeType* const>
      shapes;            ///< that its wall loops are compiled for, in the order of ContactKernel::walls
  bool adheres = false;  ///< and wants a work of adhesion
};

/// A value of numbers only, from and to them.
template <class Value>
Value from_numbers(const double* numbers) {
  static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % sizeof(double) == 0);
  Value value;
  std::memcpy(static_cast<void*>(&value), numbers, sizeof value);
  return value;
}

template <class Value>
void to_numbers(const Value& value, double* numbers) {
  static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) % sizeof(double) == 0);
  std::memcpy(numbers, &value, sizeof value);
}

template <class Shapes>
struct WallShapeTypes;
template <template <class> class... Shapes>
struct WallShapeTypes<ShapeList<Shapes...>> {
  static_assert((NumberShape<Shapes<double>> && ...), "the loops take a shape as wall_shape_size numbers");
  static constexpr const WallShapeType* list[] = {&wall_shape_type<Shapes<double>>...};
};

/// The functions of a law, with loops that are compiled for a list of laws and one of shapes
/// (kernels/contacts.cpp).
template <class Law, class Laws = ContactLaws, class Shapes = WallShapes>
struct ContactLawOf {
  static_assert(index_in<Law>(Laws{}) < Laws::size, "the loops are not compiled for this law");
  using Parameters = typename Law::template Parameters<double>;
  using History = typename Law::template History<double>;

  static void parameters(const EffectiveBody& body, const ContactProperties& properties, double step,
                         double* numbers) {
    to_numbers(Law::parameters(body, properties, step), numbers);
  }
  static double reach(const EffectiveBody& body, const ContactProperties& properties) {
    if constexpr (Law::acts_beyond_touch) return Law::reach(body, properties);
    return 0;
  }
  static double overlap(const double* history) { return Law::overlap(from_numbers<History>(history)); }
  static double stored_energy(const double* parameters, const double* history) {
    return Law::stored_energy(from_numbers<Parameters>(parameters), from_numbers<History>(history));
  }
  static double normal_energy(const double* parameters, const double* history) {
    History unsheared = from_numbers<History>(history);
    unsheared.spring = {};
    return Law::stored_energy(from_numbers<Parameters>(parameters), unsheared);
  }
  static double closing_power(const double* parameters, const double* history) {
    return Law::closing_power(from_numbers<Parameters>(parameters), from_numbers<History>(history));
  }
  static void exchange_bodies(double* history) {
    to_numbers(Law::exchanged(from_numbers<History>(history)), history);
  }
  static ContactAction<double> act(const double* parameters, const TouchingPair<double>& pair, double step,
                                   const double* history) {
    History now = from_numbers<History>(history);
    return Law::template act<true>(from_numbers<Parameters>(parameters), pair, step, now);
  }
  static const ContactKernel& kernel(const ContactPhysics& physics, InstructionSet set) {
    return kernel_of<ContactKernelFamily<Laws, Shapes>::template Of>(
        set, contact_index(physics, index_in<Law>(Laws{})));
  }
};

template <class Law, class Laws = ContactLaws, class Shapes = WallShapes>
inline constexpr ContactLaw contact_law_of{
    .name = Law::name,
    .parameters_size = sizeof(typename Law::template Parameters<double>) / sizeof(double),
    .parameters = ContactLawOf<Law, Laws, Shapes>::parameters,
    .stiffness = Law::stiffness,
    .restitution = collision_restitution<Law>,
    .reach = ContactLawOf<Law, Laws, Shapes>::reach,
    .overlap = ContactLawOf<Law, Laws, Shapes>::overlap,
    .stored_energy = ContactLawOf<Law, Laws, Shapes>::stored_energy,
    .normal_energy = ContactLawOf<Law, Laws, Shapes>::normal_energy,
    .closing_power = ContactLawOf<Law, Laws, Shapes>::closing_power,
    .exchange_bodies = ContactLawOf<Law, Laws, Shapes>::exchange_bodies,
    .act = ContactLawOf<Law, Laws, Shapes>::act,
    .kernel = ContactLawOf<Law, Laws, Shapes>::kernel,
    .shapes = WallShapeTypes<Shapes>::list,
    .adheres = Adheres<Law>};

/// The law of this name among ContactLaws. Throws InvalidInput where there is none.
const ContactLaw& contact_law(std::string_view name);

/// The law of these properties: the first of ContactLaws where none is named.
const ContactLaw& law_of(const ContactProperties& properties);

/// The names of ContactLaws with their laws.
std::vector<std::pair<std::string, const ContactLaw*>> contact_law_words();

/// Throws InvalidInput for friction that is negative or not finite, for an elasticity that no material has,
/// for a law that adheres without a work of adhesion, or a work of adhesion without such a law.
void check(const ContactProperties& properties);

/// Number of a wall's shape among those of the law's loops; behind them all of a mesh. Throws InvalidInput
/// where they are not compiled for it.
int shape_index(const ContactLaw& law, const Wall& wall);

}  // namespace fiberchain::dem
