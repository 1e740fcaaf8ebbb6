#include "intake/slices.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace marketgen::intake {
namespace {

// Limits of Node::ratio, with room for rounding.
constexpr double min_ratio = 0.081;
constexpr double max_ratio = 0.919;
constexpr int forbidden_depth = 100;  // of a cut whose ratio is outside the limits
constexpr double ratio_digits = 1e6;  // enough for whole millimetres in a 200 m store

// The parts first..last of a slice as one binary subtree.
struct Range {
  std::size_t first, last;
};

class BinaryTree {
 public:
  explicit BinaryTree(const Slice& slice) : slice_(slice), count_(slice.parts.size()) {
    for (const Slice& part : slice.parts)
      part_depths_.push_back(tree_depth(part));
    best_.assign(count_ * count_, -1);
    cut_.assign(count_ * count_, 0);
  }

  // Fewest cuts above the deepest leaf of the range.
  int depth(Range range) {
    if (range.first == range.last) return part_depths_[range.first];
    int& best = best_[range.first * count_ + range.last];
    if (best >= 0) return best;
    double best_balance = 2;
    for (std::size_t k = range.first; k < range.last; ++k) {
      const double ratio = ratio_at(range, k);
      const bool allowed = ratio >= min_ratio && ratio <= max_ratio;
      const int deep = 1 + std::max(depth({range.first, k}), depth({k + 1, range.last})) +
                       (allowed ? 0 : forbidden_depth);
      const double balance = std::abs(ratio - 0.5);
      if (best >= 0 && (deep > best || (deep == best && balance >= best_balance))) continue;
      best = deep;
      best_balance = balance;
      cut_[range.first * count_ + range.last] = k;
    }
    return best;
  }

  // The last part of the first child. Precondition: depth(range) was asked, and the range has two
  // parts or more.
  std::size_t cut(Range range) const { return cut_[range.first * count_ + range.last]; }

  double ratio_at(Range range, std::size_t k) const {
    const double first = length({range.first, k});
    return first / (first + length({k + 1, range.last}));
  }

 private:
  double length(Range range) const {
    double sum = slice_.sizes_mm[range.first];
    for (std::size_t i = range.first; i < range.last; ++i) {
      sum += slice_.gaps_mm[i] + slice_.sizes_mm[i + 1];
    }
    return std::max(1.0, sum);
  }

  const Slice& slice_;
  std::size_t count_;
  std::vector<int> part_depths_;
  std::vector<int> best_;
  std::vector<std::size_t> cut_;
};

class NodeWriter {
 public:
  explicit NodeWriter(const std::vector<std::string>& zone_ids) : zone_ids_(zone_ids) {}

  void write(const Slice& slice, const std::string& id) {
    if (slice.zone >= 0) {
      plan::Node& leaf = nodes.emplace_back();
      leaf.id = id;
      leaf.zone = zone_ids_[static_cast<std::size_t>(slice.zone)];
      return;
    }
    BinaryTree tree(slice);
    const Range all{0, slice.parts.size() - 1};
    tree.depth(all);
    write_range(slice, tree, all, id);
  }

  std::vector<plan::Node> nodes;

 private:
  void write_range(const Slice& slice, BinaryTree& tree, Range range, const std::string& id) {
    if (range.first == range.last) return write(slice.parts[range.first], id);
    const std::size_t k = tree.cut(range);
    plan::Node& node = nodes.emplace_back();
    node.id = id;
    node.split = slice.axis;
    const double ratio = std::clamp(tree.ratio_at(range, k), min_ratio, max_ratio);
    node.ratio = std::floor(ratio * ratio_digits + 0.5) / ratio_digits;
    node.gap_mm = slice.gaps_mm[k];
    node.children = {id + "/1", id + "/2"};
    write_range(slice, tree, {range.first, k}, id + "/1");
    write_range(slice, tree, {k + 1, range.last}, id + "/2");
  }

  const std::vector<std::string>& zone_ids_;
};

void collect_rects(const Slice& slice, const RectMm& rect, std::vector<RectMm>& rects) {
  if (slice.zone >= 0) {
    rects[static_cast<std::size_t>(slice.zone)] = rect;
    return;
  }
  int at = slice.axis == plan::Axis::x ? rect.x0 : rect.y0;
  for (std::size_t i = 0; i < slice.parts.size(); ++i) {
    RectMm part = rect;
    (slice.axis == plan::Axis::x ? part.x0 : part.y0) = at;
    at += slice.sizes_mm[i];
    (slice.axis == plan::Axis::x ? part.x1 : part.y1) = at;
    collect_rects(slice.parts[i], part, rects);
    if (i + 1 < slice.parts.size()) at += slice.gaps_mm[i];
  }
}

}  // namespace

void Slice::add(Slice part, int size_mm, int gap_before_mm) {
  if (!parts.empty()) gaps_mm.push_back(gap_before_mm);
  const bool same_cut = part.zone < 0 && part.axis == axis;
  if (!same_cut) {
    parts.push_back(std::move(part));
    sizes_mm.push_back(size_mm);
    return;
  }
  parts.insert(parts.end(), part.parts.begin(), part.parts.end());
  sizes_mm.insert(sizes_mm.end(), part.sizes_mm.begin(), part.sizes_mm.end());
  gaps_mm.insert(gaps_mm.end(), part.gaps_mm.begin(), part.gaps_mm.end());
}

Slice zone_slice(int zone) {
  Slice slice;
  slice.zone = zone;
  return slice;
}

Slice cut_slice(plan::Axis axis) {
  Slice slice;
  slice.axis = axis;
  return slice;
}

Slice transposed(Slice slice) {
  slice.axis = slice.axis == plan::Axis::x ? plan::Axis::y : plan::Axis::x;
  for (Slice& part : slice.parts)
    part = transposed(std::move(part));
  return slice;
}

Slice simplified(Slice slice) {
  if (slice.zone >= 0 || slice.parts.size() != 1) return slice;
  Slice only = std::move(slice.parts[0]);
  return only;
}

std::vector<RectMm> zone_rects(const Slice& slice, const RectMm& rect, std::size_t zones) {
  std::vector<RectMm> rects(zones);
  collect_rects(slice, rect, rects);
  return rects;
}

int tree_depth(const Slice& slice) {
  if (slice.zone >= 0) return 0;
  return BinaryTree(slice).depth({0, slice.parts.size() - 1});
}

std::vector<plan::Node> nodes_of(const Slice& slice, const std::vector<std::string>& zone_ids) {
  NodeWriter writer(zone_ids);
  writer.write(slice, "floor");
  return std::move(writer.nodes);
}

}  // namespace marketgen::intake
