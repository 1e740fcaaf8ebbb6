#include "store/report_plots.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

#include "base/text.h"

namespace marketgen::store {
namespace {

// ---- Horizontal bars; SVG user units are CSS pixels. ----
constexpr int row_px = 24, label_width_px = 170, bar_width_px = 320, value_width_px = 110;

// ---- Histogram. ----
constexpr std::size_t steps = 12;
constexpr double kept_share = 0.97;  // of the values lie within the steps; a few dear ones do not
constexpr int plot_width_px = 520, plot_height_px = 150, axis_px = 40, head_px = 16;

// The least of 1, 2 and 5 times a power of ten that is at least this.
double round_width(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>",
                     x,
                     y,
                     anchor,
                     escaped_markup(text));
}

}  // namespace

std::string bar_plot(const std::vector<PlotBar>& bars) {
  if (bars.empty()) return {};
  const int width = label_width_px + bar_width_px + value_width_px;
  const auto height = static_cast<int>(bars.size()) * row_px;
  std::string svg = fmt::format(
      "<svg role=\"img\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">", width, height);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double top = static_cast<double>(i) * row_px, base = top + row_px * 0.68;
    const double length = bar_width_px * std::clamp(bars[i].share, 0.0, 1.0);
    svg += text_at(label_width_px - 8, base, "end", bars[i].label);
    svg += fmt::format("<rect class=\"back\" x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"/>",
                       label_width_px,
                       top + 5,
                       bar_width_px,
                       row_px - 10);
    svg += fmt::format("<rect class=\"bar\" x=\"{}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>",
                       label_width_px,
                       top + 5,
                       length,
                       row_px - 10);
    svg += text_at(label_width_px + bar_width_px + 8, base, "start", bars[i].value);
  }
  return svg + "</svg>";
}

std::string histogram(std::vector<double> values, std::string_view quantity) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto last = static_cast<std::size_t>(kept_share * static_cast<double>(values.size() - 1));
  const double step = round_width(std::max(values[last], 1e-6) / steps);
  std::vector<std::size_t> counts(steps, 0);
  for (const double value : values)
    ++counts[std::min(static_cast<std::size_t>(value / step), steps - 1)];
  const auto most = static_cast<double>(std::ranges::max(counts));
  const double slot = static_cast<double>(plot_width_px) / steps;
  std::string svg =
      fmt::format("<svg role=\"img\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">",
                  plot_width_px,
                  head_px + plot_height_px + axis_px);
  for (std::size_t i = 0; i < steps; ++i) {
    const double height = plot_height_px * static_cast<double>(counts[i]) / most;
    const double left = static_cast<double>(i) * slot, top = head_px + plot_height_px - height;
    svg += fmt::format(
        "<rect class=\"bar\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
        left + 2,
        top,
        slot - 4,
        height);
    svg += text_at(
        left + slot / 2, top - 4, "middle", counts[i] == 0 ? "" : fmt::format("{}", counts[i]));
    const std::string from = fmt::format("{:.4g}", static_cast<double>(i) * step);
    svg += text_at(
        left + 2, head_px + plot_height_px + 15, "start", i + 1 == steps ? "≥ " + from : from);
  }
  svg += text_at(plot_width_px / 2.0, head_px + plot_height_px + 34, "middle", quantity);
  return svg + "</svg>";
}

}  // namespace marketgen::store
