#include "layout/site.h"

#include <algorithm>
#include <numeric>

namespace marketgen::layout {
namespace {

bool overlaps_any(const RectMm& rect, const std::vector<RectMm>& others) {
  return std::ranges::any_of(others, [&](const RectMm& o) { return marketgen::overlap(o, rect); });
}

void collect_spans(std::vector<Span>& spans,
                   const RectMm& area,
                   Side side,
                   const std::vector<RectMm>& others) {
  for (const RectMm& other : others) {
    if (marketgen::overlap(other, area)) spans.push_back(along(other, side));
  }
}

// "run-2", "run-2b", "run-2c"…
std::string segment_id(const std::string& run, std::size_t segment) {
  return segment == 0 ? run : run + static_cast<char>('a' + std::min<std::size_t>(segment, 25));
}

int start_of(Span span, int used, Packing align) {
  switch (align) {
    case Packing::low:
      return span.from;
    case Packing::middle:
      return span.from + (span.length() - used) / 2;
    case Packing::high:
      return span.to - used;
  }
  return span.from;
}

}  // namespace

Site::Site(const Design& design) : design_(design), fixed_(design.floor.outside) {
  for (const RectMm& column : design.floor.columns) {
    fixed_.push_back(column.grown(column_clearance_mm));
  }
  for (const Doorway& door : design.floor.doorways) {
    if (!door.approach.empty()) kept_clear_.push_back(door.approach);
  }
}

bool Site::is_clear(const RectMm& rect) const {
  return design_.floor.bounds.contains(rect) && !overlaps_any(rect, standing_) &&
         !overlaps_any(rect, design_.floor.outside) && !overlaps_any(rect, design_.floor.columns);
}

bool Site::can_stand(const RectMm& footprint) const {
  return design_.floor.bounds.contains(footprint) && !overlaps_any(footprint, fixed_) &&
         !overlaps_any(footprint, standing_) && !overlaps_any(footprint, kept_clear_);
}

std::vector<Span> Site::free_spans(const Row& row) const {
  const Side front = row.front;
  const Span whole = intersection(along(row.band, front), along(design_.floor.bounds, front));
  const Span deep = across(row.band, front);
  const Span room = across(design_.floor.bounds, front);
  if (deep.from < room.from || deep.to > room.to) return {};
  std::vector<Span> taken;
  for (const std::vector<RectMm>* others : {&fixed_, &standing_, &kept_clear_}) {
    collect_spans(taken, row.band, front, *others);
  }
  std::vector<Side> fronts{front};
  if (row.spec->sides == 2) fronts.push_back(opposite(front));
  for (const Side side : fronts) {
    const RectMm clear = strip_beyond(row.band, side, row.clear_mm);
    if (!design_.floor.bounds.contains(cut_along(clear, side, whole))) return {};
    for (const std::vector<RectMm>* others :
         {&standing_, &design_.floor.outside, &design_.floor.columns}) {
      collect_spans(taken, clear, side, *others);
    }
  }
  return without(whole, taken, row.spec->narrowest_mm());
}

Span Site::add_modules(const Row& row,
                       const std::string& run,
                       const std::vector<int>& widths,
                       int start) {
  // Widths run from the low end, so that rows back to back share their joints. Module 1 stands at
  // the left of someone who looks at the front.
  const bool left_is_high = left_of(row.front) == Side::east || left_of(row.front) == Side::north;
  int at = start;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::size_t number = left_is_high ? widths.size() - i : i + 1;
    const PointMm center = cut_along(row.band, row.front, {at, at + widths[i]}).center();
    at += widths[i];
    Fixture module = make_module(*row.spec, *row.zone);
    module.id = run + "/module-" + std::to_string(number);
    module.run = run;
    module.x_mm = center[0];
    module.y_mm = center[1];
    module.yaw_deg = yaw_facing(row.front);
    module.width_mm = widths[i];
    fixtures_.push_back(std::move(module));
  }
  return {start, at};
}

std::vector<PlacedRun> Site::place(const Row& row, Packing align) {
  std::vector<PlacedRun> placed;
  int room = row.max_modules;
  for (const Span& span : free_spans(row)) {
    std::vector<int> widths = fill_widths(*row.spec, span.length());
    if (room < static_cast<int>(widths.size())) widths.resize(static_cast<std::size_t>(room));
    if (widths.empty()) continue;
    room -= static_cast<int>(widths.size());
    const int used = std::accumulate(widths.begin(), widths.end(), 0);
    const std::string run = segment_id(row.run, placed.size());
    const Span stood = add_modules(row, run, widths, start_of(span, used, align));
    const RectMm rect = cut_along(row.band, row.front, stood);
    standing_.push_back(rect);
    kept_clear_.push_back(strip_beyond(rect, row.front, row.clear_mm));
    if (row.spec->sides == 2) {
      kept_clear_.push_back(strip_beyond(rect, opposite(row.front), row.clear_mm));
    }
    placed.push_back({run, rect, static_cast<int>(widths.size())});
  }
  return placed;
}

void Site::add(Fixture fixture, int clear_mm) {
  const RectMm rect = footprint_of(fixture);
  standing_.push_back(rect);
  if (clear_mm > 0) {
    kept_clear_.push_back(strip_beyond(rect, facing_of(fixture.yaw_deg), clear_mm));
  }
  fixtures_.push_back(std::move(fixture));
}

void Site::keep(Fixture fixture, int clear_mm) {
  if (fixture.sides == 2 && clear_mm > 0)
    keep_clear(strip_beyond(footprint_of(fixture), opposite(facing_of(fixture.yaw_deg)), clear_mm));
  add(std::move(fixture), clear_mm);
}

int Site::free_beyond(const RectMm& rect, Side side, int reach_mm) const {
  const RectMm ahead = strip_beyond(rect, side, reach_mm);
  int nearest = distance_beyond(rect, side, strip_beyond(design_.floor.bounds, side, 1));
  nearest = std::min(nearest, reach_mm);
  for (const std::vector<RectMm>* others :
       {&standing_, &design_.floor.outside, &design_.floor.columns}) {
    for (const RectMm& other : *others) {
      if (marketgen::overlap(ahead, other))
        nearest = std::min(nearest, distance_beyond(rect, side, other));
    }
  }
  return std::max(0, nearest);
}

}  // namespace marketgen::layout
