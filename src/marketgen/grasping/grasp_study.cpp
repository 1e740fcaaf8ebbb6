#include "grasping/grasp_study.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include "base/parallel.h"
#include "grasping/grasp_basket.h"
#include "physics/goods/friction_table.h"
#include "scene/planogram.h"

namespace marketgen::grasping {
namespace {

constexpr std::string_view pad_material = "rubber";
// Between neighbours fingers come as narrow as the tool's own error lets them.

GraspExclusion exclusion_of(motion::GraspRefusal refusal) {
  return static_cast<GraspExclusion>(refusal);
}
static_assert(motion::names_of(motion::GraspRefusal{})[6] == names_of(GraspExclusion{})[6]);

bool stands_on_boards(const catalog::Product& product, const assets::ProductBody& body) {
  const bool hangs = std::ranges::any_of(body.features, [](const assets::PackFeature& feature) {
    return feature.kind == assets::FeatureKind::hang_hole;
  });
  return product.orientation != catalog::Orientation::any && !hangs;
}

class ProductStudy {
 public:
  ProductStudy(const catalog::Product& product,
               const std::map<physics::GoodsUse, physics::SharedGoodsBody>& goods,
               const std::optional<physics::SoftPack>& soft,
               double friction,
               const StudyOptions& options)
      : product_(product), goods_(goods), soft_(soft), friction_(friction), options_(options) {}

  // Once, before rates in a basket are asked for.
  Result<void> settle_basket() {
    MARKETGEN_TRY(basket_,
                  basket_case(goods_.at(physics::GoodsUse::bulk),
                              Seed(options_.seed).child("basket", product_.sku)));
    return {};
  }

  Result<GraspRate> rate(const robots::GraspTool& tool, GraspSetting setting) const {
    GraspRate rate{product_.sku, product_.archetype, tool.id, setting, {}, {}, {}};
    const bool in_basket = setting == GraspSetting::basket;
    if (in_basket && basket_.excluded != GraspExclusion::none)
      return without(std::move(rate), basket_.excluded, basket_.reason);
    const bool on_shelf = setting != GraspSetting::free && !in_basket;
    if (on_shelf && !stands_on_boards(product_, pack()))
      return without(
          std::move(rate), GraspExclusion::unshelved, "it lies in heaps or hangs from pegs");
    MARKETGEN_TRY(const motion::GraspCandidates candidates,
                  motion::grasp_candidates(product_,
                                           pack(),
                                           tool,
                                           in_basket ? basket_query(basket_.basket, friction_)
                                                     : grasp_query(setting, product_, friction_)));
    rate.excluded = exclusion_of(candidates.refusal);
    rate.reason = candidates.reason;
    if (candidates.found.empty()) return rate;
    if (setting == GraspSetting::free) {
      MARKETGEN_TRY(const bool stands,
                    stands_alone(goods_in(setting), tool, soft_for(tool, setting)));
      if (!stands) return without(std::move(rate), GraspExclusion::unstable, tips);
    }
    const auto count = std::min(static_cast<std::size_t>(options_.tries), candidates.found.size());
    for (std::size_t i = 0; i < count && !is_settled(rate, count); ++i) {
      MARKETGEN_TRY(const GraspTry tried, try_once(tool, setting, candidates.found[i], i));
      if (tried.end == GraspEnd::unstable)
        return without(std::move(rate), GraspExclusion::unstable, in_basket ? restless : tips);
      rate.tries.push_back(tried);
    }
    return rate;
  }

 private:
  // More tries would not change whether enough of them hold.
  bool is_settled(const GraspRate& rate, std::size_t count) const {
    const int left = static_cast<int>(count - rate.tries.size());
    return options_.enough_held > 0 &&
           (rate.held() >= options_.enough_held || rate.held() + left < options_.enough_held);
  }

  static constexpr const char* tips = "it does not stand by itself";
  static constexpr const char* restless = "it does not lie still in the basket";

  static GraspRate without(GraspRate rate, GraspExclusion why, std::string reason) {
    rate.excluded = why;
    rate.reason = std::move(reason);
    rate.tries.clear();
    return rate;
  }

  Result<GraspTry> try_once(const robots::GraspTool& tool,
                            GraspSetting setting,
                            const motion::GraspCandidate& candidate,
                            std::size_t index) const {
    const Seed seed = Seed(options_.seed)
                          .child("grasp", product_.sku)
                          .child(tool.id)
                          .child(name_of(setting), index);
    MARKETGEN_TRY(const GraspOutcome outcome,
                  try_grasp({goods_in(setting),
                             tool,
                             candidate.grasp,
                             friction_,
                             setting,
                             seed,
                             &basket_.basket,
                             soft_for(tool, setting)}));
    return GraspTry{candidate.strategy,
                    outcome.end,
                    candidate.width_m * 1e3,
                    candidate.grasp.force_n,
                    outcome.slip_m * 1e3,
                    outcome.turned_rad * 180 / std::numbers::pi,
                    outcome.neighbour_n};
  }

  // What grasps are aimed at: the pack's own shape.
  const assets::ProductBody& pack() const { return goods_.at(physics::GoodsUse::single)->body; }
  const physics::GoodsBody& goods_in(GraspSetting setting) const {
    return *goods_.at(use_of(setting));
  }

  // Bags bend on a table, in a gripper.
  const physics::SoftPack* soft_for(const robots::GraspTool& tool, GraspSetting setting) const {
    const bool bends =
        soft_ && setting == GraspSetting::free && tool.kind == robots::ToolKind::gripper;
    return bends ? &*soft_ : nullptr;
  }

  const catalog::Product& product_;
  const std::map<physics::GoodsUse, physics::SharedGoodsBody>& goods_;
  const std::optional<physics::SoftPack>& soft_;
  double friction_;
  const StudyOptions& options_;
  BasketCase basket_;
};

struct ProductRates {
  std::vector<GraspRate> rates;
  std::optional<Error> error;
};

Result<std::vector<GraspRate>> rates_of(const catalog::Product& product,
                                        const std::vector<robots::GraspTool>& tools,
                                        double friction,
                                        const StudyOptions& options) {
  std::map<physics::GoodsUse, physics::SharedGoodsBody> goods;
  for (const physics::GoodsUse use :
       {physics::GoodsUse::stocked, physics::GoodsUse::single, physics::GoodsUse::bulk}) {
    MARKETGEN_TRY(goods[use], physics::goods_body(product, use));
  }
  MARKETGEN_TRY(const std::optional<physics::SoftPack> soft, physics::soft_pack_of(product));
  ProductStudy study(product, goods, soft, friction, options);
  if (std::ranges::count(options.settings, GraspSetting::basket) > 0)
    MARKETGEN_CHECK(study.settle_basket());
  std::vector<GraspRate> rates;
  for (const robots::GraspTool& tool : tools) {
    for (const GraspSetting setting : options.settings) {
      MARKETGEN_TRY(GraspRate rate, study.rate(tool, setting));
      rates.push_back(std::move(rate));
    }
  }
  return rates;
}

}  // namespace

int GraspRate::held() const {
  return static_cast<int>(std::ranges::count(tries, GraspEnd::held, &GraspTry::end));
}

std::vector<int> GraspRate::held_tries() const {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < tries.size(); ++i)
    if (tries[i].end == GraspEnd::held) numbers.push_back(static_cast<int>(i));
  return numbers;
}

bool GraspRate::first_held() const {
  return !tries.empty() && tries.front().end == GraspEnd::held;
}

double rubber_friction(const std::vector<catalog::FrictionRow>& frictions,
                       const catalog::Product& product) {
  const physics::FrictionTable table(frictions);
  return table.sliding_on(table.material(pad_material), product);
}

motion::GraspQuery grasp_query(GraspSetting setting,
                               const catalog::Product& product,
                               double friction) {
  motion::GraspQuery query;
  query.friction = friction;
  if (setting == GraspSetting::free) return query;
  query.from_front = true;
  query.ceiling_m = product.height_m() + min_headroom_m;
  query.neighbour_gap_m = spaced_gap_m;
  if (setting == GraspSetting::stocked) {
    query.neighbour_gap_m = scene::pack_gap_m;
    query.finger_gap_m = motion::wedge_gap_m;
  }
  return query;
}

Result<std::vector<GraspRate>> study_grasps(const std::vector<const catalog::Product*>& products,
                                            const std::vector<robots::GraspTool>& tools,
                                            const std::vector<catalog::FrictionRow>& frictions,
                                            const StudyOptions& options,
                                            Progress& progress) {
  progress.begin("grasps", products.size());
  const std::vector<ProductRates> all = parallel_map(products.size(), [&](std::size_t i) {
    const catalog::Product& product = *products[i];
    Result<std::vector<GraspRate>> rates =
        rates_of(product, tools, rubber_friction(frictions, product), options);
    if (rates.ok() && options.finished) options.finished(*rates);
    progress.advance();
    return rates.ok() ? ProductRates{std::move(rates).value(), {}}
                      : ProductRates{{}, rates.error()};
  });
  progress.end();
  std::vector<GraspRate> joined;
  for (const ProductRates& one : all) {
    if (one.error) return *one.error;
    joined.insert(joined.end(), one.rates.begin(), one.rates.end());
  }
  return joined;
}

}  // namespace marketgen::grasping
