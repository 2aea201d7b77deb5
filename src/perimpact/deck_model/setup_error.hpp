/// A value of the Setup that cannot be used, found out only when the simulation is built.
#pragma once

#include <string>
#include <utility>

#include "base/error.hpp"

namespace perimpact {

/// What the contact library advises, as a deck says it.
constexpr fccda::AdviceWords deck_words{.declare_orientation = "with `outside: normals` (the one that the normals point to) or `outside: reversed`",
                                        .cut_open = "with `outside: normals` (the side that the normals point to)",
                                        .clip = "say `outside: clip`"};

/// `key`: where in the Setup ("impactors.cylinder.region"), so that the deck reader can name file, line and column.
class SetupError : public fccda::InputError {
 public:
  SetupError(std::string key, const std::string& sentence) : InputError(sentence), key_(std::move(key)) {}
  SetupError(std::string key, const fccda::InputError& error) : SetupError(std::move(key), error.in_words_of(deck_words)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

}  // namespace perimpact
