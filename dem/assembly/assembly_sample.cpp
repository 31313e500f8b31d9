#include "dem/assembly/assembly_state.hpp"

#include "dem/assembly/fiber_reader.hpp"

// Sums over an assembly now: energies and bending.
namespace fiberchain::dem {
namespace {

/// Power dissipated by the dashpots of a bond at this moment [W].
double dashpot_power(const BondParameters<double>& law, const MovingSphere<double, 3>& a,
                     const MovingSphere<double, 3>& b) {
  const Vec<double, 3> r = b.pose.position - a.pose.position;
  const RelativeMotion<double, 3> motion{b.velocity - a.velocity, 0.5 * (a.spin + b.spin), b.spin - a.spin};
  const BondLoads<double, 3> loads = act_at_middle(r, dashpot_action(law, r, unit(r), motion));
  return power_taken(loads, motion.velocity, a.spin, b.spin);
}

/// Of one block. Blocks are added in their order, whichever thread had them.
struct BlockSums {
  EnergyBalance energy{};
  BondSums bonds{};
  std::int64_t count = 0;  ///< of bonds
};

/// Half of the work of the kick that is centered on this moment.
double damping_now(const Assembly::State& s, const FiberBlock& block, const FiberReader& reader, int lane) {
  const GroupKind& kind = s.kinds[block.group()];
  const ChainState<3>& state = reader.state();
  const auto sphere = [&](int i) {
    return MovingSphere<double, 3>{state.poses[i], state.velocity[i], state.spin[i], {}, {}};
  };
  double sum = 0;
  for (int i = 0; i + 1 < kind.spheres(); ++i) {
    if (block.is_broken(kind, lane, i)) continue;
    sum += 0.5 * s.step * dashpot_power(kind.parameters.bond, sphere(i), sphere(i + 1));
  }
  return sum;
}

void add_fiber(const GroupKind& kind, const ChainState<3>& state, EnergyBalance& energy) {
  for (int i = 0; i < kind.spheres(); ++i) {
    const Vec<double, 3>&v = state.velocity[i], &w = state.spin[i];
    const double share = kind.share(i);
    energy.kinetic += 0.5 * share * (kind.mass * dot(v, v) + kind.inertia * dot(w, w));
    energy.gravity -= share * dot(kind.weight, state.poses[i].position);
  }
}

BlockSums sums_of(const Assembly::State& s, const FiberBlock& block, FiberReader& reader) {
  const GroupKind& kind = s.kinds[block.group()];
  BlockSums sums;
  EnergyBalance& energy = sums.energy;
  reader.take(block);
  for (int lane = 0; lane < block.lanes(); ++lane) {
    const ChainState<3>& state = reader.read(lane);
    add_fiber(kind, state, energy);
    const BondSums own = kind.law->sums(kind.parameters.bond, kind.chain, state, reader.history(lane, 0),
                                        kind.kernel->width, kind.memory.bond * kind.kernel->width);
    sums.bonds.energy += own.energy;
    sums.bonds.bending += own.bending;
    sums.count += own.whole;
    energy.yielding += own.plastic_work;
    if (s.options.account_energy && block.moved()) energy.bond_damping += damping_now(s, block, reader, lane);
  }
  const FiberBlock::Taken taken = block.taken(kind, s.rows);
  energy.bond_damping += taken.damping;
  energy.bond_friction += taken.friction;
  energy.scheme += taken.scheme;
  energy.fluid += block.fluid_dissipation();
  return sums;
}

}  // namespace

AssemblySample Assembly::State::sample() {
  std::vector<BlockSums> sums(blocks.size());
  for_blocks(*this, 0, static_cast<int>(blocks.size()),
             [&](int b, FiberReader& reader) { sums[b] = sums_of(*this, blocks[b], reader); });
  AssemblySample all{};
  EnergyBalance& energy = all.energy;
  for (const BlockSums& own : sums) {
    energy.kinetic += own.energy.kinetic;
    energy.gravity += own.energy.gravity;
    energy.bonds += own.bonds.energy;
    energy.bond_damping += own.energy.bond_damping;
    energy.bond_friction += own.energy.bond_friction;
    energy.scheme += own.energy.scheme;
    energy.yielding += own.energy.yielding;
    energy.fluid += own.energy.fluid;
    all.bending += own.bonds.bending;
    all.bonds += own.count;
  }
  const ContactSums touching = contacts.sums();
  energy.contacts = touching.stored_energy;
  all.overlap = touching.overlap, all.overlapping = touching.overlapping;
  const ContactAccount<double> dissipated = contacts.dissipated();
  energy.contact_normal = dissipated.normal_dashpot;
  energy.contact_tangential = dissipated.sliding;
  energy.contact_rolling = dissipated.rolling;
  energy.wall_work = contacts.wall_work();
  energy.held_work = options.account_energy ? held.work(*this) : 0;
  energy.breaking = released;
  energy.inserted = inserted;
  return all;
}

}  // namespace fiberchain::dem
