// What people call the container of a shape.
#pragma once
#include <string_view>
#include <vector>

namespace marketgen::catalog {

struct ContainerNoun {
  std::string_view noun, plural;
};

// The usual one first; none for shapes that are called by nothing (loose fruit, rolls).
std::vector<ContainerNoun> container_nouns(std::string_view archetype);

}  // namespace marketgen::catalog
