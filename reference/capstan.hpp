#pragma once

namespace fiberchain::reference {

// A rod drawn over a fixed drum, all of it sliding, pulled by a force at each end from far away.
//
// Along the arc in contact the curvature is 1/rho, so the moment is constant and the shear force Q balances
// the couple of friction, which acts on the rod's surface: Q = -mu p r. With T' = Q/rho + mu p and p = T/rho
// + Q' per length, T grows as exp(growth a) with the angle a. Where the rod leaves the drum a point force P
// beside the pressure takes the shear force of the free part, which is an elastica: M^2/(2 E I) = F (1 - cos
// a) where it makes the angle a with its force. So Euler and Eytelwein's exp(mu phi) loses by the rod's
// thickness, to first order mu phi r/rho, and by bending at the ends, to first order (1 + mu^2)/2 E I/rho^2
// (1/F_0 - 1/F): angles of sqrt(E I/F)/rho without pressure, of which the point forces take back the first
// order. Limits: Jung, Pan & Kang, Tribology International 41 (2008) 524 (thickness and bending); Singh, J.
// Elasticity 151 (2022) 321 (the elastica of both ends).

struct Capstan {
  double friction;           ///< mu [-]
  double turning;            ///< phi, between the directions of both forces [rad]
  double radius;             ///< rho, of the rod's axis on the drum [m]
  double rod_radius;         ///< r [m]; 0: friction acts on the axis
  double bending_stiffness;  ///< E I [N m^2]
};

struct CapstanPull {
  double force;        ///< F at the end that is pulled [N]
  double touching;     ///< angle of the arc in contact [rad]
  double held_angle;   ///< of the rod with its force where it comes to the drum [rad]
  double drawn_angle;  ///< likewise where it leaves it
};

/// exp(mu phi). Throws InvalidArgument unless both are 0 or more.
double euler_eytelwein(double friction, double turning);

/// d ln T / d angle of the arc in contact.
double tension_growth(const Capstan& capstan);

/// The force that draws the rod against `held_force` [N]. Throws InvalidArgument unless all are above 0 (rod
/// radius and friction 0 or more), and where no arc is in contact.
CapstanPull drawn_over(const Capstan& capstan, double held_force);

}  // namespace fiberchain::reference
