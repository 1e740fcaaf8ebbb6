#include "render/annotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/visible_parts.h"

namespace marketgen::render {
namespace {

Matrix44 matrix44_of(const Pose& pose) {
  const Matrix34 upper = matrix_of(pose);
  Matrix44 m{};
  for (std::size_t r = 0; r < 3; ++r)
    std::copy_n(upper.m[r], 4, m[r].begin());
  m[3] = {0, 0, 0, 1};
  return m;
}

PoseRow pose_row(const Pose& pose) {
  return {{pose.position.x, pose.position.y, pose.position.z},
          {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z}};
}

double to_hundredths(double x) {
  return std::round(x * 100) / 100;
}

class Annotator {
 public:
  Annotator(const Frame& frame,
            const Camera& camera,
            const scene::Scene& scene,
            const Renderer& renderer,
            std::span<const PictureActor> actors)
      : frame_(frame),
        scene_(scene),
        renderer_(renderer),
        actors_(actors),
        camera_from_world_(inverse(opencv_pose_of(camera))),
        categories_(scene, categories_of(actors)),
        parts_(visible_parts(frame.instance, frame.depth_m, frame.color.width)),
        masks_(mask_runs_of(frame.instance, frame.color.width, frame.color.height)) {}

  const PictureCategories& categories() const { return categories_; }

  std::vector<ObjectAnnotation> objects(const Camera& camera) {
    std::vector<ObjectAnnotation> rows;
    std::vector<std::uint32_t> with_shape;
    for (const auto& [id, part] : parts_) {
      rows.push_back(described(id, part));
      if (rows.back().kind != ObjectKind::shell) with_shape.push_back(id);
    }
    const std::vector<Silhouette> silhouettes = renderer_.silhouettes(camera, frame_, with_shape);
    std::size_t next = 0;
    for (ObjectAnnotation& row : rows) {
      if (row.kind != ObjectKind::shell) add_silhouette(row, silhouettes[next++]);
    }
    return rows;
  }

 private:
  ObjectAnnotation described(std::uint32_t id, const VisiblePart& part) {
    ObjectAnnotation row;
    row.id = id;
    row.kind = kind_of(scene_, id);
    row.category_id = categories_.of(id);
    row.category = categories_.rows()[row.category_id - 1U].name;
    row.color = hex_of_object_color(id);
    row.pixels = part.pixels;
    row.box_px = part.box;
    row.depth_m = part.depth_sum_m / part.pixels;
    row.mask = std::move(masks_.at(id));
    name_and_place(row);
    return row;
  }

  void name_and_place(ObjectAnnotation& row) const {
    switch (row.kind) {
      case ObjectKind::shell:
        row.name = "shell";
        return;
      case ObjectKind::fixture: {
        const std::uint32_t i = row.id - first_fixture_object;
        row.name = scene_.layout.fixtures[i].id;
        row.camera_from_object =
            pose_row(camera_from_world_ * scene::world_from_fixture(scene_, i));
        return;
      }
      case ObjectKind::product: {
        const std::uint32_t i = row.id - first_product_object(scene_);
        row.name = scene::product_id(scene_, i);
        row.sku = scene_.catalog[scene_.products[i].sku].sku;
        row.camera_from_object = pose_row(camera_from_world_ * product_pose(i));
        return;
      }
      case ObjectKind::actor: {
        const PictureActor& actor = actors_[row.id - first_actor_object(scene_)];
        row.name = actor.name;
        row.camera_from_object = pose_row(camera_from_world_ * actor.world_from_actor);
        return;
      }
    }
  }

  Pose product_pose(std::uint32_t i) const {
    for (const MovedProduct& moved : renderer_.moved_products()) {
      if (moved.product == i) return moved.world_from_product;
    }
    return scene::world_from_product(scene_.products[i]);
  }

  static void add_silhouette(ObjectAnnotation& row, const Silhouette& silhouette) {
    if (silhouette.box_px) {
      row.full_box_px = *silhouette.box_px;
      for (double& edge : *row.full_box_px)
        edge = to_hundredths(edge);
    }
    row.silhouette_px = silhouette.pixels;
    if (silhouette.pixels) row.hidden = 1 - static_cast<double>(row.pixels) / *silhouette.pixels;
  }

  const Frame& frame_;
  const scene::Scene& scene_;
  const Renderer& renderer_;
  std::span<const PictureActor> actors_;
  Pose camera_from_world_;
  PictureCategories categories_;
  std::map<std::uint32_t, VisiblePart> parts_;
  std::map<std::uint32_t, MaskRuns> masks_;
};

}  // namespace

CameraMatrices matrices_of(const Camera& camera) {
  CameraMatrices matrices;
  if (camera.ortho_height_m <= 0) {
    const Intrinsics k = intrinsics_of(camera);
    matrices.k = {{{k.fx, 0, k.cx}, {0, k.fy, k.cy}, {0, 0, 1}}};
  }
  const Pose opencv = opencv_pose_of(camera), opengl = opengl_pose_of(camera);
  matrices.world_from_opencv = matrix44_of(opencv);
  matrices.opencv_from_world = matrix44_of(inverse(opencv));
  matrices.world_from_opengl = matrix44_of(opengl);
  matrices.opengl_from_world = matrix44_of(inverse(opengl));
  return matrices;
}

std::vector<PictureActor> picture_actors(std::span<const Actor> actors) {
  std::vector<PictureActor> named;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    const auto before = std::count_if(actors.begin(),
                                      actors.begin() + static_cast<std::ptrdiff_t>(i),
                                      [&](const Actor& a) { return a.name == actors[i].name; });
    named.push_back(
        {before == 0 ? actors[i].name : fmt::format("{}-{}", actors[i].name, before + 1),
         actors[i].bodies.empty() ? Pose{} : actors[i].bodies.front().world_from_body,
         actors[i].category});
  }
  return named;
}

std::vector<std::string> categories_of(std::span<const PictureActor> actors) {
  std::vector<std::string> categories;
  for (const PictureActor& actor : actors)
    categories.push_back(actor.category);
  return categories;
}

PictureAnnotations annotate(const Frame& frame,
                            const Camera& camera,
                            const scene::Scene& scene,
                            const Renderer& renderer,
                            std::span<const PictureActor> actors) {
  PictureAnnotations annotations;
  annotations.scene_hash = scene::scene_hash(scene);
  annotations.camera = camera_file_of(camera);
  annotations.matrices = matrices_of(camera);
  Annotator annotator(frame, camera, scene, renderer, actors);
  annotations.categories = annotator.categories().rows();
  annotations.objects = annotator.objects(camera);
  return annotations;
}

}  // namespace marketgen::render
