// What EpisodeCertificate::proved may say was shown; besides, episodes/certificate.h has
// "wider_search" and "physics".
#pragma once
#include <array>
#include <string_view>

namespace marketgen::episodes {

constexpr std::string_view shown_settled = "settled";  // things rest where the episode has them

// By a planned way through the whole task, which is the witness.
constexpr std::array<std::string_view, 5> shown_by_unloading{
    "order", "grasp", "reach", "approach", "place"};
constexpr std::array<std::string_view, 6> shown_by_fetching{
    "path", "base", "reach", "approach", "retreat", "place"};
constexpr std::array<std::string_view, 8> shown_behind_doors{
    "path", "open", "base", "reach", "approach", "retreat", "place", "shut"};
// By a planned way to the bar of one door (Stage::open).
constexpr std::array<std::string_view, 3> shown_before_a_door{"open", "base", "reach"};
// The paper's two conditions, without a witness.
constexpr std::array<std::string_view, 2> shown_on_paper{"path", "front_row"};

}  // namespace marketgen::episodes
