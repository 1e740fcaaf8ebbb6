// Rays of any pixels waiting for a full packet.
#pragma once
#include <array>

#include "render/tracing.h"

namespace marketgen::render::raytrace {

struct RayQueue {
  RTCRayHit16 packet;
  std::array<std::uint16_t, packet_size> pixels{};  // whose they are
  std::size_t used = 0;

  // Whether the packet is full now.
  bool add(std::size_t pixel, const Ray& ray) {
    set_ray(packet.ray, used, ray);
    pixels[used++] = static_cast<std::uint16_t>(pixel);
    return used == packet_size;
  }
  // Lanes without a ray repeat the first one, so that none holds garbage. Precondition: not empty.
  void fill() {
    for (std::size_t k = used; k < packet_size; ++k)
      set_ray(packet.ray, k, ray_in(packet.ray, 0));
  }
};

}  // namespace marketgen::render::raytrace
