#include "planners/budget.h"

#include <fmt/format.h>

#include <mutex>

#include "base/progress.h"

namespace marketgen::planners {
namespace {

constexpr double tokens_per_million = 1e6;

double usd_of(const std::array<double, 2>& prices, const Spent& spent) {
  return (static_cast<double>(spent.tokens_in) * prices[0] +
          static_cast<double>(spent.tokens_out) * prices[1]) /
         tokens_per_million;
}

Error over(std::string_view limit, std::string_view flag) {
  return {"planners.over_budget",
          "--planner",
          fmt::format("the language model has used its limit of {}; {} raises it", limit, flag)};
}

}  // namespace

struct Budget::Meter {
  Limits limits;
  mutable std::mutex guard;
  Spent spent;
  double begun = -1;  // monotonic seconds of the first question

  Result<void> admit() {
    const std::scoped_lock lock(guard);
    if (begun < 0) begun = monotonic_seconds();
    if (spent.tokens_in + spent.tokens_out >= limits.max_tokens)
      return over(fmt::format("{} tokens", limits.max_tokens), "--max-tokens");
    if (monotonic_seconds() - begun >= limits.max_seconds)
      return over(fmt::format("{:g} s", limits.max_seconds), "--max-seconds");
    if (limits.max_usd && limits.usd_per_million &&
        usd_of(*limits.usd_per_million, spent) >= *limits.max_usd)
      return over(fmt::format("{:g} US dollars", *limits.max_usd), "--max-usd");
    ++spent.requests;
    return {};
  }

  void charge(const llm::ChatAnswer& answer) {
    const std::scoped_lock lock(guard);
    spent.tokens_in += answer.tokens_in;
    spent.tokens_out += answer.tokens_out;
  }
};

Budget::Budget(llm::LanguageModel model, const Limits& limits) : meter_(std::make_shared<Meter>()) {
  meter_->limits = limits;
  metered_.name = model.name;
  metered_.chat = [meter = meter_, chat = std::move(model.chat)](
                      const llm::ChatRequest& request) -> Result<llm::ChatAnswer> {
    MARKETGEN_CHECK(meter->admit());
    MARKETGEN_TRY(llm::ChatAnswer answer, chat(request));
    meter->charge(answer);
    return answer;
  };
}

Spent Budget::spent() const {
  const std::scoped_lock lock(meter_->guard);
  Spent spent = meter_->spent;
  if (meter_->begun >= 0) spent.seconds = monotonic_seconds() - meter_->begun;
  if (const auto& prices = meter_->limits.usd_per_million) spent.usd = usd_of(*prices, spent);
  return spent;
}

}  // namespace marketgen::planners
