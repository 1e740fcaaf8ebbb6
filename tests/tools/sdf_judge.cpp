// Loads an SDF file with libsdformat, which prints its warnings to standard error, and prints how
// many models, links, joints, visuals, collisions and models that can move are in its world.
#include <iostream>
#include <sdf/sdf.hh>

int main(int count, char** words) {
  if (count != 2) return 2;
  sdf::Root root;
  const sdf::Errors errors = root.Load(words[1]);
  for (const sdf::Error& error : errors)
    std::cerr << error << '\n';
  if (!errors.empty() || root.WorldCount() != 1) return 1;
  // What `gz sdf --check` asks beside that.
  sdf::Errors of_joints;
  sdf::checkJointParentChildNames(&root, of_joints);
  if (!of_joints.empty() || !sdf::checkFrameAttachedToNames(&root) ||
      !sdf::checkFrameAttachedToGraph(&root) || !sdf::checkPoseRelativeToGraph(&root) ||
      !sdf::recursiveSiblingUniqueNames(root.Element()))
    return 1;
  const sdf::World& world = *root.WorldByIndex(0);
  std::uint64_t links = 0, joints = 0, visuals = 0, collisions = 0, free = 0;
  for (std::uint64_t m = 0; m < world.ModelCount(); ++m) {
    const sdf::Model& model = *world.ModelByIndex(m);
    free += model.Static() || model.JointByName("body/mount") != nullptr ? 0 : 1;
    joints += model.JointCount();
    links += model.LinkCount();
    for (std::uint64_t l = 0; l < model.LinkCount(); ++l) {
      visuals += model.LinkByIndex(l)->VisualCount();
      collisions += model.LinkByIndex(l)->CollisionCount();
    }
  }
  std::cout << world.ModelCount() << ' ' << links << ' ' << joints << ' ' << visuals << ' '
            << collisions << ' ' << free << '\n';
}
