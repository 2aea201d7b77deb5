/// Contact of a program's points with moving surfaces, rigid and deforming: the complete interface of detection and response.
#pragma once

#include "base/error.hpp"                            // InputError, RunError
#include "fccda/api/contact_detector.hpp"            // ContactDetector::detect: positions in, contacts out
#include "fccda/api/deforming_contact_detector.hpp"  // DeformingContactDetector: the same for surfaces whose vertices move
#include "fccda/api/respond_arrays.hpp"              // respond: relocation, velocities, impulse
#include "fccda/deforming/step_warnings.hpp"         // step_warnings: what is unusual about the motion of a deforming surface
#include "fccda/detect/points.hpp"                   // Points: the interface for solvers that have blocks and bounds of their own
#include "fccda/detect/swept.hpp"                    // Swept: the detector behind it
#include "fccda/rigid_body/rigid_body.hpp"           // RigidBody, Motion, Pose
#include "marine/hull.hpp"                           // make_hull, make_propeller
#include "marine/propeller.hpp"
#include "marine/still_water.hpp"   // StillWater, apply: weight and buoyancy of a rigid body
#include "mesh/remesh/coarsen.hpp"  // coarsen, refine: larger and smaller panels
#include "mesh/remesh/refine.hpp"
#include "mesh/shapes/box.hpp"  // make_box, make_cylinder, make_sphere
#include "mesh/shapes/cylinder.hpp"
#include "mesh/shapes/prism.hpp"  // make_prism: outlines, for codes in two dimensions
#include "mesh/shapes/sphere.hpp"
#include "mesh/submerged.hpp"       // submerged: what lies under a plane
#include "mesh/surface.hpp"         // Surface
#include "mesh_io/read_panels.hpp"  // read_panels: STL, OBJ
