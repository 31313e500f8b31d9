#include "dem/motion/cvode_session.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "dem/model/errors.hpp"
#include "dem/motion/vector_operations.hpp"

namespace fiberchain::dem {
namespace {

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

struct CvodeSession::Memory {
  CvodeProblem problem;
  std::unique_ptr<std::remove_pointer_t<SUNContext>, ContextFree> context;
  Vector y, tolerances;
  std::unique_ptr<void, MemoryFree> cvode;
  std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, LinearSolverFree> linear;
  double last_time = -1, last_gamma = 0;
  int again = 0;
  std::exception_ptr thrown;

  static int rates(double time, N_Vector y, N_Vector rate, void* self) {
    Memory& own = *static_cast<Memory*>(self);
    try {
      own.problem.rates(time, data(y), data(rate));
    } catch (...) {
      own.thrown = std::current_exception();
      return -1;
    }
    return std::isfinite(N_VL1Norm(rate)) ? 0 : 1;  // 1: CVODE takes a shorter step
  }

  /// CVODE's matrix-embedded solver: it asks for the solution only, and tells gamma when asked.
  static int solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double) {
    Memory& own = *static_cast<Memory*>(solver->content);
    double time, gamma, rl1;
    N_Vector predicted, y, rate, zn1;
    void* user;
    if (CVodeGetNonlinearSystemData(own.cvode.get(), &time, &predicted, &y, &rate, &gamma, &rl1, &zn1,
                                    &user) < 0) {
      return SUNLS_MEM_FAIL;
    }
    const bool same = time == own.last_time && gamma == own.last_gamma;
    own.again = same ? own.again + 1 : 0;
    own.last_time = time, own.last_gamma = gamma;
    try {
      own.problem.solve({time, gamma, data(predicted), own.again}, data(b), data(x));
    } catch (...) {
      own.thrown = std::current_exception();
      return SUNLS_PACKAGE_FAIL_UNREC;
    }
    return SUNLS_SUCCESS;
  }

  static SUNLinearSolver_Type matrix_embedded(SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; }
};

CvodeSession::CvodeSession(CvodeProblem problem) : memory_(std::make_unique<Memory>()) {
  for (const double value : problem.tolerances) {
    if (!(value > 0) || !std::isfinite(value)) {
      throw InvalidInput(
          fmt::format("tolerance = {} is not allowed: it must be finite and greater than 0", value));
    }
  }
  Memory& m = *memory_;
  m.problem = std::move(problem);
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  m.context.reset(context);
  const auto size = static_cast<sunindextype>(m.problem.start.size());
  m.y.reset(N_VNew_Serial(size, context));
  use_own_operations(m.y.get());
  m.tolerances.reset(N_VClone(m.y.get()));
  std::ranges::copy(m.problem.start, data(m.y.get()));
  std::ranges::copy(m.problem.tolerances, data(m.tolerances.get()));
  m.cvode.reset(CVodeCreate(CV_BDF, context));
  void* cvode = m.cvode.get();
  m.linear.reset(SUNLinSolNewEmpty(context));
  m.linear->ops->gettype = Memory::matrix_embedded;
  m.linear->ops->solve = Memory::solve;
  m.linear->content = &m;
  require(CVodeSetErrHandlerFn(
              cvode, [](int, const char*, const char*, char*, void*) {}, nullptr),
          "CVodeSetErrHandlerFn");
  require(CVodeInit(cvode, Memory::rates, 0.0, m.y.get()), "CVodeInit");
  require(CVodeSVtolerances(cvode, 0.0, m.tolerances.get()), "CVodeSVtolerances");
  require(CVodeSetUserData(cvode, &m), "CVodeSetUserData");
  require(CVodeSetLinearSolver(cvode, m.linear.get(), nullptr), "CVodeSetLinearSolver");
  require(CVodeSetMaxNumSteps(cvode, m.problem.max_steps), "CVodeSetMaxNumSteps");
}

CvodeSession::~CvodeSession() = default;
CvodeSession::CvodeSession(CvodeSession&&) noexcept = default;

const double* CvodeSession::at(double time) {
  double reached = 0;
  if (time > 0) {
    const int flag = CVode(memory_->cvode.get(), time, memory_->y.get(), &reached, CV_NORMAL);
    if (memory_->thrown) std::rethrow_exception(std::exchange(memory_->thrown, nullptr));
    if (flag < 0) {
      CVodeGetCurrentTime(memory_->cvode.get(), &reached);
      throw Diverged(fmt::format(
          "CVODE gave up at t = {:.6g} s: {}; likely cause: a tolerance below the rounding of the "
          "positions",
          reached, CVodeGetReturnFlagName(flag)));
    }
  }
  return data(memory_->y.get());
}

double CvodeSession::steps() const {
  long steps = 0;
  CVodeGetNumSteps(memory_->cvode.get(), &steps);
  return static_cast<double>(steps);
}

}  // namespace fiberchain::dem
