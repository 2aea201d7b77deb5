// Prints how many of 20 000 true crossings of each shape the detectors find, and the outcome of those found:
//
//   detection_table > docs/theory/detection_evidence.csv
//
// and the misses of the detector of Zhang et al., attributed to the equation that rejected the panel actually crossed.
// Shown in docs/theory/detection_evidence.md. Takes one to two minutes.
#include <cstdio>

#include "fccda/detect/published.hpp"
#include "fccda/evidence/score.hpp"
#include "fccda/evidence/shapes.hpp"

using namespace evidence;

namespace {

constexpr std::size_t contacts = 5000, past = 1000;  // of each shape, step and detector

void print(const char* shape, double step, const char* detector, const Score& score, const Rejections& missed) {
  std::printf("%s,%g,%s,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu\n", shape, step, detector, score.contacts, score.found, score.past, score.invented,
              score.inside, score.thrown, missed.by_eq14, missed.by_eq15, missed.by_eq17, missed.by_eq20);
}

/// In 24 orientations, with moving points, moving and rotating bodies in equal parts.
Score score_of_swept(const std::shared_ptr<const Surface>& surface, const Truth& truth, double radius, double step) {
  Swept detector(surface, Unbounded{}, radius);
  Score total;
  for (const Way way : {Way::points_move, Way::body_moves, Way::body_turns}) {
    const auto third = [&](std::size_t count) { return (count + 2 - static_cast<std::size_t>(way)) / 3; };
    for (const Flight& flight : flights(truth, {.radius = radius, .step = step, .way = way, .contacts = third(contacts), .past = third(past), .seed = 61}))
      total += score(detector, truth, flight, way, radius, [](const Passage&, std::size_t) {});
  }
  return total;
}

}  // namespace

int main() {
  std::printf("shape,step,detector,crossings,found,past,invented,inside,thrown,by_eq14,by_eq15,by_eq17,by_eq20\n");
  for (const fixtures::Body& shape : shapes()) {
    const auto surface = fixtures::surface_of(shape.panels);
    const Truth truth(*surface);
    for (const double step : {1e-4, 1e-3, 1e-2, 4e-2}) {
      print(shape.name, step, "swept", score_of_swept(surface, truth, 0, step), {});
      print(shape.name, step, "swept r = 0.005", score_of_swept(surface, truth, 0.005, step), {});
      // The equations of the paper depend on x, y and z, so the shape is not rotated.
      const std::vector<Flight> straight = flights(truth, {.step = step, .contacts = contacts, .past = past, .seed = 62}, std::vector<Pose>(24));
      for (const auto& [name, reading] : {std::pair{"corrected", Published::Variant::corrected}, std::pair{"literal", Published::Variant::literal}}) {
        Published detector(surface, Unbounded{}, reading);
        Score total;
        Rejections reasons;
        for (const Flight& flight : straight) {
          total += score(detector, truth, flight, Way::points_move, 0, [&](const Passage& passage, std::size_t) {
            const auto crossed = surface->triangles()[truth.first_crossing(passage.path)->triangle];
            reasons.count(detector.verdict(static_cast<std::size_t>(crossed.panel), passage.path.start, passage.path.end, flight.motion));
          });
        }
        print(shape.name, step, name, total, reasons);
        std::fflush(stdout);
      }
    }
  }
}
