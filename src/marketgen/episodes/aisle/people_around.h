// People who walk about in the store while a robot works there.
//
// Each stands before a shelf for a while and then walks to another, as they decide when they go.
// They are granted their way step by step: a step that would bring them too near to the robot, or
// to where another has been granted theirs, is refused, and they come to stand before it. So nobody
// ever meets anybody. Who was stopped for some seconds goes another way or elsewhere, past
// everybody and the robot as they stand; so does who stands where a robot waits before them. Who
// found no such way and still stands there comes nearer to the robot to get past it, or turns
// round and goes as far from it as they can. Only who is shut in by it and has nowhere farther to
// go stands on and looks again later: the robot has to make room.
//
// Store frame, SI units.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/byte_archive.h"
#include "base/seed.h"
#include "collect/person_round.h"
#include "episodes/aisle/person_moment.h"
#include "motion/way_round.h"

namespace marketgen::episodes {

// People walk no nearer to a robot, between their body and its nearest part: where personal
// distance begins, nearer than which only friends come (Hall, "The Hidden Dimension", 1966: 0.46 m
// to 1.2 m), and some.
inline constexpr double stop_before_robot_m = 0.6;
// A robot that is nearer than that to somebody who stands there asks them to make room.
inline constexpr double asks_for_room_m = 1.2;
// Who finds no other way comes so near to a robot to get past it.
inline constexpr double min_gap_m = 0.35;
// How long people stand before a robot, or one another, until they go elsewhere; and until who
// found nowhere to go looks again.
inline constexpr double patience_s = 2, looks_again_s = 2;

// Their bodies for contacts: an upright cylinder to the shoulders, a ball for the head. Radii after
// ANSUR II; the head is 0.20 m across.
using motion::person_radius_m;
inline constexpr double head_radius_m = 0.10;

// Something round on the floor: a part of the robot, seen from above.
struct FloorDisc {
  Vec2 at;
  double radius_m = 0;
};

// A value; copies share who they are. Not thread-safe while it is changed.
class PeopleAround {
 public:
  static constexpr std::size_t max_count = 60;

  PeopleAround() = default;
  // So many a square metre of the floor that nothing stands on, rounded down, max_count at most;
  // fewer where no more find a place to stand. Nobody begins within 1.5 m of `robot`. Errors: those
  // of drive_graph().
  static Result<PeopleAround> make(const scene::Scene& scene, double per_m2, Seed seed, Vec2 robot);

  std::size_t count() const { return walkers_.size(); }

  // Time goes on by dt_s, 0 to 0.1. `robot`: where it is.
  void pass(double dt_s, std::span<const FloorDisc> robot);

  std::vector<PersonMoment> moments() const;
  Vec2 place(std::size_t person) const;
  Pose store_from_person(std::size_t person) const;
  double speed_m_s(std::size_t person) const { return walkers_[person].speed_m_s; }
  double stature_m(std::size_t person) const { return who(person).look.stature_m; }
  // Whether nothing that stands on the floor is between them and `from`.
  bool sees(Vec2 from, std::size_t person) const;
  // How long somebody or the robot has kept them from going where they want, or waited before
  // them; 0 once they go.
  double stopped_s(std::size_t person) const { return walkers_[person].stopped_s; }
  // How many walks they have begun.
  int walks(std::size_t person) const { return static_cast<int>(walkers_[person].walks); }
  // Posed as at that moment of theirs.
  assets::PlacedPerson at(std::size_t person, const PersonMoment& moment) const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.walkers_);
    if constexpr (!std::is_const_v<Self>) self.know_acts();
  }

 private:
  struct Walker {
    PersonMoment now;
    int granted = 0;       // steps of the walk
    double stopped_s = 0;  // by somebody or the robot
    double speed_m_s = 0;
    std::uint32_t walks = 0, decisions = 0;
    bool found_none = false;  // where to go, when they looked last
    bool squeezes = false;    // on this walk: past the robot by min_gap_m
    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.now, self.granted, self.stopped_s, self.speed_m_s, self.walks, self.decisions);
      archive(self.found_none, self.squeezes);
    }
  };
  struct Company {
    collect::PeopleFloor floor;
    navigation::FreeSpace sight;            // between fixtures
    std::vector<collect::PersonRound> who;  // without acts
    std::vector<Seed> seeds;
  };
  using Robot = std::span<const FloorDisc>;
  using Discs = std::vector<navigation::DiscMm>;

  const collect::PersonRound& who(std::size_t person) const { return company_->who[person]; }
  void know_acts();
  void begin(std::size_t person, collect::PersonWalk walk);
  collect::StandingPlace stands_at(std::size_t person) const;
  std::vector<Vec2> held_by(std::size_t person) const;
  bool may_step(std::size_t person, int step, Robot robot) const;
  bool grant(std::size_t person, int steps, Robot robot);
  void cut(std::size_t person, int steps);
  bool walk_on(std::size_t person, const collect::PersonAct& walk, double to_s, Robot robot);
  bool has_stood_enough(std::size_t person, double dt_s, Robot robot);
  double keeps_m(std::size_t person) const;
  void decide(std::size_t person, Robot robot);
  bool goes_to(std::size_t person,
               const collect::StandingPlace& to,
               const Discs& past,
               double stay_s,
               Robot robot);
  bool goes_elsewhere(std::size_t person, Stream& draw, Robot robot);
  bool gets_away(std::size_t person, Stream& draw, Robot robot);
  Discs others_in_the_way(std::size_t person) const;
  std::optional<collect::PersonWalk> walk_to(std::size_t person,
                                             const collect::StandingPlace& to,
                                             const Discs& past,
                                             double stay_s) const;
  std::vector<collect::StandingPlace> wishes(std::size_t person, Stream& draw) const;
  std::vector<collect::StandingPlace> refuges(std::size_t person, Robot robot) const;

  std::shared_ptr<const Company> company_;
  std::vector<Walker> walkers_;
  std::vector<collect::PersonRound> rounds_;  // who they are, with the acts of their walks
};

}  // namespace marketgen::episodes
