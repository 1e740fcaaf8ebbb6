// What a picture shows, for training and scoring: market-annotations/1.
//
// Per object that covers at least one pixel: what it is, its boxes, mask, pose in the camera's
// frame, and how much of it others hide. Behind glass counts as seen. With it the camera, so that
// points of the store and of the picture turn into one another.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/fields.h"
#include "geometry/pose.h"
#include "render/cameras/camera_file.h"
#include "render/mask_runs.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "scene/scene.h"

namespace marketgen::render {

using Matrix44 = std::array<std::array<double, 4>, 4>;  // rows

// The camera in the forms that others take: row-major matrices on column vectors, metres.
struct CameraMatrices {
  std::array<std::array<double, 3>, 3> k{};  // OpenCV's camera matrix, pixels; 0 when orthographic
  Matrix44 world_from_opencv{}, opencv_from_world{}, world_from_opengl{}, opengl_from_world{};

  static constexpr auto fields = field_list(
      field("k", &CameraMatrices::k, "OpenCV's camera matrix, rows; zeros when orthographic"),
      field("world_from_opencv",
            &CameraMatrices::world_from_opencv,
            "pose of the camera, rows; camera frame x right, y down, z ahead"),
      field("opencv_from_world", &CameraMatrices::opencv_from_world, "its inverse: extrinsics"),
      field("world_from_opengl",
            &CameraMatrices::world_from_opengl,
            "the same; camera frame x right, y up, z back"),
      field("opengl_from_world", &CameraMatrices::opengl_from_world, "its inverse: view matrix"));
};
CameraMatrices matrices_of(const Camera& camera);

struct PoseRow {
  std::array<double, 3> position_m{};
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};

  static constexpr auto fields =
      field_list(field("position_m", &PoseRow::position_m, "of the object's origin"),
                 field("rotation_wxyz", &PoseRow::rotation_wxyz, "unit quaternion"));
};

struct ObjectAnnotation {
  std::uint32_t id = 0;
  ObjectKind kind = ObjectKind::shell;
  std::string name, sku, category;
  std::uint16_t category_id = 0;
  std::string color;
  int pixels = 0;
  std::array<int, 4> box_px{};
  std::optional<std::array<double, 4>> full_box_px;
  std::optional<int> silhouette_px;
  std::optional<double> hidden;
  double depth_m = 0;
  std::optional<PoseRow> camera_from_object;
  MaskRuns mask;

  static constexpr auto fields = field_list(
      field("id", &ObjectAnnotation::id, "number in the picture of object numbers"),
      field("kind", &ObjectAnnotation::kind, "shell, fixture, product or actor"),
      field("name",
            &ObjectAnnotation::name,
            "fixture id, product id, the actor's name, or \"shell\""),
      field("sku", &ObjectAnnotation::sku, "of a product"),
      field("category",
            &ObjectAnnotation::category,
            "of a product; a fixture's kind; person; otherwise the object's kind"),
      field("category_id", &ObjectAnnotation::category_id, "number in the picture of categories"),
      field("color", &ObjectAnnotation::color, "in the segmentation; two objects may share one"),
      field("pixels", &ObjectAnnotation::pixels, "how many show it"),
      field("box_px",
            &ObjectAnnotation::box_px,
            "x0, y0, x1, y1 around what shows; x1 and y1 are past the last pixel: from the "
            "picture's top left corner, where OpenCV's pixels are 0.5 less"),
      field(
          "full_box_px",
          &ObjectAnnotation::full_box_px,
          "x0, y0, x1, y1 around the whole object, hidden parts and those beyond the picture too, "
          "from the same corner; absent for the room, and when a part lies behind the camera"),
      field("silhouette_px",
            &ObjectAnnotation::silhouette_px,
            "how many pixels of the picture would show it alone; products and actors"),
      field("hidden",
            &ObjectAnnotation::hidden,
            "share of those that others hide: 1 - pixels / silhouette_px"),
      field("depth_m", &ObjectAnnotation::depth_m, "mean over its pixels, along the optical axis"),
      field("camera_from_object",
            &ObjectAnnotation::camera_from_object,
            "pose of its frame in the camera's (x right, y down, z ahead); not of the room"),
      field("mask", &ObjectAnnotation::mask, "its pixels, as COCO's compressed run lengths"));
};

struct PictureAnnotations {
  std::string schema = "market-annotations/1";
  std::string scene_hash;
  CameraFile camera;
  CameraMatrices matrices;
  std::vector<PictureCategory> categories;  // all of the scene, by id
  std::vector<ObjectAnnotation> objects;    // by id

  static constexpr auto fields = field_list(
      field("schema", &PictureAnnotations::schema, "schema tag", constant("market-annotations/1")),
      field("scene_hash", &PictureAnnotations::scene_hash, "of the store that it shows"),
      field("camera", &PictureAnnotations::camera, "what took it; also a file for --camera-file"),
      field("matrices", &PictureAnnotations::matrices, "the same camera as matrices"),
      field("categories", &PictureAnnotations::categories, "all of the scene, by id"),
      field("objects", &PictureAnnotations::objects, "what is to be seen, by id"));
};

// An actor as it stands in the picture.
struct PictureActor {
  std::string name;
  Pose world_from_actor;
  std::string category = "actor";
};
std::vector<std::string> categories_of(std::span<const PictureActor> actors);
// Each with its name, "panda" and "panda-2" for the second of them, where its first body stands.
std::vector<PictureActor> picture_actors(std::span<const Actor> actors);

// Precondition: `frame` is the picture that `camera` took of `scene` with these actors, in their
// order in Renderer::set_actors(). `renderer` is asked for what each object would cover alone.
PictureAnnotations annotate(const Frame& frame,
                            const Camera& camera,
                            const scene::Scene& scene,
                            const Renderer& renderer,
                            std::span<const PictureActor> actors);

}  // namespace marketgen::render
