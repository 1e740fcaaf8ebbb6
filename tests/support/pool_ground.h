// The episodes that come with the program, of each track, opened once a process.
#pragma once
#include <map>
#include <memory>

#include "environments/environment.h"

namespace marketgen {

inline const std::shared_ptr<environments::EpisodeGround>& pool_ground(episodes::Track track) {
  static std::map<episodes::Track, std::shared_ptr<environments::EpisodeGround>> grounds;
  std::shared_ptr<environments::EpisodeGround>& ground = grounds[track];
  if (ground) return ground;
  auto opened = environments::EpisodeGround::of_pool(track);
  if (!opened.ok()) fatal(to_string(opened.error()).c_str());
  return ground = std::move(opened).value();
}

// The first of them, with this much time.
inline episodes::EpisodeSpec pool_episode(episodes::Track track, double limit_s) {
  episodes::EpisodeSpec spec = pool_ground(track)->episodes().front();
  spec.limit_s = limit_s;
  return spec;
}

inline std::unique_ptr<environments::Environment> pool_environment(
    episodes::Track track, const environments::EnvironmentOptions& options = {}) {
  auto made = environments::Environment::create(pool_ground(track), track, options);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made).value();
}

}  // namespace marketgen
