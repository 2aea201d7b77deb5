#include "io/deck/did_you_mean.hpp"

#include <doctest/doctest.h>

using namespace perimpact::deck;

TEST_CASE("did you mean: an inserted, deleted, replaced or transposed letter is one edit, case and dashes are ignored") {
  CHECK(edits_between("spacing", "spacing") == 0);
  CHECK(edits_between("spaccing", "spacing") == 1);
  CHECK(edits_between("spacin", "spacing") == 1);
  CHECK(edits_between("spazing", "spacing") == 1);
  CHECK(edits_between("spacnig", "spacing") == 1);
  CHECK(edits_between("Youngs-Modulus", "youngs_modulus") == 0);
  CHECK(edits_between("", "end") == 3);
  CHECK(edits_between("kitten", "sitting") == 3);
}

TEST_CASE("did you mean: a similar word is suggested, a dissimilar one is not") {
  const std::vector<std::string> keys = {"spacing", "horizon_ratio", "poissons_ratio", "position", "free"};
  CHECK(nearest_word("poisson_ratio", keys) == "poissons_ratio");
  CHECK(nearest_word("Spacing", keys) == "spacing");
  CHECK(nearest_word("horizon", keys) == "horizon_ratio");  // its beginning
  CHECK(nearest_word("colour", keys) == "");
  CHECK(nearest_word("x", keys) == "");
  CHECK(nearest_word("", keys) == "");
  CHECK(suggestion("colour", keys) == "known here: spacing, horizon_ratio, poissons_ratio, position, free.");
  CHECK(suggestion("posiiton", keys) == "did you mean position?");
}
