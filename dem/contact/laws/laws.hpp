#pragma once

#include "dem/contact/laws/dmt.hpp"
#include "dem/contact/laws/hertz_mindlin.hpp"
#include "dem/contact/laws/jkr.hpp"
#include "dem/math/type_list.hpp"

// The contact laws that the contact loops are compiled for, the default first. A further one is a header and
// a line here; a scene names it by ContactProperties::law = &contact_law("name")
// (dem/contact/contact_law.hpp).
//
// A law is a type with, as static functions from parameters() on; act, overlap, elastic_force, spring_energy
// on any Real, the others on doubles:
// clang-format off
//   name                                  as a scene names it
//   acts_beyond_touch                     whether it acts across a gap; then also
//   reach(body, properties)               the largest such gap [m]
//   elastic_force(p, history)             in place of elastic_force(p, overlap), after act(): 0 where it holds nothing
//   lost_at_end(p, history)               what the normal spring has lost where the contact ends [J], on any Real
//   adheres                               true where it wants a work of adhesion; of other laws left out
//   Parameters<Real>                      numbers only: of a pair of bodies
//   History<Real>                         numbers only, contact_history_size at most, zero before the first touch.
//                                         The first is `spring`, the tangential spring's force on the first body [N];
//                                         two more are `normal_velocity` [m/s] and `rolling_power` [W] of the step
//                                         before: for the account
//   parameters(body, properties, dt)      Parameters<double> of two bodies with these properties
//   stiffness(body, properties, overlap)  what the time step needs of a contact pressed in by `overlap` [m]
//   act<rolls>(p, pair, dt, history)      force and moment on the first body; the history moves on
//   exchanged(history)                    with the second body as the first: forces on the first change their sign
//   overlap(history)                      at the last act() [m]
//   elastic_force(p, overlap)             the normal spring's part of the normal force [N]; the rest is the dashpot's
//   spring_energy(p, history)             stored in the tangential spring [J]
//   stored_energy(p, history)             stored in both springs [J]
//   closing_power(p, history)             at which the normal spring is pressed [W]
// clang-format on
namespace fiberchain::dem {

using ContactLaws = TypeList<HertzMindlin, Jkr, Dmt>;

}  // namespace fiberchain::dem
