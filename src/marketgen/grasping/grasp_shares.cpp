#include "grasping/grasp_shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace marketgen::grasping {
namespace {

constexpr double normal_95 = 1.959963984540054;  // standard normal, two-sided 95 %

// What is counted of one group of rates.
class Count {
 public:
  void add(const GraspRate& rate) {
    ++products_;
    if (!rate.fits()) {
      ++excluded_[rate.excluded];
      return;
    }
    ++fit_;
    first_ += rate.first_held() ? 1 : 0;
    any_ += rate.held() > 0 ? 1 : 0;
    const GraspTry& best = rate.tries.front();
    if (best.end != GraspEnd::held) ++lost_[best.end];
    const bool kept = best.end != GraspEnd::dropped && best.end != GraspEnd::missed &&
                      best.end != GraspEnd::collided;
    if (kept) slips_mm_.push_back(best.slip_mm);
  }

  GraspShare share(const std::string& tool, GraspSetting setting, const std::string& archetype) {
    GraspShare made;
    made.tool = tool;
    made.setting = setting;
    made.archetype = archetype;
    made.products = products_;
    made.fit = share_of(fit_, products_);
    made.first = share_of(first_, fit_);
    made.any = share_of(any_, fit_);
    if (!slips_mm_.empty()) {
      std::ranges::sort(slips_mm_);
      const auto last = static_cast<double>(slips_mm_.size() - 1);
      made.slip_p99_mm = slips_mm_[static_cast<std::size_t>(std::ceil(0.99 * last))];
    }
    for (const auto& [why, count] : excluded_)
      made.excluded.push_back({why, count});
    for (const auto& [end, count] : lost_)
      made.lost.push_back(fmt::format("{} {}", name_of(end), count));
    return made;
  }

 private:
  int products_ = 0, fit_ = 0, first_ = 0, any_ = 0;
  std::vector<double> slips_mm_;
  std::map<GraspExclusion, int> excluded_;
  std::map<GraspEnd, int> lost_;
};

}  // namespace

Share share_of(int number, int of) {
  if (of == 0) return {};
  const double n = of, p = number / n, zz = normal_95 * normal_95;
  const double middle = (p + zz / (2 * n)) / (1 + zz / n);
  const double half = normal_95 / (1 + zz / n) * std::sqrt(p * (1 - p) / n + zz / (4 * n * n));
  return {of, number, p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

std::vector<GraspShare> grasp_shares(const std::vector<GraspRate>& rates) {
  struct Group {
    std::string tool;
    GraspSetting setting;
    Count all;
    std::map<std::string, Count> shapes;
  };
  std::vector<Group> groups;
  for (const GraspRate& rate : rates) {
    auto group = std::ranges::find_if(
        groups, [&](const Group& g) { return g.tool == rate.tool && g.setting == rate.setting; });
    if (group == groups.end()) {
      groups.push_back({rate.tool, rate.setting, {}, {}});
      group = std::prev(groups.end());
    }
    group->all.add(rate);
    group->shapes[rate.archetype].add(rate);
  }
  std::vector<GraspShare> shares;
  for (Group& group : groups) {
    shares.push_back(group.all.share(group.tool, group.setting, ""));
    for (auto& [archetype, count] : group.shapes)
      shares.push_back(count.share(group.tool, group.setting, archetype));
  }
  return shares;
}

}  // namespace marketgen::grasping
