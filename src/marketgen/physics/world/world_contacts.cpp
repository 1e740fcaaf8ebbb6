// Contacts of a World: how they rub, and with what force.
#include <cmath>
#include <utility>

#include "base/gravity.h"
#include "physics/world/world_state.h"

namespace marketgen::physics {
namespace {

// A static product is woken by half the push that would slide or tip it: several neighbours may
// push at once. Goods in heaps lean on one another with about their weight.
constexpr double of_stands_share = 0.5, heap_share = 2;
// What came to rest against its neighbours presses on them for good.
constexpr double moved_share = 1;
// Load from something that was not there before, as a share of the product's weight.
constexpr double load_share = 0.1;
constexpr double arrived_m = 0.002;

void turn_round(WorldContact& contact) {
  std::swap(contact.a, contact.b);
  contact.normal = -contact.normal;
  contact.force_n = -contact.force_n;
}

}  // namespace

// MuJoCo takes the greater friction of the two. Every coefficient of a contact is scaled by the
// same factor, `mu` as well: the regularisation that mj_step1 has made depends on their ratios
// only.
void World::State::set_frictions() {
  for (int i = 0; i < d().ncon; ++i) {
    mjContact& contact = d().contact[i];
    if (contact.geom[0] < 0 || contact.geom[1] < 0) continue;
    const double sliding =
        frictions.sliding(geom_material[static_cast<std::size_t>(contact.geom[0])],
                          geom_material[static_cast<std::size_t>(contact.geom[1])]);
    if (sliding == 0 || contact.dim < 3) continue;
    const double factor = sliding / contact.friction[0];
    for (mjtNum& coefficient : contact.friction)
      coefficient *= factor;
    contact.mu *= factor;
  }
}

ContactSide World::State::side_of(int geom) const {
  const GeomOwner& owner = store.owners[static_cast<std::size_t>(geom)];
  if (!owner.pool) return {owner.kind, owner.row};
  return {BodyKind::product, static_cast<std::uint32_t>(live[owner.row].product)};
}

Result<void> World::State::read_contacts() {
  contacts.clear();
  for (int i = 0; i < d().ncon; ++i) {
    const mjContact& from = d().contact[i];
    if (from.geom[0] < 0 || from.geom[1] < 0) continue;
    mjtNum force[6];
    mj_contactForce(&m(), &d(), i, force);
    WorldContact contact;
    contact.a = side_of(from.geom[0]), contact.b = side_of(from.geom[1]);
    contact.position = vec3_of(from.pos), contact.normal = vec3_of(from.frame);
    contact.depth_m = -from.dist;
    contact.normal_n = force[0];
    contact.tangential_n = std::sqrt(force[1] * force[1] + force[2] * force[2]);
    contact.force_n = vec3_of(from.frame) * force[0] + vec3_of(from.frame + 3) * force[1] +
                      vec3_of(from.frame + 6) * force[2];
    contact.friction = from.friction[0];
    if (contact.b.kind < contact.a.kind) turn_round(contact);
    contacts.push_back(contact);
  }
  return {};
}

void World::State::wake_pressed() {
  for (const WorldContact& contact : contacts) {
    const bool both = contact.a.kind == BodyKind::product && contact.b.kind == BodyKind::product;
    if (!both) continue;
    for (const bool on_b : {true, false}) {
      const ContactSide &pressed = on_b ? contact.b : contact.a, &by = on_b ? contact.a : contact.b;
      if (body_of[pressed.row] >= 0 || body_of[by.row] < 0 || refused[pressed.row]) continue;
      const Vec3 force = on_b ? contact.force_n : -contact.force_n;
      const StandingGoods& goods = store.goods[sku_of(pressed.row)];
      const double weight = goods.mass_kg * standard_gravity;
      const double sideways = std::sqrt(force.x * force.x + force.y * force.y);
      const auto& visitor = live[static_cast<std::size_t>(body_of[by.row])];
      const bool came =
          length(product_pose(by.row).position - visitor.woke_at.position) > arrived_m;
      const bool heap = heaped(pressed.row);
      const double push = heap                          ? heap_share
                          : moved.contains(pressed.row) ? moved_share
                                                        : of_stands_share * goods.stands_share;
      const double load = heap ? heap_share : load_share;
      if (sideways > push * weight || (came && -force.z > load * weight)) wake(pressed.row);
    }
  }
}

}  // namespace marketgen::physics
