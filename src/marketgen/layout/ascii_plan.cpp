#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ranges>
#include <string>
#include <vector>

#include "layout/visual_prompt.h"

namespace marketgen::layout {
namespace {

constexpr int min_cell_mm = 500, max_cells = 100;

class AsciiPlan {
 public:
  explicit AsciiPlan(const Layout& layout)
      : layout_(layout),
        floor_(plan::floor_of(layout.shell)),
        cell_mm_(std::max(
            min_cell_mm,
            (std::max(layout.shell.width_mm, layout.shell.depth_mm) + max_cells - 1) / max_cells)),
        columns_((layout.shell.width_mm + cell_mm_ - 1) / cell_mm_),
        rows_((layout.shell.depth_mm + cell_mm_ - 1) / cell_mm_),
        lines_(static_cast<std::size_t>(rows_) + 2,
               std::string(static_cast<std::size_t>(columns_) + 2, '#')) {}

  std::string run() {
    fill_floor();
    for (const plan::Opening& opening : layout_.shell.openings)
      put_opening(opening);
    std::string text = fmt::format("one character: {:.2f} m; north is up\n", cell_mm_ * 1e-3);
    for (const std::string& line : std::ranges::reverse_view(lines_))  // south is the first
      text += line + "\n";
    return text;
  }

 private:
  char& at(int column, int row) {  // -1 and columns_, rows_: the walls
    return lines_[static_cast<std::size_t>(row + 1)][static_cast<std::size_t>(column + 1)];
  }

  PointMm middle(int column, int row) const {
    return {std::min(column * cell_mm_ + cell_mm_ / 2, layout_.shell.width_mm - 1),
            std::min(row * cell_mm_ + cell_mm_ / 2, layout_.shell.depth_mm - 1)};
  }

  char mark_of(std::string_view zone) const {
    const auto found = std::ranges::find(layout_.zones, zone, &LayoutZone::id);
    return found == layout_.zones.end()
               ? '?'
               : mark_of_zone(static_cast<std::size_t>(found - layout_.zones.begin()));
  }

  char floor_at(PointMm point) const {
    if (!contains(floor_, point)) return ' ';
    for (const plan::Column& column : layout_.shell.columns) {
      if (plan::footprint_of(column).contains(point)) return 'o';
    }
    for (std::size_t i = 0; i < layout_.zones.size(); ++i) {
      if (contains(layout_.zones[i].polygon_mm, point))
        return static_cast<char>(std::tolower(static_cast<unsigned char>(mark_of_zone(i))));
    }
    return '.';
  }

  void fill_floor() {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column)
        at(column, row) = floor_at(middle(column, row));
    }
    for (const Fixture& fixture : layout_.fixtures)
      put_fixture(fixture);
  }

  void put_fixture(const Fixture& fixture) {
    const RectMm rect = footprint_of(fixture);
    const int first_column = std::clamp(rect.x0 / cell_mm_, 0, columns_ - 1);
    const int last_column = std::clamp((rect.x1 - 1) / cell_mm_, 0, columns_ - 1);
    const int first_row = std::clamp(rect.y0 / cell_mm_, 0, rows_ - 1);
    const int last_row = std::clamp((rect.y1 - 1) / cell_mm_, 0, rows_ - 1);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        if (rect.contains(middle(column, row))) at(column, row) = mark_of(fixture.zone);
      }
    }
  }

  static char sign_of(plan::OpeningKind kind) {
    switch (kind) {
      case plan::OpeningKind::entrance:
        return '=';
      case plan::OpeningKind::exit:
        return '-';
      case plan::OpeningKind::window:
        return '~';
      case plan::OpeningKind::service:
      case plan::OpeningKind::emergency:
        return '+';
    }
    return '+';
  }

  void put_opening(const plan::Opening& opening) {
    const bool level = opening.wall == plan::Wall::north || opening.wall == plan::Wall::south;
    const int cells = level ? columns_ : rows_;
    const double length = level ? layout_.shell.width_mm : layout_.shell.depth_mm;
    const double first = opening.center * length - opening.width_mm / 2.0;
    for (int i = 0; i < cells; ++i) {
      const double at_mm = (i + 0.5) * cell_mm_;
      if (at_mm < first || at_mm > first + opening.width_mm) continue;
      const int row = opening.wall == plan::Wall::south ? -1 : rows_;
      const int column = opening.wall == plan::Wall::west ? -1 : columns_;
      (level ? at(i, row) : at(column, i)) = sign_of(opening.kind);
    }
  }

  const Layout& layout_;
  PolygonMm floor_;
  int cell_mm_, columns_, rows_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string ascii_plan(const Layout& layout) {
  return AsciiPlan(layout).run();
}

}  // namespace marketgen::layout
