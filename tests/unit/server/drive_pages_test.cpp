// Pages that come and go at a drive while they are sent what it says.
#include "server/drive_pages.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <thread>

namespace marketgen {
namespace {

// A page's socket: its end leaves, as that of a real one does, whichever thread lets it go last.
class LeavingPage : public server::SocketSender {
 public:
  explicit LeavingPage(server::DrivePages& pages) : pages_(pages), number_(pages.join()) {}
  ~LeavingPage() override { pages_.leave(number_); }
  LeavingPage(const LeavingPage&) = delete;
  LeavingPage& operator=(const LeavingPage&) = delete;
  void text(std::string) override { sent(); }
  void latest(std::shared_ptr<const std::string>) override { sent(); }
  int number() const { return number_; }

  std::function<void()> sent = [] {};

 private:
  server::DrivePages& pages_;
  const int number_;
};

struct Room {
  server::DrivePages pages{false};
  std::shared_ptr<LeavingPage> first = std::make_shared<LeavingPage>(pages);
  std::shared_ptr<LeavingPage> second = std::make_shared<LeavingPage>(pages);
  Room() {
    pages.greet(first->number(), first);
    pages.greet(second->number(), second);
  }
};

using Send = std::function<void(server::DrivePages&)>;

class GoneMeanwhile : public testing::TestWithParam<int> {};

// Whatever it is sent when its socket lets it go: its end comes in the thread that sends.
TEST_P(GoneMeanwhile, LeavesAndTheOthersGoOn) {
  const std::vector<Send> sends = {
      [](server::DrivePages& pages) { pages.show(std::make_shared<const std::string>("moment")); },
      [](server::DrivePages& pages) {
        pages.tell_all({"opened", false, false, {}, {}, {}});
      },
      [](server::DrivePages& pages) {
        pages.tell_driver({"saved", false, false, {}, {}, {}});
      },
      [](server::DrivePages& pages) { pages.take(1); },
  };
  Room room;
  ASSERT_TRUE(room.pages.drives(room.first->number()));
  room.first->sent = [&room] { room.first.reset(); };
  sends[static_cast<std::size_t>(GetParam())](room.pages);
  EXPECT_EQ(room.first, nullptr);
  EXPECT_FALSE(room.pages.taken());
  room.pages.take(room.second->number());
  EXPECT_TRUE(room.pages.drives(room.second->number()));
}

INSTANTIATE_TEST_SUITE_P(Sends, GoneMeanwhile, testing::Range(0, 4));

TEST(DrivePages, ManyComeAndGoWhileTheyAreShownSomething) {
  server::DrivePages pages(false);
  std::atomic<bool> ends = false;
  std::thread shows([&] {
    while (!ends)
      pages.show(std::make_shared<const std::string>("moment"));
  });
  for (int i = 0; i < 20'000; ++i) {
    const auto page = std::make_shared<LeavingPage>(pages);
    pages.greet(page->number(), page);
  }
  ends = true;
  shows.join();
  EXPECT_FALSE(pages.taken());
}

}  // namespace
}  // namespace marketgen
