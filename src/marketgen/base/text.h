// Small text tools shared by error messages and readers.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace marketgen {

// Levenshtein distance with adjacent transposition counted as one edit (optimal string alignment),
// over bytes.
int edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to `word`, if it is near enough to be what was meant: at most a third of
// the length away.
std::optional<std::string> nearest_name(std::string_view word,
                                        std::span<const std::string_view> candidates);

// `; did you mean "levels"?` or an empty string.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

bool is_utf8(std::string_view bytes);
std::string with_thousands(std::int64_t number);  // 1204112 -> "1,204,112"
std::vector<std::string> split(std::string_view text, char separator);
std::string lower_ascii(std::string_view text);
// Without blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);
// With & < > " as entities: what may stand in XML and HTML text and attributes.
std::string escaped_markup(std::string_view text);

}  // namespace marketgen
