// People who walk about in the store while a robot works there.
//
// Each goes along a round (collect/store_people.h) by a clock of their own. Whom the robot is in
// the way of stands still, and after a while steps back along the way they came to where they stood
// before a shelf; whoever stands, stands on as long as the robot is before them. Clocks drift apart
// that way, so nobody enters a place that somebody who is behind in time has yet to leave: with
// that rule people never meet, and of themselves never block one another for good (Cap, Gregoire
// and Frazzoli, "Provably Safe and Deadlock-Free Execution of Multi-Robot Plans under Delaying
// Disturbances", IROS 2016). Who has stepped back may, for a while.
//
// Store frame, SI units.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "collect/store_people.h"

namespace marketgen::episodes {

// People stop so far from a robot, between their body and its nearest part: where personal distance
// begins, nearer than which only friends come (Hall, "The Hidden Dimension", 1966: 0.46 m to 1.2
// m), and some.
inline constexpr double stop_before_robot_m = 0.6;
// Nearer than this the robot is too near; likewise.
inline constexpr double near_person_m = 0.46;

// Their bodies for contacts: an upright cylinder to the shoulders, a ball for the head. Radii after
// ANSUR II: half of a mean bideltoid breadth of 0.49 m, of a head of 0.20 m.
inline constexpr double person_radius_m = 0.24, head_radius_m = 0.10;

// Something round on the floor: a part of the robot, seen from above.
struct FloorDisc {
  Vec2 at;
  double radius_m = 0;
};

// A value; copies share the rounds. Not thread-safe while it is changed.
class PeopleAround {
 public:
  PeopleAround() = default;
  // As StorePeople::walkers(), without those who would begin within 1.5 m of `robot`. Errors: those
  // of walkers().
  static Result<PeopleAround> make(const scene::Scene& scene, int max_count, Seed seed, Vec2 robot);

  std::size_t count() const { return walkers_.size(); }

  // Time goes on by dt_s, 0 to 0.1, for everybody who may walk on. `robot`: where it is.
  void pass(double dt_s, std::span<const FloorDisc> robot);

  // Where each is in their round; what pictures of a moment are made by.
  std::vector<double> clocks() const;
  Pose store_from_person(std::size_t person) const;
  double speed_m_s(std::size_t person) const { return walkers_[person].speed_m_s; }
  double stature_m(std::size_t person) const;
  // Posed as at that time of their round.
  assets::PlacedPerson at(std::size_t person, double clock_s) const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.walkers_);
  }

 private:
  enum class Going { ahead, back, rests };
  struct Walker {
    std::uint32_t round = 0;  // in the rounds
    double clock_s = 0;
    double held_up_s = 0;  // by the robot; of who rests: since they came back
    Going going = Going::ahead;
    double speed_m_s = 0;
    void turn(Going to) { going = to, held_up_s = 0; }
    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.round, self.clock_s, self.held_up_s, self.going);
      archive(self.speed_m_s);
    }
  };
  struct Sample {
    Vec2 at;
    double room_m = 0;
  };
  using Samples = std::vector<std::vector<Sample>>;  // by round, evenly over it

  Vec2 place(std::size_t person) const;
  const Sample& sample(const Walker& walker, double clock_s) const;
  bool meets_anybody(std::size_t person, double clock_s) const;
  bool meets_later(const Sample& there, const Walker& other, double until_s) const;
  bool nears_robot(const Walker& walker, double clock_s, std::span<const FloorDisc> robot) const;
  void go_ahead(std::size_t person, double dt_s, std::span<const FloorDisc> robot);
  void go_back(std::size_t person, double dt_s, std::span<const FloorDisc> robot);
  void rest(std::size_t person, double dt_s, std::span<const FloorDisc> robot);

  std::shared_ptr<const collect::StorePeople> rounds_;
  std::shared_ptr<const Samples> samples_;
  std::vector<Walker> walkers_;
};

}  // namespace marketgen::episodes
