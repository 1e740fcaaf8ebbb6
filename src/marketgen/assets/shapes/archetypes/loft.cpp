#include "assets/shapes/archetypes/loft.h"

#include <algorithm>
#include <cmath>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

bool is_pole(const Section& section) {
  return section.half_width <= 0 || section.half_depth <= 0;
}

// The most chords of a quarter turn with which the loft keeps to its triangles.
int fitting_segments(const std::vector<Section>& sections, const LoftStyle& style) {
  int per_step = 0;  // triangles that one more step around adds
  bool oval = false;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const bool end = i == 0 || i + 1 == sections.size();
    if (end && !is_pole(sections[i])) ++per_step;  // its cap
    if (i > 0) per_step += is_pole(sections[i - 1]) || is_pole(sections[i]) ? 1 : 2;
    oval = oval || sections[i].roundness < 1;
  }
  const int steps_around =
      style.triangles / std::max(per_step, 1) - (oval ? 8 : 0);  // 8: the straight sides' halves
  return std::clamp(steps_around / 4, 3, style.max_chords);
}

// Chords of a quarter turn that a label covers; one of them ends at the label's edge.
int label_segments(float label_arc, int quarter_segments) {
  if (label_arc >= 1) return quarter_segments;
  if (label_arc <= 0) return 0;
  const auto whole =
      static_cast<int>(std::lround(label_arc * static_cast<float>(quarter_segments)));
  return std::clamp(whole, 1, quarter_segments - 1);
}

class Loft {
 public:
  Loft(PackBuilder& pack,
       const std::vector<Section>& sections,
       const LoftStyle& style,
       const Placement& place)
      : pack_(pack),
        sections_(sections),
        style_(style),
        place_(place),
        quarter_segments_(fitting_segments(sections, style)),
        label_segments_(label_segments(style.label_arc, quarter_segments_)) {
    for (const Section& section : sections)
      rings_.push_back(ring_of(section));
    measure_around();
  }

  void add_bands() {
    for (std::size_t start = 0; start + 1 < sections_.size();) {
      std::size_t end = start + 1;
      while (end + 1 < sections_.size() && sections_[end].surface == sections_[start].surface)
        ++end;
      add_run(start, end);
      start = end;
    }
  }

  void add_caps() {
    add_cap(0);
    add_cap(sections_.size() - 1);
  }

 private:
  // Of each quarter: the middle of a side, then the corner's arc with both its ends.
  std::size_t points_per_quarter() const { return static_cast<std::size_t>(quarter_segments_) + 2; }
  std::size_t point_count() const { return 4 * points_per_quarter(); }

  // Share of the quarter turn from the front or back towards a side after `chords` chords.
  double arc_from_face(int chords) const {
    const double edge = std::clamp(static_cast<double>(style_.label_arc), 0.0, 1.0);
    if (chords <= label_segments_) return edge * chords / std::max(1, label_segments_);
    return edge + (1 - edge) * (chords - label_segments_) / (quarter_segments_ - label_segments_);
  }

  // In turns from the +X axis, starting at the back.
  double turn_of(std::size_t k) const {
    const std::size_t quarter = k / points_per_quarter(), j = k % points_per_quarter();
    const int chords = j == 0 ? 0 : static_cast<int>(j) - 1;
    const double arc =
        quarter % 2 == 0 ? arc_from_face(chords) : 1 - arc_from_face(quarter_segments_ - chords);
    return 0.25 * static_cast<double>(quarter + 1) + 0.25 * (j == 0 ? 0.0 : arc);
  }

  // Where a label's edges lie: the last point of it in a quarter that leaves the front or back, the
  // first in one that reaches it.
  std::size_t label_end(std::size_t quarter) const {
    if (style_.label_arc >= 1) return (quarter + 1) * points_per_quarter();
    return quarter * points_per_quarter() + 1 + static_cast<std::size_t>(label_segments_);
  }
  std::size_t label_start(std::size_t quarter) const {
    if (style_.label_arc >= 1) return quarter * points_per_quarter();
    return (quarter + 1) * points_per_quarter() - 1 - static_cast<std::size_t>(label_segments_);
  }
  static bool is_back(std::size_t quarter) { return quarter == 0 || quarter == 3; }
  bool is_beside_label(std::size_t k) const {
    const std::size_t quarter = k / points_per_quarter();
    if (is_back(quarter) && pack_.panel(PanelKind::top) != nullptr &&
        pack_.panel(PanelKind::front) != nullptr) {
      return true;  // a sleeve has no back
    }
    return quarter % 2 == 0 ? k >= label_end(quarter) : k < label_start(quarter);
  }

  // Point k of the section's outline, from its middle.
  Vec2f outline_at(const Section& s, std::size_t k) const {
    const Vec2 direction = unit_circle(turn_of(k));
    const auto cx = static_cast<float>(direction.x), cy = static_cast<float>(direction.y);
    const float wave = 1.0F + s.lobe * wave_at(k);
    const float width = s.half_width * wave, depth = s.half_depth * wave;
    if (k % points_per_quarter() == 0) return {width * cx, depth * cy};
    const std::size_t quarter = k / points_per_quarter();
    const float side_x = quarter < 2 ? -1.0F : 1.0F;
    const float side_y = quarter == 0 || quarter == 3 ? 1.0F : -1.0F;
    const float flat = 1.0F - s.roundness;
    return {width * (flat * side_x + s.roundness * cx), depth * (flat * side_y + s.roundness * cy)};
  }

  float wave_at(std::size_t k) const {
    if (style_.lobes == 0) return 0;
    return static_cast<float>(unit_circle(style_.lobes * (turn_of(k) + style_.lobe_turn)).x);
  }

  std::vector<Vec3f> ring_of(const Section& section) const {
    std::vector<Vec3f> ring;
    for (std::size_t k = 0; k < point_count(); ++k) {
      const Vec2f p = outline_at(section, k);
      ring.push_back(place_({section.x + p.x, section.y + p.y, section.z}));
    }
    ring.push_back(ring.front());
    return ring;
  }

  // Shares of the way around, measured on the widest printed section (or the widest of all).
  void measure_around() {
    std::size_t widest = 0;
    float best = -1;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      const float size = sections_[i].half_width + sections_[i].half_depth +
                         (pack_.is_print(sections_[i].surface) ? 1.0F : 0.0F);
      if (size > best) {
        best = size;
        widest = i;
      }
    }
    Section plain = sections_[widest];
    plain.lobe = 0;
    const std::vector<Vec3f> ring = ring_of(plain);
    around_.assign(1, 0.0F);
    for (std::size_t k = 1; k < ring.size(); ++k) {
      around_.push_back(around_.back() + length(ring[k] - ring[k - 1]));
    }
    const float total = around_.back();
    for (float& share : around_)
      share /= total;
    for (std::size_t quarter = 0; quarter <= 4; ++quarter) {  // exact in spite of rounding
      around_[quarter * points_per_quarter()] = 0.25F * static_cast<float>(quarter);
    }
  }

  static float span(const Section& a, const Section& b) {
    const Vec3f d{b.half_width - a.half_width, b.half_depth - a.half_depth, b.z - a.z};
    return length(d);
  }

  // The bands between two sections that have one surface; v runs from 0 at the upper to 1 at the
  // lower.
  void add_run(std::size_t start, std::size_t end) {
    std::vector<float> below(end - start + 1, 0.0F);
    for (std::size_t i = start; i < end; ++i) {
      below[i - start + 1] = below[i - start] + span(sections_[i], sections_[i + 1]);
    }
    const float total = below.back() > 0 ? below.back() : 1.0F;
    for (std::size_t i = start; i < end; ++i) {
      const float v_low = 1.0F - below[i - start] / total;
      const float v_high = i + 1 == end ? 0.0F : 1.0F - below[i - start + 1] / total;
      add_band(i, v_low, v_high);
    }
  }

  void add_band(std::size_t i, float v_low, float v_high) {
    for (std::size_t k = 0; k + 1 < around_.size(); ++k) {
      const std::size_t quarter = k / points_per_quarter();
      const bool beside = pack_.is_print(sections_[i].surface) && is_beside_label(k);
      const std::uint16_t surface = beside ? style_.beside : sections_[i].surface;
      const auto corner = [&](std::size_t ring, std::size_t at, float v) {
        return Corner{rings_[ring][at], uv_at(surface, around_[at], v, quarter)};
      };
      pack_.add_quad(corner(i, k, v_low),
                     corner(i, k + 1, v_low),
                     corner(i + 1, k + 1, v_high),
                     corner(i + 1, k, v_high),
                     surface);
    }
  }

  Vec2f uv_at(std::uint16_t surface, float around, float v, std::size_t quarter) const {
    if (!pack_.is_print(surface)) return {around, v};
    if (const Panel* band = pack_.panel(PanelKind::band)) return uv_in(band, around, v);
    if (const Panel* skin = pack_.panel(PanelKind::skin)) return uv_in(skin, around, v);
    const bool front = !is_back(quarter);
    const float across = front ? share_of_front(around) : share_of_back(around, quarter);
    const Panel* panel = pack_.panel(front ? PanelKind::front : PanelKind::back);
    if (!style_.lying) return uv_in(panel, across, v);
    return uv_in(panel, front ? 1 - v : v, front ? across : 1 - across);
  }

  // 0 at the label's left edge, as seen before it, 1 at its right edge.
  float share_of_front(float around) const {
    const float left = around_[label_start(1)], right = around_[label_end(2)];
    return (around - left) / (right - left);
  }
  float share_of_back(float around, std::size_t quarter) const {
    const float left = around_[label_start(3)] - 1, right = around_[label_end(0)];
    return ((quarter == 3 ? around - 1 : around) - left) / (right - left);
  }

  void add_cap(std::size_t i) {
    const Section& s = sections_[i];
    if (is_pole(s)) return;
    const bool top = i > 0;
    const Panel* panel = top && pack_.is_print(s.surface) ? pack_.panel(PanelKind::top) : nullptr;
    const Corner middle{place_({s.x, s.y, s.z}), uv_in(panel, 0.5F, 0.5F)};
    const Section unit{.half_width = 0.5F, .half_depth = 0.5F, .roundness = s.roundness};
    for (std::size_t k = 0; k + 1 < around_.size(); ++k) {
      const auto corner = [&](std::size_t at) {
        const Vec2f p = outline_at(unit, at % point_count());
        return Corner{rings_[i][at], uv_in(panel, 0.5F + p.x, 0.5F - p.y)};
      };
      if (top)
        pack_.add_triangle(middle, corner(k), corner(k + 1), s.surface);
      else
        pack_.add_triangle(middle, corner(k + 1), corner(k), s.surface);
    }
  }

  PackBuilder& pack_;
  const std::vector<Section>& sections_;
  const LoftStyle& style_;
  const Placement& place_;
  int quarter_segments_, label_segments_;
  std::vector<std::vector<Vec3f>> rings_;  // point_count() + 1 points each, the last is the first
  std::vector<float> around_;              // share of the way around at each of them
};

}  // namespace

float label_width(const Section& section, float label_arc) {
  constexpr int chords = 32;
  const float round_width = section.roundness * section.half_width;
  const float round_depth = section.roundness * section.half_depth;
  float arc = 0;
  for (int i = 0; i < chords; ++i) {
    const auto turn = [&](int at) {
      return unit_circle(0.25 * static_cast<double>(label_arc) * at / chords);
    };
    const Vec2 a = turn(i), b = turn(i + 1);
    arc += length(Vec3f{round_width * static_cast<float>(b.y - a.y),
                        round_depth * static_cast<float>(b.x - a.x),
                        0});
  }
  const float flat_side = label_arc < 1 ? 0 : section.half_depth * (1 - section.roundness);
  return 2 * (section.half_width * (1 - section.roundness) + arc + flat_side);
}

void add_loft(PackBuilder& pack,
              const std::vector<Section>& sections,
              const LoftStyle& style,
              const Placement& place) {
  Loft loft(pack, sections, style, place);
  loft.add_bands();
  loft.add_caps();
}

}  // namespace marketgen::assets
