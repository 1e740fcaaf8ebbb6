#include "physics/world/still_geoms.h"

#include <fmt/format.h>

#include "physics/goods/spec_geoms.h"

namespace marketgen::physics {
namespace {

constexpr int batch_geoms = 512;  // 128 to 1024 take as long

}  // namespace

mjsGeom* StillGeoms::add(const assets::ContactShape& shape) {
  if (batches_.empty() || batches_.back().geoms == batch_geoms) {
    Batch batch;
    batch.spec.reset(mj_makeSpec());
    batch.body = mjs_findBody(batch.spec.get(), "world");
    batch.frame = mjs_addFrame(batch.body, nullptr);
    batches_.push_back(std::move(batch));
  }
  Batch& batch = batches_.back();
  ++batch.geoms;
  mjsGeom* geom = add_shape(batch.body, shape);
  mjs_setFrame(geom->element, batch.frame);
  return geom;
}

Result<void> StillGeoms::attach_to(mjsBody* body, mjSpec& spec, const std::string& name) {
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const std::string prefix = fmt::format("{}-{}-", name, i);
    const char* const text = prefix.c_str();
    const mjsElement* const frame = batches_[i].frame->element;
    const mjsElement* attached = nullptr;
    MARKETGEN_CHECK(
        guarded("world", [&] { attached = mjs_attach(body->element, frame, text, ""); }));
    if (attached == nullptr) return Error{"physics.failed", "world", mjs_getError(&spec)};
  }
  return {};
}

}  // namespace marketgen::physics
