/// What runs the kernels of bodies.
#pragma once

namespace perimpact {

class Device;

/// What runs the kernels of bodies.
struct Processor {
  Device* device = nullptr;  ///< outlives the simulation; null: the processor of the host
  bool is_scalar = false;    ///< there: one particle at a time, the reference for devices
};

}  // namespace perimpact
