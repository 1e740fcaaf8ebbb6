// People in pictures, as a person or a script asks for them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/png.h"
#include "small_store.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

// A picture from above with everything that says what it shows.
Ran people_picture(const fs::path& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"render",
                                     small_store().string(),
                                     "--camera",
                                     "top",
                                     "--size",
                                     "240x160",
                                     "--quality",
                                     "fast",
                                     "--quiet",
                                     "-o",
                                     "top.png",
                                     "--object-ids",
                                     "ids.png",
                                     "--annotations",
                                     "seen.json",
                                     "--categories",
                                     "categories.png"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return marketgen_run(arguments, folder);
}

nlohmann::json people_seen(const fs::path& folder) {
  nlohmann::json people = nlohmann::json::array();
  const nlohmann::json seen = nlohmann::json::parse(contents_of(folder / "seen.json"));
  for (const auto& object : seen["objects"]) {
    if (object["kind"] == "actor") people.push_back(object);
  }
  return people;
}

TEST(PeopleInPictures, HaveNumbersAndACategoryOfTheirOwn) {
  const nlohmann::json counts =
      nlohmann::json::parse(contents_of(small_store() / "store.json"))["counts"];
  const auto first =
      2 + counts["fixtures"].get<std::uint32_t>() + counts["products"].get<std::uint32_t>();
  for (const char* mode : {"sensor", "path"}) {
    const ScratchFolder scratch;
    const Ran ran = people_picture(scratch.path(), {"--people", "2", "--mode", mode, "--spp", "1"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    const nlohmann::json people = people_seen(scratch.path());
    ASSERT_EQ(people.size(), 2U) << mode;
    EXPECT_EQ(people[0]["name"], "person");
    EXPECT_EQ(people[1]["name"], "person-2");
    EXPECT_EQ(people[0]["id"], first);
    EXPECT_EQ(people[1]["id"], first + 1);
    const nlohmann::json rows =
        nlohmann::json::parse(contents_of(scratch.path() / "seen.json"))["categories"];
    for (const auto& person : people) {
      EXPECT_EQ(person["category"], "person");
      EXPECT_EQ(person["category_id"], rows.back()["id"]);
      EXPECT_GT(person["pixels"], 20);
    }
    EXPECT_EQ(rows.back()["name"], "person");
    EXPECT_EQ(rows[1]["name"], "actor");
  }
}

TEST(PeopleInPictures, NobodyIsThereUnlessAskedFor) {
  const ScratchFolder plain, none, some;
  ASSERT_EQ(people_picture(plain.path(), {}).status, 0);
  ASSERT_EQ(people_picture(none.path(), {"--people", "0"}).status, 0);
  ASSERT_EQ(people_picture(some.path(), {"--people", "2"}).status, 0);
  for (const char* file : {"top.png", "ids.png", "seen.json", "categories.png"}) {
    const std::string without = contents_of(plain.path() / file);
    EXPECT_EQ(without, contents_of(none.path() / file)) << file;
    EXPECT_NE(without, contents_of(some.path() / file)) << file;
  }
  EXPECT_TRUE(people_seen(plain.path()).empty());
  // What is numbered without people keeps its number among them.
  const auto categories = [](const fs::path& folder) {
    return nlohmann::json::parse(contents_of(folder / "seen.json"))["categories"];
  };
  nlohmann::json with = categories(some.path());
  with.erase(with.size() - 1);
  EXPECT_EQ(categories(plain.path()), with);
}

TEST(PeopleInPictures, AreTheSameInEveryRunAndWalk) {
  const ScratchFolder one, again, later;
  ASSERT_EQ(people_picture(one.path(), {"--people", "2", "--threads", "1"}).status, 0);
  ASSERT_EQ(people_picture(again.path(), {"--people", "2", "--threads", "3"}).status, 0);
  ASSERT_EQ(people_picture(later.path(), {"--people", "2", "--people-at", "40"}).status, 0);
  EXPECT_EQ(contents_of(one.path() / "top.png"), contents_of(again.path() / "top.png"));
  EXPECT_EQ(contents_of(one.path() / "seen.json"), contents_of(again.path() / "seen.json"));
  EXPECT_NE(contents_of(one.path() / "ids.png"), contents_of(later.path() / "ids.png"));
}

TEST(PeopleInPictures, NoMoreThanTheFloorHolds) {
  const ScratchFolder scratch;
  const Ran ran = people_picture(scratch.path(), {"--people", "200"});
  EXPECT_NE(ran.status, 0);
  EXPECT_NE(ran.err.find("error[people.no_room]"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("ask for fewer"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(scratch.path() / "top.png"));
  EXPECT_NE(people_picture(scratch.path(), {"--people", "-1"}).status, 0);
}

}  // namespace
}  // namespace marketgen
