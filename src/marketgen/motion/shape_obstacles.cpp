#include "motion/shape_obstacles.h"

namespace marketgen::motion {

void add_shape(const assets::ContactShape& shape, Obstacles& obstacles) {
  if (shape.shape == assets::CollisionShape::cylinder)
    obstacles.cylinders.push_back({shape.pose, shape.size.x, shape.size.y});
  else
    obstacles.boxes.push_back({shape.pose, shape.size});
}

void add_pieces(const std::vector<assets::ContactPiece>& pieces,
                const Pose& pose,
                Obstacles& obstacles) {
  for (const assets::ContactPiece& piece : pieces) {
    if (piece.shape == assets::PieceShape::hull)
      obstacles.convex.push_back({pose, piece.points});
    else
      add_shape(pose * assets::contact_shape_of(piece), obstacles);
  }
}

}  // namespace marketgen::motion
