// JSON, schemas and FlatBuffers of described structs.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>

#include "io/flatbuffer.h"
#include "io/json.h"

namespace marketgen {
namespace {

enum class Colour { red, green_blue };
constexpr std::array<std::string_view, 2> names_of(Colour) {
  return {"red", "green-blue"};
}

struct Point {
  float x = 0, y = 0;
  Colour colour = Colour::red;
  static constexpr auto fields = field_list(field("x", &Point::x, "x"),
                                            field("y", &Point::y, "y"),
                                            field("colour", &Point::colour, "colour"));
};

struct Sample {
  std::string id = "a";
  int levels = 5;
  double fill = 0.95;
  bool open = false;
  std::uint64_t seed = 0;
  Colour colour = Colour::red;
  std::optional<int> width_mm;
  std::optional<std::string> note;
  IntRange facings{2, 4};
  std::vector<std::string> words;
  std::vector<Point> points;
  std::vector<std::array<int, 2>> polygon;
  std::vector<Sample> children;

  static constexpr auto fields =
      field_list(field("id", &Sample::id, "id", identifier()),
                 field("levels", &Sample::levels, "levels", range(1, 10)),
                 field("fill", &Sample::fill, "fill", range(0, 1)),
                 field("open", &Sample::open, "open"),
                 field("seed", &Sample::seed, "seed"),
                 field("colour", &Sample::colour, "colour"),
                 field("width_mm", &Sample::width_mm, "width", at_least(1)),
                 field("note", &Sample::note, "note"),
                 field("facings", &Sample::facings, "facings", within(1, 40)),
                 field("words", &Sample::words, "words", at_most_items(3)),
                 field("points", &Sample::points, "points"),
                 field("polygon", &Sample::polygon, "polygon"));
};

Sample full_sample() {
  Sample s;
  s.id = "dairy/run-1";
  s.levels = 7;
  s.fill = 0.1;
  s.open = true;
  s.seed = 18446744073709551615ULL;
  s.colour = Colour::green_blue;
  s.width_mm = 1250;
  s.note = "quote \" slash \\ line\n käse";
  s.facings = {1, 9};
  s.words = {"one", "", "three"};
  s.points = {{1.5F, -2.25F, Colour::green_blue}, {0.1F, 3e-7F, Colour::red}};
  s.polygon = {{0, 0}, {100, -5}};
  return s;
}

void expect_same(const Sample& a, const Sample& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.levels, b.levels);
  EXPECT_EQ(a.fill, b.fill);
  EXPECT_EQ(a.open, b.open);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.colour, b.colour);
  EXPECT_EQ(a.width_mm, b.width_mm);
  EXPECT_EQ(a.note, b.note);
  EXPECT_EQ(a.facings, b.facings);
  EXPECT_EQ(a.words, b.words);
  EXPECT_EQ(a.polygon, b.polygon);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].x, b.points[i].x);
    EXPECT_EQ(a.points[i].y, b.points[i].y);
    EXPECT_EQ(a.points[i].colour, b.points[i].colour);
  }
}

TEST(Json, WritesCanonicalText) {
  Sample s;
  s.words = {"x"};
  EXPECT_EQ(
      io::write_json_line(s),
      R"({"id": "a", "levels": 5, "fill": 0.95, "open": false, "seed": 0, "colour": "red", "facings": [2, 4], )"
      R"("words": ["x"], "points": [], "polygon": []})");
}

TEST(Json, ReadsBackWhatItWrote) {
  const Sample s = full_sample();
  const auto read = io::read_json<Sample>(io::write_json(s), "test");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  expect_same(s, *read);
}

TEST(Json, ZeroBelowZeroReadsBackAsItWas) {
  Sample s;
  s.fill = -0.0;
  s.points = {{.x = -0.0F, .y = 1}};
  const std::string text = io::write_json(s);
  const auto again = io::read_json<Sample>(text, "test");
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_TRUE(std::signbit(again->fill)) << text;
  EXPECT_TRUE(std::signbit(again->points[0].x)) << text;
  EXPECT_EQ(io::write_json(*again), text);
}

struct Fault {
  const char* text;
  const char* code;
  const char* where;
  const char* says;
};

TEST(Json, RefusesEveryFaultWithItsPlace) {
  const Fault faults[] = {
      {R"({"id": "a", "level": 3})", "json.unknown_field", "f:/level", "did you mean \"levels\""},
      {R"({"levels": 3})", "json.missing_field", "f:/", "\"id\" is missing"},
      {R"({"id": "a", "levels": "3"})", "json.wrong_type", "f:/levels", "whole number"},
      {R"({"id": "a", "levels": 3.5})", "json.wrong_type", "f:/levels", "whole number"},
      {R"({"id": "a", "levels": 11})", "json.out_of_range", "f:/levels", "outside 1 to 10"},
      {R"({"id": "a", "levels": 99999999999})", "json.out_of_range", "f:/levels", "32 bits"},
      {R"({"id": "a", "seed": -1})", "json.out_of_range", "f:/seed", "64 bits"},
      {R"({"id": "a", "colour": "green_blue"})",
       "json.unknown_name",
       "f:/colour",
       "did you mean \"green-blue\""},
      {R"({"id": "../x"})", "json.bad_identifier", "f:/id", "not an id"},
      {R"({"id": "a", "facings": [1]})", "json.wrong_type", "f:/facings", "a list of 2"},
      {R"({"id": "a", "facings": [0, 4]})", "json.out_of_range", "f:/facings/0", "outside 1 to 40"},
      {R"({"id": "a", "words": ["1","2","3","4"]})", "json.out_of_range", "f:/words", "at most 3"},
      {R"({"id": "a", "points": [{"x": 1}, {"z": 1}]})",
       "json.unknown_field",
       "f:/points/1/z",
       "known are: x, y, colour"},
      {R"({"id": "a", "id": "b"})", "json.duplicate_key", "f", "\"id\""},
      {"{\"id\": \"a\",\n \"levels\": }", "json.syntax", "f:2", ""},
      {"{\"id\": \"\xff\"}", "input.not_utf8", "f", "UTF-8"},
      {"", "json.syntax", "f:1", ""},
  };
  for (const Fault& fault : faults) {
    const auto read = io::read_json<Sample>(fault.text, "f");
    ASSERT_FALSE(read.ok()) << fault.text;
    EXPECT_EQ(read.error().code, fault.code) << fault.text;
    EXPECT_EQ(read.error().where, fault.where) << fault.text;
    EXPECT_NE(read.error().message.find(fault.says), std::string::npos) << read.error().message;
  }
}

TEST(Json, RefusesDeepNestingWithoutOverflow) {
  const auto read = io::read_json<Sample>(std::string(100'000, '['), "f");
  ASSERT_FALSE(read.ok());
  EXPECT_TRUE(read.error().code == "json.too_deep" || read.error().code == "json.syntax");
}

// Reading costs in proportion to the text: what looked through the list at the end of every object
// took minutes for this one.
TEST(Json, AListOfAMillionObjectsIsReadInTime) {
  std::string text = R"({"id": "a", "points": [{})";
  for (int i = 1; i < 1'200'000; ++i)
    text += ",{}";
  text += "]}";
  const auto start = std::chrono::steady_clock::now();
  const auto read = io::read_json<Sample>(text, "f");
  const auto took = std::chrono::steady_clock::now() - start;
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().message, "the list has 1200000 entries; at most 100000 are allowed");
  EXPECT_LT(took, std::chrono::seconds(10));
}

TEST(Json, WatchesKeysAndNestingAtAnyDepth) {
  const std::string lists(64, '['), ends(64, ']');
  EXPECT_EQ((io::read_json<Sample>(lists + "1" + ends, "f").error().code), "json.wrong_type");
  EXPECT_EQ((io::read_json<Sample>("[" + lists + "1" + ends + "]", "f").error().code),
            "json.too_deep");
  const auto same_in_two =
      io::read_json<Sample>(R"({"id": "a", "points": [{"x": 1}, {"x": 1}]})", "f");
  EXPECT_TRUE(same_in_two.ok());
  const auto twice = io::read_json<Sample>(R"({"id": "a", "points": [{}, {"x": 1, "x": 2}]})", "f");
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().code, "json.duplicate_key");
  EXPECT_EQ((io::read_json<Sample>(R"({"id": "a", "levels": 1e999})", "f").error().code),
            "json.syntax");
}

TEST(Json, NullIsAbsentOnlyForOptionals) {
  EXPECT_TRUE((io::read_json<Sample>(R"({"id": "a", "width_mm": null})", "f").ok()));
  EXPECT_FALSE((io::read_json<Sample>(R"({"id": "a", "levels": null})", "f").ok()));
}

TEST(FlatBuffer, ReadsBackWhatItWrote) {
  const Sample s = full_sample();
  const std::string bytes = io::write_flatbuffer_of(type_of<Sample>(), &s, "TST1");
  Sample back;
  const auto read = io::read_flatbuffer_into(
      std::as_bytes(std::span(bytes)), "f", "TST1", type_of<Sample>(), &back);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  expect_same(s, back);
  EXPECT_EQ(bytes, io::write_flatbuffer_of(type_of<Sample>(), &back, "TST1"));
}

std::string code_of(const std::string& bytes, std::string_view identifier = "TST1") {
  Sample back;
  const auto read = io::read_flatbuffer_into(
      std::as_bytes(std::span(bytes)), "f", identifier, type_of<Sample>(), &back);
  return read.ok() ? "ok" : read.error().code;
}

TEST(FlatBuffer, TellsTruncationFromDamageFromOtherVersions) {
  const Sample s = full_sample();
  const std::string bytes = io::write_flatbuffer_of(type_of<Sample>(), &s, "TST1");
  EXPECT_EQ(code_of(""), "scene.truncated");
  EXPECT_EQ(code_of(bytes.substr(0, bytes.size() / 2)), "scene.truncated");
  EXPECT_EQ(code_of(bytes + "x"), "scene.corrupt");
  EXPECT_EQ(code_of(bytes, "TST2"), "scene.wrong_version");
  EXPECT_EQ(code_of(bytes, "ABCD"), "scene.corrupt");
}

TEST(FlatBuffer, NoFlippedByteReadsOutsideTheFile) {  // meant for the sanitizer build
  const Sample s = full_sample();
  const std::string bytes = io::write_flatbuffer_of(type_of<Sample>(), &s, "TST1");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char flip : {'\x01', '\x80', '\xff'}) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ flip);
      code_of(damaged);
    }
  }
}

TEST(Schema, SaysWhatTheReaderEnforces) {
  const std::string schema = io::json_schema_of(type_of<Sample>(), "test.schema.json", "Sample");
  for (const char* part : {"\"additionalProperties\": false",
                           "\"minimum\": 1.0",
                           "\"maximum\": 10.0",
                           "\"green-blue\"",
                           "\"required\""}) {
    EXPECT_NE(schema.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace marketgen
