// What lies beside a URDF or SDF export: meshes as OBJ, each with its MTL and PNG, so that whoever
// reads a mesh has its look.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "export/exporter.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// In the product frame.
std::string goods_mesh_file(const std::string& sku);

class ModelFiles {
 public:
  // With the goods that stand in the scene, and the room without its ceiling: one looks in from
  // above. Errors: assets.*, image.*.
  static Result<ModelFiles> make(const scene::Scene& scene);

  struct RoomMesh {
    std::string surface, file;  // store frame
  };
  const std::vector<RoomMesh>& room() const { return room_; }
  // Replaces nothing: a second file of a name is left out.
  void add(const std::string& name, std::string bytes);
  std::vector<BesideFile> take() { return std::move(files_); }

 private:
  Result<void> add_room(const scene::Scene& scene);

  std::vector<RoomMesh> room_;
  std::vector<BesideFile> files_;
};

}  // namespace marketgen::exporters
