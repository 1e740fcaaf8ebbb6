#include "server/drive_pages.h"

#include <utility>

#include "io/json.h"

namespace marketgen::server {

int DrivePages::join() {
  const std::scoped_lock lock(mutex_);
  return next_++;
}

void DrivePages::greet(int page, std::weak_ptr<SocketSender> sender) {
  Held held;
  const std::scoped_lock lock(mutex_);
  pages_[page] = std::move(sender);
  if (driver_ < 0 && !watched_) driver_ = page;
  say_who_drives(held);
  if (latest_ == nullptr || ended_) return;
  if (SocketSender* const one = hold(page, held)) one->latest(latest_);
}

void DrivePages::leave(int page) {
  Held held;
  const std::scoped_lock lock(mutex_);
  pages_.erase(page);
  if (driver_ != page) return;
  driver_ = -1;
  say_who_drives(held);
}

void DrivePages::take(int page) {
  Held held;
  const std::scoped_lock lock(mutex_);
  if (driver_ < 0 && !watched_ && pages_.contains(page)) driver_ = page;
  say_who_drives(held);
}

bool DrivePages::drives(int page) const {
  const std::scoped_lock lock(mutex_);
  return driver_ == page;
}

bool DrivePages::taken() const {
  const std::scoped_lock lock(mutex_);
  return watched_ || driver_ >= 0;
}

SocketSender* DrivePages::hold(int page, Held& held) const {
  const auto found = pages_.find(page);
  if (found == pages_.end()) return nullptr;
  held.push_back(found->second.lock());
  return held.back().get();
}

void DrivePages::send(int page, const std::string& text, Held& held) const {
  if (ended_) return;
  if (SocketSender* const sender = hold(page, held)) sender->text(text);
}

void DrivePages::say_who_drives(Held& held) const {
  for (const auto& [page, sender] : pages_)
    send(page,
         io::write_json_line(
             DriveNote{"you", page == driver_, watched_ || driver_ >= 0, {}, {}, {}}),
         held);
}

void DrivePages::tell(int page, const DriveNote& note) const {
  Held held;
  const std::scoped_lock lock(mutex_);
  send(page, io::write_json_line(note), held);
}

void DrivePages::tell_driver(const DriveNote& note) const {
  Held held;
  const std::scoped_lock lock(mutex_);
  send(driver_, io::write_json_line(note), held);
}

void DrivePages::tell_all(const DriveNote& note) const {
  Held held;
  const std::scoped_lock lock(mutex_);
  for (const auto& [page, sender] : pages_)
    send(page, io::write_json_line(note), held);
}

void DrivePages::show(std::shared_ptr<const std::string> latest) {
  Held held;
  const std::scoped_lock lock(mutex_);
  latest_ = std::move(latest);
  if (ended_ || latest_ == nullptr) return;
  for (const auto& [page, weak] : pages_)
    if (SocketSender* const sender = hold(page, held)) sender->latest(latest_);
}

void DrivePages::end() {
  const std::scoped_lock lock(mutex_);
  ended_ = true;
}

}  // namespace marketgen::server
