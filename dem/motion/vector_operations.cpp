#include "dem/motion/vector_operations.hpp"

#include <nvector/nvector_serial.h>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace fiberchain::dem {
namespace {

Eigen::Map<Eigen::ArrayXd> array(N_Vector v) { return {N_VGetArrayPointer(v), N_VGetLength(v)}; }

void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
  array(z) = a * array(x) + b * array(y);
}
void constant(double c, N_Vector z) { array(z).setConstant(c); }
void product(N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) * array(y); }
void quotient(N_Vector x, N_Vector y, N_Vector z) { array(z) = array(x) / array(y); }
void scaled(double c, N_Vector x, N_Vector z) { array(z) = c * array(x); }
void absolute(N_Vector x, N_Vector z) { array(z) = array(x).abs(); }
void inverse(N_Vector x, N_Vector z) { array(z) = array(x).inverse(); }
void shifted(N_Vector x, double b, N_Vector z) { array(z) = array(x) + b; }

double sum_of_sizes(N_Vector x) { return array(x).abs().sum(); }
double least(N_Vector x) { return array(x).minCoeff(); }
double largest_size(N_Vector x) { return array(x).abs().maxCoeff(); }
double weighted_square_sum(N_Vector x, N_Vector w) { return (array(x) * array(w)).square().sum(); }
double weighted_norm(N_Vector x, N_Vector w) {
  return std::sqrt(weighted_square_sum(x, w) / static_cast<double>(N_VGetLength(x)));
}

/// z may be one of the vectors that are summed.
int linear_combination(int count, double* c, N_Vector* x, N_Vector z) {
  constexpr sunindextype block = 64;
  double sums[block];
  double* out = N_VGetArrayPointer(z);
  const sunindextype size = N_VGetLength(z);
  for (sunindextype begin = 0; begin < size; begin += block) {
    const sunindextype n = std::min(block, size - begin);
    std::fill_n(sums, n, 0.0);
    for (int k = 0; k < count; ++k) {
      const double* term = N_VGetArrayPointer(x[k]) + begin;
      for (sunindextype i = 0; i < n; ++i) sums[i] += c[k] * term[i];
    }
    std::copy_n(sums, n, out + begin);
  }
  return 0;
}

int scale_add_multi(int count, double* a, N_Vector x, N_Vector* y, N_Vector* z) {
  for (int k = 0; k < count; ++k) array(z[k]) = a[k] * array(x) + array(y[k]);
  return 0;
}

}  // namespace

void use_own_operations(N_Vector vector) {
  auto& own = *vector->ops;
  own.nvlinearsum = linear_sum;
  own.nvconst = constant;
  own.nvprod = product;
  own.nvdiv = quotient;
  own.nvscale = scaled;
  own.nvabs = absolute;
  own.nvinv = inverse;
  own.nvaddconst = shifted;
  own.nvl1norm = sum_of_sizes;
  own.nvmin = least;
  own.nvmaxnorm = largest_size;
  own.nvwsqrsumlocal = weighted_square_sum;
  own.nvwrmsnorm = weighted_norm;
  own.nvlinearcombination = linear_combination;
  own.nvscaleaddmulti = scale_add_multi;
}

}  // namespace fiberchain::dem
