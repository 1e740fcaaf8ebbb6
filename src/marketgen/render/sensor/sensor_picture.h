// Whole pictures of sensor mode: tiles of one or many cameras side by side, then their edges.
//
//   trace_tile ─▶ shade_tile ─▶ colour, depth, numbers, normals of the tile
//                                  └▶ planes ─▶ pixels with an edge again, with more rays ─▶ colour
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/render.h"
#include "render/sensor/sensor_shading.h"

namespace marketgen::render::raytrace {

// One camera's picture to make. What `lighting` refers to must not change meanwhile.
struct SensorShot {
  const Lighting* lighting = nullptr;
  View view;
  FrameBuffers to;
};

SensorEffort sensor_effort(const RenderOptions& options);

// Writes every buffer that is there, whole. Pixels are the same for any number of threads, and
// whatever else is in the batch. Stops early when interrupted: buffers are then incomplete.
void take_pictures(std::span<const SensorShot> shots,
                   const SensorEffort& effort,
                   Progress& progress);

}  // namespace marketgen::render::raytrace
