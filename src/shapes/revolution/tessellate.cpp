#include "shapes/revolution/tessellate.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace vitrine {

namespace {

/// From one ring, and from one sector, to the next the surface turns by no more, however coarse the tolerance.
constexpr double maxTurn = piD / 8;

/// What single precision may move a vertex by, next to zero too.
double roundingOf(const Profile& profile) {
    return std::max(0x1p-23 * profile.size(), double(std::numeric_limits<float>::denorm_min()));
}

/// The least of 1, 2, 3, 4, 6, 8, 12, ... that is not below: rings of few kinds fit each other.
std::uint32_t roundUp(double sectors) {
    std::uint32_t power = 1;
    while (power < sectors)
        power *= 2;
    return power >= 4 && power / 4 * 3 >= sectors ? power / 4 * 3 : power;
}

/// The radius whose arc strays from its chord as far as a triangle edge between two circles does from the cone through
/// them, for the same angle: of |(1-s) a + s b e^(i d)| against (1-s) a + s b, the worst s, to second order in d.
double effectiveRadius(double a, double b) {
    const double roots = std::sqrt(a) + std::sqrt(b);
    return roots > 0 ? 4 * a * b / sqr(roots) : 0;
}

} // namespace

double turnedSize(const Profile& profile) {
    Imath::Box2d box;
    for (const ProfilePart& part : profile.parts()) {
        box.extendBy(part.curve.first());
        box.extendBy(part.curve.last());
    }
    return std::max(2 * box.max.x, box.max.y - box.min.y);
}

double finestTolerance(const Profile& profile) {
    return 2 * roundingOf(profile);
}

/// Vertices of one station, as the triangles on one side of it use them.
struct RevolutionTessellation::Row {
    std::uint32_t first = 0, sectors = 0;
    bool onAxis = false;

    /// A row has both ends of its arc; on the axis it has the middle of every sector.
    std::uint32_t vertices() const { return onAxis ? sectors : sectors + 1; }
};

RevolutionTessellation::RevolutionTessellation(const Profile& profile, double phiMaxDegrees, double tolerance)
    : phiMax_(radians(std::min(phiMaxDegrees, 360.))), isFull_(phiMaxDegrees >= 360),
      insideOut_(profile.drawnInsideOut()) {
    if (!(tolerance > 0) || !std::isfinite(tolerance))
        throw std::invalid_argument(fmt::format("the tolerance must be positive and finite, not {:g}", tolerance));
    if (!(phiMax_ > 0)) throw std::invalid_argument("\"phimax\" must be positive");
    const double rounding = roundingOf(profile);
    if (!(profile.size() <= double(std::numeric_limits<float>::max())))
        throw std::invalid_argument("the shape is too large for the single precision of the vertices");
    if (!(tolerance > finestTolerance(profile)))
        throw std::invalid_argument(fmt::format(
            "the tolerance {:g} is finer than the single precision of the vertices keeps for a shape of this "
            "size; it must be above {:g}",
            tolerance, finestTolerance(profile)));
    // Profile and circle take half each: with errors a + b fixed, the triangles, as 1/sqrt(a b), are then fewest.
    const double half = (tolerance - rounding) / 2;
    constexpr std::size_t mostStations = maxTriangles / 8;
    stations_ = placeStations(profile, half, maxTurn, mostStations);
    planSectors(half);
    if (triangles_ > maxTriangles || vertices_ > maxTriangles)
        throw std::invalid_argument("the tolerance is so small that the mesh would have more than 2^31 triangles");
}

std::uint32_t RevolutionTessellation::sectorsFor(double radius, double tolerance) const {
    // r (1 - cos(step/2)) = tolerance
    const double step = tolerance < 2 * radius ? 4 * std::asin(std::sqrt(tolerance / (2 * radius))) : maxTurn;
    const double sectors = phiMax_ / std::min(step, maxTurn);
    // phiMax over maxTurn may be a whole number, which rounding must not lift.
    return roundUp(sectors * (1 - 1e-12));
}

void RevolutionTessellation::planSectors(double tolerance) {
    const std::size_t n = stations_.size();
    std::vector<double> radius(n);
    for (std::size_t i = 0; i < n; ++i) {
        radius[i] = stations_[i].p.x;
        for (const std::size_t j : {i - 1, i + 1}) // below 0 wraps to above n
            if (j < n) radius[i] = std::max(radius[i], effectiveRadius(stations_[i].p.x, stations_[j].p.x));
    }
    if (stations_.front().p == stations_.back().p)
        radius.front() = radius.back() = std::max(radius.front(), radius.back());
    sectors_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        sectors_[i] = stations_[i].onAxis() ? 0 : sectorsFor(radius[i], tolerance);
    for (std::size_t i = 0; i < n; ++i) {
        if (i + 1 < n) triangles_ += sectors_[i] + std::uint64_t(sectors_[i + 1]);
        for (const Row& row : rows(i))
            vertices_ += row.vertices();
    }
}

/// The rows of a station, the one for the strip before it first; one alone where both strips share it. (Row::first is left
/// to the caller.) A station on the axis has a row a strip, with the sectors of the ring on the other side.
std::vector<RevolutionTessellation::Row> RevolutionTessellation::rows(std::size_t station) const {
    const bool hasBefore = station > 0, hasAfter = station + 1 < stations_.size();
    if (!stations_[station].onAxis()) {
        const Row row{0, sectors_[station], false};
        if (hasBefore && hasAfter && stations_[station].isCrease()) return {row, row};
        return {row};
    }
    std::vector<Row> result;
    if (hasBefore) result.push_back({0, sectors_[station - 1], true});
    if (hasAfter) result.push_back({0, sectors_[station + 1], true});
    return result;
}

void RevolutionTessellation::addRow(const ProfileStation& station, const V2d& tangent, const Row& row,
                                    MeshInput& mesh) const {
    const double sign = insideOut_ ? -1 : 1;
    const V2d n(sign * tangent.y, -sign * tangent.x);
    const float y = float(station.p.y), v = float(station.v);
    for (std::uint32_t i = 0; i < row.vertices(); ++i) {
        const double u = (i + (row.onAxis ? 0.5 : 0.)) / row.sectors;
        // The seam's second side has the very bits of the first.
        const double phi = isFull_ && i == row.sectors ? 0 : u * phiMax_;
        const double c = std::cos(phi), s = std::sin(phi);
        mesh.p.push_back(row.onAxis ? V3f(0, y, 0) : V3f(float(station.p.x * c), y, float(station.p.x * s)));
        mesh.n.emplace_back(float(n.x * c), float(n.y), float(n.x * s));
        mesh.uv.emplace_back(float(u), v);
    }
}

/// Between two rows the next diagonal is always the one that is less oblique.
void RevolutionTessellation::addStrip(const Row& a, const Row& b, MeshInput& mesh) const {
    const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        // (along phi, along the profile) is left-handed seen from outside.
        mesh.triangles.insert(mesh.triangles.end(), {p, insideOut_ ? q : r, insideOut_ ? r : q});
    };
    if (a.onAxis || b.onAxis) {
        if (a.onAxis && b.onAxis) return;
        for (std::uint32_t i = 0; i < a.sectors; ++i)
            if (a.onAxis)
                add(a.first + i, b.first + i + 1, b.first + i);
            else
                add(a.first + i, a.first + i + 1, b.first + i);
        return;
    }
    std::uint64_t i = 0, j = 0;
    const std::uint64_t na = a.sectors, nb = b.sectors;
    while (i < na || j < nb) {
        // Angles in parts of 1/(na nb).
        const auto oblique = [&](std::uint64_t x, std::uint64_t y) {
            return std::abs(std::int64_t(x * nb) - std::int64_t(y * na));
        };
        const std::uint32_t pa = a.first + std::uint32_t(i), pb = b.first + std::uint32_t(j);
        if (j == nb || (i < na && oblique(i + 1, j) <= oblique(i, j + 1))) {
            add(pa, pa + 1, pb);
            ++i;
        } else {
            add(pa, pb + 1, pb);
            ++j;
        }
    }
}

MeshInput RevolutionTessellation::mesh() const {
    MeshInput mesh;
    mesh.p.reserve(vertices_ + 1); // makeMeshShapes adds one
    mesh.n.reserve(vertices_);
    mesh.uv.reserve(vertices_);
    mesh.triangles.reserve(3 * triangles_);
    Row before;
    for (std::size_t k = 0; k < stations_.size(); ++k) {
        std::vector<Row> both = rows(k);
        for (std::size_t side = 0; side < both.size(); ++side) {
            both[side].first = std::uint32_t(mesh.p.size());
            const bool arriving = side == 0 && k > 0;
            addRow(stations_[k], arriving ? stations_[k].tangentIn : stations_[k].tangentOut, both[side], mesh);
        }
        if (k > 0) addStrip(before, both.front(), mesh);
        before = both.back();
    }
    return mesh;
}

MeshInput tessellate(const Profile& profile, double phiMaxDegrees, double tolerance) {
    return RevolutionTessellation(profile, phiMaxDegrees, tolerance).mesh();
}

double toleranceForTriangles(const Profile& profile, double phiMaxDegrees, std::uint64_t triangles) {
    const auto fits = [&](double tolerance) {
        return RevolutionTessellation(profile, phiMaxDegrees, tolerance).triangleCount() <= triangles;
    };
    double high = turnedSize(profile), low = 2 * finestTolerance(profile);
    if (!fits(high))
        throw std::invalid_argument(fmt::format("the coarsest mesh of the profile has {} triangles, more than {}",
                                                RevolutionTessellation(profile, phiMaxDegrees, high).triangleCount(),
                                                triangles));
    if (fits(low)) return low;
    while (high > 1.001 * low) {
        const double middle = std::sqrt(low * high);
        (fits(middle) ? high : low) = middle;
    }
    return high;
}

} // namespace vitrine
