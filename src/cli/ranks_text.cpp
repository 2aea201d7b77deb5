#include "cli/ranks_text.hpp"

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "cli/memory_text.hpp"
#include "cli/progress.hpp"
#include "cli/row.hpp"
#include "perimpact/discretisation/cloud_of.hpp"
#include "run/run_loop.hpp"

namespace perimpact {

using output::Json;

namespace {

Memory of_largest_rank(const RankForecast& ranks, Memory memory) {
  memory.reduce_to(ranks.memory_share());
  return memory;
}

/// Of a step of the run, with what the loop over steps sends.
struct StepOfRanks {
  Traffic sent;                     // by the rank that sends most
  double computing, messaging = 0;  // [s] of the slowest rank

  StepOfRanks(const Setup& setup, const RankForecast& ranks, const Network& network) : sent(ranks.most_sent()), computing(ranks.computing) {
    const Traffic of_loop = RunLoop::collectives_in_step(setup.output);
    sent += of_loop;
    messaging = ranks.messaging + network.seconds_of(of_loop, static_cast<int>(ranks.sent.size()));
  }
  double seconds() const { return computing + messaging; }
};

bool has_fragments(const Setup& setup) { return setup.contact.fragments.law.as<FragmentLaw>() != FragmentLaw::none; }

double mean_cells(const RankForecast& ranks, std::size_t body) { return ranks.cells[body] / static_cast<double>(ranks.sent.size()); }

std::string milliseconds(double seconds) { return fmt::format("{:.3g} ms", 1e3 * seconds); }

}  // namespace

std::string ranks_text(const Setup& setup, const RankForecast& ranks, const Memory& memory, const std::optional<Forecast>& step, const Network& network) {
  std::string text = fmt::format("{} ranks\n", ranks.sent.size());
  for (std::size_t b = 0; b < ranks.largest.size(); ++b) {
    const BodyShare& largest = ranks.largest[b];
    const double mean = mean_cells(ranks, b);
    text += row(setup.bodies[b].name.c_str(),
                fmt::format("at most {:.0f} {} on a rank, {:.3f} times the mean of {:.6g}; ghosts: at most {:.0f}; neighbours: at most {}", largest.cells,
                            is_cloud(setup.bodies[b]) ? "particles" : "cells", largest.cells / mean, mean, largest.ghosts, largest.neighbours));
  }
  text += memory_text(of_largest_rank(ranks, memory));
  if (!step) return text;
  const StepOfRanks of(setup, ranks, network);
  text += "step of a rank\n" + row("messages", fmt::format("{}, at most {} bytes; {} reductions of {} bytes in all; collections of contacts: {}",
                                                           of.sent.messages, of.sent.bytes, of.sent.reductions, of.sent.reduced_bytes, of.sent.collections));
  if (has_fragments(setup)) text += row("fragments", "contact between them adds messages and reductions, which are not forecast");
  if (of.computing > 0)
    text += row("duration", fmt::format("about {}: {} of computing on {}, {} of messages (latency {:.3g} s, bandwidth {:.3g} byte/s)",
                                        milliseconds(of.seconds()), milliseconds(of.computing), counted(fccda::thread_count(), "thread"),
                                        milliseconds(of.messaging), network.latency, network.bandwidth)) +
            row("run", fmt::format("about {} for {:.4g} steps", duration_in_words(of.seconds() * step->steps), step->steps));
  return text;
}

Json ranks_json(const Setup& setup, const RankForecast& ranks, const Memory& memory, const std::optional<Forecast>& step, const Network& network) {
  Json json = Json::object();
  json["count"] = ranks.sent.size();
  for (std::size_t b = 0; b < ranks.largest.size(); ++b) {
    const BodyShare& largest = ranks.largest[b];
    Json& body = json["bodies"][setup.bodies[b].name];
    body["largest_cells"] = largest.cells;
    body["mean_cells"] = mean_cells(ranks, b);
    body["largest_ghosts"] = largest.ghosts;
    body["largest_neighbours"] = largest.neighbours;
  }
  json["memory"] = memory_json(of_largest_rank(ranks, memory));
  if (!step) return json;
  const StepOfRanks of(setup, ranks, network);
  json["messages"] = of.sent.messages;
  json["sent [byte]"] = of.sent.bytes;
  json["reductions"] = of.sent.reductions;
  json["reduced [byte]"] = of.sent.reduced_bytes;
  json["collections"] = of.sent.collections;
  json["includes_fragments"] = !has_fragments(setup);
  json["latency [s]"] = network.latency;
  json["bandwidth [byte/s]"] = network.bandwidth;
  json["computing [s]"] = of.computing;
  json["step [s]"] = of.seconds();
  return json;
}

}  // namespace perimpact
