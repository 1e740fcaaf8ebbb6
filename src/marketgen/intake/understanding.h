// What a prompt says, as far as the offline planner understands it.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "intake/brief.h"
#include "intake/language.h"
#include "intake/photographed.h"
#include "intake/worded_change.h"

namespace marketgen::intake {

// "lots of", "a large", "a small selection of": more or less of a zone than usual.
struct Emphasis {
  std::string zone;   // zone type
  double factor = 1;  // of its usual area
  std::string text;
  IntRange span{0, 0};
  std::string named;  // the zone type, or the goods of it that were named
};

// "small", "large": more or less floor than the kind of shop usually has.
struct SizeWord {
  double factor = 1;
  bool of_shop = false;  // the word for a shop follows it
  IntRange span{0, 0};
};

// "two rows of frozen food"
struct WantedRows {
  std::string zone;  // zone type
  int rows = 1;
  IntRange span{0, 0};
};

// "Twice as much floor for fruit as for dairy": as soon as the prompt says how much dairy has.
struct ZoneRatio {
  std::string zone, of;  // zone types
  double factor = 1;
  plan::Strength strength = plan::Strength::must;
  std::string text;
  IntRange span{0, 0};
};

// The goods or fixtures that a relation was said of, where its subject or object is the zone that
// keeps them; empty where the zone itself was named.
struct NamedThings {
  IntRange span{0, 0};  // of the relation
  std::string subject, object;
  bool by_fixture = false;  // the subject is a fixture
};

struct StoreName {
  std::string text;
  IntRange span{0, 0};
};

struct Understanding {
  std::vector<plan::Requirement> requirements;
  std::vector<Emphasis> emphases;
  std::vector<WantedRows> rows;
  std::vector<ZoneRatio> ratios;  // while it is read; none when everything is
  std::vector<NamedThings> named;
  std::vector<StoreName> names;  // while it is read
  std::vector<SizeWord> sizes;   // the same
  std::optional<StoreName> name;
  std::vector<WordedChange> changes;  // of an edit
  double size_factor = 1;             // "small", "large": of the profile's usual floor area
  std::vector<UnparsedWord> unparsed;
  std::vector<Conflict> conflicts;
  bool understood = false;                // at least one word said something
  std::optional<plan::Wall> drawn_front;  // the wall of the entrance on a floor plan
  PhotoWishes photographed;               // set by apply_photos

  // The first requirement of that kind (and subject), or null.
  const plan::Requirement* find(plan::RequirementKind kind) const;
  const plan::Requirement* find(plan::RequirementKind kind, std::string_view subject) const;
};

// Reads the whole prompt. Deterministic; never fails: what is not understood is in `unparsed`.
// "Front" and "left" are those of someone who comes in by the entrance: in the wall that the prompt
// names, or in `entrance`. Precondition: valid UTF-8.
Understanding understand(std::string_view prompt,
                         const Language& language,
                         const catalog::Catalog& catalog,
                         plan::Wall entrance = plan::Wall::south);

}  // namespace marketgen::intake
