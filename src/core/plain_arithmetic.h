// The same floating-point arithmetic on every thread.
#pragma once

#include <xmmintrin.h>

namespace vitrine {

/// Rounding and denormal numbers as IEEE 754 has them, for as long as this lives. TBB runs tasks with the settings of
/// whoever used its scheduler first, and Embree does so with denormals flushed: no picture shall depend on that.
class PlainArithmetic {
  public:
    PlainArithmetic() : before_(_mm_getcsr()) { _mm_setcsr(0x1f80); }
    ~PlainArithmetic() { _mm_setcsr(before_); }
    PlainArithmetic(const PlainArithmetic&) = delete;
    PlainArithmetic& operator=(const PlainArithmetic&) = delete;

  private:
    unsigned before_;
};

} // namespace vitrine
