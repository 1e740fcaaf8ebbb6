#include "assets/people/part_fields.h"
#include "base/parallel.h"

namespace marketgen::assets {
namespace {

constexpr float far_cells = 2;  // times the cells for eyes a metre away

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
  const float cells = detail == PersonDetail::far ? far_cells : 1;
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
