#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

#include "base/parallel.hpp"
#include "cli/commands.hpp"
#include "cli/large_check.hpp"
#include "cli/memory_text.hpp"
#include "cli/open_deck.hpp"
#include "cli/progress.hpp"
#include "cli/row.hpp"
#include "cli/setup_text.hpp"
#include "fccda/contact_bounds/bounds_panels.hpp"
#include "io/output/results_folder.hpp"
#include "io/output/vtp.hpp"
#include "io/results/lines.hpp"
#include "io/results/panel_frames.hpp"
#include "io/results/particle_frame.hpp"
#include "perimpact/simulation/memory.hpp"

namespace perimpact {

using output::Json;

namespace {

std::vector<Discretisation> discretised(const Setup& setup) {
  std::vector<Discretisation> bodies;
  for (const BodySetup& body : setup.bodies) bodies.push_back(discretise(body));
  return bodies;
}

std::string lines_text(const std::vector<Line>& lines, const Simulation& simulation) {
  std::string text;
  for (const Line& line : lines)
    text += fmt::format("line {}\n", line.name) + row("samples", fmt::format("{} points of {}, written after step {}", line.samples.size(),
                                                                             simulation.bodies()[line.body].name, fmt::join(line.steps, ", ")));
  return text;
}

/// What thinned frames have of each body.
std::string frames_text(const std::vector<FrameParticles>& frames, const Simulation& simulation) {
  std::string text;
  for (std::size_t b = 0; b < frames.size(); ++b)
    if (frames[b].is_thinned())
      text += fmt::format("frames of {}\n", simulation.bodies()[b].name) +
              row("particles", fmt::format("{} of {}{}", frames[b].in_every_frame(), simulation.bodies()[b].particles.size(),
                                           frames[b].varies() ? ", and those that come to be damaged or detached" : ""));
  return text;
}

struct Duration {
  double seconds = 0;  // of the whole run with its set-up, without output
  double set_up = 0;   // [s]
  long trial_steps = 0;
};

/// Estimated from a few steps.
std::optional<Duration> duration_of(Simulation& simulation) {
  if (simulation.relaxation()) return std::nullopt;  // the durations of increments are unrelated
  constexpr int trial_steps = 5;
  simulation.step();  // warms caches
  const auto begin = std::chrono::steady_clock::now();
  const long first = simulation.clock().step;
  while (simulation.clock().step < first + trial_steps && !simulation.clock().is_finished()) simulation.step();
  const long done = simulation.clock().step - first;
  if (done == 0) return std::nullopt;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double set_up = simulation.set_up_timers().total();
  return Duration{set_up + seconds / static_cast<double>(done) * static_cast<double>(simulation.clock().steps), set_up, done};
}

void write_frames(const Simulation& simulation, const std::filesystem::path& folder) {
  output::prepare_folder(folder);
  remove_defect_files(simulation, folder);
  for (const Body& body : simulation.bodies()) write_particles(folder / (body.name + ".vtp"), body);
  for (const Impactor& impactor : simulation.impactors()) {
    write_impactor(folder / (impactor.name() + "_surface.vtp"), impactor);
    fccda::Panels region = fccda::bounds_panels(impactor.region().region);
    if (region.panels.empty()) continue;
    for (Vec3d& vertex : region.vertices) vertex = impactor.body().pose().to_world(vertex);
    output::write_vtp(folder / (impactor.name() + "_contact_bounds.vtp"), {.points = output::coordinates(region.vertices), .panels = region.panels},
                      output::Compression::zlib);
  }
}

void print_json(const deck::Deck& deck, const Messages& messages, const Json& setup, const std::filesystem::path& folder) {
  Json json = Json::object();
  json["schema"] = messages_schema;
  json["program"] = "perimpact " PERIMPACT_VERSION;
  json["title"] = deck.setup.title;
  json["folder"] = folder.string();
  json.append(setup);
  json["threads"] = fccda::thread_count();
  json["warnings"] = messages.warnings();
  fmt::print("{}", json.text());
}

}  // namespace

int check_command(const CheckArguments& arguments) {
  Messages messages(arguments.messages, arguments.json ? Messages::Form::none : Messages::Form::text);
  return logged(messages, [&] {
    const deck::Deck deck = open_deck(arguments, messages);
    messages.print(deck.setup.title + '\n');
    const std::filesystem::path folder = results_folder(arguments, deck.setup) / "check";
    return with_places(deck, {folder}, [&] {
      std::vector<Discretisation> bodies = discretised(deck.setup);
      if (arguments.ranks > 0 || is_large(deck.setup, bodies)) {
        const LargeCheck large(deck.setup, bodies, arguments.ranks, arguments.network);
        if (arguments.json)
          print_json(deck, messages, large.json(), folder);
        else
          messages.print(large.text());
        large.expect_to_fit();
        return 0;
      }
      Memory memory = memory_of(deck.setup, bodies);
      bodies.clear();
      Simulation simulation = set_up(deck, messages);
      for (const Impactor& impactor : simulation.impactors()) memory.add(impactor.surface());
      const std::vector<Line> lines = lines_of(simulation);
      const std::vector<FrameParticles> frames = frame_particles_of(simulation);
      if (!arguments.json) messages.print(setup_text(simulation) + memory_text(memory) + frames_text(frames, simulation) + lines_text(lines, simulation));
      Json json = arguments.json ? setup_json(simulation) : Json();  // before the trial steps
      for (const std::string& warning : simulation.warnings()) messages.warn(warning);
      write_frames(simulation, folder);
      const std::optional<Duration> duration = duration_of(simulation);
      if (arguments.json) {
        json["memory"] = memory_json(memory);
        if (duration) json["duration [s]"] = duration->seconds;
        print_json(deck, messages, json, folder);
        return 0;
      }
      if (duration)
        messages.print(fmt::format("duration\n  about {} on {}, {} of it for the set-up, without output frames (from {} steps)\n",
                                   duration_in_words(duration->seconds), counted(fccda::thread_count(), "thread"), duration_in_words(duration->set_up),
                                   duration->trial_steps));
      messages.print(fmt::format("surfaces, contact bounds and bodies are in {} as VTP\n", folder.string()));
      return 0;
    });
  });
}

}  // namespace perimpact
