#include "reference/thermoelastic.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <cmath>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::reference {
namespace {

void validate_wire(const ThermoelasticWire& wire) {
  require_positive("radius", wire.radius);
  require_positive("modulus", wire.modulus);
  require_positive("expansion (without its sign)", std::abs(wire.expansion));
  require_positive("temperature", wire.temperature);
  require_positive("density", wire.density);
  require_positive("specific_heat", wire.specific_heat);
  require_positive("conductivity", wire.conductivity);
}

/// I_3(z)/I_2(z) = z/(6 + z^2/(8 + z^2/(10 + ...))), from where the terms are far above |z|.
std::complex<double> bessel_ratio(std::complex<double> z) {
  const int terms = 30 + static_cast<int>(2 * std::abs(z));
  std::complex<double> tail = 6.0 + 2.0 * terms;
  for (int n = terms - 1; n >= 0; --n) tail = 6.0 + 2.0 * n + z * z / tail;
  return z / tail;
}

/// 1 - 4 I_2/(z^2 I_1') and its derivative by x = z^2. By I_1 = I_3 + 4 I_2/z and I_1' = I_2 + I_1/z it is
/// H/(4 + H), H = z (z + I_3/I_2), in which nothing cancels.
ModulusValue unrelaxed_part(std::complex<double> x) {
  if (std::abs(x) < 1e-12) return {x * (7.0 / 24), 7.0 / 24};
  const std::complex<double> z = std::sqrt(x);
  const std::complex<double> ratio = bessel_ratio(z);
  const std::complex<double> ratio_slope = 1.0 - ratio * ratio - 5.0 * ratio / z;
  const std::complex<double> h = z * (z + ratio);
  const std::complex<double> h_slope = 2.0 * z + ratio + z * ratio_slope;
  return {h / (4.0 + h), 4.0 / ((4.0 + h) * (4.0 + h)) * h_slope / (2.0 * z)};
}

/// R^2/D [s]
double diffusion_time(const ThermoelasticWire& wire) {
  return wire.radius * wire.radius / thermal_diffusivity(wire);
}

}  // namespace

double relaxation_strength(const ThermoelasticWire& wire) {
  validate_wire(wire);
  return wire.modulus * wire.expansion * wire.expansion * wire.temperature /
         (wire.density * wire.specific_heat);
}

double thermal_diffusivity(const ThermoelasticWire& wire) {
  validate_wire(wire);
  return wire.conductivity / (wire.density * wire.specific_heat);
}

double thermoelastic_peak(const ThermoelasticWire& wire) {
  const double q = thermal_mode_zero(1);
  return q * q / (2 * std::numbers::pi * diffusion_time(wire));
}

double thermal_mode_zero(int k) {
  require_between("k", k, 1, 1e6);
  // 2 J_1' = J_0 - J_2; McMahon: below (k - 1/4) pi
  const auto slope = [](double q) { return gsl_sf_bessel_J0(q) - gsl_sf_bessel_J1(q) / q; };
  const double above = (k - 0.25) * std::numbers::pi;
  return detail::find_root(slope, above - 0.7, above, {}, "zero of J_1'");
}

double thermal_mode_weight(int k) {
  const double q = thermal_mode_zero(k);
  return 8 / (q * q * (q * q - 1));
}

ComplexModulus thermoelastic_modulus(const ThermoelasticWire& wire) {
  const double delta = relaxation_strength(wire);
  const double time = diffusion_time(wire);
  return [delta, time](std::complex<double> s) {
    const ModulusValue part = unrelaxed_part(s * time);
    return ModulusValue{1.0 + delta * part.value, delta * time * part.slope};
  };
}

PronySeries thermoelastic_series(const ThermoelasticWire& wire, int terms) {
  require_between("terms", terms, 1, 1e6);
  const double delta = relaxation_strength(wire);
  const double time = diffusion_time(wire);
  PronySeries series;
  for (int k = 1; k <= terms; ++k) {
    const double q = thermal_mode_zero(k);
    series.push_back({delta * thermal_mode_weight(k), time / (q * q)});
  }
  return series;
}

PronySeries zener_series(const ThermoelasticWire& wire) {
  const double q = thermal_mode_zero(1);
  return {{relaxation_strength(wire), diffusion_time(wire) / (q * q)}};
}

int thermoelastic_terms(double frequency_ratio, double tolerance) {
  require_positive("frequency_ratio", frequency_ratio);
  require_between("frequency_ratio", frequency_ratio, 0, 1e8);
  require_between("tolerance", tolerance, 1e-12, 1);
  const double first = thermal_mode_zero(1);
  const double x = frequency_ratio * first * first;
  const double exact = unrelaxed_part({0, x}).value.imag();
  double loss = 0;
  for (int k = 1; k <= 1000000; ++k) {
    const double q = thermal_mode_zero(k);
    const double ratio = x / (q * q);
    loss += thermal_mode_weight(k) * ratio / (1 + ratio * ratio);
    if (loss >= (1 - tolerance) * exact) return k;
  }
  throw NoConvergence("series of thermal modes");
}

UniformBeam wire_beam(const ThermoelasticWire& wire, double length) {
  validate_wire(wire);
  require_positive("length", length);
  const double r2 = wire.radius * wire.radius;
  using std::numbers::pi;
  return {length, wire.modulus * pi * r2 * r2 / 4, wire.density * pi * r2};
}

}  // namespace fiberchain::reference
