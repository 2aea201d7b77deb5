/// The number of threads of parallel loops. OpenMP has one number for each thread that begins such loops; this one is for all threads of Python.
#pragma once

namespace perimpact::python {

/// Throws InputError for a number that the command line refuses too.
void choose_threads(long long count);
/// Call before parallel loops: the calling thread uses the number that was chosen, if any.
void use_chosen_threads();

}  // namespace perimpact::python
