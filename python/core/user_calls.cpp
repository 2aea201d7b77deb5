#include "user_calls.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"

namespace perimpact::python {

std::string UserCalls::sentence_of(const std::string& what, const py::error_already_set& error) {
  std::string text;
  try {
    text = py::str(error.value());
  } catch (const py::error_already_set&) {
    // an exception without text
  }
  std::string sentence = fmt::format("{} raised {}", what, std::string(py::str(error.type().attr("__name__"))));
  if (!text.empty()) sentence += ": " + text;
  return sentence.ends_with('.') ? sentence : sentence + ".";
}

void UserCalls::fail(const std::string& sentence) {
  kept_ = std::current_exception();
  throw fccda::RunError(sentence);
}

void UserCalls::rethrow() {
  if (const std::exception_ptr exception = std::exchange(kept_, nullptr)) std::rethrow_exception(exception);
}

}  // namespace perimpact::python
