#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dem/chain/sphere_storage.hpp"
#include "dem/contact/contact_history.hpp"
#include "dem/contact/fiber_bodies.hpp"
#include "dem/contact/ridge_contact.hpp"
#include "dem/contact/wall_neighbors.hpp"
#include "dem/mesh/mesh_shape.hpp"

namespace fiberchain::dem {

/// A moment at which contacts with ridges are found.
struct RidgeMoment {
  const MeshShape& mesh;  ///< where its wall stands
  const MeshRidges& ridges;
  const SphereStorage& rows;
  const FiberBodies& bodies;
  WallNeighbors& nodes;  ///< what nodes touch of the mesh now, or nearly
};

/// The contacts of nodes as RidgeView takes them, padded to whole vectors: bodies that begin or end there.
struct NodeRows {
  std::vector<std::int32_t> bodies;
  std::vector<double> places, shares;
};

/// Contacts of segments with ridges of one wall, by rising body and feature, padded to whole vectors.
struct RidgeContacts {
  std::vector<std::int32_t> bodies, features, contact;  ///< contact: number in the histories
  std::vector<double> places, shares;                   ///< as RidgePoint's
  std::vector<double> nearest;                          ///< as WallView::nearest
  std::size_t count = 0;                                ///< without pads

  void clear();
  void insert(std::int32_t body, std::int32_t feature, std::int32_t number);
};

/// Segments of smooth fibers of a part near ridges of a mesh, by rising number, and the ridges that each may
/// touch until the neighbor list is built again.
class RidgeNeighbors {
 public:
  /// Writes the edges that a segment may touch to an empty list.
  using FindRidges = std::function<void(std::int32_t body, std::vector<std::int32_t>& found)>;

  /// As MeshNeighbors::update().
  void update(const std::vector<std::int32_t>& rebuilt, const FindRidges& find, RidgeNeighbors& scratch);
  void clear();
  bool has(std::int32_t body) const;

  /// The contacts now in place of those of the step before, and shares of the nodes', of which those that
  /// touch get numbers, and pads that touch nothing. A contact with the same feature keeps its history;
  /// another one goes on with that of one of the same segment that ends, in about the same direction; else
  /// the deepest contact of a node or a segment beside it lends its spring, of which the new one has no share
  /// yet.
  void find_contacts(const RidgeMoment& moment, int width, ContactHistories& histories);

  const RidgeContacts& contacts() const { return contacts_; }
  RidgeContacts& contacts() { return contacts_; }
  const NodeRows& node_rows() const { return node_rows_; }

 private:
  struct Listed {
    std::int32_t body;
    std::size_t begin, end;            ///< in edges_
    Vec<double, 3> looked_at[2] = {};  ///< its ends then, in the mesh [m]
    double clearance = -1;             ///< that no ridge was nearer than [m]
  };
  /// Points of a listed segment, to found_.
  void look(Listed& listed, const RidgeMoment& moment);
  void add_found(std::int32_t body, const RidgeMoment& moment);
  /// What a node touches, or nearly, in the frame of the mesh.
  struct NearNode {
    std::int32_t node, row;  ///< row: of moment.nodes; -1 where it does not touch
    NodeContact contact;
  };
  /// Moves those that do not touch from moment.nodes; rows of the others.
  void sort_nodes(const RidgeMoment& moment, ContactHistories& histories);
  void begin_rows(const RidgeMoment& moment, ContactHistories& histories);
  /// Of a node, to `all`; the first of them in near_.
  std::size_t near_node(std::int32_t node, std::vector<NodeContact>& all) const;
  void keep_histories(const RidgeMoment& moment, ContactHistories& histories);
  std::int32_t ended_like(std::size_t n, const RidgeMoment& moment);
  std::int32_t lender(std::size_t n, const RidgeMoment& moment, const ContactHistories& histories) const;
  Vec<double, 3> direction_of(const RidgeContacts& from, std::size_t n, const RidgeMoment& moment) const;

  std::vector<Listed> list_;
  std::vector<std::int32_t> edges_;
  RidgeContacts contacts_, last_;
  NodeRows node_rows_;
  std::vector<RidgePoint> found_, all_;
  std::vector<NearNode> near_;  ///< by rising node
  std::vector<NodeContact> ends_[2];
  std::vector<std::int32_t> asked_;
};

/// Nodes of a segment in the frame of a mesh.
SegmentNodes<double> nodes_in_mesh(const FiberBodies& bodies, const SphereStorage& rows,
                                   const MeshShape& mesh, std::int32_t body);

}  // namespace fiberchain::dem
