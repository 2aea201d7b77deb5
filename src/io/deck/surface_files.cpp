#include "io/deck/surface_files.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <variant>

#include "io/deck/deck_file.hpp"

namespace perimpact::deck {

namespace {

/// Calls visit(surface, key) for each surface from a file.
template <class S, class Visit>
void for_each_surface(S& setup, const Visit& visit) {
  const auto visit_solid = [&](auto& shape, const std::string& key) {
    if (auto* file = std::get_if<FileSolid>(&shape)) visit(*file, key + ".shape");
  };
  for (auto& body : setup.bodies) {
    const std::string key = "bodies." + body.name;
    visit_solid(body.shape, key);
    for (const auto& [list, solids] : {std::pair{"add", &body.add}, std::pair{"holes", &body.holes}, std::pair{"particle_sets", &body.particle_sets}})
      for (auto& solid : *solids) visit_solid(solid.shape, fmt::format("{}.{}.{}", key, list, solid.name));
  }
  for (auto& impactor : setup.impactors)
    if (auto* file = std::get_if<FileSurface>(&impactor.surface)) visit(*file, "impactors." + impactor.name + ".surface");
}

}  // namespace

void find_surfaces(Setup& setup, const std::filesystem::path& folder, const SurfacesInMemory& in_memory, const Places& places) {
  for_each_surface(setup, [&](FileSurface& surface, const std::string& key) {
    if (const auto panels = in_memory.find(surface.file); panels != in_memory.end())
      surface.panels = std::make_shared<const fccda::NamedPanels>(panels->second);
    else
      surface.file = full_path(folder / surface.file, places.of(key + ".file"));
  });
}

SurfacesInMemory surfaces_in_memory(const Setup& setup) {
  SurfacesInMemory found;
  for_each_surface(setup, [&](const FileSurface& surface, const std::string&) {
    if (surface.panels) found.emplace(surface.file, *surface.panels);
  });
  return found;
}

}  // namespace perimpact::deck
