// Pictures in batches: drawn side by side, then each described, encoded and put into words on its
// own thread; only files are written one after another.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "base/build_info.h"
#include "base/parallel.h"
#include "export/coco_annotator.h"
#include "export/coco_cameras.h"
#include "export/exporter.h"
#include "export/licences.h"
#include "export/nav2_map.h"
#include "io/file.h"
#include "io/jpeg.h"
#include "io/json.h"
#include "io/png.h"
#include "render/depth_mm.h"
#include "render/picture_objects.h"

namespace marketgen::exporters {
namespace {

constexpr std::size_t batch_size = 8;  // pictures in memory at a time, 10 MB each

// One picture, ready to be written.
struct TakenPicture {
  CocoImage image;
  std::vector<CocoAnnotation> annotations;
  Result<std::string> jpeg = std::string(), depth_png = std::string();
  std::string image_row, annotation_rows;  // lines of JSON

  void put_into_words() {
    image_row = io::write_json_line(image);
    for (const CocoAnnotation& annotation : annotations)
      annotation_rows += (annotation_rows.empty() ? "" : ",\n") + io::write_json_line(annotation);
  }
};

class CocoWriter {
 public:
  CocoWriter(const scene::Scene& scene, const ExportOptions& options, render::Renderer& renderer)
      : scene_(scene), options_(options), renderer_(renderer), annotator_(scene) {}

  Result<void> add(std::span<const ShelfShot> shots) {
    MARKETGEN_CHECK(draw(shots));
    const auto parts = parallel_map(shots.size(), [&](std::size_t i) {
      const render::Frame& frame = frames_[i];
      return render::visible_parts(frame.instance, frame.depth_m, frame.color.width);
    });
    std::vector<std::map<std::uint32_t, int>> silhouettes;  // one at a time: see Renderer
    for (std::size_t i = 0; i < shots.size(); ++i)
      silhouettes.push_back(silhouettes_in(frames_[i], shots[i].camera, parts[i]));
    std::vector<TakenPicture> taken = parallel_map(shots.size(), [&](std::size_t i) {
      return described(shots[i],
                       frames_[i],
                       annotator_.annotate(frames_[i], shots[i].camera, parts[i], silhouettes[i]));
    });
    for (TakenPicture& picture : taken)
      number(picture);
    parallel_for(taken.size(), [&](std::size_t i) { taken[i].put_into_words(); });
    for (const TakenPicture& picture : taken)
      MARKETGEN_CHECK(write(picture));
    return {};
  }

  std::string document(const CocoInfo& info) const {
    std::vector<std::string> categories;
    for (const CocoCategory& category : coco_categories(scene_))
      categories.push_back(io::write_json_line(category));
    return fmt::format(
        "{{\n\"info\": {},\n\"licenses\": [],\n\"categories\": [\n{}\n],\n\"images\": [\n{}\n],\n"
        "\"annotations\": [\n{}\n]\n}}\n",
        io::write_json_line(info),
        fmt::join(categories, ",\n"),
        fmt::join(images_, ",\n"),
        fmt::join(annotations_, ",\n"));
  }

 private:
  // Into frames_, which is kept from batch to batch.
  Result<void> draw(std::span<const ShelfShot> shots) {
    const auto [width, height] = options_.picture_px;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<render::Shot> batch;
    frames_.resize(std::max(frames_.size(), shots.size()));
    for (std::size_t i = 0; i < shots.size(); ++i) {
      render::Frame& frame = frames_[i];
      if (frame.color.empty()) frame.color = Image(width, height);
      frame.depth_m.resize(count), frame.instance.resize(count);
      batch.push_back({&renderer_,
                       shots[i].camera,
                       {frame.color.pixels.data(),
                        frame.depth_m.data(),
                        frame.instance.data(),
                        nullptr,
                        nullptr}});
    }
    return render::render_batch(batch, {.quality = render::Quality::fast});
  }

  std::map<std::uint32_t, int> silhouettes_in(const render::Frame& frame,
                                              const render::Camera& camera,
                                              const VisibleParts& parts) const {
    std::vector<std::uint32_t> items;
    for (const auto& [object, part] : parts) {
      if (render::kind_of(scene_, object) == render::ObjectKind::product) items.push_back(object);
    }
    std::map<std::uint32_t, int> pixels;
    for (const render::Silhouette& silhouette : renderer_.silhouettes(camera, frame, items))
      pixels[silhouette.object] = silhouette.pixels.value_or(0);
    return pixels;
  }

  TakenPicture described(const ShelfShot& shot,
                         const render::Frame& frame,
                         std::vector<CocoAnnotation> annotations) const {
    TakenPicture taken;
    taken.annotations = std::move(annotations);
    CocoImage& image = taken.image;
    image.width = frame.color.width, image.height = frame.color.height;
    image.zone = shot.zone, image.run = shot.run, image.side = coco_side(shot.side);
    image.camera_height_m = render::place_of(shot.camera).z, image.distance_m = shot.distance_m;
    image.camera = render::camera_file_of(shot.camera);
    const render::CameraMatrices matrices = render::matrices_of(shot.camera);
    image.camera_matrix = matrices.k, image.world_from_camera = matrices.world_from_opencv;
    std::set<std::string> fixtures;
    for (const CocoAnnotation& annotation : taken.annotations) {
      if (annotation.place) fixtures.insert(annotation.place->fixture);
    }
    image.fixtures.assign(fixtures.begin(), fixtures.end());
    taken.jpeg = io::encode_jpeg(frame.color);
    taken.depth_png =
        io::encode_png16(image.width, image.height, render::depth_in_mm(frame.depth_m));
    return taken;
  }

  void number(TakenPicture& taken) {
    CocoImage& image = taken.image;
    image.id = ++image_count_;
    const auto file = [&](std::string_view folder, const char* extension) {
      return fmt::format("{}/{}/{:06}{}", options_.beside, folder, image.id, extension);
    };
    image.file_name = file(coco_color_folder, ".jpg");
    image.depth_file = file(coco_depth_folder, ".png");
    for (CocoAnnotation& annotation : taken.annotations) {
      annotation.id = ++annotation_count_;
      annotation.image_id = image.id;
    }
  }

  Result<void> write(const TakenPicture& taken) {
    MARKETGEN_TRY(const std::string jpeg, taken.jpeg);
    MARKETGEN_TRY(const std::string depth_png, taken.depth_png);
    const auto put = [&](const std::string& file, std::string_view bytes) {
      return options_.put_beside(file.substr(options_.beside.size() + 1), bytes);
    };
    MARKETGEN_CHECK(put(taken.image.file_name, jpeg));
    MARKETGEN_CHECK(put(taken.image.depth_file, depth_png));
    images_.push_back(taken.image_row);
    if (!taken.annotation_rows.empty()) annotations_.push_back(taken.annotation_rows);
    return {};
  }

  const scene::Scene& scene_;
  const ExportOptions& options_;
  render::Renderer& renderer_;
  CocoAnnotator annotator_;
  std::vector<render::Frame> frames_;
  int image_count_ = 0, annotation_count_ = 0;
  std::vector<std::string> images_, annotations_;  // lines of JSON, those of a picture together
};

}  // namespace

Result<ExportFiles> write_coco(const scene::Scene& scene, const ExportOptions& options) {
  MARKETGEN_CHECK(check_nav2_options(scene, options));
  MARKETGEN_CHECK(check_coco_options(options));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const catalog::Catalog catalog, catalog::load_catalog(data));
  const ShelfShots found = shelf_shots(scene, catalog, options);
  Progress& progress = options.progress != nullptr ? *options.progress : silent_progress();
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer,
                render::Renderer::create(scene, progress, {.keep_light = true}));
  CocoWriter writer(scene, options, *renderer);
  progress.begin("pictures", found.shots.size());
  const std::span<const ShelfShot> shots = found.shots;
  for (std::size_t first = 0; first < shots.size(); first += batch_size) {
    const auto batch = shots.subspan(first, std::min(batch_size, shots.size() - first));
    MARKETGEN_CHECK(writer.add(batch));
    progress.advance(batch.size());
  }
  progress.end();
  return ExportFiles{writer.document({"shelf pictures of a store made by MarketGen",
                                      std::string(program_version),
                                      scene.layout.name,
                                      scene::scene_hash(scene),
                                      1e-3,
                                      found.stops_without_room}),
                     {licences_file(scene)}};
}

}  // namespace marketgen::exporters
