#include "intake/materials.h"
#include "intake/reading.h"

namespace marketgen::intake {
namespace {

bool describes(const Sentence& sentence, std::size_t i) {
  return sentence.is(i, Sense::color) || sentence.is(i, Sense::material);
}

// Colours and materials between two phrases, and the colour's hex value (kept in the row's zone
// column).
struct Surface {
  SurfaceWords words;
  std::string hex;
  std::size_t first = 0, last = 0;
  bool empty() const { return words.materials.empty() && words.colors.empty(); }
};

void add_word(Surface& surface, const Phrase& phrase) {
  if (phrase.sense == Sense::material) {
    surface.words.materials.push_back(phrase.value);
    return;
  }
  surface.words.colors.push_back(phrase.value);
  surface.hex = phrase.zone;
}

// "dark oak" of "dark oak floor"
Surface surface_before(const Sentence& sentence, std::size_t part) {
  Surface surface;
  surface.first = surface.last = part;
  while (surface.first > 0 && describes(sentence, surface.first - 1) &&
         !sentence.at(surface.first - 1).used) {
    add_word(surface, sentence.phrases[--surface.first]);
  }
  return surface;
}

// "white" of "shelves in white" or "floor of oak". The "in" of such phrases looks like a place.
Surface surface_after(const Sentence& sentence, std::size_t part) {
  Surface surface;
  surface.first = surface.last = part;
  std::size_t i = sentence.skip_fillers(part + 1);
  if (sentence.is(i, Sense::relation, "in")) i = sentence.skip_fillers(i + 1);
  for (; describes(sentence, i) && !sentence.at(i).used; ++i) {
    if (sentence.is(sentence.skip_fillers(i + 1), Sense::part))
      break;  // it describes the next part
    add_word(surface, sentence.phrases[i]);
    surface.last = i;
  }
  return surface;
}

// Says what the part is to be; false when the catalogue has nothing like it.
bool add_surface(const Reading& reading,
                 const std::string& part,
                 const Surface& surface,
                 IntRange span,
                 plan::Strength strength) {
  if (part == "accent" || (part == "fixture" && surface.words.materials.empty())) {
    if (surface.hex.empty()) return false;
    plan::Requirement& color = reading.add(plan::RequirementKind::color, span, strength);
    color.subject = part;
    color.object = surface.hex;
    return true;
  }
  const catalog::MaterialRow* row = material_for(reading.catalog, part, surface.words, surface.hex);
  if (row == nullptr) return false;
  plan::Requirement& material = reading.add(plan::RequirementKind::material, span, strength);
  material.subject = part;
  material.object = row->id;
  return true;
}

// "white walls and ceiling": the words before the first part hold for the second.
std::size_t shared_part(const Sentence& sentence, std::size_t part) {
  const std::size_t next = part + 1;
  if (!sentence.is(next, Sense::separator, "and")) return sentence.phrases.size();
  const std::size_t second = sentence.skip_fillers(next + 1);
  return sentence.is(second, Sense::part) ? second : sentence.phrases.size();
}

void read_part(Sentence& sentence, const Reading& reading, std::size_t part) {
  Surface surface = surface_before(sentence, part);
  if (surface.empty()) surface = surface_after(sentence, part);
  if (surface.empty()) return;
  const Phrase& what = sentence.phrases[part];
  const IntRange span = joined(joined(sentence.phrases[surface.first].span, what.span),
                               sentence.phrases[surface.last].span);
  const std::string name = what.sense == Sense::fixture ? "fixture" : what.value;
  if (!add_surface(reading, name, surface, span, what.strength)) return;
  sentence.use(surface.first, surface.last);
  for (std::size_t next = shared_part(sentence, part); next < sentence.phrases.size();
       next = shared_part(sentence, next)) {
    const Phrase& shared = sentence.phrases[next];
    if (!add_surface(reading, shared.value, surface, joined(span, shared.span), shared.strength)) {
      break;
    }
    sentence.use(next, next);
  }
}

// "terrazzo", "parquet" and the like name their part themselves.
void read_lone_material(Sentence& sentence, const Reading& reading, std::size_t i) {
  Phrase& phrase = sentence.phrases[i];
  if (phrase.zone.empty()) return;
  Surface surface;
  add_word(surface, phrase);
  std::size_t first = i;
  if (i > 0 && sentence.is(i - 1, Sense::color) && !sentence.at(i - 1).used) {
    add_word(surface, sentence.phrases[--first]);
  }
  const IntRange span = joined(sentence.phrases[first].span, phrase.span);
  if (add_surface(reading, phrase.zone, surface, span, phrase.strength)) sentence.use(first, i);
}

void read_light(Sentence& sentence, const Reading& reading, std::size_t i) {
  Phrase& phrase = sentence.phrases[i];
  plan::Requirement& light =
      reading.add(plan::RequirementKind::light, phrase.span, phrase.strength);
  light.subject = phrase.value;
  light.value = phrase.number;
  phrase.used = true;
}

}  // namespace

void read_look(Sentence& sentence, Reading& reading) {
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    if (sentence.at(i).used && !sentence.at(i).counted) continue;
    if (sentence.is(i, Sense::part) || sentence.is(i, Sense::fixture))
      read_part(sentence, reading, i);
  }
  for (std::size_t i = 0; i < sentence.phrases.size(); ++i) {
    if (sentence.at(i).used) continue;
    if (sentence.is(i, Sense::material)) read_lone_material(sentence, reading, i);
    if (sentence.is(i, Sense::light)) read_light(sentence, reading, i);
  }
}

}  // namespace marketgen::intake
