// The fixtures of an MJCF file. What stands still is a geom of the world; what a joint moves is a
// geom of a body with a hinge or a slide. Body and joint are called "<fixture id>/<joint>".
//
// A self-closing joint's spring pulls towards its rest x away with the torque k x (1 - (x / h)^2),
// h the distance of the position from which it holds open: past that it pushes to the end, as the
// hinges of cooler doors do. Dry friction holds it a few degrees before that, too.
//
// MuJoCo has no surface velocity. A belt is a body without a joint, to be known by its contacts,
// and a custom numeric "<fixture id>/<joint>": the direction in which its surface runs (x y z,
// store frame), its least and its greatest speed in m/s. A controller drives what lies on it.
//
// Nor has it a force that lets go. A door with a magnetic gasket has a custom numeric "<fixture
// id>/<joint>/gasket": its torque t on the closed door in N m and the angle a at which that has
// gone. Our World pulls with t (1 - q / a)^2 below a; whoever wants it elsewhere applies it at
// every step (qfrc_applied). In the file alone such a door opens with the force of its spring.
#pragma once
#include "export/export.h"
#include "export/mjcf_text.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// Inside <worldbody>.
void write_mjcf_fixtures(XmlText& out, const scene::Scene& scene, const ExportOptions& options);
// A <custom> section, or nothing when no joint is a belt or has a gasket.
void write_mjcf_joint_numbers(XmlText& out,
                              const scene::Scene& scene,
                              const ExportOptions& options);

}  // namespace marketgen::exporters
