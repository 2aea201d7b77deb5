/// Messages of the libraries that name options of the command line, in terms of Python.
#pragma once

#include <string>
#include <utility>

#include "base/error.hpp"

namespace perimpact::python {

/// "--set time.end: …" → "set["time.end"]: …", "run without --resume" → "leave out resume=True", and so on.
std::string in_words_of_python(std::string sentence);

/// f(), with the messages of its errors in terms of Python.
template <class F>
auto worded(const F& f) {
  try {
    return f();
  } catch (const fccda::InputError& error) {
    throw fccda::InputError(in_words_of_python(error.what()));
  } catch (const fccda::RunError& error) {
    throw fccda::RunError(in_words_of_python(error.what()));
  }
}

}  // namespace perimpact::python
