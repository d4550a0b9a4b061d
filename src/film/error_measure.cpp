#include "film/error_measure.h"

#include <algorithm>
#include <numeric>

namespace vitrine {

std::vector<std::size_t> withoutLargest(std::span<const double> values) {
    std::vector<std::size_t> kept(values.size());
    std::iota(kept.begin(), kept.end(), std::size_t(0));
    const std::size_t count = values.size() - values.size() / 1000;
    std::nth_element(kept.begin(), kept.begin() + std::ptrdiff_t(count), kept.end(), [&](std::size_t a, std::size_t b) {
        return values[a] != values[b] ? values[a] < values[b] : a < b;
    });
    kept.resize(count);
    // A fixed order, so that sums over the rest have the same bits everywhere.
    std::sort(kept.begin(), kept.end());
    return kept;
}

} // namespace vitrine
