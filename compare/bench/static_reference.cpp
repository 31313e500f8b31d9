#include "compare/bench/static_reference.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multiroots.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <vector>

#include "dem/chain/residual.hpp"
#include "reference/elastica.hpp"
#include "reference/errors.hpp"

namespace fiberchain::compare {
namespace {

/// Unknowns x/L, y/L, angle of every sphere but the clamped first; equations: force and moment over load and
/// load L.
struct Balance {
  const dem::Chain<2>& chain;
  const dem::Boundary<2>& boundary;
  double length, force;

  std::size_t unknowns() const { return 3 * static_cast<std::size_t>(chain.fiber.aspect_ratio); }

  dem::Poses<2> poses(const gsl_vector* unknown) const {
    dem::Poses<2> all = chain.poses;
    for (std::size_t i = 1; i < all.size(); ++i) {
      const std::size_t k = 3 * (i - 1);
      all[i] = {{length * gsl_vector_get(unknown, k), length * gsl_vector_get(unknown, k + 1)},
                gsl_vector_get(unknown, k + 2)};
    }
    return all;
  }
};

int out_of_balance(const gsl_vector* unknown, void* data, gsl_vector* f) {
  const Balance& balance = *static_cast<const Balance*>(data);
  const auto net = dem::net_forces(balance.chain, balance.poses(unknown), balance.boundary, 1.0);
  for (std::size_t i = 1; i < net.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double scale = balance.force * (c == 2 ? balance.length : 1);
      gsl_vector_set(f, 3 * (i - 1) + static_cast<std::size_t>(c), net[i][c] / scale);
    }
  }
  return GSL_SUCCESS;
}

using Solver = std::unique_ptr<gsl_multiroot_fsolver, decltype(&gsl_multiroot_fsolver_free)>;
using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;

Vector elastica_start(const Balance& balance, double load) {
  Vector start(gsl_vector_alloc(balance.unknowns()), &gsl_vector_free);
  const reference::BeamShape shape = reference::elastica_shape(load, balance.chain.poses.size());
  for (std::size_t i = 1; i < shape.s.size(); ++i) {
    const double values[] = {shape.x[i], shape.y[i], shape.theta[i]};
    for (std::size_t c = 0; c < 3; ++c) gsl_vector_set(start.get(), 3 * (i - 1) + c, values[c]);
  }
  return start;
}

dem::Vec<double, 2> tip_from(Balance& balance, double start_load) {
  const std::size_t n = balance.unknowns();
  const Vector start = elastica_start(balance, start_load);
  gsl_multiroot_function equations{&out_of_balance, n, &balance};
  dem::Vec<double, 2> tip{};
  // the hybrid step stalls near round-off: begin again from where it stopped, with fresh differences
  for (int round = 0; round < 6; ++round) {
    Solver solver(gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, n), &gsl_multiroot_fsolver_free);
    if (!solver) throw std::bad_alloc();
    gsl_multiroot_fsolver_set(solver.get(), &equations, start.get());
    for (int i = 0; i < 500 && gsl_multiroot_fsolver_iterate(solver.get()) == GSL_SUCCESS; ++i) {
      if (gsl_multiroot_test_residual(solver->f, 1e-14) == GSL_SUCCESS) break;
    }
    gsl_vector_memcpy(start.get(), solver->x);
    tip = {gsl_vector_get(start.get(), n - 3), gsl_vector_get(start.get(), n - 2)};
    // stiff stretch springs: forces over the load carry the rounding of positions 16 r_f^2 times
    if (round == 5 && gsl_multiroot_test_residual(solver->f, 1e-7) != GSL_SUCCESS) {
      throw reference::NoConvergence("equilibrium of the chain by GSL's hybrid method");
    }
  }
  return tip;
}

}  // namespace

RootSearchTip equilibrium_by_root_search(const dem::Chain<2>& chain, const dem::Boundary<2>& boundary,
                                         double load) {
  Balance balance{chain, boundary, dem::fiber_length(chain.fiber), dem::load_force(chain.fiber, load)};
  const dem::Vec<double, 2> tip = tip_from(balance, load), other = tip_from(balance, 0.9 * load);
  return {tip, dem::norm(tip - other)};
}

}  // namespace fiberchain::compare
