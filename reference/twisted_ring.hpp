#pragma once

namespace fiberchain::reference {

// A straight rod joined to a ring and twisted. Its sections bear the force n = F b along the ring's axis that
// keeps the twisting moment turning, F = kappa m_t / v_t, which shears and, once the ring leaves its plane,
// stretches it.

/// Stiffnesses as of SpatialRod; infinity is allowed for the last two.
struct TwistedRing {
  double length;   ///< L [m]
  double bending;  ///< E I [N m^2]
  double torsion;  ///< G J [N m^2]
  double axial;    ///< E A [N]
  double shear;    ///< G A [N]
};

/// Turn of one end against the other at which the ring leaves its plane, with two waves around: rigid in
/// stretch and shear 2 pi sqrt(3) E I / (G J) (J. H. Michell 1889; E. E. Zajac, J. Appl. Mech. 29 (1962)
/// 136-142). Zero of the determinant of the linearized rod for motions exp(2 i s 2 pi / L). [rad]
/// Throws InvalidArgument, NoConvergence.
double twisted_ring_critical_turn(const TwistedRing& ring);

}  // namespace fiberchain::reference
