#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "dem/chain/sphere_storage.hpp"
#include "dem/contact/contact_history.hpp"
#include "dem/contact/wall_neighbors.hpp"
#include "dem/mesh/mesh_shape.hpp"

namespace fiberchain::dem {

/// A moment at which contacts with a mesh are found.
struct MeshMoment {
  const MeshShape& mesh;  ///< where its wall stands
  const SphereStorage& rows;
  double gap;    ///< up to which the contact law acts [m]
  double moved;  ///< bound of the way of any sphere of the part over the mesh since whenever [m]
};

/// Spheres of a part near a mesh, by rising number, and the triangles that each may touch until the neighbor
/// list is built again. Of these, the inner ones are looked at, which it may touch until it has gone by a
/// margin; a sphere that touches none sleeps until the fastest of the part could have gone as far as its
/// nearest triangle was away, and on if it has not gone so far itself. What is skipped could not have
/// touched.
class MeshNeighbors {
 public:
  /// Writes the triangles that a sphere may touch to an empty list; none where it is far from all.
  using FindTriangles = std::function<void(std::int32_t sphere, std::vector<std::int32_t>& found)>;

  /// The part's `rebuilt` spheres (by rising number) are listed anew, others stay. `scratch` keeps its memory
  /// between calls.
  void update(const std::vector<std::int32_t>& rebuilt, const FindTriangles& find, MeshNeighbors& scratch);
  void clear();
  bool has(std::int32_t sphere) const;

  /// The contacts now in place of those of the step before, whole vectors of `width`, pads are the slot
  /// `pad`. A sphere's contact with the same feature keeps its history; one with another feature goes on with
  /// that of a feature it has left in about the same direction; the histories of others are given back.
  /// Contacts that begin have no number.
  void find_contacts(const MeshMoment& moment, int width, std::int32_t pad, WallNeighbors& contacts,
                     ContactHistories& histories);

 private:
  /// Contacts of the n-th sphere, to found_.contacts. As far as it may go and have none [m]; negative or 0
  /// where it has some.
  double look(std::size_t n, const MeshMoment& moment, const Vec<double, 3>& center, double radius,
              bool held);
  /// The same where it is in a flat place, with no look at the mesh; nothing where it is not.
  std::optional<double> find_flat(std::size_t n, const MeshMoment& moment, const Vec<double, 3>& center,
                                  double reach);
  /// What is known of the mesh around the n-th sphere here: whether it is flat; its inner triangles, too,
  /// where it is not or not for long.
  void choose(std::size_t n, const TriangleMesh& mesh, const Vec<double, 3>& center, double reach,
              double margin);
  /// Its inner triangles, nearer than `reach` and a margin, and its clearance here.
  void choose_inner(std::size_t n, const TriangleMesh& mesh, const Vec<double, 3>& center, double reach,
                    double margin);
  /// Adds what was found to the contacts; those of the step before are [from, to) of last_.
  void add_found(const MeshShape& mesh, std::int32_t slot, const Vec<double, 3>& center, std::size_t from,
                 std::size_t to, WallNeighbors& contacts, ContactHistories& histories);
  /// Number of the history that a contact goes on with, which is taken from last_; 0 where it begins.
  std::int32_t handed_on(const TriangleMesh& mesh, const MeshContact& contact, const Vec<double, 3>& center,
                         std::size_t from, std::size_t to);

  /// The spheres and what is near each.
  struct List {
    std::vector<std::int32_t> slots;
    std::vector<std::size_t> begin{0};           ///< of each in triangles and inner, and the end
    std::vector<std::int32_t> triangles, inner;  ///< by rising number
    std::vector<std::int32_t> inner_count;       ///< of each in inner; -1: not chosen yet
    std::vector<Vec<double, 3>> chosen_at;       ///< center, in the mesh, where inner ones were chosen [m]
    std::vector<double> clearance;               ///< from touching anything, there [m]
    std::vector<FlatPlace> flat;                 ///< tried last
    std::vector<double> asleep_until;            ///< of MeshMoment::moved

    void clear();
    void append(std::int32_t slot, std::span<const std::int32_t> near);
    /// The n-th of another list with all that is known of it.
    void append(const List& other, std::size_t n);
    /// Of the n-th sphere.
    std::span<const std::int32_t> triangles_of(std::size_t n) const;
    std::span<const std::int32_t> inner_of(std::size_t n) const;
  };

  List list_;
  std::vector<std::int32_t> asked_;  ///< of update()
  std::vector<std::size_t> awake_;   ///< of find_contacts(): numbers in the list
  WallNeighbors last_{};
  MeshContactScratch found_;
  std::vector<MeshContact> all_;  ///< found in this step, in space
};

}  // namespace fiberchain::dem
