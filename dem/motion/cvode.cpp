#include "dem/motion/cvode.hpp"

#include <cmath>
#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <optional>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>

#include "dem/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Numbers of one sphere in CVODE's vector: position, orientation (angle or quaternion), velocity, spin.
template <int Dim>
inline constexpr int orientation_size = Dim == 2 ? 1 : 4;
template <int Dim>
inline constexpr int pose_size = Dim + orientation_size<Dim>;
template <int Dim>
inline constexpr int sphere_size = pose_size<Dim> + sphere_motions<Dim>;

void write(double angle, double* y) { y[0] = angle; }
void write(const Quaternion<double>& q, double* y) { y[0] = q.w, y[1] = q.v[0], y[2] = q.v[1], y[3] = q.v[2]; }
void read(const double* y, double& angle) { angle = y[0]; }
void read(const double* y, Quaternion<double>& q) { q = normalized(Quaternion<double>{y[0], {y[1], y[2], y[3]}}); }

/// d(orientation)/dt of a spin.
void write_rate(double, const Vec<double, 1>& spin, double* y) { y[0] = spin[0]; }
void write_rate(const Quaternion<double>& q, const Vec<double, 3>& spin, double* y) {
  write(Quaternion<double>{0, 0.5 * spin} * q, y);
}

/// The rotation vector that a small change of the orientation's numbers stands for.
Vec<double, 1> rotation_of(double, const double* change) { return {change[0]}; }
Vec<double, 3> rotation_of(const Quaternion<double>& q, const double* change) {
  return 2.0 * (Quaternion<double>{change[0], {change[1], change[2], change[3]}} * conjugate(q)).v;
}

double* data(N_Vector v) { return N_VGetArrayPointer(v); }

struct VectorFree {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, VectorFree>;

struct ContextFree {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct MemoryFree {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
struct LinearSolverFree {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFreeEmpty(solver); }
};

void require(int flag, const char* call) {
  if (flag < 0) throw Diverged(fmt::format("{} failed: {}", call, CVodeGetReturnFlagName(flag)));
}

}  // namespace

template <int Dim>
struct CvodeMotion<Dim>::Solver {
  Chain<Dim> chain;
  Boundary<Dim> boundary;
  ChainVector<Dim> loads;
  SphereVector<Dim> inertias;
  std::unique_ptr<std::remove_pointer_t<SUNContext>, ContextFree> context;
  Vector y, tolerances;
  std::unique_ptr<void, MemoryFree> memory;
  std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, LinearSolverFree> linear;
  // Newton's matrix of one step and what its right-hand side takes
  std::optional<ChainFactors<sphere_motions<Dim>>> factors;
  std::optional<ChainTangent<Dim>> springs;
  Poses<Dim> factors_at;
  double factors_time = -1, factors_gamma = 0;
  Work work;

  int spheres() const { return static_cast<int>(chain.poses.size()); }

  ChainState<Dim> unpack(const double* numbers) const {
    ChainState<Dim> state = at_rest<Dim>(chain.poses);
    for (int i = 0; i < spheres(); ++i, numbers += sphere_size<Dim>) {
      for (int c = 0; c < Dim; ++c) state.poses[i].position[c] = numbers[c];
      read(numbers + Dim, state.poses[i].orientation);
      for (int c = 0; c < Dim; ++c) state.velocity[i][c] = numbers[pose_size<Dim> + c];
      for (int c = 0; c < spin_size<Dim>; ++c) state.spin[i][c] = numbers[pose_size<Dim> + Dim + c];
    }
    return state;
  }

  void pack(const ChainState<Dim>& state, double* numbers) const {
    for (int i = 0; i < spheres(); ++i, numbers += sphere_size<Dim>) {
      for (int c = 0; c < Dim; ++c) numbers[c] = state.poses[i].position[c];
      write(state.poses[i].orientation, numbers + Dim);
      for (int c = 0; c < Dim; ++c) numbers[pose_size<Dim> + c] = state.velocity[i][c];
      for (int c = 0; c < spin_size<Dim>; ++c) numbers[pose_size<Dim> + Dim + c] = state.spin[i][c];
    }
  }

  void rates(const double* numbers, double* out) {
    const ChainState<Dim> state = unpack(numbers);
    ChainVector<Dim> velocity(spheres()), forces = bond_forces(chain, state.poses);
    for (int i = 0; i < spheres(); ++i) velocity[i] = motion_of<Dim>(state.velocity[i], state.spin[i]);
    const ChainVector<Dim> dashpots = dashpot_forces(chain, state.poses, velocity);
    for (int i = 0; i < spheres(); ++i) forces[i] = (forces[i] + dashpots[i] + loads[i]).cwiseQuotient(inertias);
    for (const int sphere : boundary.clamped) forces[sphere].setZero(), velocity[sphere].setZero();
    for (int i = 0; i < spheres(); ++i, out += sphere_size<Dim>) {
      for (int c = 0; c < Dim; ++c) out[c] = velocity[i][c];
      write_rate(state.poses[i].orientation, rotation_part<Dim>(velocity[i]), out + Dim);
      for (int c = 0; c < sphere_motions<Dim>; ++c) out[pose_size<Dim> + c] = forces[i][c];
    }
    work.bond_evaluations += chain.fiber.aspect_ratio;
  }

  void set_up_matrix(const double* predicted, double time, double gamma) {
    factors_at = unpack(predicted).poses;
    springs.emplace(stiffness(chain, factors_at, Boundary<Dim>{}));
    factors.emplace(motion_matrix(chain, factors_at, boundary, *springs, {1.0, gamma, gamma * gamma}));
    factors_time = time, factors_gamma = gamma;
    ++work.factorizations;
  }

  /// (I - g J) x = b: with b = (b_x, b_v), (M + g C + g^2 K) x_v = M b_v - g K b_x and x_x = b_x + g x_v. The change of
  /// the orientation's rate with the orientation itself is left to Newton's iterations.
  void solve(const double* b, double* x, double gamma) {
    ChainVector<Dim> displaced(spheres()), rhs(spheres());
    for (int i = 0; i < spheres(); ++i) {
      const double* own = b + i * sphere_size<Dim>;
      Vec<double, Dim> moved;
      for (int c = 0; c < Dim; ++c) moved[c] = own[c];
      displaced[i] = motion_of<Dim>(moved, rotation_of(factors_at[i].orientation, own + Dim));
    }
    const ChainVector<Dim> resisted = product(*springs, displaced);
    for (int i = 0; i < spheres(); ++i) {
      const double* own = b + i * sphere_size<Dim> + pose_size<Dim>;
      for (int c = 0; c < sphere_motions<Dim>; ++c) rhs[i][c] = inertias[c] * own[c] - gamma * resisted[i][c];
    }
    for (const int sphere : boundary.clamped) rhs[sphere].setZero();
    factors->solve_in_place(rhs);
    ++work.linear_solves;
    for (int i = 0; i < spheres(); ++i) {
      const double* own = b + i * sphere_size<Dim>;
      double* out = x + i * sphere_size<Dim>;
      const SphereVector<Dim> advance = gamma * rhs[i];
      double turned[orientation_size<Dim>];
      write_rate(factors_at[i].orientation, rotation_part<Dim>(advance), turned);
      for (int c = 0; c < Dim; ++c) out[c] = own[c] + advance[c];
      for (int c = 0; c < orientation_size<Dim>; ++c) out[Dim + c] = own[Dim + c] + turned[c];
      for (int c = 0; c < sphere_motions<Dim>; ++c) out[pose_size<Dim> + c] = rhs[i][c];
    }
  }
};

namespace {

template <class Solver>
int rates(double, N_Vector y, N_Vector rate, void* solver) {
  static_cast<Solver*>(solver)->rates(data(y), data(rate));
  return std::isfinite(N_VL1Norm(rate)) ? 0 : 1;  // 1: CVODE takes a shorter step
}

/// CVODE's matrix-embedded solver: it asks for the solution only, and tells gamma when asked.
template <class Solver>
int solve(SUNLinearSolver self, SUNMatrix, N_Vector x, N_Vector b, double) {
  Solver& solver = *static_cast<Solver*>(self->content);
  double time, gamma, rl1;
  N_Vector predicted, y, rate, zn1;
  void* user;
  if (CVodeGetNonlinearSystemData(solver.memory.get(), &time, &predicted, &y, &rate, &gamma, &rl1, &zn1, &user) < 0) {
    return SUNLS_MEM_FAIL;
  }
  if (!solver.factors || time != solver.factors_time || gamma != solver.factors_gamma) {
    solver.set_up_matrix(data(predicted), time, gamma);
  }
  solver.solve(data(b), data(x), gamma);
  return SUNLS_SUCCESS;
}

SUNLinearSolver_Type matrix_embedded(SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; }

}  // namespace

template <int Dim>
CvodeMotion<Dim>::CvodeMotion(const Chain<Dim>& chain, const Boundary<Dim>& boundary, const ChainState<Dim>& start,
                              const CvodeTolerance& tolerance)
    : solver_(std::make_unique<Solver>()) {
  for (const double value : {tolerance.relative, tolerance.length, tolerance.angle, tolerance.time}) {
    if (!(value > 0) || !std::isfinite(value)) {
      throw InvalidInput(fmt::format("tolerance = {} is not allowed: it must be finite and greater than 0", value));
    }
  }
  Solver& s = *solver_;
  s.chain = chain;
  s.boundary = boundary;
  s.loads = applied_loads(boundary, s.spheres());
  s.inertias = sphere_inertias<Dim>(chain.fiber);
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  s.context.reset(context);
  const int size = s.spheres() * sphere_size<Dim>;
  s.y.reset(N_VNew_Serial(size, context));
  s.tolerances.reset(N_VNew_Serial(size, context));
  s.pack(start, data(s.y.get()));
  for (int i = 0; i < size; ++i) {
    const int own = i % sphere_size<Dim>, moving = own - pose_size<Dim>;
    const bool angular = moving < 0 ? own >= Dim : moving >= Dim;
    const double scale = angular ? tolerance.angle : tolerance.length;
    data(s.tolerances.get())[i] = tolerance.relative * scale / (moving < 0 ? 1 : tolerance.time);
  }
  s.memory.reset(CVodeCreate(CV_BDF, context));
  void* memory = s.memory.get();
  s.linear.reset(SUNLinSolNewEmpty(context));
  s.linear->ops->gettype = matrix_embedded;
  s.linear->ops->solve = fiberchain::dem::solve<Solver>;
  s.linear->content = &s;
  require(CVodeSetErrHandlerFn(memory, [](int, const char*, const char*, char*, void*) {}, nullptr), "CVodeSetErrHandlerFn");
  require(CVodeInit(memory, fiberchain::dem::rates<Solver>, 0.0, s.y.get()), "CVodeInit");
  require(CVodeSVtolerances(memory, 0.0, s.tolerances.get()), "CVodeSVtolerances");
  require(CVodeSetUserData(memory, &s), "CVodeSetUserData");
  require(CVodeSetLinearSolver(memory, s.linear.get(), nullptr), "CVodeSetLinearSolver");
  require(CVodeSetMaxNumSteps(memory, tolerance.max_steps), "CVodeSetMaxNumSteps");
}

template <int Dim>
CvodeMotion<Dim>::~CvodeMotion() = default;
template <int Dim>
CvodeMotion<Dim>::CvodeMotion(CvodeMotion&&) noexcept = default;

template <int Dim>
ChainState<Dim> CvodeMotion<Dim>::at(double time) {
  double reached = 0;
  if (time > 0) {
    const int flag = CVode(solver_->memory.get(), time, solver_->y.get(), &reached, CV_NORMAL);
    if (flag < 0) {
      CVodeGetCurrentTime(solver_->memory.get(), &reached);
      throw Diverged(fmt::format("CVODE gave up at t = {:.6g} s: {}; likely cause: a tolerance below the rounding of the "
                                 "positions", reached, CVodeGetReturnFlagName(flag)));
    }
  }
  return solver_->unpack(data(solver_->y.get()));
}

template <int Dim>
Work CvodeMotion<Dim>::work() const {
  Work work = solver_->work;
  long steps = 0;
  CVodeGetNumSteps(solver_->memory.get(), &steps);
  work.steps = static_cast<double>(steps);
  return work;
}

template class CvodeMotion<2>;
template class CvodeMotion<3>;

}  // namespace fiberchain::dem
