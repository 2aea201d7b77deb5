#include "mesh/panels_in_memory.hpp"

#include <doctest/doctest.h>

#include <string>

#include "base/error.hpp"
#include "mesh/shapes/box.hpp"
#include "mesh_io/read_panels.hpp"

using namespace fccda;

namespace {

Panels box(double height) { return make_box({.size = {1, 1, height}, .edge_length = 1}); }

}  // namespace

TEST_CASE("panels in memory: they are read under their name, part by part, during the lifetime of their owner") {
  Panels panels = box(1);
  panels.part.assign(panels.panels.size(), 0);
  panels.part.back() = 1;
  panels.part_names = {"most", "last"};
  std::string name;
  {
    const PanelsInMemory kept(panels);
    name = kept.name();
    CHECK(read_panels(name).vertices == panels.vertices);
    CHECK(read_panels(name).panels == panels.panels);
    const std::string last[] = {"last"};
    CHECK(read_panels(name, last).panels.size() == 1);
    const PanelsInMemory copy = kept;
    CHECK(copy.name() == name);
  }
  CHECK(!panels_in_memory(name));
  CHECK_THROWS_AS(read_panels(name), InputError);
}

TEST_CASE("panels in memory: equal panels have equal names, and different ones different names") {
  const PanelsInMemory one(box(1)), same(box(1)), higher(box(1 + 1e-15));
  CHECK(one.name() == same.name());
  CHECK(&one.panels() == &same.panels());
  CHECK(one.name() != higher.name());
  Panels turned = box(1);
  std::swap(turned.panels[0][0], turned.panels[0][1]);
  CHECK(PanelsInMemory(turned).name() != one.name());
  Panels named = box(1);
  named.part.assign(named.panels.size(), 0);
  named.part_names = {"all"};
  CHECK(PanelsInMemory(named).name() != one.name());
}
