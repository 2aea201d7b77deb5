/// Arrays over slots with slack at both ends, so that a stencil around any slot reads within the allocation. Values read there, and in
/// cells without a particle, are finite and unused.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/aligned.hpp"
#include "base/contract.hpp"
#include "base/pack.hpp"
#include "base/vec3.hpp"

namespace perimpact {

using fccda::Vec3d;

/// `components` numbers per slot, stored by component in one allocation with a constant stride.
template <std::size_t components>
class SlotArray {
 public:
  SlotArray() = default;
  /// `slack`: reach of the stencil in slots. All numbers are initialised to `value`.
  SlotArray(std::size_t slots, std::size_t slack, double value = 0)
      : slots_(slots), slack_(fccda::in_eights(slack)), stride_(fccda::in_eights(slots) + 2 * slack_), numbers_(components * stride_, value) {}

  std::size_t slots() const { return slots_; }
  std::span<const double> with_slack() const { return numbers_; }  ///< of all components, one after the other
  double* component(std::size_t c) { return numbers_.data() + c * stride_ + slack_; }
  const double* component(std::size_t c) const { return numbers_.data() + c * stride_ + slack_; }
  std::array<double*, components> writable_pointers() {
    std::array<double*, components> all;
    for (std::size_t c = 0; c < components; ++c) all[c] = component(c);
    return all;
  }
  std::array<const double*, components> pointers() const {
    std::array<const double*, components> all;
    for (std::size_t c = 0; c < components; ++c) all[c] = component(c);
    return all;
  }

  Vec3d at(std::size_t slot) const requires(components == 3) {
    EXPECTS(slot < slots_);
    return {component(0)[slot], component(1)[slot], component(2)[slot]};
  }
  void set(std::size_t slot, const Vec3d& value) requires(components == 3) {
    EXPECTS(slot < slots_);
    for (std::size_t c = 0; c < 3; ++c) component(c)[slot] = value[c];
  }

 private:
  std::size_t slots_ = 0, slack_ = 0, stride_ = 0;
  fccda::AlignedVector<double> numbers_;
};

using ScalarArray = SlotArray<1>;
using VectorArray = SlotArray<3>;

}  // namespace perimpact
