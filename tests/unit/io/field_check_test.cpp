// What may be written is what may be read: the same rules for values in memory and in a text.
#include "io/field_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "io/json.h"

namespace marketgen {
namespace {

enum class Tone { low, high };
constexpr std::array<std::string_view, 2> names_of(Tone) {
  return {"low", "high"};
}

struct Inner {
  std::string id = "a";
  double share = 0.5;
  static constexpr auto fields = field_list(field("id", &Inner::id, "id", identifier()),
                                            field("share", &Inner::share, "share", range(0, 1)));
};

struct Outer {
  std::string schema = "outer/1";
  std::string name = "n";
  std::uint64_t seed = 1;
  float weight = 1;
  Tone tone = Tone::low;
  std::optional<int> width_mm;
  IntRange facings{2, 4};
  std::vector<Inner> parts{{}, {}};
  static constexpr auto fields =
      field_list(field("schema", &Outer::schema, "tag", constant("outer/1")),
                 field("name", &Outer::name, "name", at_most_bytes(5)),
                 field("seed", &Outer::seed, "seed", at_least(1)),
                 field("weight", &Outer::weight, "weight"),
                 field("tone", &Outer::tone, "tone"),
                 field("width_mm", &Outer::width_mm, "width", range(600, 8000)),
                 field("facings", &Outer::facings, "facings", range(1, 40)),
                 field("parts", &Outer::parts, "parts", at_most_items(3)));
};

struct SpoiltField {
  std::function<void(Outer&)> spoil;
  const char *code, *where, *says;
};

const std::vector<SpoiltField>& spoilt_fields() {
  static const std::vector<SpoiltField> all{
      {[](Outer& o) { o.schema = "outer/2"; }, "json.wrong_schema", "f:/schema", "outer/1"},
      {[](Outer& o) { o.name = "longer"; }, "json.out_of_range", "f:/name", "6 bytes"},
      {[](Outer& o) { o.seed = 0; }, "json.out_of_range", "f:/seed", "less than 1"},
      {[](Outer& o) { o.width_mm = 300; }, "json.out_of_range", "f:/width_mm", "600 to 8000"},
      {[](Outer& o) {
         o.facings = {0, 4};
       },
       "json.out_of_range",
       "f:/facings/0",
       "1 to 40"},
      {[](Outer& o) { o.parts.resize(4); }, "json.out_of_range", "f:/parts", "at most 3"},
      {[](Outer& o) { o.parts[1].id = "../x"; }, "json.bad_identifier", "f:/parts/1/id", "../x"},
      {[](Outer& o) { o.parts[0].share = 1.01; }, "json.out_of_range", "f:/parts/0/share", "1.01"},
      {[](Outer& o) { o.name = "\xff"; }, "input.not_utf8", "f", "UTF-8"},
  };
  return all;
}

TEST(FieldCheck, RefusesWhatAReaderRefuses) {
  EXPECT_TRUE(io::check_fields(Outer{}, "f").ok());
  for (const SpoiltField& fault : spoilt_fields()) {
    Outer value;
    fault.spoil(value);
    const auto held = io::check_fields(value, "f");
    ASSERT_FALSE(held.ok()) << fault.where;
    EXPECT_EQ(held.error().code, fault.code) << fault.where;
    EXPECT_NE(held.error().where.find(fault.where), std::string::npos) << held.error().where;
    EXPECT_NE(held.error().message.find(fault.says), std::string::npos) << held.error().message;
    const auto read = io::read_json<Outer>(io::write_json(value), "f");
    ASSERT_FALSE(read.ok()) << fault.where;
    EXPECT_EQ(read.error().code, fault.code) << fault.where;
  }
}

TEST(FieldCheck, NumbersThatNoTextHolds) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    Outer held;
    held.parts[0].share = value;
    EXPECT_FALSE(io::check_fields(held, "f").ok());
    held = {};
    held.weight = static_cast<float>(value);
    EXPECT_FALSE(io::check_fields(held, "f").ok());
  }
  Outer odd;
  odd.tone = static_cast<Tone>(7);
  EXPECT_EQ(io::check_fields(odd, "f").error().code, "json.unknown_name");
}

// A double that no float holds was read as infinity, which is written as null.
TEST(FieldCheck, ANumberMustFitItsField) {
  const auto read = io::read_json<Outer>(R"({"schema": "outer/1", "weight": 1e300})", "f");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "json.out_of_range");
  EXPECT_EQ(read.error().where, "f:/weight");
}

TEST(FieldCheck, UnsignedNumbersAreNotNegative) {
  Outer value;
  value.seed = std::numeric_limits<std::uint64_t>::max();
  EXPECT_TRUE(io::check_fields(value, "f").ok());
  EXPECT_TRUE((io::read_json<Outer>(io::write_json(value), "f").ok()));
}

TEST(FieldCheck, AFlagAsksAboutOneField) {
  EXPECT_FALSE(io::fault_of_field<Outer>("width_mm", 600));
  const auto fault = io::fault_of_field<Outer>("width_mm", 599);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->message, "599 is outside 600 to 8000");
}

}  // namespace
}  // namespace marketgen
