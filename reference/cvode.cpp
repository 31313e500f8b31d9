#include "reference/cvode.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "reference/errors.hpp"

namespace fiberchain::reference::detail {
namespace {

template <class T>
T* require_memory(T* pointer) {
  if (pointer == nullptr) throw std::bad_alloc();
  return pointer;
}

SUNContext new_context() {
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  return context;
}

template <auto free>
struct Free {
  template <class T>
  void operator()(T* pointer) const {
    free(pointer);
  }
};

void free_context(SUNContext context) { SUNContext_Free(&context); }
void free_cvode(void* memory) { CVodeFree(&memory); }

using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, Free<&free_context>>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Free<&N_VDestroy>>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Free<&SUNMatDestroy>>;
using Solver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Free<&SUNLinSolFree>>;
using Integrator = std::unique_ptr<void, Free<&free_cvode>>;

std::span<double> values(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<std::size_t>(N_VGetLength(vector))};
}

}  // namespace

/// Declared in the order of creation, so that everything is freed before the context it belongs to.
struct Cvode::Memory {
  CvodeRhs rhs;
  CvodeJacobian jacobian;
  std::string name;
  std::exception_ptr failure;
  Context context;
  Vector state;
  Matrix matrix;
  Solver solver;
  Integrator integrator;

  /// Runs a callback; an exception must not travel through C, so it is kept and -1 stops CVODE.
  template <class Callback>
  int guarded(const Callback& callback) noexcept {
    try {
      callback();
      return 0;
    } catch (...) {
      failure = std::current_exception();
      return -1;
    }
  }

  static int call_rhs(realtype t, N_Vector state, N_Vector derivative, void* self) {
    auto& memory = *static_cast<Memory*>(self);
    return memory.guarded([&] { memory.rhs(t, values(state), values(derivative)); });
  }

  static int call_jacobian(realtype t, N_Vector state, N_Vector, SUNMatrix matrix, void* self, N_Vector,
                           N_Vector, N_Vector) {
    auto& memory = *static_cast<Memory*>(self);
    const std::span<double> entries(SUNDenseMatrix_Data(matrix),
                                    static_cast<std::size_t>(SUNDenseMatrix_LData(matrix)));
    std::fill(entries.begin(), entries.end(), 0.0);
    return memory.guarded([&] { memory.jacobian(t, values(state), entries); });
  }

  static void keep_quiet(int, const char*, const char*, char*, void*) {}

  void check(int flag, const char* call) const {
    if (failure) std::rethrow_exception(failure);
    if (flag >= 0) return;
    const std::unique_ptr<char, Free<&std::free>> text(CVodeGetReturnFlagName(flag));
    throw NoConvergence(name + " (" + call + ": " + (text ? text.get() : "unknown") + ")");
  }
};

Cvode::Cvode(CvodeMethod method, CvodeRhs rhs, CvodeJacobian jacobian, double t,
             std::span<const double> state, const CvodeTolerances& tolerances, std::string name)
    : memory_(std::make_unique<Memory>()) {
  require_positive("relative tolerance", tolerances.relative);
  require_positive("absolute tolerance", tolerances.absolute);
  Memory& m = *memory_;
  m.rhs = std::move(rhs);
  m.jacobian = std::move(jacobian);
  m.name = std::move(name);
  const auto n = static_cast<sunindextype>(state.size());
  m.context.reset(new_context());
  m.state.reset(require_memory(N_VNew_Serial(n, m.context.get())));
  std::copy(state.begin(), state.end(), values(m.state.get()).begin());
  m.matrix.reset(require_memory(SUNDenseMatrix(n, n, m.context.get())));
  m.solver.reset(require_memory(SUNLinSol_Dense(m.state.get(), m.matrix.get(), m.context.get())));
  m.integrator.reset(
      require_memory(CVodeCreate(method == CvodeMethod::bdf ? CV_BDF : CV_ADAMS, m.context.get())));
  void* cvode = m.integrator.get();
  m.check(CVodeSetErrHandlerFn(cvode, &Memory::keep_quiet, nullptr), "CVodeSetErrHandlerFn");
  m.check(CVodeInit(cvode, &Memory::call_rhs, t, m.state.get()), "CVodeInit");
  m.check(CVodeSetUserData(cvode, &m), "CVodeSetUserData");
  m.check(CVodeSStolerances(cvode, tolerances.relative, tolerances.absolute), "CVodeSStolerances");
  m.check(CVodeSetMaxNumSteps(cvode, tolerances.max_steps), "CVodeSetMaxNumSteps");
  m.check(CVodeSetLinearSolver(cvode, m.solver.get(), m.matrix.get()), "CVodeSetLinearSolver");
  m.check(CVodeSetJacFn(cvode, &Memory::call_jacobian), "CVodeSetJacFn");
}

Cvode::~Cvode() = default;

std::span<const double> Cvode::advance(double t) {
  Memory& m = *memory_;
  realtype reached = 0;
  m.check(CVode(m.integrator.get(), t, m.state.get(), &reached, CV_NORMAL), "CVode");
  return values(m.state.get());
}

CvodeStatistics Cvode::statistics() const {
  void* cvode = memory_->integrator.get();
  CvodeStatistics s;
  memory_->check(CVodeGetNumSteps(cvode, &s.steps), "CVodeGetNumSteps");
  memory_->check(CVodeGetNumRhsEvals(cvode, &s.right_hand_sides), "CVodeGetNumRhsEvals");
  memory_->check(CVodeGetNumJacEvals(cvode, &s.jacobians), "CVodeGetNumJacEvals");
  memory_->check(CVodeGetNumLinSolvSetups(cvode, &s.linear_setups), "CVodeGetNumLinSolvSetups");
  memory_->check(CVodeGetNumNonlinSolvIters(cvode, &s.newton_iterations), "CVodeGetNumNonlinSolvIters");
  memory_->check(CVodeGetNumErrTestFails(cvode, &s.error_test_failures), "CVodeGetNumErrTestFails");
  memory_->check(CVodeGetNumNonlinSolvConvFails(cvode, &s.convergence_failures),
                 "CVodeGetNumNonlinSolvConvFails");
  return s;
}

}  // namespace fiberchain::reference::detail
