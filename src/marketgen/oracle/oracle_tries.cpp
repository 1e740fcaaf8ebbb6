#include "oracle/oracle_tries.h"

#include <algorithm>
#include <cmath>

namespace marketgen::oracle {
namespace {

constexpr int max_tries = 3;  // of an item before it is put down where it belongs
constexpr int max_takes = 6;  // of an item in all
// What counts as the same grasp.
constexpr double same_grasp_m = 0.012, same_grasp_cosine = 0.96;

int count_of(const std::map<std::size_t, int>& counts, std::size_t item) {
  const auto found = counts.find(item);
  return found == counts.end() ? 0 : found->second;
}

}  // namespace

bool OracleTries::may_take(std::size_t item) const {
  return count_of(tries_, item) < max_tries && count_of(takes_, item) < max_takes;
}

bool OracleTries::failed_before(std::size_t item,
                                const Pose& product_from_tip,
                                robots::ToolKind tool) const {
  return std::ranges::any_of(failed_, [&](const auto& failed) {
    const Pose& then = failed.second;
    const auto cosine = [&](Vec3 axis) {
      return dot(rotate(product_from_tip.rotation, axis), rotate(then.rotation, axis));
    };
    return failed.first == item &&
           length(product_from_tip.position - then.position) < same_grasp_m &&
           cosine({0, 0, 1}) > same_grasp_cosine &&
           (tool == robots::ToolKind::suction || std::abs(cosine({0, 1, 0})) > same_grasp_cosine);
  });
}

int OracleTries::take(std::size_t item) {
  ++takes_[item];
  return ++tries_[item];
}

void OracleTries::fail(std::size_t item, const Pose& product_from_tip) {
  failed_.emplace_back(item, product_from_tip);
}

void OracleTries::put_down(std::size_t item) {
  tries_.erase(item);
}

}  // namespace marketgen::oracle
