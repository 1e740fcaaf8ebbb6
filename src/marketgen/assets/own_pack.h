// Products with a mesh of their own (archetype "mesh", see catalog/own_mesh.h): the answers that
// an archetype gives for the others. The kept file is read anew each time.
#pragma once
#include "assets/product_model.h"
#include "base/result.h"
#include "catalog/product.h"
#include "geometry/image.h"

namespace marketgen::assets {

bool has_own_mesh(const catalog::Product& product);

// The model from glTF's frame in the product's; surfaces with a picture show "label". Errors:
// those of kept_mesh().
Result<ProductModel> own_pack_model(const catalog::Product& product, Detail detail);
CollisionPrimitive own_pack_collision(const catalog::Product& product);  // the box of its size

// The contact pieces in the file, or else made here: by planes for a closed mesh, one hull for
// another. Mass is spread evenly over the enclosed volume, of the hull when there is none.
Result<ProductBody> own_pack_body(const catalog::Product& product);

// The picture of the model, at most `size_px` high. Error: assets.bad_row when it has none.
Result<Image> own_pack_picture(const catalog::Product& product, int size_px);

}  // namespace marketgen::assets
