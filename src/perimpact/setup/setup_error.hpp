/// A value of the Setup that cannot be used, found out only when the simulation is built.
#pragma once

#include <string>

#include "fccda/core/error.hpp"

namespace perimpact {

/// `key`: where in the Setup ("impactors.cylinder.region"), so that the deck reader can name file, line and column.
class SetupError : public fccda::InputError {
 public:
  SetupError(std::string key, const std::string& sentence) : InputError(sentence), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

}  // namespace perimpact
