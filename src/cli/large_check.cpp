#include "cli/large_check.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "cli/contact_bounds_text.hpp"
#include "cli/memory_text.hpp"
#include "cli/progress.hpp"
#include "cli/ranks_text.hpp"
#include "cli/remesh_text.hpp"
#include "cli/row.hpp"
#include "cli/surface_text.hpp"
#include "perimpact/deck_model/setup_error.hpp"
#include "perimpact/family/stencil.hpp"
#include "perimpact/impactor/impactor.hpp"
#include "perimpact/simulation/expect_parts.hpp"
#include "perimpact/simulation/forecast.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

using output::Json;

namespace {

/// A body by its lattice alone.
struct CountedBody {
  const BodySetup& body;
  Lattice lattice;
  Stencil stencil;
  double particles;

  CountedBody(const BodySetup& setup, const BodySolid& solid, double count)
      : body(setup),
        lattice(lattice_that_fills(setup, solid)),
        stencil(setup.family.as<FamilyRule>(), lattice.spacing, setup.horizon_ratio, lattice.thickness),
        particles(count) {}
  double largest_bonds() const { return 0.5 * particles * static_cast<double>(stencil.size()); }
  double spacing() const { return lattice.spacing; }
  double mass() const { return particles * lattice.cell_volume() * body.elastic().density; }

  std::string text() const {
    return row("particles",
               fmt::format("{:.0f} ({} x {} x {} cells of {:.4g} m)", particles, lattice.cells[0], lattice.cells[1], lattice.cells[2], spacing())) +
           row("bonds", fmt::format("at most {:.4g} ({} an interior particle, horizon {:.4g} m)", largest_bonds(), stencil.size(), stencil.horizon())) +
           row("mass", fmt::format("{:.5g} kg", mass()));
  }
};

/// A body from a file of particles.
struct CountedCloud {
  const BodySetup& body;
  const Cloud& cloud;

  double spacing() const { return spacing_of(cloud); }
  double mass() const { return body.elastic().density * std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0); }
  std::string text() const {
    return row("particles", fmt::format("{} (points of a file, mean spacing {:.4g} m)", cloud.points.size(), spacing())) +
           row("mass", fmt::format("{:.5g} kg", mass()));
  }
};

}  // namespace

bool is_large(const Setup& setup, const std::vector<Discretisation>& bodies) {
  constexpr double most = 4e6;  // particles; a million takes about 2 s to set up, and 20 s for the exact critical step
  double slots = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double own = slots_of(setup.bodies[b], bodies[b]);
    if (std::holds_alternative<Cloud>(bodies[b]) || !(own < std::numeric_limits<std::uint32_t>::max())) return false;  // the latter is refused
    slots += own;
  }
  return slots > most;
}

LargeCheck::LargeCheck(const Setup& setup, const std::vector<Discretisation>& bodies, int ranks, const Network& network)
    : setup_(setup), bodies_(bodies), ranks_(ranks), memory_(memory_of(setup, bodies)), json_(Json::object()) {
  json_["is_estimate"] = true;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto add = [&](const auto& body) {
      text_ += fmt::format("body {}\n", setup.bodies[b].name) + body.text();
      Json& json = json_["bodies"][setup.bodies[b].name];
      json["particles"] = memory_.particles[b];
      json["spacing [m]"] = body.spacing();
      json["mass [kg]"] = body.mass();
    };
    if (const auto* cloud = std::get_if<Cloud>(&bodies[b]))
      add(CountedCloud{setup.bodies[b], *cloud});
    else
      add(CountedBody(setup.bodies[b], std::get<BodySolid>(bodies[b]), memory_.particles[b]));
  }
  for (const ImpactorSetup& impactor : setup.impactors) {
    const Impactor alone(impactor, setup.contact.impactors, {});
    memory_.add(alone.surface());
    text_ += fmt::format("impactor {}\n", alone.name()) + remesh_text(alone) + surface_text(alone.surface().report()) + contact_bounds_text(alone);
    json_["impactors"][alone.name()]["panels"] = alone.surface().report().panels;
  }
  Json& time = json_["time"];
  std::optional<Forecast> forecast;
  if (const auto& relax = setup.time.relax) {
    const double increment = setup.time.end / relax->increments;
    text_ += "time\n" + row("increments", fmt::format("{} of {:.4g} s", relax->increments, increment));
    time["increments"] = relax->increments;
    time["increment [s]"] = increment;
  } else {
    forecast = forecast_of(setup, bodies, std::accumulate(memory_.particles.begin(), memory_.particles.end(), 0.0));
    text_ +=
        "time\n" + row("step", fmt::format("about {:.4g} s, {:.3g} steps: of a block of the same material", forecast->step, forecast->steps)) +
        fmt::format("duration\n  about {} on {}, {} of it for the set-up, without impactors and output frames (from steps of the block)\n",
                    duration_in_words(forecast->set_up + forecast->running), counted(fccda::thread_count(), "thread"), duration_in_words(forecast->set_up));
    time["step [s]"] = forecast->step;
    time["steps"] = forecast->steps;
    json_["duration [s]"] = forecast->set_up + forecast->running;
  }
  if (ranks > 0) {
    const RankForecast shared = rank_forecast_of(setup, bodies, ranks, forecast ? forecast->running / forecast->steps : 0, network);
    text_ += ranks_text(setup, shared, memory_, forecast, network);
    json_["ranks"] = ranks_json(setup, shared, memory_, forecast, network);
  } else {
    text_ += memory_text(memory_);
    json_["memory"] = memory_json(memory_);
  }
  text_ +=
      "The bodies are not built: particles are counted, and time and duration are estimates. Contact, probes and warnings are examined when the run begins, "
      "or with a larger spacing.\n";
}

void LargeCheck::expect_to_fit() const {
  if (ranks_ == 0) perimpact::expect_to_fit(setup_, bodies_, memory_, available_memory());
}

}  // namespace perimpact
