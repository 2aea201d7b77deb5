/// How the power of a record is spread over frequencies.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace perimpact {

/// X_k = Σ x_n exp(-2πi kn/N), in place; N is a power of two (Cooley and Tukey, Math. Comput. 19 (1965) 297).
void fourier_transform(std::span<std::complex<double>> x);

/// One-sided power spectral density P(f) [square of the unit, per Hz]: the integral of P over a band is the mean square that frequencies of that
/// band contribute, and that over all is the variance.
struct Spectrum {
  double interval;              ///< [s] between the values of the record
  std::size_t segment;          ///< values of a segment, a power of two
  std::size_t segments;         ///< that were averaged
  std::vector<double> density;  ///< at k/(segment · interval) [Hz], k = 0 … segment/2

  double resolution() const { return 1 / (interval * static_cast<double>(segment)); }  ///< [Hz]
  double frequency(std::size_t k) const { return static_cast<double>(k) * resolution(); }
  std::size_t highest() const;  ///< the k > 0 of the largest density; 0 where all are 0
};

/// Welch's method (IEEE Trans. Audio Electroacoust. 15 (1967) 70): Hann windows w that overlap by one half, the mean of each segment removed,
///
///   P_k = c_k Δt |Σ w_n (x_n - x̄) exp(-2πi kn/N)|² / Σ w_n²,    c_0 = c_{N/2} = 1, otherwise 2
///
/// averaged over the segments. What is left at the end, shorter than half a segment, is not used. `segment`: a power of two, at most the number
/// of values.
Spectrum welch(std::span<const double> values, double interval, std::size_t segment);

/// The segment where none is asked for: the longest power of two of which seven fit with their overlap, but 32 values at least where there are as
/// many. More segments make the density smoother, longer ones resolve finer frequencies.
std::size_t default_segment(std::size_t values);

}  // namespace perimpact
