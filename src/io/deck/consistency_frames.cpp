#include "io/deck/consistency_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "io/deck/did_you_mean.hpp"
#include "io/deck/yaml_node.hpp"
#include "perimpact/deck_model/distinct_words.hpp"

namespace perimpact::deck {

namespace {

void check_fields(const std::vector<std::string>& fields, const std::string& place) {
  const std::vector<std::string> known(std::begin(frame_field_words), std::end(frame_field_words));
  const auto refuse_here = [&](const std::string& sentence) { refuse(place, sentence); };
  const auto expect_known = [&](const std::string& field) {
    if (std::find(known.begin(), known.end(), field) == known.end())
      refuse_here(fmt::format("frame_fields contains \"{}\", which is not a field of the particles; {}", field, suggestion(field, known)));
  };
  check_distinct("frame_fields", fields, expect_known, refuse_here);
}

void check_box(const FrameBoxSetup& box, const std::string& path, const Places& places) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(box.lower[axis] < box.upper[axis]))
      refuse(places.of(path + ".upper"), fmt::format("upper is {} m along {}, but lower is {} m, so the box {} is empty; upper must exceed lower.",
                                                     box.upper[axis], "xyz"[axis], box.lower[axis], box.name));
}

}  // namespace

void check_frames(const Setup& setup, const Places& places) {
  const OutputSetup& output = setup.output;
  check_fields(output.frame_fields, places.of("output.frame_fields"));
  const auto window = std::find_if(setup.bodies.begin(), setup.bodies.end(), [](const BodySetup& body) { return body.moving_window.has_value(); });
  if (window != setup.bodies.end() && std::find(output.frame_fields.begin(), output.frame_fields.end(), "displacement") == output.frame_fields.end())
    refuse(places.of("output.frame_fields"),
           fmt::format("frame_fields lacks displacement, but {} has a moving window, so that displacements do not follow from positions; add displacement.",
                       window->name));
  if (!output.frame_particles) return;
  const std::string path = "output.frame_particles";
  const FrameParticlesSetup& particles = *output.frame_particles;
  if (!particles.has_criterion() && particles.boxes.empty())
    refuse(places.of(path),
           "frame_particles gives no selection; set surface, stride, damage_above, detached or boxes, or remove frame_particles to write all particles.");
  if (window != setup.bodies.end())
    refuse(places.of(path),
           fmt::format("frame_particles is given, but the particles of {} change with its moving window; remove one of the two.", window->name));
  for (const FrameBoxSetup& box : particles.boxes) check_box(box, path + ".boxes." + box.name, places);
}

}  // namespace perimpact::deck
