// What a store sells, for who plans what to buy in it.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"
#include "shopping/assortment.h"

namespace marketgen::environments {

// Rows of the scene; sold out is that of which no item is there, and `sold_out`.
shopping::Assortment assortment_of(const scene::Scene& scene,
                                   const std::vector<std::string>& sold_out = {});

}  // namespace marketgen::environments
