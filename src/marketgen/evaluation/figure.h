// A measured or published number, as tables have it.
#pragma once
#include <optional>
#include <string>

#include "base/fields.h"
#include "evaluation/store_bootstrap.h"

namespace marketgen::evaluation {

// A figure; without an interval where none was published.
struct Figure {
  double value = 0;
  std::optional<double> low = {}, high = {};
  static constexpr auto fields = field_list(field("value", &Figure::value, "as measured"),
                                            field("low", &Figure::low, "95 % interval"),
                                            field("high", &Figure::high, "95 % interval"));
};

Figure figure_of(const Estimate& estimate);
// A share as a percentage, with its interval where it has one; nothing for none.
std::string percent(const std::optional<Figure>& figure);

}  // namespace marketgen::evaluation
