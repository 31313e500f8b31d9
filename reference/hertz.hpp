#pragma once

namespace fiberchain::reference {

// Two elastic spheres, or a sphere and a wall, that collide head on: Hertz's contact and its closed forms
// (Johnson, Contact Mechanics (1985), sections 4.2 and 11.4).

/// A sphere; a wall has an infinite radius and an infinite mass. An infinite modulus: rigid.
struct ElasticBody {
  double radius;          ///< [m]
  double mass;            ///< [kg]
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;   ///< [-]
};

/// What a contact knows of its two bodies.
struct HertzPair {
  double modulus;        ///< E*, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa]
  double shear_modulus;  ///< G*, 1/G* = (2 - nu_1)/G_1 + (2 - nu_2)/G_2 [Pa]
  double radius;         ///< R*, 1/R* = 1/R_1 + 1/R_2 [m]
  double mass;           ///< m*, 1/m* = 1/m_1 + 1/m_2 [kg]
};

/// Throws InvalidArgument unless radii, masses and moduli are positive, -1 < nu <= 0.5, and of both bodies
/// not both are flat, unmovable or rigid.
HertzPair hertz_pair(const ElasticBody& first, const ElasticBody& second);

double hertz_stiffness(const HertzPair& pair);  ///< k of F = k delta^(3/2): 4/3 E* sqrt(R*) [N/m^1.5]
double mindlin_stiffness(
    const HertzPair& pair);  ///< 8 G* sqrt(R*), times sqrt(delta) the tangential stiffness [N/m^1.5]

/// Head-on collision without damping.
struct HertzCollision {
  double overlap;  ///< largest: (5 m* v^2 / (4 k))^(2/5) [m]
  double time;     ///< of contact: 2.94328 delta / v [s]
  double force;    ///< largest: k delta^(3/2) [N]
};

/// At the closing speed v [m/s] > 0. Throws InvalidArgument.
HertzCollision hertz_collision(const HertzPair& pair, double speed);

/// 4/5 sqrt(pi) Gamma(2/5) / Gamma(9/10) = 2.94328: time of contact by largest overlap over closing speed.
double hertz_time_factor();

// With a dashpot c delta^(1/4), c = 2 zeta sqrt(5/4 m* k), beside the spring. With y = 4/5 delta^(5/4) and
// time counted by delta^(1/4), y'' + 2 zeta w y' + w^2 y = 0, w^2 = 5 k / (4 m*), a linear oscillator
// (Antypov & Elliott, EPL 94 (2011) 50004).

/// When a contact is over.
enum class ContactEnd {
  zero_force,   ///< bodies do not pull on each other
  zero_overlap  ///< they do until they have parted
};

/// Coefficient of restitution at any speed and stiffness: exp(-2 zeta acos(zeta) / sqrt(1 - zeta^2)) at zero
/// force (acosh beyond zeta = 1), exp(-pi zeta / sqrt(1 - zeta^2)) at zero overlap (0 from zeta = 1 on).
/// Throws InvalidArgument unless zeta >= 0.
double hertz_restitution(double damping_ratio, ContactEnd end);

/// Its inverse for zero overlap, which is the formula in common use: zeta = -ln e / sqrt(pi^2 + ln^2 e).
/// Throws InvalidArgument unless 0 < e <= 1.
double common_damping_ratio(double restitution);

/// Head-on collision with the dashpot, ended at zero force.
struct DampedCollision {
  double overlap;       ///< largest [m], closed form
  double time;          ///< of contact [s], by quadrature over the oscillator's phase
  double restitution;   ///< closed form
  double overlap_left;  ///< when the force has gone [m], closed form
};

/// Throws InvalidArgument unless speed > 0 and 0 <= zeta < 1.
DampedCollision damped_hertz_collision(const HertzPair& pair, double damping_ratio, double speed);

}  // namespace fiberchain::reference
