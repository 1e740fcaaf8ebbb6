#include "motion/shape_obstacles.h"

namespace marketgen {

void add_shape(const ContactShape& shape, Obstacles& obstacles) {
  if (shape.shape == CollisionShape::cylinder)
    obstacles.cylinders.push_back({shape.pose, shape.size.x, shape.size.y});
  else
    obstacles.boxes.push_back({shape.pose, shape.size});
}

void add_pieces(const std::vector<ContactPiece>& pieces, const Pose& pose, Obstacles& obstacles) {
  for (const ContactPiece& piece : pieces) {
    if (piece.shape == PieceShape::hull)
      obstacles.convex.push_back({pose, piece.points});
    else
      add_shape(pose * contact_shape_of(piece), obstacles);
  }
}

}  // namespace marketgen
