#pragma once

#include "dem/contact/contact_body.hpp"
#include "dem/model/contact_properties.hpp"

namespace fiberchain::dem {

/// How far the coefficient of restitution is off at a step [s] when two free bodies meet head on at `speed`
/// [m/s]: the largest difference over the moments within a step at which they may touch.
double restitution_error(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                         double speed, double step);

/// The largest step [s] up to `high` with which it is off by `allowed` at most, to 3 %; a tenth of `high`
/// where none above does. Throws InvalidInput unless allowed is above 0.
double step_for_restitution(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                            double speed, double allowed, double high);

}  // namespace fiberchain::dem
