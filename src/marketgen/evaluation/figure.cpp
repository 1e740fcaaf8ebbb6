#include "evaluation/figure.h"

#include <fmt/format.h>

#include "evaluation/leaderboard_page.h"

namespace marketgen::evaluation {

Figure figure_of(const Estimate& estimate) {
  return {estimate.value, estimate.low, estimate.high};
}

std::string percent(const std::optional<Figure>& figure) {
  if (!figure) return "";
  if (!figure->low || !figure->high) return fmt::format("{:.2f}", 100 * figure->value);
  return percent_with_interval(figure->value, *figure->low, *figure->high);
}

}  // namespace marketgen::evaluation
