// Records what happens in an episode as it is run: MotionEvent (episodes/motion.h).
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "episodes/motion.h"
#include "episodes/track_world.h"

namespace marketgen::evaluation {

// Between two touches of both fingers, or two seals, that are one hold.
inline constexpr std::uint32_t hold_gap_steps = 4;

// Not thread-safe; of one episode at a time.
class EventRecorder {
 public:
  // The world was reset and outlives the looks.
  void begin(const episodes::TrackWorld& world);
  // After each control step, numbered from 0, which is the beginning.
  void look(std::uint32_t step);
  // So far, by their first step. Contacts that last are among them.
  std::vector<episodes::MotionEvent> events() const;

 private:
  episodes::MotionEvent of_product(episodes::MotionEventKind kind, std::uint32_t product) const;
  episodes::MotionEvent contact_of(const episodes::Push& push) const;
  void look_at_holds();
  void look_at_pushes();
  void look_at_goods(episodes::MotionEventKind kind,
                     const std::set<std::uint32_t>& now,
                     std::set<std::uint32_t>& before);
  void count(episodes::MotionEventKind kind, int now, int& before);

  const episodes::TrackWorld* world_ = nullptr;
  std::uint32_t step_ = 0;
  std::vector<episodes::MotionEvent> events_;
  std::map<std::uint32_t, std::size_t> holds_;  // by product: its last one in events_
  std::size_t pushes_ = 0;
  std::vector<episodes::MotionEvent> lasting_;  // contacts
  std::set<std::uint32_t> toppled_, dropped_, displaced_;
  int base_collisions_ = 0, stops_ = 0;
};

}  // namespace marketgen::evaluation
