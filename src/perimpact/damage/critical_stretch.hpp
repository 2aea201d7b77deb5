/// A bond breaks for ever when its stretch exceeds a critical value, in tension only (Silling & Askari, Comput. Struct. 83 (2005) 1526).
#pragma once

namespace perimpact {

class CriticalStretch {
 public:
  explicit CriticalStretch(double stretch) : stretch_(stretch) {}  ///< [-]

  double longest() const { return 1 + stretch_; }  ///< [-] of the first length

  /// Squared length [m²] beyond which a bond of the given first length [m] breaks: no root is needed to ask.
  double squared_limit(double length) const {
    const double limit = (1 + stretch_) * length;
    return limit * limit;
  }

 private:
  double stretch_;
};

}  // namespace perimpact
