// Four doubles that are worked on together.
#pragma once

#include <cmath>

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace vitrine {

using Lanes [[gnu::vector_size(32)]] = double;

inline Lanes broadcast(double x) {
    return Lanes{x, x, x, x};
}

/// a b + c, rounded once in every lane.
inline Lanes fusedMultiplyAdd(Lanes a, Lanes b, Lanes c) {
#ifdef __FMA__
    return Lanes(_mm256_fmadd_pd(__m256d(a), __m256d(b), __m256d(c)));
#else
    return Lanes{std::fma(a[0], b[0], c[0]), std::fma(a[1], b[1], c[1]), std::fma(a[2], b[2], c[2]),
                 std::fma(a[3], b[3], c[3])};
#endif
}

inline Lanes lesser(Lanes a, Lanes b) {
    return a < b ? a : b;
}

inline Lanes greater(Lanes a, Lanes b) {
    return a > b ? a : b;
}

/// Bit i is set where lane i of a is less than lane i of b.
inline unsigned lessMask(Lanes a, Lanes b) {
#ifdef __AVX2__
    return unsigned(_mm256_movemask_pd(__m256d(a < b)));
#else
    unsigned mask = 0;
    for (int i = 0; i < 4; ++i)
        mask |= unsigned(a[i] < b[i]) << i;
    return mask;
#endif
}

} // namespace vitrine
