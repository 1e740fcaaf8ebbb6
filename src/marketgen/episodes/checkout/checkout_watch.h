// Watches a running Checkout Unloading, step by step: who touches what and how hard, how things
// come to rest. A value: copied with the state it belongs to.
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "episodes/checkout/checkout_model.h"
#include "episodes/push_ledger.h"

namespace marketgen::episodes {

class CheckoutWatch {
 public:
  CheckoutWatch() = default;
  // After the model was placed where the episode begins.
  CheckoutWatch(const CheckoutModel& model, const mjData& data);

  void look(const CheckoutModel& model, const mjData& data);  // after every step

  struct Item {
    bool touched = false;  // by a finger, in the last step
    bool held = false;     // between both fingers
    bool met = false;      // something other than the arm
    double speed_m_s = 0, rested_s = 0, impact_m_s = 0;
    bool toppled = false, dropped = false;
    std::optional<Quaternion> stood;  // outside the basket, when it came to rest there
    Pose first;                       // basket_from_product

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.touched, self.held, self.met, self.speed_m_s, self.rested_s, self.impact_m_s);
      archive(self.toppled, self.dropped, self.stood, self.first);
    }
  };
  const std::vector<Item>& items() const { return items_; }
  double greatest_tilt_deg() const { return tilt_deg_; }

  // Counts contacts that still last as ended. `displaced` and `wrong_items` are the judge's.
  SideEffects effects() const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.items_, self.pushes_, self.tilt_deg_);
  }

 private:
  struct Touches {
    std::vector<std::array<bool, 2>> fingers;  // of each item
    std::vector<bool> met;
    std::map<std::uint64_t, double> force_n;  // on items, the basket, and what stands still
  };
  Touches touches(const CheckoutModel& model, const mjData& data) const;
  void follow_item(std::size_t index, const CheckoutModel& model, const mjData& data);

  std::vector<Item> items_;
  PushLedger pushes_;
  double tilt_deg_ = 0;
};

Pose body_pose(const mjData& data, int body);

}  // namespace marketgen::episodes
