#include "intake/draft_search.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

constexpr int moves_per_start = 220;
constexpr double followed_wish_chance = 0.15;
constexpr double wished_zone_chance = 0.35;  // moves of zones whose place was asked for
constexpr double first_temperature = 6;  // in penalty points; falls to nothing over a start's moves
constexpr double taste_points = 2.5;
constexpr double corner_tills_below_m2 = 190;
constexpr double walls_only_below_m2 = 45;
constexpr double corner_tills_chance = 0.6;  // in small shops that are deep enough for either
constexpr int front_tills_from_depth_mm = 8000;
constexpr int corner_tills_below_depth_mm = 10500;

class Search {
 public:
  Search(const StoreProgram& program,
         const Understanding& understanding,
         const catalog::Catalog& catalog,
         Seed seed)
      : program_(program), understanding_(understanding), catalog_(catalog), seed_(seed) {
    Stream draw = seed.child("taste").stream();
    for (std::size_t i = 0; i < program.zones.size(); ++i) {
      taste_.emplace_back();
      for (double& points : taste_.back())
        points = draw.uniform(0, taste_points);
      if (is_wished(program.zones[i].type->type)) wished_.push_back(static_cast<int>(i));
    }
    for (const plan::Requirement& wish : understanding.requirements)
      if (wish.kind == plan::RequirementKind::relation) add_tie(wish);
  }

  FoundDraft run(int starts) {
    std::vector<FoundDraft> found =
        parallel_map(static_cast<std::size_t>(starts), [&](std::size_t i) {
          Stream draw = seed_.child("start", i).stream();
          return improve(start(draw), draw);
        });
    FoundDraft& best = *std::ranges::min_element(found, {}, &FoundDraft::penalty);
    best.evaluations = starts * (moves_per_start + 1);
    return std::move(best);
  }

 private:
  bool is_wished(const std::string& type) const {
    return std::ranges::any_of(understanding_.requirements, [&](const plan::Requirement& wish) {
      return wish.kind == plan::RequirementKind::relation &&
             (wish.subject == type || wish.object == type || wish.second_object == type);
    });
  }

  // The draft's penalty when it is at most `accepted` and a plan can express it; infinite
  // otherwise. The test of the tree takes longest and comes last.
  double evaluate(const FloorDraft& draft, double accepted, FoundDraft& best) const {
    Candidate candidate = make_candidate(draft, program_, understanding_, catalog_);
    const double penalty =
        penalty_of(draft, candidate, {program_, understanding_, taste_}, accepted);
    if (penalty == HUGE_VAL || tree_depth(candidate.root) > plan::max_bsp_depth) return HUGE_VAL;
    if (penalty < best.penalty) best = {draft, std::move(candidate), penalty, 0};
    return penalty;
  }

  // The best draft of one start.
  FoundDraft improve(FloorDraft draft, Stream& draw) const {
    FoundDraft best;
    best.penalty = HUGE_VAL;
    double current = evaluate(draft, HUGE_VAL, best);
    for (int move = 0; move < moves_per_start; ++move) {
      FloorDraft changed = draft;
      change(changed, draw);
      const double left = 1 - static_cast<double>(move) / moves_per_start;
      const double slack = first_temperature * left * left * draw.uniform();
      const double accepted = current < HUGE_VAL ? current + slack : HUGE_VAL;
      const double penalty = evaluate(changed, accepted, best);
      if (penalty == HUGE_VAL && current < HUGE_VAL) continue;
      draft = std::move(changed);
      current = penalty;
    }
    return best;
  }

  // ---- Starts ----

  FloorDraft start(Stream& draw) const {
    FloorDraft draft;
    const bool front_runs_east = entrance_wall_of(understanding_) == plan::Wall::south ||
                                 entrance_wall_of(understanding_) == plan::Wall::north;
    const int depth = front_runs_east ? program_.depth_mm : program_.width_mm;
    const bool shallow = depth < front_tills_from_depth_mm;
    const bool small =
        program_.area_m2() < corner_tills_below_m2 || depth < corner_tills_below_depth_mm;
    draft.corner_tills = shallow || (small && draw.chance(corner_tills_chance));
    draft.tills_east = draw.chance(0.5);
    draft.stacked_core = draw.chance(0.35);
    draft.deep_west = draw.chance(0.3);
    draft.deep_east = !draft.deep_west && draw.chance(0.3);
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(program_.zones.size()); ++i)
      order.push_back(i);
    draw.shuffle(std::span(order));
    for (const int zone : order)
      place(draft, zone);
    order_tills(draft);
    draft.entrance_gap = draft.band(Band::front).size();
    keep_core(draft);
    center_core(draft);
    return draft;
  }

  // Into the band that suits the zone best, counting taste and how full the band is.
  void place(FloorDraft& draft, int zone) const {
    const auto index = static_cast<std::size_t>(zone);
    const ProgramZone& row = program_.zones[index];
    if (row.stance == Stance::front && row.type->type != "cafe") {
      draft.tills.push_back(zone);
      return;
    }
    std::size_t best = 0;
    double best_points = HUGE_VAL;
    for (std::size_t b = 0; b < band_count; ++b) {
      constexpr double asked_for = 50;
      constexpr double crowded = 0.8;  // each zone that stands there already
      const double many =
          b == index_of(Band::core) ? 0 : crowded * static_cast<double>(draft.bands[b].size());
      constexpr double too_large = 30;
      const bool no_room = b == index_of(Band::front) && said_m2(row) > front_m2();
      const double points = band_habit(row, static_cast<Band>(b)) + taste_[index][b] + many +
                            (no_room ? too_large : 0) -
                            (wished_band(row.type->type) == static_cast<Band>(b) ? asked_for : 0);
      if (points >= best_points) continue;
      best = b;
      best_points = points;
    }
    draft.bands[best].push_back(zone);
  }

  static double said_m2(const ProgramZone& zone) {
    return zone.wanted_m2 && zone.wanted_how != plan::Comparison::at_most ? *zone.wanted_m2 : 0;
  }

  // What the front has for a zone beside the tills and the door.
  double front_m2() const {
    constexpr double share = 0.35;
    const plan::Wall wall = entrance_wall_of(understanding_);
    const bool runs_east = wall == plan::Wall::south || wall == plan::Wall::north;
    const int length_mm = runs_east ? program_.width_mm : program_.depth_mm;
    return share * 1e-6 * length_mm * front_depth_mm(program_, catalog_, 0);
  }

  // The band in which a zone stands where it was asked to be.
  std::optional<Band> wished_band(const std::string& type) const {
    for (const plan::Requirement& wish : understanding_.requirements) {
      if (wish.kind != plan::RequirementKind::relation || wish.subject != type) continue;
      const bool aside = wish.relation == plan::RelationKind::left_of ||
                         wish.relation == plan::RelationKind::right_of ||
                         wish.relation == plan::RelationKind::near;
      if (aside && (wish.object == "entrance" || wish.object == "checkout")) return Band::front;
      if (wish.relation != plan::RelationKind::at && wish.relation != plan::RelationKind::along)
        continue;
      if (wish.object == "center") return Band::core;
      if (const auto wall = value_named<plan::Wall>(wish.object)) return band_at(*wall);
    }
    return std::nullopt;
  }

  // The band along a wall of the store as built.
  Band band_at(plan::Wall wall) const {
    // Walls counter-clockwise from the entrance's.
    constexpr std::array<plan::Wall, 4> turn = {
        plan::Wall::south, plan::Wall::east, plan::Wall::north, plan::Wall::west};
    constexpr std::array<Band, 4> along = {Band::front, Band::east, Band::north, Band::west};
    const auto at = [&](plan::Wall w) { return std::ranges::find(turn, w) - turn.begin(); };
    const auto steps = at(wall) - at(entrance_wall_of(understanding_)) + 4;
    return along[static_cast<std::size_t>(steps % 4)];
  }

  // Zones that are to be in the middle of the store stand in the middle of the core.
  void center_core(FloorDraft& draft) const {
    std::vector<int>& core = draft.band(Band::core);
    for (std::size_t i = 0; i < core.size(); ++i) {
      const std::string& type = program_.zones[static_cast<std::size_t>(core[i])].type->type;
      const bool central = std::ranges::any_of(understanding_.requirements, [&](const auto& wish) {
        return wish.kind == plan::RequirementKind::relation && wish.subject == type &&
               wish.object == "center";
      });
      if (central) std::swap(core[i], core[core.size() / 2]);
    }
  }

  // Checkouts first, next to the entrance's side; machines, then service.
  void order_tills(FloorDraft& draft) const {
    const auto rank = [&](int zone) {
      const std::string& type = program_.zones[static_cast<std::size_t>(zone)].type->type;
      return std::pair{type == "checkout" ? 0 : (type == "self_checkout" ? 1 : 2), zone};
    };
    std::ranges::sort(draft.tills, {}, rank);
  }

  // Some zone must fill the middle, but of a floor that has room for walls only.
  void keep_core(FloorDraft& draft) const {
    if (!draft.band(Band::core).empty()) return;
    const bool west = !draft.band(Band::west).empty(), east = !draft.band(Band::east).empty();
    const bool at_side = draft.corner_tills ? (draft.tills_east ? west : east) : west || east;
    if (at_side && program_.area_m2() < walls_only_below_m2) return;
    for (const Band from : {Band::west, Band::east, Band::north, Band::front}) {
      if (draft.band(from).empty()) continue;
      draft.band(Band::core).push_back(draft.band(from).back());
      draft.band(from).pop_back();
      return;
    }
  }

  // ---- Moves ----

  struct Place {
    std::size_t band, at;
  };

  // What a wish says of a zone: beside or opposite which other, or at which wall.
  struct Tie {
    int zone = 0;
    std::optional<int> other;
    std::optional<Band> band;
    bool opposite = false, at_front = false;
  };

  std::optional<int> zone_called(const std::string& type) const {
    for (std::size_t i = 0; i < program_.zones.size(); ++i)
      if (program_.zones[i].type->type == type) return static_cast<int>(i);
    return std::nullopt;
  }

  void add_tie(const plan::Requirement& wish) {
    const auto zone = zone_called(wish.subject);
    const bool apart = wish.relation == plan::RelationKind::far ||
                       wish.relation == plan::RelationKind::not_adjacent;
    if (!zone || apart) return;
    Tie tie;
    tie.zone = *zone;
    tie.opposite = wish.relation == plan::RelationKind::facing;
    tie.at_front = wish.object == "entrance" || wish.object == "exit" || wish.object == "checkout";
    if (const auto wall = value_named<plan::Wall>(wish.object)) tie.band = band_at(*wall);
    for (const std::string& name : {wish.object, wish.second_object}) {
      tie.other = zone_called(name);
      if (tie.other && is_till(*tie.other)) tie.other.reset();
      if (tie.other || tie.band || tie.at_front) ties_.push_back(tie);
    }
  }

  bool is_till(int zone) const {
    return program_.zones[static_cast<std::size_t>(zone)].stance == Stance::front;
  }

  std::optional<Place> place_of(const FloorDraft& draft, int zone) const {
    for (std::size_t b = 0; b < band_count; ++b) {
      const auto at = std::ranges::find(draft.bands[b], zone);
      if (at != draft.bands[b].end())
        return Place{b, static_cast<std::size_t>(at - draft.bands[b].begin())};
    }
    return std::nullopt;
  }

  static void insert_at(FloorDraft& draft, Band band, std::size_t at, int zone) {
    std::vector<int>& zones = draft.band(band);
    zones.insert(zones.begin() + static_cast<std::ptrdiff_t>(std::min(at, zones.size())), zone);
  }

  // Puts a zone where a wish says.
  void follow_wish(FloorDraft& draft, Stream& draw) const {
    const Tie& tie =
        ties_[static_cast<std::size_t>(draw.integer(0, static_cast<int>(ties_.size()) - 1))];
    const auto from = place_of(draft, tie.zone);
    if (!from) return;
    std::vector<int>& source = draft.bands[from->band];
    source.erase(source.begin() + static_cast<std::ptrdiff_t>(from->at));
    const std::size_t end = draw.chance(0.5) ? 0 : program_.zones.size();
    if (tie.other) return put_by(draft, tie, draw);
    if (tie.band) return insert_at(draft, *tie.band, end, tie.zone);
    // By the doors: along the front, or where a side wall begins.
    constexpr std::array<Band, 3> by_doors = {Band::front, Band::west, Band::east};
    const Band band = by_doors[static_cast<std::size_t>(draw.integer(0, 2))];
    insert_at(draft, band, band == Band::front ? end : 0, tie.zone);
  }

  // Beside the other zone; or across the aisle from it, where the fronts along a side wall look at
  // those of the nearest run.
  void put_by(FloorDraft& draft, const Tie& tie, Stream& draw) const {
    std::optional<Place> other = place_of(draft, *tie.other);
    const std::size_t end = draw.chance(0.5) ? 0 : program_.zones.size();
    if (!other) return insert_at(draft, Band::core, end, tie.zone);
    if (!tie.opposite || other->band == index_of(Band::core)) {
      const auto band = static_cast<Band>(other->band);
      return insert_at(draft, band, other->at + (draw.chance(0.5) ? 1 : 0), tie.zone);
    }
    const bool aside = other->band == index_of(Band::west) || other->band == index_of(Band::east);
    if (!aside) {  // across the front or the back aisle runs show their ends
      std::vector<int>& source = draft.bands[other->band];
      source.erase(source.begin() + static_cast<std::ptrdiff_t>(other->at));
      other->band = index_of(draw.chance(0.5) ? Band::west : Band::east);
      insert_at(draft, static_cast<Band>(other->band), end, *tie.other);
    }
    insert_at(draft,
              Band::core,
              other->band == index_of(Band::west) ? 0 : program_.zones.size(),
              tie.zone);
  }

  std::optional<Place> random_place(const FloorDraft& draft, Stream& draw) const {
    std::size_t zones = 0;
    for (const auto& band : draft.bands)
      zones += band.size();
    if (zones == 0) return std::nullopt;
    auto pick = static_cast<std::size_t>(draw.integer(0, static_cast<int>(zones) - 1));
    for (std::size_t b = 0; b < band_count; ++b) {
      if (pick < draft.bands[b].size()) return Place{b, pick};
      pick -= draft.bands[b].size();
    }
    return std::nullopt;
  }

  // Where a zone stands whose place was asked for; nothing when it is a till.
  std::optional<Place> wished_place(const FloorDraft& draft, Stream& draw) const {
    const int zone =
        wished_[static_cast<std::size_t>(draw.integer(0, static_cast<int>(wished_.size()) - 1))];
    for (std::size_t b = 0; b < band_count; ++b) {
      for (std::size_t i = 0; i < draft.bands[b].size(); ++i) {
        if (draft.bands[b][i] == zone) return Place{b, i};
      }
    }
    return std::nullopt;
  }

  void change(FloorDraft& draft, Stream& draw) const {
    const double kind = draw.uniform();
    if (!ties_.empty() && draw.chance(followed_wish_chance)) {
      follow_wish(draft, draw);
    } else if (kind < 0.40) {
      swap_zones(draft, draw);
    } else if (kind < 0.82) {
      move_zone(draft, draw);
    } else if (kind < 0.88) {
      draft.tills_east = !draft.tills_east;
    } else if (kind < 0.93) {
      draft.entrance_gap = static_cast<std::size_t>(
          draw.integer(0, static_cast<int>(draft.band(Band::front).size())));
    } else if (kind < 0.96) {
      draft.stacked_core = !draft.stacked_core;
    } else {
      bool& deep = draw.chance(0.5) ? draft.deep_west : draft.deep_east;
      deep = !deep;
    }
    keep_core(draft);
  }

  void swap_zones(FloorDraft& draft, Stream& draw) const {
    const auto a = random_place(draft, draw);
    const auto b = random_place(draft, draw);
    if (a && b) std::swap(draft.bands[a->band][a->at], draft.bands[b->band][b->at]);
  }

  void move_zone(FloorDraft& draft, Stream& draw) const {
    auto from = random_place(draft, draw);
    if (!wished_.empty() && draw.chance(wished_zone_chance)) from = wished_place(draft, draw);
    if (!from) return;
    std::vector<int>& source = draft.bands[from->band];
    const int zone = source[from->at];
    source.erase(source.begin() + static_cast<std::ptrdiff_t>(from->at));
    std::vector<int>& target =
        draft.bands[static_cast<std::size_t>(draw.integer(0, static_cast<int>(band_count) - 1))];
    const int at = draw.integer(0, static_cast<int>(target.size()));
    target.insert(target.begin() + at, zone);
  }

  const StoreProgram& program_;
  const Understanding& understanding_;
  const catalog::Catalog& catalog_;
  Seed seed_;
  BandTaste taste_;
  std::vector<int> wished_;  // zones that relations name
  std::vector<Tie> ties_;
};

}  // namespace

std::int64_t work_of_a_start(const StoreProgram& program, const Understanding& understanding) {
  const auto relations = std::ranges::count(
      understanding.requirements, plan::RequirementKind::relation, &plan::Requirement::kind);
  return (moves_per_start + 1) * (std::ssize(program.zones) + relations);
}

FoundDraft search_draft(const StoreProgram& program,
                        const Understanding& understanding,
                        const catalog::Catalog& catalog,
                        Seed seed,
                        int starts) {
  return Search(program, understanding, catalog, seed).run(starts);
}

}  // namespace marketgen::intake
