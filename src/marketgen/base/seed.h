// Randomness from named streams only: the same name under the same seed gives the same numbers,
// whatever else is drawn.
//
//   Stream draw = seed.child("shelf_fill", fixture_id).stream();
//   const double jitter = draw.uniform(-1.0, 1.0);
//
// Numbers are counter based (SplitMix64's finaliser over key + n * golden ratio; Steele, Lea,
// Flood, OOPSLA 2014), made with integer arithmetic and exact conversions, so they are the same on
// every machine and for every thread count.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace marketgen {

class Stream {
 public:
  explicit Stream(std::uint64_t key) : key_(key) {}

  std::uint64_t bits();                     // 64 uniform bits
  double uniform();                         // [0, 1), 53 bits
  double uniform(double low, double high);  // [low, high)
  int integer(int low, int high);           // low..high inclusive, unbiased to 2^-32
  bool chance(double probability);
  double normal();  // mean 0, sigma 1: sum of 12 uniforms (no libm: bit-exact everywhere)

  // Index drawn with the given non-negative weights; 0 if all are zero. Precondition: weights not
  // empty.
  std::size_t weighted(std::span<const double> weights);

  template <class T>
  void shuffle(std::span<T> items) {  // Fisher-Yates
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(integer(0, static_cast<int>(i) - 1))]);
    }
  }

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

class Seed {
 public:
  explicit Seed(std::uint64_t value) : value_(value) {}

  std::uint64_t value() const { return value_; }
  Seed child(std::string_view name) const;
  Seed child(std::string_view name, std::string_view id) const { return child(name).child(id); }
  Seed child(std::string_view name, std::uint64_t index) const;
  Stream stream() const { return Stream(value_); }

 private:
  std::uint64_t value_;
};

}  // namespace marketgen
