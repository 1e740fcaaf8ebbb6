#include "layout/finish.h"

#include "layout/module_spec.h"

namespace marketgen::layout {

void change_finish(Fixture& fixture,
                   const plan::Look& from,
                   const plan::Look& to,
                   const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
  if (kind == nullptr || !takes_look(*kind) || fixture.material != from.fixture) return;
  const catalog::MaterialRow* before = catalog.material(from.fixture);
  const catalog::MaterialRow* after = catalog.material(to.fixture);
  fixture.material = to.fixture;
  // A colour that somebody wished for stays.
  if (before != nullptr && after != nullptr && fixture.color == before->color)
    fixture.color = after->color;
}

}  // namespace marketgen::layout
