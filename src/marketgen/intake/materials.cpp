#include "intake/materials.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "base/text.h"
#include "base/words.h"
#include "intake/tokens.h"

namespace marketgen::intake {
namespace {

std::array<int, 3> channels_of(std::string_view hex) {
  std::array<int, 3> channels{};
  for (std::size_t i = 0; i < 3 && hex.size() == 7; ++i) {
    const char* at = hex.data() + 1 + 2 * i;
    std::from_chars(at, at + 2, channels[i], 16);
  }
  return channels;
}

std::set<std::string> words_of(const catalog::MaterialRow& row) {
  std::set<std::string> words;
  for (const Token& token : tokenize(row.id + " " + row.name + " "))
    words.insert(token.stem);
  words.insert(singular(name_of(row.pattern)));
  return words;
}

bool has_any(const std::set<std::string>& words, std::string_view names) {
  return std::ranges::any_of(split(names, ' '),
                             [&](const std::string& name) { return words.contains(name); });
}

// How well the row fits; negative when it does not. The first name of a material is the one that
// was said.
int fit_of(const catalog::MaterialRow& row,
           const SurfaceWords& surface,
           std::string_view color_hex) {
  const std::set<std::string> words = words_of(row);
  int fit = 0;
  for (const std::string& names : surface.materials) {
    if (!has_any(words, names)) return -1;
    fit += words.contains(split(names, ' ').front()) ? 300 : 200;
  }
  for (const std::string& color : surface.colors)
    fit += words.contains(color) ? 100 : 0;
  if (!color_hex.empty()) {
    const int apart = static_cast<int>(color_distance(row.color, color_hex));
    const bool named = has_any(words, surface.colors.front());
    if (surface.materials.empty() && !named && apart > same_color) return -1;
    fit += 99 - std::min(99, apart / 3);
  }
  return fit;
}

}  // namespace

double color_distance(std::string_view a, std::string_view b) {
  const std::array<int, 3> first = channels_of(a);
  const std::array<int, 3> second = channels_of(b);
  int sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += (first[i] - second[i]) * (first[i] - second[i]);
  return std::sqrt(static_cast<double>(sum));
}

const catalog::MaterialRow* material_for(const catalog::Catalog& catalog,
                                         std::string_view part,
                                         const SurfaceWords& words,
                                         std::string_view color_hex) {
  const catalog::MaterialRow* best = nullptr;
  int best_fit = 0;
  for (const catalog::MaterialRow& row : catalog.materials) {
    if (std::ranges::find(row.uses, part) == row.uses.end()) continue;
    const int fit = fit_of(row, words, color_hex);
    if (fit < 0 || (best != nullptr && fit <= best_fit)) continue;
    best = &row;
    best_fit = fit;
  }
  return best;
}

}  // namespace marketgen::intake
