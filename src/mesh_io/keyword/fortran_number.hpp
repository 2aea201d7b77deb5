/// Numbers as Fortran programs write and read them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace fccda {

/// The word, without blanks around it, as a finite number: `1`, `1.`, `.5`, `+1`, `1.5e3`, and the forms that only Fortran knows: `1.5D+3` and `1.5+3`,
/// which are 1500. Nothing for anything else.
std::optional<double> fortran_real(std::string_view word);

/// The word as an integer with or without sign; nothing for anything else, and for what does not go into 64 bits.
std::optional<std::int64_t> fortran_integer(std::string_view word);

}  // namespace fccda
