// Numbers by small integer keys, in one block of memory: for the millions of vertices and cells of
// meshes, where std::unordered_map spends its time allocating nodes.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace marketgen {

// Key: std::array of integers. Keys are found again, never walked, so the order in memory shows
// nowhere.
template <class Key>
class FlatIndex {
 public:
  explicit FlatIndex(std::size_t max_keys)
      : places_(std::bit_ceil(2 * max_keys + 1)), mask_(places_.size() - 1) {}

  // The number of `key`, which is `number` when the key is new. Precondition: there are not
  // max_keys others yet.
  std::pair<std::uint32_t&, bool> try_emplace(const Key& key, std::uint32_t number) {
    Place& place = places_[place_of(key)];
    const bool is_new = place.number == none;
    if (is_new) place = {key, number};
    return {place.number, is_new};
  }

  // Null when there is no such key.
  const std::uint32_t* find(const Key& key) const {
    const Place& place = places_[place_of(key)];
    return place.number == none ? nullptr : &place.number;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  struct Place {
    Key key{};
    std::uint32_t number = none;
  };

  // Where the key lies or would lie: the first place from its own that is free or holds it.
  std::size_t place_of(const Key& key) const {
    std::uint64_t h = 0;
    for (const auto part : key) {
      h = (h ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    auto at = static_cast<std::size_t>(h) & mask_;
    while (places_[at].number != none && places_[at].key != key)
      at = (at + 1) & mask_;
    return at;
  }

  std::vector<Place> places_;
  std::size_t mask_;
};

}  // namespace marketgen
