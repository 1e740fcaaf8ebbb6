// Words that name exactly one product of those on offer, as a shopper says them: "the low-fat milk
// by Weidora, one litre".
//
// Attributes are chosen as people do (Dale and Reiter, "Computational interpretations of the
// Gricean maxims", 1995): the name first, then in an order drawn for the expression each attribute
// that rules out something that is still in question; then some that would not have been needed. So
// an attribute is there whenever a product on offer differs in nothing else that was said.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/seed.h"
#include "episodes/episode_spec.h"
#include "episodes/told_attribute.h"

namespace marketgen::episodes {

struct ReferringExpression {
  std::string text;
  std::vector<ToldAttribute> says;  // all that the text says; fits one product on offer
};

// `count` of product `number` of the offer. Empty when others have nothing that can be told from
// it.
std::optional<ReferringExpression> refer_to(const Offer& offer,
                                            std::size_t number,
                                            int count,
                                            Seed seed);

// Why a goal is not drawn whose words would fit another product, too: in draw shares and
// exclusions.
constexpr std::string_view not_told_apart = "not_told_apart";

// A sentence for what a track asks for; by SKU always the same one.
enum class InstructionVerb { unload, collect };
std::string instruction_of(InstructionVerb verb,
                           Instructions instructions,
                           const std::vector<std::string>& goals,
                           Seed seed);

}  // namespace marketgen::episodes
