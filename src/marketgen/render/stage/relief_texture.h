// Relief and gloss of a tiled material: the tilt of its normals, its roughness and its metal, with
// mip levels.
//
// Where texels run together, what their normals differ by becomes roughness (Olano and Baker, LEAN
// mapping, I3D 2010), so that a surface keeps its gloss from near to far.
#pragma once
#include <array>

#include "geometry/image.h"
#include "render/stage/mip_chain.h"

namespace marketgen::render::raytrace {

struct Relief {
  float tilt_x = 0, tilt_y = 0;  // of the unit normal: along the texture's rows, towards its top
  float roughness = 0.5F, metallic = 0;
};

class ReliefTexture {
 public:
  ReliefTexture() = default;
  // `image`: channels first .. first + 3 hold the normal's x and y, roughness and metallic, as
  // MaterialMaps has them.
  ReliefTexture(const Image& image, int first);

  // Without its finest mip levels: as it is seen from afar.
  ReliefTexture coarser(int levels) const;

  Relief sample(float u, float v, float lod) const;
  const Relief& mean() const { return mean_; }  // of the whole texture
  const MipChain& mips() const { return mips_; }
  // What four bytes 0..255 of a texel stand for.
  static Relief decoded(const std::array<float, 4>& bytes);
  // From this level on all normals have run together.
  float flat_lod() const { return flat_lod_; }

 private:
  MipChain mips_;
  float flat_lod_ = 0;
  Relief mean_;
};

}  // namespace marketgen::render::raytrace
