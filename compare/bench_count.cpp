#include "compare/bench_count.hpp"

#include <array>
#include <utility>
#include <vector>

#include "compare/static_point.hpp"
#include "dem/chain.hpp"
#include "dem/errors.hpp"
#include "dem/motion/leapfrog.hpp"

namespace fiberchain::compare {
namespace {

/// Every Counted of a value gets the count.
template <class Value>
void count_into(Value& value, OperationCount& count) {
  Counted* all = reinterpret_cast<Counted*>(&value);
  for (std::size_t i = 0; i < sizeof(Value) / sizeof(Counted); ++i) all[i] = Counted(all[i].value(), &count);
}

dem::Pose<Counted, 2> counted(const dem::Pose<double, 2>& p) {
  return {{p.position[0], p.position[1]}, p.orientation};
}
dem::Pose<Counted, 3> counted(const dem::Pose<double, 3>& p) {
  const auto& q = p.orientation;
  return {{p.position[0], p.position[1], p.position[2]}, {q.w, {q.v[0], q.v[1], q.v[2]}}};
}

template <dem::Physics P>
OperationCount counted_step(int bonds) {
  constexpr int Dim = P.dimension;
  const auto chain = dem::straight_chain<Dim>(nominal_fiber(bonds, 0.3, dem::BondModel::paper));
  OperationCount count;
  std::vector<dem::MovingSphere<Counted, Dim>> spheres(bonds + 1);
  std::vector<dem::BondHistory<Counted, Dim>> history(bonds);
  std::vector<dem::NaturalEnds<Counted, Dim>> natural(bonds);
  dem::MarchParameters<Counted, Dim> parameters{};
  for (int i = 0; i <= bonds; ++i) {
    spheres[i] = {};
    spheres[i].pose = counted(chain.poses[i]);
    count_into(spheres[i], count);
  }
  for (auto& h : history) count_into(h, count);
  for (auto& n : natural) count_into(n, count);
  count_into(parameters, count);
  const dem::ChainBlock<P, Counted> block{bonds, {true, false}, spheres.data(), history.data(), natural.data(), &parameters};
  dem::march_step<P, Counted>(block, 1);
  return count;
}

template <std::size_t... I>
OperationCount counted_step(const dem::Physics& physics, int bonds, std::index_sequence<I...>) {
  OperationCount count;
  const bool found =
      ((physics == dem::built_physics[I] && (count = counted_step<dem::built_physics[I]>(bonds), true)) || ...);
  if (!found) throw dem::InvalidInput("operations are counted only for a physics that is built");
  return count;
}

}  // namespace

OperationCount operations_of_step(const dem::Physics& physics, int bonds) {
  return counted_step(physics, bonds, std::make_index_sequence<dem::built_physics.size()>{});
}

}  // namespace fiberchain::compare
