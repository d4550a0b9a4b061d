// VITRINE_LONG=n multiplies the work of long random comparisons.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace vitrine::test {

inline int longRun() {
    const char* text = std::getenv("VITRINE_LONG");
    return text ? std::max(1, std::atoi(text)) : 1;
}

} // namespace vitrine::test
