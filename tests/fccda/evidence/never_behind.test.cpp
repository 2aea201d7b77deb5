// The first scenes of those that lost_points computes by the ten thousand.
#include <doctest/doctest.h>

#include "fccda/evidence/sliding.hpp"

using namespace evidence;

TEST_CASE("evidence: in random wedges, tanks, folded sheets and closed bodies, with friction and without, no point ends behind a panel") {
  for (const Kind kind : {Kind::wedge, Kind::tank, Kind::folded_sheet, Kind::closed_body}) {
    CAPTURE(name_of(kind));
    const Lost lost = play_sliding_scenes(kind, 1, 150);
    CAPTURE(lost.first_seed);
    CHECK(lost.behind == 0);
    CHECK(lost.too_near == 0);
    CHECK(lost.contacts > 10'000);
    CHECK(lost.shifted > lost.contacts / 2);  // friction moved them
  }
}
