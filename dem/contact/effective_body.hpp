#pragma once

// Apart from contact_body.hpp, so that laws in the kernels know nothing of fibers and domains.
namespace fiberchain::dem {

/// Two bodies as one: 1/E* = sum (1 - nu^2)/E, 1/G* = sum (2 - nu)/G, 1/R* = sum 1/R, 1/m* = sum 1/m, 1/J* =
/// sum 1/J.
struct EffectiveBody {
  double youngs_modulus, shear_modulus;  ///< E*, G* [Pa]
  double radius, mass, inertia;          ///< R*, m*, J* [m], [kg], [kg m^2]
};

}  // namespace fiberchain::dem
