#include "dem/lammps/bond_kernel.hpp"

#include "dem/contact/kernels/pairs.hpp"
#include "dem/simd/compiled_set.hpp"

// Compiled once for each instruction set, as the engine's own loops.
namespace fiberchain::dem::mpi {
namespace {

template <class Real>
struct BondEnd {
  Pose<Real, 3> pose;
  VelocitySpin<Real> motion;
};

/// Rows of three numbers, in lanes read four at a time.
template <class Real>
Vec<Real, 3> three_at(const double* numbers, const std::int32_t* slots) {
  constexpr int size = lane_count<Real> == 1 ? 3 : 4;
  Real n[size];
  load_rows<size>(rows_at<3, Real>(numbers, slots), 0, n);
  return {n[0], n[1], n[2]};
}

template <bool oriented, class Real>
BondEnd<Real> end_at(const BondView& view, const std::int32_t* slots) {
  BondEnd<Real> end;
  end.pose.position = three_at<Real>(view.position, slots);
  end.pose.orientation = {Real(1.0), {Real(0.0), Real(0.0), Real(0.0)}};
  if constexpr (oriented) {
    Real n[quaternion_size];
    load_rows<quaternion_size>(rows_at<quaternion_size, Real>(view.orientation, slots), 0, n);
    end.pose.orientation = {n[0], {n[1], n[2], n[3]}};
  }
  end.motion = {three_at<Real>(view.velocity, slots), three_at<Real>(view.spin, slots)};
  return end;
}

/// The incremental form's history, moved on by the step that led here.
template <class Real>
BondHistory<Real, 3> history_at(const BondView& view, const std::int32_t* first,
                                const BondConfiguration<Real, 3>& now) {
  const RowStarts<Real> rows = rows_at<bond_history_size, Real>(view.history, first);
  Real n[bond_history_size];
  load_rows<bond_history_size>(rows, 0, n);
  BondHistory<Real, 3> history{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  if (view.step > 0) {
    advance(history, now.line, now.motion, Real(view.step));
    const Vec<Real, 3>&d = history.displacement, &r = history.rotation;
    const Real moved[] = {d[0], d[1], d[2], r[0], r[1], r[2]};
    store_rows<bond_history_size>(moved, rows, 0);
  }
  return history;
}

template <BondForm form, bool damped, class Real>
BondLoads<Real, 3> loads_of(const BondView& view, const BondParameters<Real>& bond, const std::int32_t* first,
                            const BondConfiguration<Real, 3>& now) {
  if constexpr (form == BondForm::incremental) {
    const BondHistory<Real, 3> history = history_at<Real>(view, first, now);
    return act_at_middle(now.line.vector, IncrementalBond::action<damped>(bond, history, now));
  } else if constexpr (damped) {
    return TotalBond::loads<Real, 3>(bond, {}, now) + dashpot_loads(bond, now);
  } else {
    return TotalBond::loads<Real, 3>(bond, {}, now);
  }
}

/// Sums up what one sphere bears: along a fiber the second sphere of a bond is mostly the first of the next.
struct SlotSum {
  double *force, *torque;
  std::int32_t slot;
  double sum[load_size] = {};

  void add(std::int32_t to, const double* load, double sign) {
    if (to != slot) flush(), slot = to;
    for (int c = 0; c < 3; ++c) sum[c] += sign * load[c], sum[moment_offset + c] += load[moment_offset + c];
  }
  void flush() {
    double *f = force + static_cast<std::ptrdiff_t>(slot) * 3,
           *t = torque + static_cast<std::ptrdiff_t>(slot) * 3;
    for (int c = 0; c < 3; ++c) {
      f[c] += sum[c], t[c] += sum[moment_offset + c];
      sum[c] = sum[moment_offset + c] = 0;
    }
  }
};

template <BondForm form, bool damped, class Real>
FIBERCHAIN_FLATTEN void act_bonds(const BondView& view) {
  constexpr int lanes = lane_count<Real>;
  const BondParameters<Real> bond = broadcast<BondParameters, Real>(as_numbers<double>(*view.parameters));
  const Real inverse_length(view.inverse_length);
  SlotSum sums{view.force, view.torque, view.first[0]};
  for (std::int32_t n = 0; n < view.count; n += lanes) {
    const std::int32_t *i = view.first + n, *j = view.second + n;
    const BondEnd<Real> a = end_at<form == BondForm::total, Real>(view, i),
                        b = end_at<form == BondForm::total, Real>(view, j);
    const BondVector<Real, 3> line = bond_vector<Real, 3>(b.pose.position - a.pose.position, inverse_length);
    const RelativeMotion<Real, 3> motion{b.motion.velocity - a.motion.velocity,
                                         Real(0.5) * (a.motion.spin + b.motion.spin),
                                         b.motion.spin - a.motion.spin};
    const BondLoads<Real, 3> loads =
        loads_of<form, damped, Real>(view, bond, i, BondConfiguration<Real, 3>{a.pose, b.pose, line, motion});
    LoadRows<Real> first, second;
    to_rows(loads.force_on_first, loads.moment_on_first, first);
    to_rows(loads.force_on_first, loads.moment_on_second, second);
    const int count = view.count - n < lanes ? view.count - n : lanes;
    for (int k = 0; k < count; ++k) {
      sums.add(i[k], first.at[k], 1);
      sums.add(j[k], second.at[k], -1);
    }
  }
  sums.flush();
}

template <class Real>
FIBERCHAIN_FLATTEN void turn_rows(double* orientation, const double* spins, std::int32_t begin,
                                  std::int32_t end, double step) {
  constexpr int lanes = lane_count<Real>;
  for (std::int32_t from = begin; from < end; from += lanes) {
    std::int32_t slots[lanes];
    for (int k = 0; k < lanes; ++k) slots[k] = from + k < end ? from + k : end - 1;
    const RowStarts<Real> rows = rows_at<quaternion_size, Real>(orientation, slots);
    Real q[quaternion_size];
    load_rows<quaternion_size>(rows, 0, q);
    const Vec<Real, 3> spin = three_at<Real>(spins, slots);
    const Quaternion<Real> turned =
        cayley_turn(Real(0.5 * step) * spin, Quaternion<Real>{q[0], {q[1], q[2], q[3]}});
    const Real after[] = {turned.w, turned.v[0], turned.v[1], turned.v[2]};
    store_rows<quaternion_size>(after, rows, 0);
  }
}

template <BondForm form, bool damped, class Real>
inline constexpr BondKernel kernel_for{lane_count<Real>, act_bonds<form, damped, Real>, turn_rows<Real>};

template <class Real>
inline constexpr BondKernel kernels_of[] = {
    kernel_for<BondForm::total, false, Real>, kernel_for<BondForm::total, true, Real>,
    kernel_for<BondForm::incremental, false, Real>, kernel_for<BondForm::incremental, true, Real>};

}  // namespace

template <>
const BondKernel* BondKernels<compiled_set>::table() {
  return kernels_of<CompiledReal>;
}

}  // namespace fiberchain::dem::mpi
