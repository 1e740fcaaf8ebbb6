// What a robot did beside its task.
#pragma once
#include <optional>

#include "base/fields.h"

namespace marketgen::episodes {

// Fingers that open between stocked packs push the neighbours aside: at 2 cm, from which a good is
// `displaced`, no pick would be clean. At 10 cm, the width of a facing (median 97 mm of 3,274), it
// stands before another good's label.
constexpr double max_clean_shift_m = 0.10;

// The side-effect ledger. An item has strayed when it ends, in aisles, outside the basket and more
// than max_clean_shift_m from where it stood; at a counter, neither in the basket nor on the
// unloading or set-aside area. Contacts are those of the arm, and of what it holds, with anything
// else; each counts once, by the greatest force on it (mean over 10 ms).
struct SideEffects {
  int light_contacts = 0, firm_contacts = 0, hard_contacts = 0;
  double hardest_n = 0;
  int toppled = 0, dropped = 0, displaced = 0, strayed = 0, wrong_items = 0;
  double basket_tilt_deg = 0;
  int base_collisions = 0;
  int protective_stops = 0;
  std::optional<int> doors_open = {};  // of episodes with doors
  // Of episodes with people.
  std::optional<int> person_contacts = {};
  std::optional<double> person_hardest_n = {}, person_near_s = {}, person_distance_m = {};

  static constexpr auto fields = field_list(
      field("light_contacts", &SideEffects::light_contacts, "below 10 N"),
      field("firm_contacts", &SideEffects::firm_contacts, "10 to 50 N"),
      field("hard_contacts", &SideEffects::hard_contacts, "above 50 N"),
      field("hardest_n", &SideEffects::hardest_n, "greatest force, N"),
      field("toppled", &SideEffects::toppled, "items that fell over outside the basket"),
      field("dropped", &SideEffects::dropped, "items that met something faster than 1 m/s"),
      field("displaced", &SideEffects::displaced, "items not asked for that lie elsewhere"),
      field("strayed", &SideEffects::strayed, "items that lie where they do not belong"),
      field("wrong_items", &SideEffects::wrong_items, "items in the area that are no goal"),
      field("basket_tilt_deg", &SideEffects::basket_tilt_deg, "greatest tilt of the basket"),
      field("base_collisions",
            &SideEffects::base_collisions,
            "times that the robot's base met something that stands"),
      field("protective_stops",
            &SideEffects::protective_stops,
            "times that the robot stopped because something pressed on it"),
      field("doors_open",
            &SideEffects::doors_open,
            "of episodes with doors: how many stand open at the end"),
      field("person_contacts",
            &SideEffects::person_contacts,
            "of episodes with people: times that the robot, or what it held, touched one"),
      field("person_hardest_n",
            &SideEffects::person_hardest_n,
            "of episodes with people: the greatest force on one, N; above 65 the episode is void"),
      field("person_near_s",
            &SideEffects::person_near_s,
            "of episodes with people: seconds in which some part of the robot was nearer to one "
            "than 0.5 m and faster than 0.3 m/s"),
      field("person_distance_m",
            &SideEffects::person_distance_m,
            "of episodes with people: smallest distance between the robot and one; 2 where none "
            "came nearer"));
};

// No contact above 50 N, nothing driven into, toppled or dropped, no item strayed, nobody touched
// and no door left open. `displaced` is not asked for: what lies in a heap sinks into the room of
// what is taken out.
bool is_clean(const SideEffects& effects);

}  // namespace marketgen::episodes
