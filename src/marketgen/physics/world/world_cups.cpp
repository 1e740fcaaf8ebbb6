// Suction cups of a World: what they seal on, hold and lose.
#include <algorithm>

#include <fmt/format.h>

#include "physics/world/world_state.h"

namespace marketgen::physics {
namespace {

constexpr double lip_reach_m = 0.03;  // behind and ahead of a lip, further than it looks

}  // namespace

void World::State::find_cups() {
  for (const WorldCup& cup : options.cups) {
    ModelCup made;
    made.body = mj_name2id(&m(), mjOBJ_BODY, cup.body.c_str());
    made.shape = {cup.radius_m, cup.seal_depth_m};
    made.lip = lip_points(m(), cup.body);
    made.material = frictions.material(cup.material);
    cups.push_back(made);
  }
  live_cups.resize(cups.size());
}

Pose World::State::world_from_lip(std::size_t cup) const {
  const int body = cups[cup].body;
  const mjtNum* q = d().xquat + 4 * body;
  return Pose{vec3_of(d().xpos + 3 * body), {q[0], q[1], q[2], q[3]}} *
         options.cups[cup].body_from_lip;
}

std::uint32_t World::State::product_of(int geom) const {
  const GeomOwner& owner = store.owners[static_cast<std::size_t>(geom)];
  return owner.pool ? static_cast<std::uint32_t>(live[owner.row].product) : owner.row;
}

std::optional<UnderLip> World::State::under_lip(std::size_t cup) const {
  const Pose lip = world_from_lip(cup);
  const double reach = lip_reach_m + cups[cup].shape.radius_m;
  const Vec3 half{reach, reach, reach};
  const Box3 round{lip.position - half, lip.position + half};
  std::vector<int> geoms;
  for (const std::uint32_t product : grid.near(round, 0))
    geoms.push_back(store.product_geom[product]);
  for (std::size_t body = 0; body < live.size(); ++body) {
    if (live[body].product < 0 || !body_box(body).meets(round, 0)) continue;
    const PoolBody& made = store.pool[body];
    for (int part = made.body; part < made.body + made.parts; ++part)
      for (int i = 0; i < m().body_geomnum[part]; ++i)
        geoms.push_back(m().body_geomadr[part] + i);
  }
  const auto under = look_under_lip(m(), d(), lip, cups[cup].shape, geoms);
  if (!under) return std::nullopt;
  const std::uint32_t product = product_of(under->geoms[0]);
  const bool same =
      std::ranges::all_of(under->geoms, [&](int geom) { return product_of(geom) == product; });
  return same ? under : std::nullopt;
}

// A product that stands still is woken first, and looked at again: as a soft pack it may be
// rounder.
Result<bool> World::State::seal(std::size_t cup) {
  LiveCup& here = live_cups[cup];
  std::optional<UnderLip> under = under_lip(cup);
  here.broken = here.broken && under;
  if (!under || here.broken) return false;
  const std::uint32_t product = product_of(under->geoms[0]);
  if (body_of[product] < 0) {
    if (!wake(product)) return false;
    MARKETGEN_CHECK(find_contacts());
    under = under_lip(cup);
    if (!under || product_of(under->geoms[0]) != product) return false;
  }
  const Pose lip = world_from_lip(cup);
  const Pose lip_from_body = inverse(options.cups[cup].body_from_lip);
  here.product = product;
  here.load = {};
  for (std::size_t i = 0; i < here.holds.size(); ++i) {
    const int body = m().geom_bodyid[under->at_point(i)];
    const mjtNum* q = d().xquat + 4 * body;
    const Pose part{vec3_of(d().xpos + 3 * body), {q[0], q[1], q[2], q[3]}};
    const Vec3 point = lip * (lip_from_body * place_of_point(m(), cups[cup].lip[i]));
    here.holds[i] = {body, inverse(part) * point};
  }
  hold(cup);
  return true;
}

void World::State::hold(std::size_t cup) {
  const LiveCup& here = live_cups[cup];
  if (here.product < 0) return let_go(d(), cups[cup].lip);
  for (std::size_t i = 0; i < here.holds.size(); ++i)
    hold_point(m(), d(), cups[cup].lip[i], here.holds[i].body, here.holds[i].on_body);
}

void World::State::release(std::size_t cup) {
  LiveCup& here = live_cups[cup];
  here = {.sucks = here.sucks};
  let_go(d(), cups[cup].lip);
}

Result<void> World::State::seal_cups() {
  bool any = false;
  for (std::size_t cup = 0; cup < cups.size(); ++cup) {
    if (!live_cups[cup].sucks || live_cups[cup].product >= 0) continue;
    MARKETGEN_TRY(const bool sealed, seal(cup));
    any = any || sealed;
  }
  if (any) MARKETGEN_CHECK(find_contacts());  // with the points that hold now
  return {};
}

void World::State::keep_sealed_awake() {
  for (const LiveCup& cup : live_cups) {
    if (cup.product < 0) continue;
    const int body = body_of[static_cast<std::size_t>(cup.product)];
    mark_wake(d(), store.pool[static_cast<std::size_t>(body)]);
  }
}

void World::State::look_at_lips() {
  for (std::size_t cup = 0; cup < cups.size(); ++cup) {
    LiveCup& here = live_cups[cup];
    if (here.product < 0) continue;
    const catalog::Product& product =
        scene.catalog[sku_of(static_cast<std::uint32_t>(here.product))];
    const Vec3 ahead = rotate(world_from_lip(cup).rotation, {0, 0, 1});
    const double friction = frictions.sliding_on(cups[cup].material, product);
    if (!here.load.breaks(d(), cups[cup].lip, ahead, options.cups[cup].pull_n, friction)) continue;
    release(cup);
    here.broken = true;
  }
}

Result<void> World::State::suck(std::uint32_t cup, bool on) {
  if (cup >= cups.size())
    return Error{"physics.bad_command",
                 "World::suck",
                 fmt::format("there are {} cups: name them in WorldOptions::cups", cups.size())};
  if (!on) release(cup);
  live_cups[cup].sucks = on;
  return {};
}

Result<std::uint32_t> World::cup(std::string_view body) const {
  const auto& cups = state_->options.cups;
  const auto found = std::ranges::find(cups, body, &WorldCup::body);
  if (found != cups.end()) return static_cast<std::uint32_t>(found - cups.begin());
  return Error{"physics.bad_command",
               "World::cup",
               fmt::format("no cup on a body \"{}\": name it in WorldOptions::cups", body)};
}

bool World::sucks(std::uint32_t cup) const {
  return state_->live_cups.at(cup).sucks;
}

std::optional<std::uint32_t> World::sealed_product(std::uint32_t cup) const {
  const std::int64_t product = state_->live_cups.at(cup).product;
  return product < 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(product));
}

}  // namespace marketgen::physics
