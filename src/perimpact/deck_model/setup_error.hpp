/// Invalid value of a Setup, detected when the simulation is built.
#pragma once

#include <string>
#include <utility>

#include "base/error.hpp"

namespace perimpact {

/// Remedies of the contact library in terms of deck keys.
constexpr fccda::AdviceWords deck_words{.declare_orientation = "with `orientation: normals` (the side to which the normals point) or `orientation: reversed`",
                                        .cut_open = "with `orientation: normals` (the side to which the normals point)",
                                        .clip = "set `on_exceed: clip`"};

/// `key`: path in the Setup ("impactors.cylinder.contact_bounds"), from which the deck reader determines file, line and column.
class SetupError : public fccda::InputError {
 public:
  SetupError(std::string key, const std::string& sentence) : InputError(sentence), key_(std::move(key)) {}
  SetupError(std::string key, const fccda::InputError& error) : SetupError(std::move(key), error.in_words_of(deck_words)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

}  // namespace perimpact
