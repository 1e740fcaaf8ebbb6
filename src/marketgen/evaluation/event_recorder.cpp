#include "evaluation/event_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace marketgen::evaluation {

using episodes::EventTarget;
using episodes::MotionEvent;
using episodes::MotionEventKind;

void EventRecorder::begin(const episodes::TrackWorld& world) {
  *this = {};
  world_ = &world;
  look(0);
}

void EventRecorder::look(std::uint32_t step) {
  step_ = step;
  const episodes::EpisodeWatch& watch = world_->watch();
  look_at_holds();
  look_at_pushes();
  look_at_goods(MotionEventKind::toppled, watch.toppled(), toppled_);
  look_at_goods(MotionEventKind::dropped, watch.dropped(), dropped_);
  look_at_goods(MotionEventKind::displaced, watch.displaced(), displaced_);
  count(MotionEventKind::base_collision, watch.effects().base_collisions, base_collisions_);
  count(MotionEventKind::protective_stop, world_->controller().stops(), stops_);
}

MotionEvent EventRecorder::of_product(MotionEventKind kind, std::uint32_t product) const {
  const episodes::MovedThing thing = world_->thing_of(product);
  const bool item = thing.kind == episodes::ThingKind::item;
  return {kind,
          step_,
          step_,
          item ? EventTarget::item : EventTarget::product,
          thing.number,
          thing.sku,
          0};
}

void EventRecorder::look_at_holds() {
  for (const auto& [product, item] : world_->watch().items()) {
    if (item.held_by < 0) continue;
    const auto known = holds_.find(product);
    if (known != holds_.end() && step_ - events_[known->second].last_step <= hold_gap_steps) {
      events_[known->second].last_step = step_;
      continue;
    }
    holds_[product] = events_.size();
    events_.push_back(of_product(MotionEventKind::held, product));
  }
}

MotionEvent EventRecorder::contact_of(const episodes::Push& push) const {
  const physics::ContactSide on = episodes::EpisodeWatch::pushed_by(push);
  MotionEvent event;
  switch (on.kind) {
    case physics::BodyKind::product:
      event = of_product(MotionEventKind::contact, on.row);
      break;
    case physics::BodyKind::fixture:
      event.target = EventTarget::fixture;
      break;
    case physics::BodyKind::room:
      event.target = EventTarget::room;
      break;
    case physics::BodyKind::actor:
      event.target = EventTarget::other;
      break;
  }
  const auto lasted =
      static_cast<std::uint32_t>(std::ceil(push.lasted_s / episodes::control_step_s));
  event.kind = MotionEventKind::contact;
  event.last_step = step_;
  event.step = step_ - std::min(lasted, step_);
  event.force_n = push.peak_n;
  return event;
}

void EventRecorder::look_at_pushes() {
  const std::vector<episodes::Push>& ended = world_->watch().pushes().ended();
  for (; pushes_ < ended.size(); ++pushes_)
    events_.push_back(contact_of(ended[pushes_]));
  lasting_.clear();
  for (const episodes::Push& push : world_->watch().pushes().lasting())
    lasting_.push_back(contact_of(push));
}

void EventRecorder::look_at_goods(MotionEventKind kind,
                                  const std::set<std::uint32_t>& now,
                                  std::set<std::uint32_t>& before) {
  if (now.size() == before.size()) return;  // they only grow
  for (const std::uint32_t product : now)
    if (before.insert(product).second) events_.push_back(of_product(kind, product));
}

void EventRecorder::count(MotionEventKind kind, int now, int& before) {
  for (; before < now; ++before)
    events_.push_back({kind, step_, step_, EventTarget::nothing, 0, "", 0});
}

std::vector<MotionEvent> EventRecorder::events() const {
  std::vector<MotionEvent> events = events_;
  events.insert(events.end(), lasting_.begin(), lasting_.end());
  std::ranges::stable_sort(events, {}, &MotionEvent::step);
  return events;
}

}  // namespace marketgen::evaluation
