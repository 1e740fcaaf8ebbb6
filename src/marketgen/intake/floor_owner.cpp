#include "intake/floor_owner.h"

#include <algorithm>

namespace marketgen::intake {
namespace {

constexpr double shop_of_its_own = 1;      // lexicon: number of a zone's row
constexpr double belongs_to_the_last = 1;  // lexicon: number of ":" and "("

class FloorOwner {
 public:
  FloorOwner(const Sentence& sentence, bool shop_measured)
      : sentence_(sentence), shop_measured_(shop_measured) {}

  std::string run(std::size_t first, std::size_t last) const {
    const std::size_t after = noun_after(last);
    const std::size_t noun = is_zone(after) ? after : zone_before(first);
    if (!is_zone(noun) || is_the_shop(noun)) return "";
    const Phrase& zone = sentence_.phrases[noun];
    return zone.sense == Sense::zone ? zone.value : zone.zone;
  }

 private:
  bool is_zone(std::size_t i) const {
    return sentence_.is(i, Sense::zone) ||
           (sentence_.is(i, Sense::product) && !sentence_.at(i).zone.empty());
  }
  bool is_shop(std::size_t i) const {
    return sentence_.is(i, Sense::shop) || sentence_.is(i, Sense::profile);
  }
  bool is_adjective(std::size_t i) const {
    constexpr Sense senses[] = {
        Sense::size, Sense::amount, Sense::style, Sense::color, Sense::material, Sense::ordinary};
    return i < sentence_.phrases.size() &&
           std::ranges::find(senses, sentence_.at(i).sense) != std::end(senses);
  }

  // "a 20 m2 large bakery", but not "40 m2 with a bakery".
  std::size_t noun_after(std::size_t last) const {
    std::size_t i = last + 1;
    for (; i < sentence_.phrases.size(); ++i) {
      if (sentence_.is(i, Sense::filler, "has")) return sentence_.phrases.size();
      if (!sentence_.is(i, Sense::filler) && !is_adjective(i)) break;
    }
    return i;
  }

  // "a bakery of 20 m2", "bakery section of about 20 m2", "bakery: 20 m2"; not "a shop with snacks,
  // 40 m2" and not "a kiosk with snacks and drinks of 40 m2", in which the kiosk has them all.
  std::size_t zone_before(std::size_t first) const {
    const std::size_t none = sentence_.phrases.size();
    std::size_t at = sentence_.before(first);
    if (sentence_.is(at, Sense::comparison)) at = sentence_.before(at);
    const bool opened =
        sentence_.is(at, Sense::separator) && sentence_.at(at).number == belongs_to_the_last;
    if (opened) at = sentence_.before(at);
    const std::size_t linked_to = at;
    while (sentence_.is(at, Sense::suffix))
      at = sentence_.before(at);
    if (!is_zone(at)) return none;
    if (!opened && !has_filler(linked_to, first)) return none;
    if (starts_with_article(at)) return at;
    const bool one_of_many = sentence_.is(sentence_.before(at), Sense::separator) &&
                             is_zone(sentence_.before(sentence_.before(at)));
    return one_of_many && shop_is_named_before(at) && !shop_measured_ ? none : at;
  }

  bool has_filler(std::size_t from, std::size_t to) const {
    for (std::size_t i = from + 1; i < to; ++i) {
      if (sentence_.is(i, Sense::filler)) return true;
    }
    return false;
  }

  bool starts_with_article(std::size_t noun) const {
    std::size_t i = noun;
    while (i > 0 && is_adjective(i - 1))
      --i;
    return i > 0 && sentence_.is(i - 1, Sense::filler, "article");
  }

  bool shop_is_named_before(std::size_t end) const {
    for (std::size_t i = 0; i < end; ++i) {
      if (is_shop(i)) return true;
    }
    return false;
  }

  // "wine and spirits shop"; or the one thing that was asked for is "a bakery".
  bool is_the_shop(std::size_t noun) const {
    std::size_t i = noun + 1;
    while (is_zone(i) || sentence_.is(i, Sense::separator, "and"))
      ++i;
    if (is_shop(i)) return true;
    if (!sentence_.first || shop_measured_) return false;
    if (sentence_.at(noun).sense != Sense::zone || sentence_.at(noun).number != shop_of_its_own)
      return false;
    for (i = 0; i < sentence_.phrases.size(); ++i) {
      if (is_shop(i) || (i < noun && is_zone(i))) return false;
    }
    return true;
  }

  const Sentence& sentence_;
  const bool shop_measured_;
};

}  // namespace

std::string zone_of_floor(const Sentence& sentence,
                          std::size_t first,
                          std::size_t last,
                          bool shop_measured) {
  return FloorOwner(sentence, shop_measured).run(first, last);
}

}  // namespace marketgen::intake
