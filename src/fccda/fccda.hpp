/// Contact of a program's points with moving surfaces, rigid and deforming: detection and response as plain calls, bodies, surfaces and their files.
///
/// In headers of their own: contact bounds fitted to a surface (contact_bounds/fit_contact_bounds.hpp), several bodies resolved together
/// (respond/resolve_together.hpp), implicit coupling (respond/coupling.hpp), gauges and loads of panels (respond/gauge.hpp, panel_loads.hpp), applied loads
/// and prescribed motion (rigid_body/), the detectors of comparison (detect/analytic.hpp, published.hpp), elastic bodies and structures (elastic/, modes/),
/// and checks of surfaces (mesh/inspect/).
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
