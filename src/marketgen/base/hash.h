// Stable hashing: XXH3 (format frozen since 0.8), the same on every machine and in every version of
// this program.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace marketgen {

std::uint64_t hash64(std::string_view bytes, std::uint64_t seed = 0);

// Incremental 128-bit hash over a sequence of values. Lengths are hashed too, so ("ab", "c")
// differs from ("a", "bc").
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;

  Hasher& add(std::string_view text);
  Hasher& add(std::int64_t value);
  // Rounds to a multiple of `step` first: the hash of a pose does not see noise below the step.
  Hasher& add_rounded(double value, double step);
  // Raw bytes without a length, for bulk data of known size.
  Hasher& add_bytes(std::span<const std::byte> bytes);

  std::string hex() const;  // 32 lower-case digits

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace marketgen
