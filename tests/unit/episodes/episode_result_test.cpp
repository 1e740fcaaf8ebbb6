// Shares and verdicts of an outcome with the ledger that goes with it.
#include "episodes/episode_result.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

episodes::EpisodeResult all_there(const episodes::SideEffects& effects) {
  episodes::EpisodeResult result;
  result.side_effects = effects;
  episodes::add_outcome({{{"tea", 2, 2}}, 2, 2, 0, false}, result);
  return result;
}

TEST(EpisodeResult, CarriesItsCounts) {
  episodes::EpisodeResult result;
  episodes::add_outcome({{{"tea", 2, 2}, {"rice", 1, 1}}, 3, 2, 1, false}, result);
  EXPECT_EQ(result.hits, 2) << "three are in place, one wrong item is, too";
  EXPECT_EQ(result.asked, 3);
  EXPECT_DOUBLE_EQ(result.success_partial, 2.0 / 3);
  EXPECT_FALSE(result.success_strict);
}

TEST(EpisodeResult, CleanBearsWhatPickingMovesAndNoMore) {
  episodes::SideEffects usual;
  usual.light_contacts = 9, usual.firm_contacts = 9, usual.displaced = 9;
  EXPECT_TRUE(all_there(usual).success_clean);
  for (int episodes::SideEffects::*const count : {&episodes::SideEffects::hard_contacts,
                                                  &episodes::SideEffects::base_collisions,
                                                  &episodes::SideEffects::toppled,
                                                  &episodes::SideEffects::dropped,
                                                  &episodes::SideEffects::strayed}) {
    episodes::SideEffects once = usual;
    once.*count = 1;
    EXPECT_FALSE(all_there(once).success_clean);
    EXPECT_TRUE(all_there(once).success_strict);
  }
  episodes::SideEffects doors = usual;
  doors.doors_open = 0;
  EXPECT_TRUE(all_there(doors).success_clean);
  doors.doors_open = 1;
  EXPECT_FALSE(all_there(doors).success_clean);
}

}  // namespace
}  // namespace marketgen
