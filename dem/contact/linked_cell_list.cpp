#include "dem/contact/linked_cell_list.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {

CellGeometry::CellGeometry(const Box& box, const Vec<double, 3>& period, double edge, double most)
    : low_(box.low) {
  most = std::min(most, 1e9);
  double length[3], cells[3];
  for (int a = 0; a < 3; ++a) {
    periodic_[a] = period[a] > 0;
    length[a] = periodic_[a] ? period[a] : box.high[a] - box.low[a];
    cells[a] = std::clamp(std::floor(length[a] / edge), 1.0, most);
  }
  // few spheres in a large box, or one that flew off, need no more cells than that
  while (cells[0] * cells[1] * cells[2] > most) {
    double& largest = *std::max_element(cells, cells + 3);
    largest = std::max(1.0, std::floor(largest / 2));
  }
  std::int32_t total = 1;
  for (int a = 0; a < 3; ++a) {
    count_[a] = static_cast<int>(cells[a]);
    edge_[a] = length[a] / cells[a];
    inverse_edge_[a] = length[a] > 0 ? cells[a] / length[a] : 0;
    stride_[a] = total;
    total *= count_[a];
  }
}

int CellGeometry::along(double x, int axis) const {
  double at = (x - low_[axis]) * inverse_edge_[axis];
  if (periodic_[axis]) {
    at = std::floor(at);
    at -= count_[axis] * std::floor(at / count_[axis]);
  }
  return static_cast<int>(std::clamp(at, 0.0, count_[axis] - 1.0));
}

CellGeometry::Near CellGeometry::near(const Vec<double, 3>& place, int axis) const {
  const int own = along(place[axis], axis), count = count_[axis];
  Near near{0, {}};
  const auto add = [&](int cell) { near.at[near.count++] = cell * stride_[axis]; };
  if (periodic_[axis]) {
    // every cell once, where there are fewer than three
    for (int step = count > 2 ? -1 : 0; step < std::min(count, 2); ++step) add((own + step + count) % count);
  } else {
    for (int cell = std::max(0, own - 1); cell <= std::min(count - 1, own + 1); ++cell) add(cell);
  }
  return near;
}

CellGeometry::Span CellGeometry::span(double x, double distance, int axis) const {
  if (!periodic_[axis]) {
    const int first = along(x - distance, axis);
    return {first, along(x + distance, axis) - first + 1};
  }
  const double low = std::floor((x - distance - low_[axis]) * inverse_edge_[axis]),
               high = std::floor((x + distance - low_[axis]) * inverse_edge_[axis]);
  if (!(high - low + 1 < count_[axis])) return {0, count_[axis]};
  return {along(x - distance, axis), static_cast<int>(high - low) + 1};
}

double CellGeometry::squared_distance(double x, int axis, const Span& span, int cell) const {
  const int count = count_[axis];
  if (span.count == count) return 0;  // of a periodic axis, images on both sides
  double at = (x - low_[axis]) * inverse_edge_[axis];
  if (periodic_[axis]) {
    at -= count * std::floor(at / count);
    // the image that the span is around
    if (at < span.first) at += count;
  }
  // what stands outside of the box is in the cells at its border
  double cells = 0;
  if (cell > at && (periodic_[axis] || cell > 0)) cells = cell - at;
  if (at > cell + 1 && (periodic_[axis] || cell < count - 1)) cells = at - (cell + 1);
  const double distance = cells * edge_[axis];
  return distance * distance;
}

std::int32_t CellGeometry::index(const Vec<double, 3>& place) const {
  std::int32_t sum = 0;
  for (int a = 0; a < 3; ++a) sum += along(place[a], a) * stride_[a];
  return sum;
}

void LinkedCellList::add(const Vec<double, 3>& place) {
  std::int32_t& head = head_[cells_.index(place)];
  next_.push_back(head);
  head = static_cast<std::int32_t>(next_.size()) - 1;
}

}  // namespace fiberchain::dem
