// Pictures of a running episode, whatever its track.
#pragma once
#include <memory>
#include <string_view>
#include <utility>

#include "render/render.h"

namespace marketgen::episodes {

// Every track's view has a camera of this name, from which films are taken.
inline constexpr char film_camera_name[] = "film_camera";

// Not thread-safe. Its world must outlive it.
class TrackView {
 public:
  virtual ~TrackView() = default;
  // From now on everything is seen where it stands in the world. Error render.bad_move.
  virtual Result<void> follow() = 0;
  // As things stood when follow() was called. 0: as many pixels as the station's row says. Error
  // camera.unknown.
  virtual Result<render::Camera> camera(std::string_view name,
                                        int width = 0,
                                        int height = 0) const = 0;
  virtual render::Renderer& renderer() = 0;
};

// A track's own view, of the one world of which it was made.
template <class View, class World>
class ViewOfWorld : public TrackView {
 public:
  ViewOfWorld(std::unique_ptr<View> view, const World& world)
      : view_(std::move(view)), world_(world) {}
  Result<void> follow() override { return view_->follow(world_); }
  Result<render::Camera> camera(std::string_view name, int width, int height) const override {
    return view_->camera(name, width, height);
  }
  render::Renderer& renderer() override { return view_->renderer(); }

 private:
  std::unique_ptr<View> view_;
  const World& world_;
};

// Errors: those of View::create.
template <class View, class World>
Result<std::unique_ptr<TrackView>> open_view_of(const World& world) {
  MARKETGEN_TRY(auto view, View::create(world));
  return std::unique_ptr<TrackView>(
      std::make_unique<ViewOfWorld<View, World>>(std::move(view), world));
}

}  // namespace marketgen::episodes
