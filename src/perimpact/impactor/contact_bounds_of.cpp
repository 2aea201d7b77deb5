#include "perimpact/impactor/contact_bounds_of.hpp"

#include "perimpact/contact_bounds/all_contact_bounds.hpp"
#include "perimpact/deck_model/setup_error.hpp"

namespace perimpact {

using namespace fccda;

namespace {

ImpactorBounds make_bounds(const std::monostate&, const Surface&, Beyond) { return {Unbounded(), ""}; }

}  // namespace

ImpactorBounds contact_bounds_of(const ContactBoundsSetup& setup, const Surface& surface, const std::string& impactor) {
  try {
    return std::visit([&](const auto& shape) { return make_bounds(shape, surface, setup.on_exceed.as<Beyond, on_exceed_words>()); }, setup.shape);
  } catch (const InputError& error) {
    throw SetupError("impactors." + impactor + ".contact_bounds", error);
  }
}

}  // namespace perimpact
