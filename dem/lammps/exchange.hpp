#pragma once

#include <mpi.h>

#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/lammps/bond_kernel.hpp"
#include "dem/lammps/plan.hpp"
#include "dem/scene/packing_scene.hpp"

// Between the assembly of rank 0 and the spheres of all ranks: doubles only, by the numbers of spheres.
namespace fiberchain::dem::mpi {

struct SphereRecord {
  double number, group;
  double position[3];           ///< [m]
  double velocity[3], spin[3];  ///< half a step before
  double orientation[4];
  double load[6];  ///< of contacts
  double
      history[bond_history_size];  ///< of the bond behind it: to the rank as it is now, back as a step before
};

struct ContactRecord {
  double first, second;  ///< numbers of spheres; -1 - n of wall n
  double history[contact_history_size];
};

/// What goes out: all of it on rank 0, the plan, contacts and record on every rank.
struct Outgoing {
  Plan plan;
  std::int64_t steps = 0;
  double low[3] = {}, high[3] = {};  ///< of a box that holds all spheres [m]
  MarchRecord record;
  std::vector<ContactRecord> contacts;
  std::vector<SphereRecord> spheres;  ///< by number
};

/// @throws InvalidKey for fibers that are not built here
Outgoing outgoing(const Assembly& assembly, const PackingScene& scene);

/// All but the spheres to all ranks.
void broadcast(Outgoing& all, const PackingScene& scene, MPI_Comm world, int me);

struct Gathered {
  std::vector<SphereRecord> spheres;  ///< in any order
  std::vector<ContactRecord> contacts;
  MarchRecord record;
};

/// Of all ranks, on rank 0.
template <class Record>
std::vector<Record> gathered(const std::vector<Record>& own, MPI_Comm world, int me, int ranks) {
  MPI_Datatype record;  // counts of bytes would end at 10^7 spheres
  MPI_Type_contiguous(sizeof(Record), MPI_BYTE, &record);
  MPI_Type_commit(&record);
  const int count = static_cast<int>(own.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(static_cast<std::size_t>(ranks));
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, world);
  int sum = 0;
  for (int r = 0; me == 0 && r < ranks; ++r)
    starts[static_cast<std::size_t>(r)] = sum, sum += counts[static_cast<std::size_t>(r)];
  std::vector<Record> all(static_cast<std::size_t>(sum));
  MPI_Gatherv(own.data(), count, record, all.data(), counts.data(), starts.data(), record, 0, world);
  MPI_Type_free(&record);
  return all;
}

/// @throws Diverged naming a sphere that is missing or not at a finite place
void check_finite(const Gathered& all, const Plan& plan, std::int64_t steps);

/// The assembly that has gone so many steps from the start as all ranks say, of the fibers of `before`.
Assembly assembly_of(const Assembly& before, const Gathered& all, const Plan& plan, const PackingScene& scene,
                     std::int64_t steps);

}  // namespace fiberchain::dem::mpi
