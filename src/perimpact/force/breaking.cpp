#include "perimpact/force/breaking.hpp"

namespace perimpact {

Breaking::Breaking(const BreakingRule& rule, const std::vector<double>& strength, const Family& family, const Particles& particles) : rule_(rule) {
  if (const Stencil* stencil = family.stencil()) {
    for (const StencilBond& bond : stencil->bonds()) {
      const double limit = (1 + rule.stretch) * bond.length;
      squared_limits_.push_back(limit * limit);
      lengths_.push_back(bond.length);
    }
  }
  if (strength.empty() && !rule.compression) return;
  half_strength_ = ScalarArray(particles.slots(), particles.slack(), 0.5);
  for (std::size_t slot = 0; slot < strength.size(); ++slot) half_strength_.component(0)[slot] = 0.5 * strength[slot];
}

}  // namespace perimpact
