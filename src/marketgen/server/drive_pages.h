// The pages at one drive: one of them drives, the others look on. Thread-safe. A page may go while
// it is sent something: what ends then may leave() in the same thread.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/drive_documents.h"
#include "server/web_socket.h"

namespace marketgen::server {

class DrivePages {
 public:
  explicit DrivePages(bool watched) : watched_(watched) {}  // by all, and driven by none
  int join();                                               // its number
  // It can be sent something from now on, and drives if nobody does.
  void greet(int page, std::weak_ptr<SocketSender> sender);
  void leave(int page);
  // The page drives from now on, unless another one does.
  void take(int page);
  bool drives(int page) const;
  bool taken() const;

  void tell(int page, const DriveNote& note) const;
  void tell_driver(const DriveNote& note) const;
  void tell_all(const DriveNote& note) const;
  // To all, and first of all to who comes later.
  void show(std::shared_ptr<const std::string> latest);
  void end();  // nothing is sent any more

 private:
  // Pages that are being sent something. Made before the lock is taken and so let go after it:
  // whoever holds a page last ends it, and its end leaves.
  using Held = std::vector<std::shared_ptr<SocketSender>>;

  SocketSender* hold(int page, Held& held) const;  // null: it has gone
  void say_who_drives(Held& held) const;
  void send(int page, const std::string& text, Held& held) const;

  const bool watched_;
  mutable std::mutex mutex_;
  int next_ = 0, driver_ = -1;
  bool ended_ = false;
  std::map<int, std::weak_ptr<SocketSender>> pages_;
  std::shared_ptr<const std::string> latest_;
};

}  // namespace marketgen::server
