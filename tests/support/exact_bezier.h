// A Bezier curve in a hundred decimal digits, by de Casteljau.
#pragma once

#include "core/vec.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <vector>

namespace vitrine::test {

using Exact = boost::multiprecision::cpp_bin_float_100;

struct ExactPoint {
    Exact x, y;
};

/// Control points of the derivative of the given order, without rounding.
inline std::vector<ExactPoint> exactHodograph(const std::vector<V2d>& points, int order) {
    std::vector<ExactPoint> c;
    for (const V2d& p : points)
        c.push_back({p.x, p.y});
    for (; order > 0 && c.size() > 1; --order) {
        const double n = double(c.size()) - 1;
        for (std::size_t i = 0; i + 1 < c.size(); ++i)
            c[i] = {n * (c[i + 1].x - c[i].x), n * (c[i + 1].y - c[i].y)};
        c.pop_back();
    }
    return order > 0 ? std::vector<ExactPoint>{{0, 0}} : c;
}

inline ExactPoint exactPoint(std::vector<ExactPoint> c, const Exact& t) {
    const Exact u = 1 - t;
    for (; c.size() > 1; c.pop_back())
        for (std::size_t i = 0; i + 1 < c.size(); ++i) {
            c[i].x = u * c[i].x + t * c[i + 1].x;
            c[i].y = u * c[i].y + t * c[i + 1].y;
        }
    return c[0];
}

/// Of the larger coordinate.
inline double error(const V2d& p, const ExactPoint& exact) {
    const Exact x = abs(Exact(p.x) - exact.x), y = abs(Exact(p.y) - exact.y);
    return double(x > y ? x : y);
}

/// The largest absolute coordinate: what errors are measured by.
inline double largest(const std::vector<ExactPoint>& points) {
    Exact size = 0;
    for (const ExactPoint& p : points)
        for (const Exact& c : {p.x, p.y})
            if (abs(c) > size) size = abs(c);
    return double(size);
}

} // namespace vitrine::test
