#include "cli/memory_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/row.hpp"

namespace perimpact {

namespace {

std::string bytes_in_words(double bytes) { return bytes < 1e9 ? fmt::format("{:.0f} MB", std::ceil(bytes / 1e6)) : fmt::format("{:.1f} GB", bytes / 1e9); }

}  // namespace

std::string memory_text(const Memory& memory) {
  std::string text =
      "memory\n" + row("peak", fmt::format("about {}: {} from the first step on, up to {} more during set-up, {} while an output frame is written",
                                           bytes_in_words(memory.peak()), bytes_in_words(memory.at_rest), bytes_in_words(memory.setting_up),
                                           bytes_in_words(memory.pictures)));
  if (memory.moves > 0) text += row("moving window", fmt::format("up to {} more while it moves", bytes_in_words(memory.moves)));
  if (memory.rubble > 0) text += row("fragments", fmt::format("up to {} more if all bonds break", bytes_in_words(memory.rubble)));
  return text;
}

output::Json memory_json(const Memory& memory) {
  output::Json json = output::Json::object();
  json["peak [byte]"] = memory.peak();
  json["steps [byte]"] = memory.at_rest;
  json["set_up [byte]"] = memory.setting_up;
  json["frames [byte]"] = memory.pictures;
  json["moving_window [byte]"] = memory.moves;
  json["fragments [byte]"] = memory.rubble;
  return json;
}

}  // namespace perimpact
