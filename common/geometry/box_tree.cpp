#include "common/geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace accord {

template <int D>
BoxTree<D>::BoxTree(std::span<const Extent<D>> boxes) {
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  if (boxes.empty()) return;
  nodes_.reserve(boxes.size());
  build(boxes, 0, boxes.size());
  item_boxes_.reserve(boxes.size());
  for (const std::int32_t item : items_) {
    item_boxes_.push_back(boxes[static_cast<std::size_t>(item)]);
  }
}

// Halves the items at the median along the axis where their centres spread most: the depth is the
// logarithm of the count, whatever the boxes are.
template <int D>
void BoxTree<D>::build(std::span<const Extent<D>> boxes, std::size_t begin, std::size_t end) {
  const auto box_of = [&](std::int32_t item) -> const Extent<D>& {
    return boxes[static_cast<std::size_t>(item)];
  };
  Node node{box_of(items_[begin]), static_cast<std::int32_t>(begin), 0};
  Vec<D> low = node.box.min + node.box.max;  // twice the centres
  Vec<D> high = low;
  for (std::size_t i = begin; i < end; ++i) {
    const Extent<D>& box = box_of(items_[i]);
    node.box.merge(box);
    low = low.cwiseMin(box.min + box.max);
    high = high.cwiseMax(box.min + box.max);
  }
  const std::size_t index = nodes_.size();
  if (end - begin <= kLeafSize) {
    node.count = static_cast<std::int32_t>(end - begin);
    nodes_.push_back(node);
    return;
  }
  nodes_.push_back(node);
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::int32_t p, std::int32_t q) {
    const double a = box_of(p).min[axis] + box_of(p).max[axis];
    const double b = box_of(q).min[axis] + box_of(q).max[axis];
    return a != b ? a < b : p < q;
  });
  build(boxes, begin, middle);
  nodes_[index].first = static_cast<std::int32_t>(nodes_.size());
  build(boxes, middle, end);
}

template class BoxTree<2>;
template class BoxTree<3>;

}  // namespace accord
