/// Numbers in Fortran notation.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fccda {

/// The trimmed word as a finite number: `1`, `1.`, `.5`, `+1`, `1.5e3`, and the Fortran forms `1.5D+3` and `1.5+3`, both 1500. Nothing for
/// anything else.
std::optional<double> fortran_real(std::string_view word);

/// The word as an integer with optional sign; nothing for anything else, including values beyond 64 bits.
std::optional<std::int64_t> fortran_integer(std::string_view word);

}  // namespace fccda
