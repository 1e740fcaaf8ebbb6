// Draws episodes of Checkout Unloading from a store's stock.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/seed.h"
#include "catalog/rows.h"
#include "episodes/checkout/checkout_refusal.h"
#include "episodes/checkout/checkout_world.h"
#include "episodes/draw_rules.h"
#include "episodes/episode_origin.h"
#include "scene/scene.h"

namespace marketgen::episodes {

// Kinds of goods that the robot takes; baskets of stores with fewer than Difficulty asks for are
// smaller.
constexpr std::size_t min_stock = 2;

// Of store_stock(), what fits into a checkout's basket, whether the robot takes it or not.
std::vector<catalog::Product> checkout_stock(const scene::Scene& scene);
// How many products of the store's shelves are left out, by reason.
EpisodeExclusions checkout_exclusions(const scene::Scene& scene,
                                      const CheckoutHand& hand = {},
                                      const TrainingSet& trained_on = {});

// What a witness calls EpisodeSpec::items[number]: "item-3".
std::string witness_item(std::size_t number);

// Looks for a way through a settled basket: picks in their order, or nothing when it finds none.
using CheckoutCertifier = std::function<Result<std::optional<std::vector<WitnessPick>>>(
    const CheckoutWorld& world, Seed seed)>;

// Episode `index` of a seed. Targets and others are different products, drawn evenly over shapes,
// of a small stock at most a third of it targets: targets of what the hand takes and the rules let
// a task ask for, others of all
// of `stock`, as long as there is room in the basket; dropped into the basket one after another,
// and settled. What spills is left out; drawn anew when too few stay, words would fit another
// product of the basket as well (not_told_apart), or `certify` finds no way through (empty: not
// asked for). With `prove` a basket needs no planned way, but is drawn anew when it cannot be done
// in physics. Errors: episode.impossible (too few kinds of goods, too many baskets drawn); those of
// CheckoutWorld, of `certify` and of `prove`.
Result<EpisodeSpec> sample_checkout(const std::filesystem::path& data,
                                    const std::vector<catalog::Product>& stock,
                                    const std::vector<catalog::FrictionRow>& frictions,
                                    const EpisodeOrigin& origin,
                                    Seed seed,
                                    int index,
                                    const CheckoutCertifier& certify = {},
                                    const EpisodeProver& prove = {},
                                    const DrawRules& rules = {},
                                    const CheckoutHand& hand = {});

}  // namespace marketgen::episodes
