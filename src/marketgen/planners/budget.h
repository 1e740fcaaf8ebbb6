// What planning with a language model may cost, and what it has cost.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "base/result.h"
#include "llm/language_model.h"

namespace marketgen::planners {

struct Limits {
  std::int64_t max_tokens = 200'000;  // read and written together
  double max_seconds = 300;           // from the first question
  std::optional<double> max_usd;      // US dollars; needs prices
  // Of a million tokens read, and written; no provider tells them.
  std::optional<std::array<double, 2>> usd_per_million;
};

struct Spent {
  int requests = 0;
  std::int64_t tokens_in = 0, tokens_out = 0;
  double seconds = 0;         // since the first question
  std::optional<double> usd;  // where prices were given
};

// The model, refusing whatever would go beyond the limits: error planners.over_budget, which says
// which limit and how to raise it. An answer that has come is never thrown away. Safe to call from
// several threads.
class Budget {
 public:
  Budget(llm::LanguageModel model, const Limits& limits);
  const llm::LanguageModel& model() const { return metered_; }
  Spent spent() const;

 private:
  struct Meter;
  std::shared_ptr<Meter> meter_;
  llm::LanguageModel metered_;
};

}  // namespace marketgen::planners
