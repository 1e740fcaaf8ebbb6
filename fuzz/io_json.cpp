// JSON of a described struct: what is read is written canonically, and reads back to the same text.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "io/json.h"

namespace {

using namespace marketgen;

enum class Colour { red, green };
constexpr std::array<std::string_view, 2> names_of(Colour) {
  return {"red", "green"};
}

// One member of every kind that a field list can hold.
struct Everything {
  std::string id = "a";
  bool flag = false;
  std::int8_t tiny = 0;
  std::uint64_t big = 0;
  std::int64_t wide = 0;
  float single = 0;
  double number = 0;
  Colour colour = Colour::red;
  std::optional<int> maybe;
  std::array<double, 3> point{};
  std::vector<std::string> words;
  std::vector<Everything> children;

  static constexpr auto fields =
      field_list(field("id", &Everything::id, "id", identifier()),
                 field("flag", &Everything::flag, "flag"),
                 field("tiny", &Everything::tiny, "8 bits"),
                 field("big", &Everything::big, "64 bits"),
                 field("wide", &Everything::wide, "64 bits, signed"),
                 field("single", &Everything::single, "float", range(-1e30, 1e30)),
                 field("number", &Everything::number, "double", range(-1e300, 1e300)),
                 field("colour", &Everything::colour, "name"),
                 field("maybe", &Everything::maybe, "optional", at_least(1)),
                 field("point", &Everything::point, "three numbers"),
                 field("words", &Everything::words, "texts", at_most_items(8)),
                 field("children", &Everything::children, "more of these"));
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto value = io::read_json<Everything>({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!value.ok()) return 0;
  const std::string text = io::write_json(*value), line = io::write_json_line(*value);
  const auto again = io::read_json<Everything>(text, "fuzz"),
             from_line = io::read_json<Everything>(line, "fuzz");
  if (!again.ok() || !from_line.ok() || io::write_json(*again) != text ||
      io::write_json(*from_line) != text)
    std::abort();
  return 0;
}
