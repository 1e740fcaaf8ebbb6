#include "assets/people/part_fields.h"
#include "base/parallel.h"

namespace marketgen::assets {
namespace {

// Times the cells for eyes a metre away.
float cells_of(PersonDetail detail) {
  constexpr float far_cells = 2, coarse_cells = 4.5F;
  switch (detail) {
    case PersonDetail::far:
      return far_cells;
    case PersonDetail::coarse:
      return coarse_cells;
    default:
      return 1;
  }
}

void add_all(std::vector<PartField>& to, std::vector<PartField> more) {
  for (PartField& part : more)
    to.push_back(std::move(part));
}

}  // namespace

std::vector<PersonPart> person_parts(const PersonLook& look,
                                     const PersonPose& pose,
                                     PersonDetail detail) {
  const PersonFrame frame = frame_of(look, pose);
  std::vector<PartField> fields = head_fields(look, frame);
  add_all(fields, limb_fields(look, pose, frame));
  add_all(fields, clothes_fields(look, frame));
  add_all(fields, carried_fields(look, pose, frame));
  const float cells = cells_of(detail);
  return parallel_map(fields.size(), [&](std::size_t i) {
    const PartField& part = fields[i];
    return PersonPart{part.name,
                      mesh_of_field(part.field, part.bounds, part.cell_m * cells),
                      part.color,
                      part.roughness,
                      part.scatter_m};
  });
}

}  // namespace marketgen::assets
