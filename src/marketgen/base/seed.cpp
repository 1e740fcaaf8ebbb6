#include "base/seed.h"

#include "base/hash.h"

namespace marketgen {
namespace {

constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15ULL;

// SplitMix64's finaliser.
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

}  // namespace

std::uint64_t Stream::bits() {
  ++counter_;
  return mix(mix(key_) + counter_ * golden_ratio);
}

double Stream::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double Stream::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

int Stream::integer(int low, int high) {
  const auto span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1;
  return static_cast<int>(low + static_cast<std::int64_t>(((bits() >> 32) * span) >> 32));
}

bool Stream::chance(double probability) {
  return uniform() < probability;
}

double Stream::normal() {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
    sum += uniform();
  return sum;
}

std::size_t Stream::weighted(std::span<const double> weights) {
  double total = 0;
  for (const double w : weights)
    total += w;
  double left = uniform() * total;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (left < weights[i]) return i;
    left -= weights[i];
  }
  return 0;
}

Seed Seed::child(std::string_view name) const {
  return Seed(hash64(name, value_));
}

Seed Seed::child(std::string_view name, std::uint64_t index) const {
  return Seed(mix(child(name).value() + (index + 1) * golden_ratio));
}

}  // namespace marketgen
