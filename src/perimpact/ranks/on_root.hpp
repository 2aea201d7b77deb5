/// What only the root of a run does, such as writing files.
#pragma once

#include <algorithm>
#include <exception>
#include <string>

#include "base/error.hpp"
#include "perimpact/ranks/ranks.hpp"

namespace perimpact {

/// Calls f() on the root, while the others wait. Its InputError or RunError is thrown on all ranks. Collective.
template <class F>
void on_root(Ranks& ranks, const F& f) {
  enum class Verdict : char { done, input_error, run_error };
  std::exception_ptr error;
  Ranks::Bytes message;
  const auto state = [&](Verdict verdict, const std::string& sentence) {
    message.push_back(static_cast<std::byte>(verdict));
    std::ranges::transform(sentence, std::back_inserter(message), [](char c) { return static_cast<std::byte>(c); });
  };
  if (ranks.is_root()) {
    try {
      f();
      state(Verdict::done, "");
    } catch (const fccda::InputError& input_error) {
      error = std::current_exception();
      state(Verdict::input_error, input_error.what());
    } catch (const fccda::RunError& run_error) {
      error = std::current_exception();
      state(Verdict::run_error, run_error.what());
    }
  }
  ranks.broadcast(message);
  if (error) std::rethrow_exception(error);
  std::string sentence;
  std::ranges::transform(message.begin() + 1, message.end(), std::back_inserter(sentence), [](std::byte byte) { return static_cast<char>(byte); });
  if (static_cast<Verdict>(message.front()) == Verdict::input_error) throw fccda::InputError(sentence);
  if (static_cast<Verdict>(message.front()) == Verdict::run_error) throw fccda::RunError(sentence);
}

}  // namespace perimpact
