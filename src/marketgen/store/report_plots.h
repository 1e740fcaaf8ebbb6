// Plots of a report page: inline SVG in the page's own colours, without script or file.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace marketgen::store {

struct PlotBar {
  std::string label;
  double share = 0;   // length of the bar, 0..1
  std::string value;  // as it is to be read
};

// One row a bar, from the top. Texts are escaped.
std::string bar_plot(const std::vector<PlotBar>& bars);

// How many of `values` (0 and more) lie in each of a dozen equal steps of a round width; what lies
// beyond the last step counts in it. `quantity` names the axis: "price, euro". Empty without
// values.
std::string histogram(std::vector<double> values, std::string_view quantity);

}  // namespace marketgen::store
