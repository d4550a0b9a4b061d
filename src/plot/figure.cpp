#include "plot/figure.h"

namespace vitrine::plot {

namespace {

constexpr double tolerance = 0.02; ///< of simplified lines, in points: far below what eye or printer resolves

double distanceToSegment(const V2d& p, const V2d& a, const V2d& b) {
    const V2d d = b - a;
    const double length2 = d.length2();
    const double t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0., 1.) : 0;
    return (p - (a + d * t)).length();
}

/// Douglas & Peucker 1973: appends the points between `first` and `last` (exclusive) that the line needs.
void keepNeeded(const std::vector<V2d>& points, std::size_t first, std::size_t last, std::vector<V2d>& kept) {
    std::size_t farthest = first;
    double distance = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
        if (const double d = distanceToSegment(points[i], points[first], points[last]); d > distance) {
            distance = d;
            farthest = i;
        }
    if (farthest == first) return;
    keepNeeded(points, first, farthest, kept);
    kept.push_back(points[farthest]);
    keepNeeded(points, farthest, last, kept);
}

} // namespace

void Figure::add(Line line) {
    if (line.points.size() > 2) {
        std::vector<V2d> kept{line.points.front()};
        keepNeeded(line.points, 0, line.points.size() - 1, kept);
        kept.push_back(line.points.back());
        line.points = std::move(kept);
    }
    items_.emplace_back(std::move(line));
}

std::vector<TextRun> textRuns(const std::string& marked) {
    std::vector<TextRun> runs(1);
    const auto change = [&](bool italic, int level) {
        if (runs.back().text.empty()) runs.pop_back();
        runs.push_back({{}, italic, level});
    };
    for (std::size_t i = 0; i < marked.size(); ++i) {
        const char c = marked[i];
        const TextRun& now = runs.back();
        if (c == '\\' && i + 1 < marked.size())
            runs.back().text += marked[++i];
        else if (c == '*')
            change(!now.italic, now.level);
        else if ((c == '_' || c == '^') && i + 1 < marked.size() && marked[i + 1] == '{')
            change(now.italic, marked[i++] == '_' ? -1 : 1);
        else if (c == '}' && now.level != 0)
            change(now.italic, 0);
        else
            runs.back().text += c;
    }
    if (runs.back().text.empty()) runs.pop_back();
    return runs;
}

std::string unmarked(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\' || c == '*' || c == '_' || c == '^' || c == '}') result += '\\';
        result += c;
    }
    return result;
}

} // namespace vitrine::plot
