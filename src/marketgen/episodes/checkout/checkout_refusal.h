// Which products the Panda at the counter can be expected to take as they lie in a basket, and why
// not the others.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/rows.h"
#include "robots/grasp_tool.h"

namespace marketgen::episodes {

// The first that applies; of the gripper's, measured (docs/episodes.md).
enum class CheckoutRefusal {
  none,
  soft,         // packs that give way
  too_heavy,    // for the arm, held off its middle; for what the cup pulls, with how it is moved
  too_wide,     // for the gripper
  too_flat,     // beside the ledge there is no room for a finger
  too_long,     // to be turned in the basket
  small_round,  // rolls away between the fingers
  too_large,    // for the basket
  no_seal,      // no face on which the cup seals is up, lying on a broadest side
  no_room       // for the cup at such a face
};
constexpr std::array<std::string_view, 10> names_of(CheckoutRefusal) {
  return {"none",
          "soft",
          "too_heavy",
          "too_wide",
          "too_flat",
          "too_long",
          "small_round",
          "too_large",
          "no_seal",
          "no_room"};
}

// Of the gripper.
CheckoutRefusal checkout_refusal(const catalog::Product& product);
inline bool is_checkout_item(const catalog::Product& product) {
  return checkout_refusal(product) == CheckoutRefusal::none;
}

// Of a cup: whether it holds the pack by the face that is up when that lies on its broadest side,
// this or the other way up. Errors: assets.*, those of grasp_candidates.
Result<CheckoutRefusal> cup_refusal(const catalog::Product& product,
                                    const robots::GraspTool& cup,
                                    double lip_friction);

// With what the robot takes goods.
struct CheckoutHand {
  std::string tools = {};  // as EpisodeSpec::tools names it
  // Of what it was made for. Thread-safe.
  std::function<CheckoutRefusal(const catalog::Product&)> refusal = checkout_refusal;

  bool takes(const catalog::Product& product) const {
    return refusal(product) == CheckoutRefusal::none;
  }
};

// Of a tool set (the first when `tools` is empty) of a station (that of Checkout Unloading when it
// is empty), for these products. What a gripper can be expected to hold is said of long fingers and
// a basket with a ledge; at other stations that is where a search for a witness begins.
// Errors: those of load_checkout_station, load_grasp_tool and cup_refusal.
Result<CheckoutHand> checkout_hand(const std::filesystem::path& data,
                                   const std::vector<catalog::FrictionRow>& frictions,
                                   const std::vector<catalog::Product>& products,
                                   const std::string& tools,
                                   const std::string& station = {});

}  // namespace marketgen::episodes
