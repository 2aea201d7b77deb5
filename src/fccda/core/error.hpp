/// The two kinds of errors that reach a user. Libraries throw them; only the command line prints and exits.
#pragma once

#include <stdexcept>
#include <string>

namespace fccda {

/// The user's input cannot be used. The text says where, what, why and what to do. Exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& sentence) : std::runtime_error(sentence) {}
};

/// The simulation cannot go on (not-a-number, energy growth, no room to write). Exit code 3.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace fccda
