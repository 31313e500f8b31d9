#pragma once

#include "dem/contact/contact_body.hpp"
#include "dem/model/contact_properties.hpp"

namespace fiberchain::dem {

/// A collision of two bodies head on.
struct Impact {
  double overlap;  ///< largest [m]
  double time;     ///< from touch to parting [s]
};

/// Of two free bodies that close in at `speed` [m/s] > 0, without what damping takes, from the stiffness of
/// the contact law: m* v^2 / 2 is the work to the largest overlap. Hertz: overlap = v time / 2.943 whatever
/// the modulus (Johnson, Contact Mechanics (1985), 11.4).
Impact elastic_impact(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                      double speed);

}  // namespace fiberchain::dem
