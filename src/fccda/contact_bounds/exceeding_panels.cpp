#include "fccda/contact_bounds/exceeding_panels.hpp"

#include <iomanip>
#include <sstream>

#include "base/error.hpp"

namespace fccda {

namespace {

std::string named(const std::set<int>& panels) {
  constexpr std::size_t shown = 5;
  std::ostringstream text;
  std::size_t count = 0;
  for (const int panel : panels) {
    if (count == shown) break;
    text << (count++ > 0 ? ", " : "") << panel;
  }
  if (panels.size() > shown) text << ", ...";
  return text.str();
}

}  // namespace

void refuse(const ExceedingPanels& out, const Surface& surface, std::string_view region, std::string_view remedy) {
  std::ostringstream text;
  text << std::setprecision(4) << "contact bounds: " << out.panels.size() << " of " << surface.report().panels << " panels extend beyond " << region
       << " by up to " << out.furthest << " m (panels " << named(out.panels) << "), and contact there would be missed; " << remedy
       << ", or {} if this is intended.";
  throw InputError(text.str(), Advice::clip);
}

}  // namespace fccda
