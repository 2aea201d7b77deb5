/// Calls of functions that Python has given to a simulation: user forces and structures.
#pragma once

#include <exception>
#include <string>

#include "arrays.hpp"
#include "turns.hpp"

namespace perimpact::python {

class UserCalls {
 public:
  explicit UserCalls(Turns& turns) : turns_(turns) {}

  /// f() with the GIL. In a step, an exception is kept, and a RunError with its sentence is thrown instead, with which the results end as those of a failed
  /// run. `what`: the function, in this sentence.
  template <class F>
  auto call(const std::string& what, const F& f) {
    const py::gil_scoped_acquire acquire;
    if (!turns_.is_in_step()) return f();  // while the simulation is built
    const Turns::Call call(turns_);
    try {
      return f();
    } catch (const py::error_already_set& error) {
      fail(sentence_of(what, error));
    } catch (const std::exception& error) {
      fail(error.what());
    }
  }

  /// Throws the exception that was kept, if any.
  void rethrow();

 private:
  static std::string sentence_of(const std::string& what, const py::error_already_set& error);
  [[noreturn]] void fail(const std::string& sentence);

  Turns& turns_;
  std::exception_ptr kept_;
};

}  // namespace perimpact::python
