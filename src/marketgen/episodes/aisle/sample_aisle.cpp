#include "episodes/aisle/sample_aisle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "collect/collect_plan.h"
#include "collect/scene_obstacles.h"
#include "episodes/aisle/studied_grasps.h"
#include "episodes/proved_names.h"
#include "skills/drop_plan.h"

namespace marketgen::episodes {
namespace {

constexpr int max_attempts = 12;        // at an episode
constexpr int max_other_attempts = 60;  // of another difficulty than the standard one
constexpr int max_skus_drawn = 200;     // at an attempt; few suit a cup
constexpr int max_starts = 200;         // places drawn
constexpr std::size_t usual_rows = 3;   // items of a SKU that are looked at
constexpr std::size_t wider_rows = 8;
constexpr int wider_searches = 3;  // each from other random postures
constexpr double drop_reach_m = 1.4;
constexpr double doors_limit_s = 1500;  // four doors, each opened and shut in 75 s and driven to

// Whether an error says no more than that an item cannot be fetched so: others may be.
bool is_about_the_item(const Error& error) {
  const std::string& code = error.code;
  return (code.starts_with("motion.") && code != "motion.bad_limits") ||
         code == "robot.unreachable" || code == "collect.no_place" || code == "collect.no_drop";
}

// One hand pulls a door, another pushes it on.
Result<void> check_opens_doors(const AisleStore& store) {
  MARKETGEN_TRY(const std::string gripper, collect::gripper_row(store.robot));
  MARKETGEN_TRY(const std::vector<skills::Hand> hands, skills::hands_with(store.robot, gripper));
  if (hands.size() >= 2) return {};
  return Error{"episode.impossible",
               "aisle",
               fmt::format("with the tools \"{}\" the robot has one {}, and opens doors with two",
                           store.station.tools().id,
                           gripper)};
}

Pose upright(const motion::FloorPlace& place) {
  return {{place.position.x, place.position.y, 0}, rotation_about({0, 0, 1}, place.heading)};
}

}  // namespace

// A way through the episode as far as it was found.
struct AisleSampler::Witness {
  Vec3 axle;                                // where the robot is
  std::vector<skills::CarriedItem> inside;  // of its basket
  std::vector<std::uint32_t> taken;         // rows
};

Result<std::unique_ptr<AisleSampler>> AisleSampler::make(std::shared_ptr<const AisleStore> store,
                                                         std::shared_ptr<GraspBook> book,
                                                         DrawRules rules) {
  if (rules.doors != Doors::none) MARKETGEN_CHECK(check_opens_doors(*store));
  std::unique_ptr<AisleSampler> made(new AisleSampler);
  made->store_ = std::move(store);
  made->book_ = std::move(book);
  made->doors_ = std::make_unique<DoorBook>(made->store_);
  made->rules_ = std::move(rules);
  made->offer_ = Offer(store_stock(made->store_->scene));
  made->add_drawn_from();
  const std::size_t products = count_of(made->shapes_);
  const int needed = made->rules_.difficulty.goals.max;
  if (products < static_cast<std::size_t>(needed))
    return Error{
        "episode.impossible",
        "aisle",
        fmt::format(
            "a task may ask for {} products within the robot's reach; at least {} are needed",
            products,
            needed)};
  return made;
}

// Numbers of the grasps by which a product can be fetched; none when it cannot.
Result<std::vector<int>> AisleSampler::grasps_for(const catalog::Product& product) {
  MARKETGEN_TRY(StudiedProduct studied, book_->study(product));
  const std::scoped_lock lock(mutex_);
  considered_.insert_or_assign(product.sku, studied.why_not);
  return std::move(studied.grasps);
}

std::vector<ConsideredProduct> AisleSampler::considered() const {
  const std::scoped_lock lock(mutex_);
  std::vector<ConsideredProduct> products;
  for (const auto& [sku, why] : considered_)
    products.push_back({sku, why});
  return products;
}

void AisleSampler::consider(const std::vector<ConsideredProduct>& products) {
  const std::scoped_lock lock(mutex_);
  for (const ConsideredProduct& product : products)
    considered_.insert_or_assign(product.sku, product.why);
}

EpisodeExclusions AisleSampler::exclusions() const {
  const std::scoped_lock lock(mutex_);
  std::map<std::string, int> counts;
  for (const auto& [sku, why] : considered_)
    if (!why.empty()) ++counts[why];
  EpisodeExclusions exclusions;
  exclusions.on_offer = static_cast<int>(considered_.size());
  for (const auto& [reason, products] : counts)
    exclusions.left_out.push_back({reason, products});
  return exclusions;
}

// From where the arm is when it has pulled the item out, backed off so far as there is room.
Result<bool> AisleSampler::can_drop(const collect::CollectPlan& plan,
                                    const OpenDoor& door,
                                    Witness& witness,
                                    Seed seed) {
  const robots::Robot& robot = store_->robot;
  const robots::JointGroup& arm = *robot.find_group(plan.group);
  const scene::Scene& scene = store_->scene;
  MARKETGEN_TRY(const assets::ProductBody body,
                skills::make_store_body(scene.catalog[scene.products[plan.product].sku]));
  skills::DropQuestion question;
  question.state = plan.state;
  const std::vector<double> end = plan.retreat.at(plan.retreat.duration_s()).position;
  for (std::size_t j = 0; j < arm.dofs.size(); ++j) {
    const auto dof = static_cast<std::size_t>(arm.dofs[j]);
    question.state[dof] = end[j];
    question.stow.push_back(store_->driving[dof]);
  }
  question.state[static_cast<std::size_t>(robot.find_dof("lift"))] = store_->station.lift_m;
  question.world_from_base =
      plan.world_from_base *
      Pose{{-store_->room_behind_m(plan.world_from_base, door.ways()), 0, 0}, {}};
  question.group = plan.group;
  question.tool = plan.tool;
  question.held = &body;
  question.tip_from_product = inverse(plan.grasp.grasp.product_from_tool);
  const Vec3 middle = question.world_from_base.position + Vec3{0, 0, 0.9};
  question.around = collect::fixture_obstacles(door.store, middle, drop_reach_m);
  MARKETGEN_CHECK(collect::add_product_obstacles(
      door.store, middle, drop_reach_m, witness.taken, question.around));
  question.inside = witness.inside;
  const auto drop = skills::plan_drop(robot, store_->basket, question, seed);
  if (!drop.ok()) {
    if (is_about_the_item(drop.error())) return false;
    return drop.error();
  }
  // How it comes to lie is not known: somewhere in the box in which it is let go.
  witness.inside.push_back(skills::carried_box(
      skills::turned_box(body, drop->base_from_tip * question.tip_from_product)));
  return true;
}

// Items that a way leads to, the nearest first.
std::vector<std::uint32_t> AisleSampler::nearest_rows(const std::string& sku,
                                                      const Vec3& axle) const {
  std::vector<std::pair<double, std::uint32_t>> found;
  for (const std::uint32_t row : store_->front_items(sku)) {
    const auto place = store_->standing_place(row);
    if (!place) continue;
    const auto path = store_->ways.shortest_path(floor_mm(axle), *place);
    if (path.ok()) found.emplace_back(path->length_m, row);
  }
  std::ranges::stable_sort(found);
  std::vector<std::uint32_t> rows;
  for (const auto& [length_m, row] : found)
    rows.push_back(row);
  return rows;
}

// Off where it stands, its door open: the way to there, the arm's ways, and into the basket.
Result<std::optional<WitnessPick>> AisleSampler::pick_row(std::uint32_t row,
                                                          const collect::CollectOptions& options,
                                                          Witness& witness,
                                                          Seed seed,
                                                          std::uint64_t number) {
  const std::optional<WitnessPick> none;
  MARKETGEN_TRY(const OpenDoor door, doors_->before(row));
  if (!door.why_not.empty()) return none;
  collect::CollectOptions with_door = options;
  with_door.may_stand = door.may_stand;
  const auto plan = collect::plan_collect(
      door.store, row, store_->robot, book_->tool(), seed.child("pick", number), with_door);
  if (!plan.ok()) {
    if (is_about_the_item(plan.error())) return none;
    return plan.error();
  }
  const Vec3 axle = axle_of(store_->robot, plan->world_from_base);
  const auto drive_m = door.way_m(witness.axle, axle);
  if (!drive_m) return none;
  witness.taken.push_back(row);
  MARKETGEN_TRY(const bool dropped, can_drop(*plan, door, witness, seed.child("drop", number)));
  if (!dropped) {
    witness.taken.pop_back();
    return none;
  }
  witness.axle = door.left_from(axle);
  WitnessPick found;
  found.sku = store_->scene.catalog[store_->scene.products[row].sku].sku;
  found.product = scene::product_id(store_->scene, row);
  found.arm = plan->group;
  found.strategy = std::string(name_of(plan->grasp.strategy));
  found.base = floor_place_row(plan->world_from_base);
  found.lift_m = plan->state[static_cast<std::size_t>(store_->robot.find_dof("lift"))];
  found.drive_m = *drive_m;
  found.door = door.row;
  return std::optional(found);
}

Result<std::optional<WitnessPick>> AisleSampler::pick(const catalog::Product& product,
                                                      const std::vector<int>& grasps,
                                                      std::size_t max_rows,
                                                      Witness& witness,
                                                      Seed seed) {
  const std::vector<std::uint32_t> rows = nearest_rows(product.sku, witness.axle);
  collect::CollectOptions options;
  options.posture = store_->station.posture;
  options.carried = store_->basket.walls;
  MARKETGEN_TRY(options.grasps, studied_grasps(product, book_->tool(), book_->frictions(), grasps));
  for (std::size_t i = 0; i < std::min(rows.size(), max_rows); ++i) {
    if (std::ranges::find(witness.taken, rows[i]) != witness.taken.end()) continue;
    MARKETGEN_TRY(std::optional<WitnessPick> found, pick_row(rows[i], options, witness, seed, i));
    if (!found) continue;
    found->grasps = grasps;
    return found;
  }
  return std::optional<WitnessPick>{};
}

// More items, and other random postures.
Result<std::optional<WitnessPick>> AisleSampler::pick_wider(const catalog::Product& product,
                                                            const std::vector<int>& grasps,
                                                            Witness& witness,
                                                            Seed seed) {
  for (int search = 0; search < wider_searches; ++search) {
    MARKETGEN_TRY(auto found,
                  pick(product,
                       grasps,
                       wider_rows,
                       witness,
                       seed.child("wider", static_cast<std::uint64_t>(search))));
    if (found) return found;
  }
  return std::optional<WitnessPick>{};
}

// Of so many items of the product, how many the witness fetches one after the other.
Result<int> AisleSampler::witnessed(
    const catalog::Product& product, int count, EpisodeSpec& spec, Witness& witness, Seed seed) {
  MARKETGEN_TRY(const std::vector<int> grasps, grasps_for(product));
  if (grasps.empty()) return 0;
  for (int item = 0; item < count; ++item) {
    const Seed own = item == 0 ? seed : seed.child("item", static_cast<std::uint64_t>(item));
    MARKETGEN_TRY(auto found, pick(product, grasps, usual_rows, witness, own));
    if (!found && rules_.split == Split::certified) {
      MARKETGEN_TRY(found, pick_wider(product, grasps, witness, own));
      if (found && !spec.certificate.has(shown_by_wider_search))
        spec.certificate.proved.emplace_back(shown_by_wider_search);
    }
    if (!found) return item;
    spec.certificate.witness.push_back(*found);
  }
  return count;
}

// Of `count` items, or of as many as the split can have. False when that is none.
Result<bool> AisleSampler::add_goal(
    const catalog::Product& product, int count, EpisodeSpec& spec, Witness& witness, Seed seed) {
  if (rules_.split == Split::planned || rules_.split == Split::certified) {
    MARKETGEN_TRY(count, witnessed(product, count, spec, witness, seed));
  } else if (rules_.split == Split::paper) {
    const std::vector<std::uint32_t> rows = nearest_rows(product.sku, witness.axle);
    count = std::min(count, static_cast<int>(rows.size()));
    if (rows.empty()) return false;
    const PointMm stands = *store_->standing_place(rows.front());
    witness.axle = {stands[0] * 1e-3, stands[1] * 1e-3, 0};
  } else {
    count = std::min(count, static_cast<int>(store_->front_items(product.sku).size()));
  }
  if (count == 0) return false;
  spec.goals.push_back({product.sku, count});
  spec.categories.push_back(category_place(product));
  return true;
}

// Whether words name it among all that the store sells; considered and left out if not.
bool AisleSampler::can_be_told(const catalog::Product& product, Seed words) {
  if (rules_.instructions == Instructions::ids ||
      refer_to(offer_, offer_.number_of(product.sku), 1, words.child(product.sku)))
    return true;
  const std::scoped_lock lock(mutex_);
  considered_.insert_or_assign(product.sku, std::string(not_told_apart));
  return false;
}

std::optional<motion::FloorPlace> AisleSampler::draw_start(Stream& draw) const {
  const RectMm bounds = bounds_of(plan::floor_of(store_->scene.layout.shell));
  for (int i = 0; i < max_starts; ++i) {
    motion::FloorPlace place{{draw.uniform(bounds.x0 * 1e-3, bounds.x1 * 1e-3),
                              draw.uniform(bounds.y0 * 1e-3, bounds.y1 * 1e-3)},
                             draw.uniform(-std::numbers::pi, std::numbers::pi)};
    if (store_->ways.space().free(floor_mm(axle_of(store_->robot, upright(place))))) return place;
  }
  return std::nullopt;
}

// Where the products of a category stand: the middle of their facings' first items.
CategoryPlace AisleSampler::category_place(const catalog::Product& product) const {
  const scene::Scene& scene = store_->scene;
  Vec3 sum;
  int count = 0;
  for (const scene::Facing& facing : scene.facings) {
    if (facing.product_count == 0 || scene.catalog[facing.sku].category != product.category)
      continue;
    const auto& at = scene.products[facing.first_product].position_m;
    sum += Vec3{at[0], at[1], at[2]};
    ++count;
  }
  const Vec3 middle = sum / std::max(count, 1);
  return {product.sku, product.category, middle.x, middle.y};
}

bool AisleSampler::is_far_enough(const EpisodeSpec& spec) const {
  if (rules_.difficulty.way == 0) return true;
  std::vector<std::string> skus;
  for (const EpisodeGoal& goal : spec.goals)
    skus.push_back(goal.sku);
  const RectMm floor = bounds_of(plan::floor_of(store_->scene.layout.shell));
  const double longer_m = std::max(floor.x1 - floor.x0, floor.y1 - floor.y0) * 1e-3;
  const auto tour = shortest_tour_m(*store_, floor_mm(Vec2{spec.start.x_m, spec.start.y_m}), skus);
  return tour && *tour >= rules_.difficulty.way * longer_m;
}

Result<std::optional<EpisodeSpec>> AisleSampler::attempt(EpisodeSpec spec, Seed seed) {
  Stream draw = seed.child("targets").stream();
  const Difficulty& difficulty = rules_.difficulty;
  const bool two_of_a_kind = seed.child("counts").stream().chance(difficulty.two_of_one);
  const int wanted = std::min(draw.integer(difficulty.goals.min, difficulty.goals.max),
                              two_of_a_kind ? max_items - 1 : max_items);
  const auto start = draw_start(draw);
  if (!start) return std::optional<EpisodeSpec>{};
  Witness witness{axle_of(store_->robot, upright(*start)), {}, {}};
  std::set<std::string> drawn;
  const Seed words = seed.child("words");
  const bool alike = seed.child("look_alikes").stream().chance(difficulty.look_alikes);
  int most = two_of_a_kind ? 2 : 1;  // items of the next goal
  for (int i = 0; i < max_skus_drawn && static_cast<int>(spec.goals.size()) < wanted; ++i) {
    const Shapes& shapes = shapes_for_next(spec, alike);
    auto shape = shapes.begin();
    std::advance(shape, draw.integer(0, static_cast<int>(shapes.size()) - 1));
    const auto& of_shape = shape->second;
    const catalog::Product& product =
        *of_shape[static_cast<std::size_t>(draw.integer(0, static_cast<int>(of_shape.size()) - 1))];
    if (!drawn.insert(product.sku).second || !can_be_told(product, words)) continue;
    MARKETGEN_TRY(
        const bool added,
        add_goal(
            product, most, spec, witness, seed.child("witness", static_cast<std::uint64_t>(i))));
    if (added && spec.goals.back().count == most) most = 1;
  }
  if (static_cast<int>(spec.goals.size()) < wanted) return std::optional<EpisodeSpec>{};
  spec.start = {start->position.x, start->position.y, start->heading * 180 / std::numbers::pi};
  if (!is_far_enough(spec)) return std::optional<EpisodeSpec>{};
  spec.look_alikes = has_look_alike(spec);
  if (!tell_goals(offer_, InstructionVerb::collect, words, spec))
    return std::optional<EpisodeSpec>{};
  return std::optional(std::move(spec));
}

std::vector<std::string> AisleSampler::shown() const {
  switch (rules_.split) {
    case Split::planned:
    case Split::certified:
      if (rules_.doors != Doors::none)
        return {shown_behind_doors.begin(), shown_behind_doors.end()};
      return {shown_by_fetching.begin(), shown_by_fetching.end()};
    case Split::paper:
      return {shown_on_paper.begin(), shown_on_paper.end()};
    case Split::all:
      return {};
  }
  return {};
}

Result<EpisodeSpec> AisleSampler::sample(const EpisodeOrigin& origin,
                                         Seed seed,
                                         int index,
                                         const EpisodeProver& prove) {
  const bool with_doors = rules_.doors != Doors::none;
  const Difficulty& difficulty = rules_.difficulty;
  const Seed own = difficulty.seed_of(
      seed.child(with_doors ? "aisle doors" : "aisle", static_cast<std::uint64_t>(index)));
  const std::string kind = "aisle/" + store_->station.tools().id + (with_doors ? "/doors" : "");
  EpisodeSpec spec = begun_spec(difficulty.kind_of(kind), origin, seed, index, own);
  spec.difficulty = difficulty.told();
  if (with_doors) spec.doors = rules_.doors;
  spec.track = Track::aisle;
  spec.robot = store_->station.robot;
  spec.tools = store_->station.tools().id;
  spec.cameras = {aisle_cameras.begin(), aisle_cameras.end()};
  spec.instructions = rules_.instructions;
  spec.limit_s = with_doors ? doors_limit_s : store_->station.limit_s;
  spec.certificate.proved = shown();
  CandidateJudge judge(prove);
  const int attempts = difficulty.is_standard() ? max_attempts : max_other_attempts;
  for (int number = 0; number < attempts; ++number) {
    MARKETGEN_TRY(std::optional<EpisodeSpec> made,
                  attempt(spec, own.child("attempt", static_cast<std::uint64_t>(number))));
    if (!made) {
      judge.refuse("too_few_goals");
      continue;
    }
    MARKETGEN_TRY(const bool kept, judge.keep(*made));
    if (kept) return std::move(*made);
  }
  return Error{"episode.impossible",
               spec.id,
               fmt::format("in {} attempts, too few goals were found that can be fetched ({})",
                           attempts,
                           judge.spoken())};
}

}  // namespace marketgen::episodes
