#include "mesh/named_panels.hpp"

#include <doctest/doctest.h>

#include "mesh/shapes/box.hpp"

using namespace fccda;

namespace {

Panels box(double height) { return make_box({.size = {1, 1, height}, .edge_length = 1}); }

}  // namespace

TEST_CASE("named panels: equal panels have equal names, and different ones different names") {
  const NamedPanels one(box(1)), same(box(1)), higher(box(1 + 1e-15));
  CHECK(one.name() == same.name());
  const NamedPanels copy = one;
  CHECK(&copy.panels() == &one.panels());
  CHECK(one.name() != higher.name());
  Panels turned = box(1);
  std::swap(turned.panels[0][0], turned.panels[0][1]);
  CHECK(NamedPanels(turned).name() != one.name());
  Panels named = box(1);
  named.part.assign(named.panels.size(), 0);
  named.part_names = {"all"};
  CHECK(NamedPanels(named).name() != one.name());
}
