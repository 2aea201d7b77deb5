#include "fccda/c/guarded.hpp"

#include <exception>
#include <new>

#include "base/parallel.hpp"

namespace fccda::c_interface {

namespace {

thread_local std::string last_error;

/// Remedies in the words of C.
constexpr AdviceWords c_words{
    .declare_orientation = "with the orientation of fccda_surface_options, FCCDA_NORMALS (the one that the normals point to) or FCCDA_REVERSED",
    .cut_open = "with the orientation of fccda_surface_options, FCCDA_NORMALS (the side that the normals point to)",
    .clip = "pass FCCDA_IGNORE_BEYOND"};

fccda_status failed(fccda_status status, const std::string& sentence) {
  last_error = sentence;
  return status;
}

fccda_status rethrown() {
  try {
    throw;
  } catch (const InputError& error) {
    return failed(FCCDA_INPUT_ERROR, error.in_words_of(c_words));
  } catch (const RunError& error) {
    return failed(FCCDA_RUN_ERROR, error.what());
  } catch (const std::bad_alloc&) {
    return failed(FCCDA_INTERNAL_ERROR, "fccda: there is not enough memory; use fewer points or panels.");
  } catch (const std::exception& error) {
    return failed(FCCDA_INTERNAL_ERROR, std::string("fccda: unexpected failure: ") + error.what());
  } catch (...) {
    return failed(FCCDA_INTERNAL_ERROR, "fccda: unexpected failure.");
  }
}

}  // namespace

fccda_status status_of_exception() noexcept {
  try {
    return rethrown();
  } catch (...) {  // no memory for the sentence
    last_error.clear();
    return FCCDA_INTERNAL_ERROR;
  }
}

}  // namespace fccda::c_interface

using namespace fccda;
using namespace fccda::c_interface;

int fccda_abi_version(void) { return FCCDA_ABI_VERSION; }

const char* fccda_version(void) { return FCCDA_VERSION; }

const char* fccda_last_error(void) { return last_error.c_str(); }

fccda_status fccda_use_threads(int32_t count) {
  return guarded([&] {
    if (count < 1) throw InputError("fccda: the number of threads is " + std::to_string(count) + ", but it must be at least 1.");
    use_threads(count);
  });
}
