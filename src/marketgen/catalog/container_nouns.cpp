#include "catalog/container_nouns.h"

namespace marketgen::catalog {
namespace {

struct NounOfShape {
  std::string_view archetype;
  ContainerNoun called;
};

constexpr NounOfShape nouns[] = {
#define CONTAINER_NOUN(archetype, noun, plural) {#archetype, {noun, plural}},
#include "catalog/container_nouns.inc"
#undef CONTAINER_NOUN
};

}  // namespace

std::vector<ContainerNoun> container_nouns(std::string_view archetype) {
  std::vector<ContainerNoun> called;
  for (const NounOfShape& noun : nouns)
    if (noun.archetype == archetype) called.push_back(noun.called);
  return called;
}

}  // namespace marketgen::catalog
