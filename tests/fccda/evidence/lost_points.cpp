/// Number of points lost by friction, crevices and thin walls, for each kind of scene (sliding.hpp):
///
///   lost_points [scenes of each kind [first seed]]
///
/// Prints CSV and returns 1 if any point is behind a panel or nearer than its contact radius.
#include <cstdio>
#include <cstdlib>

#include "fccda/evidence/sliding.hpp"

int main(int count, char** arguments) {
  const std::uint64_t scenes = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10'000;
  const std::uint64_t first = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  std::puts("kind,scenes,contacts,shifted_by_friction,behind,too_near,nearest,first_seed");
  bool lost_any = false;
  for (const evidence::Kind kind : {evidence::Kind::wedge, evidence::Kind::tank, evidence::Kind::folded_sheet, evidence::Kind::closed_body}) {
    const evidence::Lost lost = evidence::play_sliding_scenes(kind, first, scenes);
    std::printf("%s,%zu,%zu,%zu,%zu,%zu,%.3g,%llu\n", evidence::name_of(kind), lost.scenes, lost.contacts, lost.shifted, lost.behind, lost.too_near,
                lost.nearest, static_cast<unsigned long long>(lost.first_seed));
    std::fflush(stdout);
    lost_any |= lost.behind + lost.too_near > 0;
  }
  return lost_any ? 1 : 0;
}
