// The tables that query_scene (scene/query.h) knows.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::scene {

inline constexpr std::array<std::string_view, 6> query_tables{
    "products", "fixtures", "zones", "prices", "materials", "planogram"};

}  // namespace marketgen::scene
