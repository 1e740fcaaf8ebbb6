// The catalogue as an agent is given it: rows, shapes and pictures of products.
//
// A picture is orthographic, against nothing: what is not the product has no depth. Product frame
// as in assets/product_model.h.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/result.h"
#include "catalog/product.h"
#include "geometry/image.h"
#include "geometry/pose.h"

namespace marketgen::agent {

struct KnownProduct {
  catalog::Product product;
  assets::ProductBody body;   // convex pieces of its shape
  double pad_friction = 0.5;  // of rubber on it
};

struct ProductPicture {
  Pose product_from_camera;  // OpenCV's axes; the picture's middle is on the camera's axis
  double pixel_m = 0;        // side of a pixel on the product
  Image color;
  std::vector<float> depth_m;  // along the optical axis, row-major; 0 = not the product
  // 1 where one looks into it, so that its colour is that of what it holds and stands before;
  // empty: nowhere.
  std::vector<std::uint8_t> clear = {};
};

using ProductPictures = std::vector<ProductPicture>;  // of one product, from all sides

class KnownProducts {
 public:
  virtual ~KnownProducts() = default;
  virtual const std::vector<catalog::Product>& rows() const = 0;
  // Lives as long as this. Errors: catalog.unknown_sku; what making it reports.
  virtual Result<const KnownProduct*> product(const std::string& sku) = 0;
  // Of each of these, in their order; of many at once they are taken sooner. Taken anew each time;
  // any number of threads may ask. Errors: as product().
  virtual Result<std::vector<ProductPictures>> pictures(
      const std::vector<std::string>& skus) const = 0;
  // Changes with whatever decides what pictures show beside a product's row, so that what is
  // learnt from them can be kept; empty: it is not to be.
  virtual std::string pictures_key() const { return {}; }
};

}  // namespace marketgen::agent
