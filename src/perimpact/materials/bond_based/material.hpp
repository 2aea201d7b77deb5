/// Bond-based material: the ordinary state-based one at the Poisson's ratio at which it has no dilatation term.
#pragma once

#include "perimpact/materials/bond_based/setup.hpp"
#include "perimpact/materials/ordinary_state/material.hpp"

namespace perimpact {

template <>
struct Material<BondBasedSetup> : OrdinaryStateMaterial {
  static MaterialMemory memory(const ElasticSetup& setup, const MemoryQuestion& question) { return OrdinaryStateMaterial::memory(setup, question, false); }
};

}  // namespace perimpact
