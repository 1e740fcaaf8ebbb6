// Snapshots of a World: what the model was changed to, and MuJoCo's own state byte for byte.
#include <span>

#include "base/hash.h"
#include "physics/mujoco_moment.h"
#include "physics/world/world_state.h"

namespace marketgen::physics {

struct WorldSnapshot::Content {
  struct MovedProduct {
    std::uint32_t product = 0;
    ShapePose first, stands;

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.product, self.first, self.stands);
    }
  };

  std::string made_of;  // scene and model that it belongs to
  MujocoMoment physics;
  std::vector<MovedProduct> moved;
  std::vector<LiveBody> live;
  std::vector<LiveCup> cups;
  std::vector<bool> refused;
  std::vector<double> belt_speed, looked_at;
  std::vector<std::pair<std::uint32_t, Wrench>> pushes;
  std::vector<WorldContact> contacts;
  std::vector<WorldEvent> events;
  std::vector<WorldCommand> commands;
  std::int64_t steps = 0, woken = 0, refusals = 0, stiffened = 0;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.made_of, self.physics, self.moved, self.live, self.cups, self.refused);
    archive(self.belt_speed, self.looked_at, self.pushes, self.contacts, self.events);
    archive(self.commands, self.steps, self.woken, self.refusals, self.stiffened);
  }
};

namespace {

using MovedProduct = WorldSnapshot::Content::MovedProduct;

std::string identity(const scene::Scene& scene, const mjModel& m, std::size_t buffer_bytes) {
  Hasher hash;
  for (const mjtSize size : {m.nbody, m.ngeom, m.nv, m.nu, m.nbvh, m.neq})
    hash.add(static_cast<std::int64_t>(size));
  hash.add(static_cast<std::int64_t>(buffer_bytes));
  hash.add(static_cast<std::int64_t>(scene.seed));
  hash.add(scene.layout.name);
  hash.add(static_cast<std::int64_t>(scene.products.size()));
  return hash.hex();
}

template <class T>
std::span<const std::byte> bytes_of(const T* values, std::size_t count) {
  return std::as_bytes(std::span<const T>(values, count));
}

}  // namespace

WorldSnapshot World::snapshot() const {
  const State& s = *state_;
  auto made = std::make_shared<WorldSnapshot::Content>();
  made->made_of = identity(s.scene, s.m(), s.d().nbuffer);
  made->physics = moment_of(s.d());
  for (const auto& [product, first] : s.moved)
    made->moved.push_back({product, first, geom_pose(s.m(), s.store.product_geom[product])});
  made->live = s.live;
  made->cups = s.live_cups;
  made->refused = s.refused;
  made->belt_speed = s.belt_speed;
  made->looked_at = s.looked_at;
  made->pushes = s.pushes;
  made->contacts = s.contacts;
  made->events = s.events;
  made->commands = s.commands;
  made->steps = s.steps, made->woken = s.woken, made->refusals = s.refusals;
  made->stiffened = s.stiffened;
  return {made};
}

std::string WorldSnapshot::bytes() const {
  ByteWriter writer;
  writer(*content);
  return writer.take();
}

Result<WorldSnapshot> WorldSnapshot::of_bytes(std::string_view bytes) {
  auto made = std::make_shared<Content>();
  ByteReader reader(bytes);
  reader(*made);
  if (!reader.ok())
    return Error{"physics.bad_command",
                 "WorldSnapshot::of_bytes",
                 "these bytes are no whole moment of a world"};
  return WorldSnapshot{std::move(made)};
}

void World::State::stand(std::uint32_t product, const ShapePose& pose) {
  const int geom = store.product_geom[product];
  move_geom(m(), d(), geom, pose);
  near.refit(m(), geom);
  switch_geom(m(), geom, true);
  grid.put(product, box_at(product, pose));
}

// Everything that was moved goes back to where it first stood.
void World::State::stand_as_built() {
  for (const auto& [product, first] : moved)
    stand(product, first);
  moved.clear();
  for (std::size_t body = 0; body < live.size(); ++body) {
    if (live[body].product < 0) continue;
    body_of[static_cast<std::size_t>(live[body].product)] = -1;
    collide_body(m(), store.pool[body], false);
  }
}

Result<void> World::restore(const WorldSnapshot& snapshot) {
  State& s = *state_;
  if (snapshot.content == nullptr ||
      snapshot.content->made_of != identity(s.scene, s.m(), s.d().nbuffer)) {
    return Error{"physics.bad_command",
                 "World::restore",
                 "the snapshot is empty or was taken of another scene or with other options"};
  }
  const WorldSnapshot::Content& from = *snapshot.content;
  for (std::size_t body = 0; body < from.live.size(); ++body) {
    if (from.live[body].product < 0) continue;
    s.make_ready(static_cast<std::uint32_t>(from.live[body].product), s.store.pool[body].soft());
  }
  if (s.fault) return *std::exchange(s.fault, {});
  s.stand_as_built();
  for (const MovedProduct& item : from.moved) {
    s.moved.emplace(item.product, item.first);
    s.stand(item.product, item.stands);
  }
  s.live = from.live;
  for (std::size_t body = 0; body < s.live.size(); ++body) {
    if (s.live[body].product < 0) continue;
    const auto product = static_cast<std::uint32_t>(s.live[body].product);
    switch_geom(s.m(), s.store.product_geom[product], false);
    s.grid.remove(product);
    s.dress(body, product, {});
    if (s.live[body].hooked) s.hook(body, product);
    s.body_of[product] = static_cast<int>(body);
  }
  s.live_cups = from.cups;
  for (std::size_t cup = 0; cup < s.cups.size(); ++cup)
    s.hold(cup);
  restore_moment(s.d(), from.physics);
  s.near.forget();
  for (std::uint32_t joint = 0; joint < s.belt_speed.size(); ++joint)
    s.run_belt(joint, from.belt_speed[joint]);
  s.looked_at = from.looked_at;
  s.refused = from.refused, s.pushes = from.pushes, s.contacts = from.contacts;
  s.events = from.events, s.commands = from.commands;
  s.steps = from.steps, s.woken = from.woken, s.refusals = from.refusals;
  s.stiffened = from.stiffened;
  s.fault = {};
  s.failed = false;
  return {};
}

std::string World::state_hash() const {
  const State& s = *state_;
  const mjModel& m = s.m();
  const mjData& d = s.d();
  Hasher hash;
  hash.add(s.steps);
  hash.add_bytes(bytes_of(d.qpos, static_cast<std::size_t>(m.nq)));
  hash.add_bytes(bytes_of(d.qvel, static_cast<std::size_t>(m.nv)));
  hash.add_bytes(bytes_of(d.qacc_warmstart, static_cast<std::size_t>(m.nv)));
  hash.add_bytes(bytes_of(d.act, static_cast<std::size_t>(m.na)));
  hash.add_bytes(bytes_of(d.ctrl, static_cast<std::size_t>(m.nu)));
  hash.add_bytes(bytes_of(d.mocap_pos, 3 * static_cast<std::size_t>(m.nmocap)));
  hash.add_bytes(bytes_of(d.tree_asleep, static_cast<std::size_t>(m.ntree)));
  for (const auto& [product, first] : s.moved) {
    const ShapePose pose = geom_pose(m, s.store.product_geom[product]);
    hash.add(std::int64_t{product}).add(std::int64_t{s.body_of[product]});
    hash.add_bytes(bytes_of(pose.position, 3));
    hash.add_bytes(bytes_of(pose.rotation, 4));
  }
  hash.add_bytes(bytes_of(s.belt_speed.data(), s.belt_speed.size()));
  hash.add_bytes(bytes_of(s.looked_at.data(), s.looked_at.size()));
  for (const LiveCup& cup : s.live_cups) {
    hash.add(std::int64_t{cup.sucks})
        .add(std::int64_t{cup.broken})
        .add(cup.product)
        .add(std::int64_t{cup.load.steps()});
    for (const LiveCup::Hold& hold : cup.holds) {
      hash.add(std::int64_t{hold.body});
      hash.add_bytes(bytes_of(&hold.on_body.x, 3));
    }
  }
  return hash.hex();
}

}  // namespace marketgen::physics
