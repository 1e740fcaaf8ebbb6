// Stands for VAMP's nn.hh, whose k-d tree (KavrakiLab/nigh) is not on PyPI: nearest by a linear scan.
#pragma once
#include <limits>
#include <optional>
#include <vector>
#include <vamp/vector.hh>
#include <vamp/vector/eigen.hh>
namespace vamp::planning {
template <std::size_t dim_> struct NNFloatArray { inline static constexpr auto dim = dim_; float* v; };
template <std::size_t dimension> struct NNNode {
  std::size_t index;
  NNFloatArray<dimension> array;
  inline auto as_vector() const noexcept -> FloatVector<dimension> { return FloatVector<dimension>(array.v); }
};
template <std::size_t dimension, std::size_t batch = 128> struct NN {
  std::vector<NNNode<dimension>> nodes;
  void insert(const NNNode<dimension>& n) { nodes.push_back(n); }
  std::size_t size() const { return nodes.size(); }
  std::optional<std::pair<NNNode<dimension>, float>> nearest(const NNFloatArray<dimension>& q) const {
    if (nodes.empty()) return std::nullopt;
    const FloatVector<dimension> at(q.v);
    float best = std::numeric_limits<float>::max();
    std::size_t k = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const float d = (at - nodes[i].as_vector()).l2_norm();
      if (d < best) { best = d; k = i; }
    }
    return std::pair{nodes[k], best};
  }
};
}
