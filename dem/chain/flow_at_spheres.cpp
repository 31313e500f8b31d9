#include "dem/chain/flow_at_spheres.hpp"

namespace fiberchain::dem {

template <int Dim>
SphereVector<Dim> drag_of(const Fluid& fluid, const Fiber& fiber) {
  const StokesDrag drag = stokes_drag(fluid, fiber);
  SphereVector<Dim> all;
  all.template head<Dim>().setConstant(drag.translation);
  all.template tail<spin_size<Dim>>().setConstant(drag.rotation);
  return all;
}

template <int Dim>
ChainVector<Dim> undisturbed(const Gradient& A, const Poses<Dim>& poses) {
  ChainVector<Dim> motion(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    motion[i] = motion_of<Dim>(velocity_at<Dim>(A, poses[i].position), spin_of<Dim>(A));
  }
  return motion;
}

template SphereVector<2> drag_of<2>(const Fluid&, const Fiber&);
template SphereVector<3> drag_of<3>(const Fluid&, const Fiber&);
template ChainVector<2> undisturbed<2>(const Gradient&, const Poses<2>&);
template ChainVector<3> undisturbed<3>(const Gradient&, const Poses<3>&);

}  // namespace fiberchain::dem
