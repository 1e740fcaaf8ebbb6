// What a policy may sense and know in Checkout Unloading, made from a running episode: pictures of
// the cameras, the nominal place. Nothing else of the world passes through these
// interfaces.
#pragma once
#include <map>
#include <memory>

#include "agent/eyes.h"
#include "agent/workplace.h"
#include "episodes/checkout/checkout_view.h"

namespace marketgen::episodes {

// The station's cameras, as the world's realism has them. `world` must outlive it.
class CheckoutEyes : public agent::Eyes {
 public:
  explicit CheckoutEyes(const CheckoutWorld& world) : world_(world) {}
  Result<agent::View> look(std::string_view camera) override;

  // The truth, for TrueMasks and measures; no policy sees it: which item each pixel of the camera's
  // last picture shows, -1 none. Empty before there is one.
  const std::vector<int>& items_shown(const std::string& camera) const;

 private:
  const CheckoutWorld& world_;
  std::map<std::string, std::vector<int>> items_shown_;  // by camera
  std::unique_ptr<CheckoutView> view_;  // of the episode that runs, once it was looked at
};

agent::Workplace workplace_of(const CheckoutStation& station);

}  // namespace marketgen::episodes
