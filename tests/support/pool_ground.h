// The episodes that come with the program, of each track, opened once a process.
#pragma once
#include <map>
#include <memory>

#include "environments/environment.h"

namespace marketgen {

inline const std::shared_ptr<EpisodeGround>& pool_ground(Track track) {
  static std::map<Track, std::shared_ptr<EpisodeGround>> grounds;
  std::shared_ptr<EpisodeGround>& ground = grounds[track];
  if (ground) return ground;
  auto opened = EpisodeGround::of_pool(track);
  if (!opened.ok()) fatal(to_string(opened.error()).c_str());
  return ground = std::move(opened).value();
}

// The first of them, with this much time.
inline EpisodeSpec pool_episode(Track track, double limit_s) {
  EpisodeSpec spec = pool_ground(track)->episodes().front();
  spec.limit_s = limit_s;
  return spec;
}

inline std::unique_ptr<Environment> pool_environment(Track track,
                                                     const EnvironmentOptions& options = {}) {
  auto made = Environment::create(pool_ground(track), track, options);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made).value();
}

}  // namespace marketgen
