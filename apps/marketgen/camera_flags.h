// The flags that say where a picture is taken from.
#pragma once
#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>

#include "base/result.h"
#include "render/cameras/camera.h"
#include "scene/scene.h"

namespace marketgen::app {

struct CameraFlags {
  std::string name, file, from, at, size = "1280x720";
  std::optional<double> fov_deg;  // 60 with --from and --at
};

void add_camera_flags(CLI::App& command, CameraFlags& flags);

// Width and height of "1280x720". Error: camera.bad_size at --size.
Result<std::pair<int, int>> picture_size(const std::string& text);

// Errors: usage.bad_flag, camera.*; those of the file.
Result<render::Camera> camera_of(const CameraFlags& flags, const scene::Scene& scene);

}  // namespace marketgen::app
