/// All that a program needs to find and answer contact of its points with a moving rigid surface.
#pragma once

#include "fccda/body/rigid_body.hpp"         // RigidBody, Motion, Pose
#include "fccda/body/still_water.hpp"        // StillWater, apply: weight and buoyancy of a rigid body
#include "fccda/core/error.hpp"              // InputError, RunError
#include "fccda/detect/points.hpp"           // Points: the interface for solvers that have blocks and bounds of their own
#include "fccda/detect/swept.hpp"            // Swept: the detector behind it
#include "fccda/plain/contact_detector.hpp"  // ContactDetector::detect: positions in, contacts out
#include "fccda/plain/respond_arrays.hpp"    // respond: relocation, velocities, impulse
#include "fccda/remesh/coarsen.hpp"          // coarsen, refine: larger and smaller panels
#include "fccda/remesh/refine.hpp"
#include "fccda/shapes/box.hpp"  // make_box, make_cylinder, make_sphere
#include "fccda/shapes/cylinder.hpp"
#include "fccda/shapes/hull.hpp"   // make_hull, make_propeller
#include "fccda/shapes/prism.hpp"  // make_prism: outlines, for codes in two dimensions
#include "fccda/shapes/propeller.hpp"
#include "fccda/shapes/sphere.hpp"
#include "fccda/surface/read/read_panels.hpp"  // read_panels: STL, OBJ
#include "fccda/surface/submerged.hpp"         // submerged: what lies under a plane
#include "fccda/surface/surface.hpp"           // Surface
