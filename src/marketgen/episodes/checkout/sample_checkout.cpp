#include "episodes/checkout/sample_checkout.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "catalog/look_alike.h"
#include "episodes/checkout/checkout_world.h"
#include "episodes/goal_words.h"
#include "episodes/proved_names.h"

namespace marketgen::episodes {
namespace {

constexpr int max_baskets = 20;  // drawn until enough stays in
// A cup needs a flat face up, and no finger rights a pack; short fingers do not reach down to much.
constexpr int max_rare_baskets = 80;
// A full basket has a way through far less often: so many times as many.
constexpr int other_difficulty_times = 5;
constexpr double settle_s = 1.5;    // in the station, with the basket free
constexpr double still_m_s = 0.01;  // at the end of it
constexpr double max_overlap_m = 0.002;
// Of the basket's room, what the boxes round all that is poured take up at most: packs lie loose.
constexpr double max_filled = 0.6;

using Goods = std::vector<const catalog::Product*>;

// What a task may ask for.
Goods targets_of(const std::vector<catalog::Product>& stock,
                 const CheckoutHand& hand,
                 const TrainingSet& trained_on) {
  Goods targets;
  for (const catalog::Product& product : stock)
    if (hand.takes(product) && !trained_on.has(product)) targets.push_back(&product);
  return targets;
}

using Shapes = std::map<std::string, Goods>;

double volume_m3(const catalog::Product& product) {
  return product.width_m() * product.depth_m() * product.height_m();
}

// One of the shapes, then one of its products that is not taken yet and leaves room.
const catalog::Product* draw_product(const Shapes& shapes,
                                     const Goods& taken,
                                     double room_m3,
                                     Stream& draw) {
  Goods free;
  auto shape = shapes.begin();
  std::advance(shape, draw.integer(0, static_cast<int>(shapes.size()) - 1));
  for (const catalog::Product* product : shape->second)
    if (std::ranges::find(taken, product) == taken.end() && volume_m3(*product) <= room_m3)
      free.push_back(product);
  if (free.empty()) return nullptr;
  return free[static_cast<std::size_t>(draw.integer(0, static_cast<int>(free.size()) - 1))];
}

// What is poured: targets first, then others. Of one target there may be two, side by side here.
struct BasketDraw {
  std::vector<const catalog::Product*> goods;
  int targets = 0, others = 0;  // kinds
};

class CheckoutSampler {
 public:
  CheckoutSampler(const std::vector<catalog::Product>& stock,
                  CheckoutWorld& world,
                  const CheckoutCertifier& certify,
                  const EpisodeProver& prove,
                  const CheckoutHand& hand,
                  const Goods& targets,
                  const DrawRules& rules,
                  Seed seed)
      : stock_(stock),
        world_(world),
        certify_(certify),
        judge_(prove),
        hand_(hand),
        rules_(rules),
        seed_(seed) {
    for (const catalog::Product& product : stock_)
      shapes_[product.archetype].push_back(&product);
    for (const catalog::Product* target : targets)
      target_shapes_[target->archetype].push_back(target);
  }

  const CandidateJudge& judge() const { return judge_; }

  // Empty when it is not kept, for the reason that the judge has.
  Result<std::optional<EpisodeSpec>> attempt(EpisodeSpec spec, int number) {
    const BasketDraw drawn = draw_basket(static_cast<std::uint64_t>(number));
    MARKETGEN_CHECK(
        pour(drawn.goods, seed_.child("pour", static_cast<std::uint64_t>(number)), spec));
    if (static_cast<int>(spec.items.size()) <
        drawn.targets + std::min(drawn.others, rules_.difficulty.others.min))
      return refused("spilled");
    ask_for(drawn.targets, spec);
    if (spec.goals.empty()) return refused("spilled");
    if (!tell_goals(Offer(rows_of(spec)),
                    InstructionVerb::unload,
                    seed_.child("words", static_cast<std::uint64_t>(number)),
                    spec))
      return refused(std::string(not_told_apart));
    MARKETGEN_TRY(const bool rests, settle(spec));
    if (!rests) return refused("restless");
    return certified(std::move(spec), seed_.child("witness", static_cast<std::uint64_t>(number)));
  }

 private:
  BasketDraw draw_basket(std::uint64_t number) const {
    Stream draw = seed_.child("basket", number).stream();
    const auto kinds = static_cast<int>(stock_.size());
    BasketDraw basket;
    const DrawnCount &goals = rules_.difficulty.goals, &others = rules_.difficulty.others;
    basket.targets = std::min(draw.integer(goals.min, goals.max), std::max(1, kinds / 3));
    basket.others = std::min(draw.integer(others.min, others.max), kinds - basket.targets);
    draw_products(target_shapes_, basket.targets, draw, basket.goods);
    basket.targets = static_cast<int>(basket.goods.size());
    draw_products(shapes_, basket.targets + basket.others, draw, basket.goods);
    set_look_alikes(seed_.child("look_alikes", number), basket);
    add_second(seed_.child("counts", number), basket);
    return basket;
  }

  // With one of them in the place of the first of the others; or none of the others is one, as far
  // as the stock has other goods.
  void set_look_alikes(Seed seed, BasketDraw& basket) const {
    Stream draw = seed.stream();
    const auto first = static_cast<std::size_t>(basket.targets);
    if (basket.goods.size() <= first) return;
    const bool wanted = draw.chance(rules_.difficulty.look_alikes);
    for (std::size_t i = first; i < (wanted ? first + 1 : basket.goods.size()); ++i)
      if (is_like_a_target(*basket.goods[i], basket) != wanted) replace(i, wanted, basket, draw);
  }

  // By goods that are not in the basket; stays where the stock has none.
  void replace(std::size_t number, bool by_look_alike, BasketDraw& basket, Stream& draw) const {
    std::vector<const catalog::Product*> others;
    for (const catalog::Product& product : stock_)
      if (std::ranges::find(basket.goods, &product) == basket.goods.end() &&
          is_like_a_target(product, basket) == by_look_alike)
        others.push_back(&product);
    if (others.empty()) return;
    basket.goods[number] =
        others[static_cast<std::size_t>(draw.integer(0, static_cast<int>(others.size()) - 1))];
  }

  static bool is_like_a_target(const catalog::Product& product, const BasketDraw& basket) {
    const auto count = std::min(static_cast<std::size_t>(basket.targets), basket.goods.size());
    return std::ranges::any_of(
        basket.goods.begin(),
        basket.goods.begin() + static_cast<std::ptrdiff_t>(count),
        [&](const catalog::Product* target) { return catalog::are_look_alikes(product, *target); });
  }

  // Of a target; the last of the others makes room for it where there are most of them.
  void add_second(Seed seed, BasketDraw& basket) const {
    Stream draw = seed.stream();
    if (!draw.chance(rules_.difficulty.two_of_one)) return;
    const int target = draw.integer(0, basket.targets - 1);
    if (target >= static_cast<int>(basket.goods.size())) return;
    if (basket.others == max_other_goods) {
      basket.goods.pop_back();
      --basket.others;
    }
    const auto at = basket.goods.begin() + target;
    basket.goods.insert(at, *at);
  }

  // For the first kinds of what lies there: others follow where targets spilled.
  void ask_for(int kinds, EpisodeSpec& spec) const {
    for (const EpisodeItem& item : spec.items) {
      if (!spec.goals.empty() && spec.goals.back().sku == item.sku)
        ++spec.goals.back().count;
      else if (static_cast<int>(spec.goals.size()) < kinds &&
               !rules_.trained_on.has(row_of(item.sku)))
        spec.goals.push_back({item.sku, 1});
    }
    const std::vector<catalog::Product> rows = rows_of(spec);
    spec.look_alikes = std::ranges::any_of(rows, [&](const catalog::Product& row) {
      return std::ranges::any_of(spec.goals, [&](const EpisodeGoal& goal) {
        return catalog::are_look_alikes(row,
                                        *std::ranges::find(rows, goal.sku, &catalog::Product::sku));
      });
    });
  }

  // Of what lies there, each once.
  std::vector<catalog::Product> rows_of(const EpisodeSpec& spec) const {
    std::vector<catalog::Product> rows;
    for (const EpisodeItem& item : spec.items)
      if (std::ranges::find(rows, item.sku, &catalog::Product::sku) == rows.end())
        rows.push_back(row_of(item.sku));
    return rows;
  }

  const catalog::Product& row_of(const std::string& sku) const {
    return *std::ranges::find(stock_, sku, &catalog::Product::sku);
  }

  // Until there are so many, or nothing that is drawn leaves room for itself.
  void draw_products(const Shapes& shapes, int count, Stream& draw, Goods& drawn) const {
    constexpr int max_draws = 1000;
    for (int i = 0; i < max_draws && static_cast<int>(drawn.size()) < count; ++i)
      if (const catalog::Product* product = draw_product(shapes, drawn, room_beside(drawn), draw))
        drawn.push_back(product);
  }

  double room_beside(const Goods& goods) const {
    const physics::OpenContainer container = world_.station().container();
    double room_m3 = max_filled * container.top_x_m * container.top_y_m * container.height_m;
    for (const catalog::Product* product : goods)
      room_m3 -= volume_m3(*product);
    return room_m3;
  }

  // What the hand cannot take goes in first: it could not be cleared away. All else in an order
  // of its own, so that targets lie under others as well as over them.
  Result<void> pour(const std::vector<const catalog::Product*>& drawn,
                    Seed seed,
                    EpisodeSpec& spec) {
    std::vector<std::size_t> order(drawn.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    Stream draw = seed.child("order").stream();
    draw.shuffle(std::span(order));
    std::ranges::stable_partition(order, [&](std::size_t i) { return !hand_.takes(*drawn[i]); });
    std::vector<physics::SharedGoodsBody> bulk(drawn.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      MARKETGEN_TRY(bulk[i], physics::goods_body(*drawn[order[i]], physics::GoodsUse::bulk));
    }
    MARKETGEN_TRY(const physics::SettledBulk settled,
                  physics::settle_bulk(world_.station().container(), bulk, seed));
    std::vector<std::pair<std::size_t, EpisodeItem>> inside;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Pose& p = settled.items[i].container_from_product;
      if (settled.items[i].inside)
        inside.emplace_back(order[i], EpisodeItem::at(drawn[order[i]]->sku, p));
    }
    std::ranges::sort(inside, {}, [](const auto& entry) { return entry.first; });
    for (auto& [index, item] : inside)
      spec.items.push_back(std::move(item));
    return {};
  }

  // Lets go in the station, and notes where things lie then. False when they do not rest inside.
  Result<bool> settle(EpisodeSpec& spec) {
    MARKETGEN_CHECK(world_.reset(spec, stock_));
    const agent::Action wait = still_action(world_.observe());
    while (world_.time_s() < settle_s) {
      if (const auto stepped = world_.step(wait); !stepped.ok()) return stepped.error();
    }
    const physics::OpenContainer container = world_.station().container();
    for (std::size_t i = 0; i < spec.items.size(); ++i) {
      const Pose pose = inverse(world_.basket_pose()) * world_.item_pose(i);
      const Vec3 middle = pose * to_double(world_.goods(i).body.center_of_mass);
      const bool in = std::abs(middle.x) < container.top_x_m / 2 &&
                      std::abs(middle.y) < container.top_y_m / 2 && middle.z > 0;
      if (!in || world_.watched(i).speed_m_s > still_m_s) return false;
      spec.items[i] = EpisodeItem::at(spec.items[i].sku, pose);
    }
    return world_.deepest_overlap_m() <= max_overlap_m;
  }

  std::optional<EpisodeSpec> refused(const std::string& reason) {
    judge_.refuse(reason);
    return std::nullopt;
  }

  Result<std::optional<EpisodeSpec>> certified(EpisodeSpec spec, Seed seed) {
    spec.certificate.proved = {std::string(shown_settled)};
    if (certify_) {
      MARKETGEN_TRY(auto witness, certify_(world_, seed));
      if (!witness && !judge_.proves()) return refused("no_witness");
      if (witness) {
        for (const std::string_view shown : shown_by_unloading)
          spec.certificate.proved.emplace_back(shown);
        spec.certificate.witness = std::move(*witness);
      }
    }
    MARKETGEN_TRY(const bool kept, judge_.keep(spec));
    return kept ? std::optional(std::move(spec)) : std::nullopt;
  }

  const std::vector<catalog::Product>& stock_;
  CheckoutWorld& world_;
  const CheckoutCertifier& certify_;
  CandidateJudge judge_;
  const CheckoutHand& hand_;
  const DrawRules& rules_;
  Seed seed_;
  Shapes shapes_, target_shapes_;
};

}  // namespace

std::string witness_item(std::size_t number) {
  return fmt::format("item-{}", number);
}

std::vector<catalog::Product> checkout_stock(const scene::Scene& scene) {
  std::vector<catalog::Product> stock = store_stock(scene);
  std::erase_if(stock, [](const catalog::Product& product) {
    return !physics::fits_in(physics::checkout_basket, product);
  });
  return stock;
}

EpisodeExclusions checkout_exclusions(const scene::Scene& scene,
                                      const CheckoutHand& hand,
                                      const TrainingSet& trained_on) {
  EpisodeExclusions exclusions;
  std::map<CheckoutRefusal, int> counts;
  int seen = 0;
  for (const catalog::Product& product : store_stock(scene)) {
    ++exclusions.on_offer;
    const CheckoutRefusal why = hand.refusal(product);
    ++counts[why];
    seen += why == CheckoutRefusal::none && trained_on.has(product);
  }
  for (const auto& [why, products] : counts)
    if (why != CheckoutRefusal::none)
      exclusions.left_out.push_back({std::string(name_of(why)), products});
  if (seen > 0) exclusions.left_out.push_back({std::string(seen_in_training), seen});
  return exclusions;
}

Result<EpisodeSpec> sample_checkout(const std::filesystem::path& data,
                                    const std::vector<catalog::Product>& stock,
                                    const std::vector<catalog::FrictionRow>& frictions,
                                    const EpisodeOrigin& origin,
                                    Seed seed,
                                    int index,
                                    const CheckoutCertifier& certify,
                                    const EpisodeProver& prove,
                                    const DrawRules& rules,
                                    const CheckoutHand& hand) {
  const Goods targets = targets_of(stock, hand, rules.trained_on);
  if (targets.size() < min_stock)
    return Error{"episode.impossible",
                 origin.store,
                 fmt::format("of what the store offers, a task may ask for {} products out of a "
                             "basket; at least {} are needed: give it more kinds of boxes, cans or "
                             "bottles",
                             targets.size(),
                             min_stock)};
  MARKETGEN_TRY(CheckoutWorld world,
                CheckoutWorld::create(data, frictions, station_or_own(rules.station), hand.tools));
  const Seed own =
      rules.difficulty.seed_of(seed.child("checkout", static_cast<std::uint64_t>(index)));
  const std::string at = station_or_own(rules.station);
  const std::string kind = hand.tools.empty() ? at : at + "/" + hand.tools;
  EpisodeSpec spec = begun_spec(rules.difficulty.kind_of(kind), origin, seed, index, own);
  spec.difficulty = rules.difficulty.told();
  spec.robot = world.station().robot;
  spec.tools = hand.tools;
  if (at != checkout_station) spec.station = at;
  spec.instructions = rules.instructions;
  spec.cameras = {"scene", "wrist"};
  spec.limit_s = world.station().limit_s;
  CheckoutSampler sampler(stock, world, certify, prove, hand, targets, rules, own);
  const bool cup = world.robot().tools.front().kind == robots::ToolKind::suction;
  const int times = rules.difficulty.is_standard() ? 1 : other_difficulty_times;
  const bool rare = cup || at != checkout_station;
  const int max_drawn = times * (rare ? max_rare_baskets : max_baskets);
  for (int number = 0; number < max_drawn; ++number) {
    MARKETGEN_TRY(std::optional<EpisodeSpec> made, sampler.attempt(spec, number));
    if (made) return std::move(*made);
  }
  return Error{
      "episode.impossible",
      spec.id,
      fmt::format("in {} baskets drawn, too few goods stayed inside, or could be taken out again "
                  "({})",
                  max_drawn,
                  sampler.judge().spoken())};
}

}  // namespace marketgen::episodes
