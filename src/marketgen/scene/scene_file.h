// scene.bin: the Scene as a FlatBuffer, verified and memory-mapped.
#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::scene {

constexpr std::string_view scene_file_identifier = "MGS1";

std::string encode_scene(const Scene& scene);
// Checks bounds, every index between tables, finite numbers. Errors: scene.truncated,
// scene.corrupt, scene.wrong_version.
Result<Scene> decode_scene(std::span<const std::byte> bytes, const std::string& source);
Result<void> check_indices(const Scene& scene, const std::string& source);
// Mapped, verified, decoded; meshes of users' own products that lie beside it are kept for use.
Result<Scene> open_scene(const std::filesystem::path& file);

}  // namespace marketgen::scene
