// Certificates that say what cannot be of their episode: refused, with what is wrong. Those of all
// episodes that come with the program are accepted.
#include "episodes/check_witness.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "episodes/episode_sets.h"
#include "io/file.h"
#include "io/gzip.h"

namespace marketgen {
namespace {

const std::filesystem::path shipped = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";

std::vector<episodes::EpisodeSpec> episodes_of(const std::string& set) {
  const auto file = episodes::find_episode_file(set, shipped).value();
  std::string text = io::read_file(file).value();
  if (io::is_gzip(text)) text = io::gunzip(text, set).value();
  return episodes::read_episodes(text, set).value().episodes;
}

episodes::WitnessPick pick_of(const std::string& sku, const std::string& product) {
  episodes::WitnessPick pick;
  pick.sku = sku;
  pick.product = product;
  pick.strategy = "side";
  pick.grasps = {0, 2};
  return pick;
}

// A basket of two teas and a cocoa that lies on them.
episodes::EpisodeSpec basket() {
  episodes::EpisodeSpec spec;
  spec.items = {{"tea"}, {"tea"}, {"cocoa"}};
  spec.goals = {{"tea", 2}};
  spec.certificate.proved = {"settled", "order", "grasp", "reach", "approach", "place"};
  spec.certificate.witness = {
      pick_of("cocoa", "item-2"), pick_of("tea", "item-1"), pick_of("tea", "item-0")};
  return spec;
}

episodes::EpisodeSpec shelf() {
  episodes::EpisodeSpec spec;
  spec.track = episodes::Track::aisle;
  spec.goals = {{"tea", 2}, {"cocoa", 1}};
  spec.certificate.proved = {"path", "base", "reach", "approach", "retreat", "place"};
  spec.certificate.witness = {
      pick_of("tea", "run/1"), pick_of("tea", "run/2"), pick_of("cocoa", "run/3")};
  return spec;
}

Error error_of(const episodes::EpisodeSpec& spec) {
  const auto checked = episodes::check_witness(spec, "e.jsonl:2");
  return checked.ok() ? Error{"none", "", ""} : checked.error();
}

struct Tampering {
  const char *where, *says;
  void (*change)(episodes::EpisodeCertificate&);
};

void expect_refused(const episodes::EpisodeSpec& drawn, const std::vector<Tampering>& all) {
  ASSERT_EQ(error_of(drawn).code, "none") << to_string(error_of(drawn));
  for (const Tampering& tampering : all) {
    episodes::EpisodeSpec spec = drawn;
    tampering.change(spec.certificate);
    const Error error = error_of(spec);
    EXPECT_EQ(error.code, "episode.bad_value") << tampering.where << ": " << tampering.says;
    EXPECT_EQ(error.where, std::string("e.jsonl:2/certificate/") + tampering.where);
    EXPECT_NE(error.message.find(tampering.says), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("draw the episodes again"), std::string::npos) << error.message;
  }
}

TEST(CheckWitness, AcceptsAllThatComesWithTheProgram) {
  std::size_t checked = 0;
  for (const auto& [name, file] : episodes::episode_sets(shipped))
    for (const episodes::EpisodeSpec& spec : episodes_of(name)) {
      const Error error = error_of(spec);
      ASSERT_EQ(error.code, "none") << name << " " << spec.id << ": " << to_string(error);
      ++checked;
    }
  EXPECT_GE(checked, 3060U);  // three of 1,000, and the pool's
}

TEST(CheckWitness, OfABasketIsOfItsItems) {
  expect_refused(basket(),
                 {{"witness",
                   "is empty, and \"proved\" says \"order\"",
                   [](episodes::EpisodeCertificate& c) { c.witness.clear(); }},
                  {"witness",
                   "takes 1 of \"tea\", and 2 are asked for",
                   [](episodes::EpisodeCertificate& c) { c.witness.pop_back(); }},
                  {"witness/0/sku",
                   "\"item-2\" is a \"cocoa\", not a \"coffee\"",
                   [](episodes::EpisodeCertificate& c) { c.witness[0].sku = "coffee"; }},
                  {"witness/0/product",
                   "\"item-3\" is none of item-0 to item-2",
                   [](episodes::EpisodeCertificate& c) { c.witness[0].product = "item-3"; }},
                  {"witness/2/product",
                   "\"item-1\" was taken before",
                   [](episodes::EpisodeCertificate& c) { c.witness[2].product = "item-1"; }},
                  {"witness/1/strategy",
                   "did you mean \"side\"?",
                   [](episodes::EpisodeCertificate& c) { c.witness[1].strategy = "sied"; }},
                  {"witness/1/grasps",
                   "-1 is less than 0",
                   [](episodes::EpisodeCertificate& c) { c.witness[1].grasps = {-1}; }},
                  {"witness/1/grasps",
                   "4 is there twice",
                   [](episodes::EpisodeCertificate& c) {
                     c.witness[1].grasps = {4, 4};
                   }},
                  {"witness/1/drive_m", "is less than 0", [](episodes::EpisodeCertificate& c) {
                     c.witness[1].drive_m = -1;
                   }}});
}

TEST(CheckWitness, InTheAislesFetchesTheGoalsInTheirOrder) {
  expect_refused(shelf(),
                 {{"witness/1/sku",
                   "\"tea\" is taken after a goal that comes later",
                   [](episodes::EpisodeCertificate& c) { std::ranges::reverse(c.witness); }},
                  {"witness/2/sku",
                   "\"salt\" is no goal",
                   [](episodes::EpisodeCertificate& c) {
                     c.witness[2].sku = "salt";
                     c.proved = {};
                   }},
                  {"witness",
                   "takes 0 of \"cocoa\", and 1 are asked for",
                   [](episodes::EpisodeCertificate& c) { c.witness.pop_back(); }}});
}

TEST(CheckWitness, WhatWasShownHasTheTracksNames) {
  expect_refused(basket(),
                 {{"proved",
                   "nothing is shown that is called \"everything\"",
                   [](episodes::EpisodeCertificate& c) { c.proved = {"everything"}; }},
                  {"proved",
                   "did you mean \"settled\"?",
                   [](episodes::EpisodeCertificate& c) { c.proved[0] = "setled"; }},
                  {"proved",
                   "\"retreat\"",
                   [](episodes::EpisodeCertificate& c) { c.proved.emplace_back("retreat"); }},
                  {"proved", "says \"place\" twice", [](episodes::EpisodeCertificate& c) {
                     c.proved.emplace_back("place");
                   }}});
  expect_refused(shelf(), {{"proved", "\"order\"", [](episodes::EpisodeCertificate& c) {
                              c.proved.emplace_back("order");
                            }}});
}

// The paper's conditions and what an actor did have no planned way, nor has what nobody looked at.
TEST(CheckWitness, NoneIsNeededWhereNoWayIsSaidToBePlanned) {
  episodes::EpisodeSpec at_the_counter = basket(), in_the_aisle = shelf();
  at_the_counter.certificate = {{"settled", "physics"}, {}};
  in_the_aisle.certificate = {{"path", "front_row"}, {}};
  EXPECT_EQ(error_of(at_the_counter).code, "none") << to_string(error_of(at_the_counter));
  EXPECT_EQ(error_of(in_the_aisle).code, "none") << to_string(error_of(in_the_aisle));
  at_the_counter.certificate = in_the_aisle.certificate = {};
  EXPECT_EQ(error_of(at_the_counter).code, "none");
  EXPECT_EQ(error_of(in_the_aisle).code, "none");
}

}  // namespace
}  // namespace marketgen
