// Mean of random values and how sure it is.
#pragma once

#include <algorithm>

namespace vitrine::test {

struct Estimate {
    double sum = 0, sum2 = 0;
    int n = 0;

    void add(double x) {
        sum += x;
        sum2 += x * x;
        ++n;
    }
    double mean() const { return sum / n; }
    /// Unbiased; needs two values.
    double varianceOfMean() const { return std::max(0., sum2 / n - mean() * mean()) / (n - 1); }
};

} // namespace vitrine::test
