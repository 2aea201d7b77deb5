/// Paths of decks and of `--out`, which no shell has expanded (`--out=~/x` is not expanded either).
#pragma once

#include <string>

namespace perimpact::deck {

/// `~`, `~/x`, `$HOME/x` and `${HOME}/x` with the home folder; other paths unchanged. Throws InputError at `place` for `~user` and for other
/// variables, which would otherwise become folders of that name.
std::string expanded_path(const std::string& path, const std::string& place);

}  // namespace perimpact::deck
