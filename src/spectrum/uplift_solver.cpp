#include "spectrum/uplift_solver.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace vitrine {

namespace {

#include "spectrum/data/cie1931.inc"

using Triple = UpliftSolver::Triple;
using Matrix = UpliftSolver::Matrix;

constexpr double lambdaStart = 360, lambdaRange = 470;
/// Steeper sigmoids cannot be told from steps, and float could not hold their polynomials.
constexpr double largestCoefficient = 1e5;
constexpr double reached = 1e-6;

/// A table of 5 nm steps from 360 nm, linear between its entries.
template <class Entry>
double interpolate(Entry&& entry, double lambda) {
    const double position = (lambda - lambdaStart) / 5;
    const std::size_t i = std::min(std::size_t(position), std::size_t(93));
    const double f = position - double(i);
    return (1 - f) * double(entry(i)) + f * double(entry(i + 1));
}

/// CIELAB's compressed response and its derivative.
std::pair<double, double> compress(double t) {
    constexpr double delta = 6. / 29;
    if (t <= delta * delta * delta) return {t / (3 * delta * delta) + 4. / 29, 1 / (3 * delta * delta)};
    const double root = std::cbrt(t);
    return {root, 1 / (3 * root * root)};
}

/// L*, a*, b* from the compressed responses.
Triple labOf(const Triple& f) {
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// Solves a x = b by elimination with partial pivoting. \returns false when a is singular.
bool solveLinear(Matrix a, Triple b, Triple& x) {
    for (std::size_t column = 0; column < 3; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < 3; ++row)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        if (!(std::abs(a[pivot][column]) > 1e-30)) return false;
        std::swap(a[column], a[pivot]);
        std::swap(b[column], b[pivot]);
        for (std::size_t row = column + 1; row < 3; ++row) {
            const double factor = a[row][column] / a[column][column];
            for (std::size_t k = column; k < 3; ++k)
                a[row][k] -= factor * a[column][k];
            b[row] -= factor * b[column];
        }
    }
    for (std::size_t row = 3; row-- > 0;) {
        double sum = b[row];
        for (std::size_t k = row + 1; k < 3; ++k)
            sum -= a[row][k] * x[k];
        x[row] = sum / a[row][row];
    }
    return true;
}

/// The step x of Levenberg and Marquardt: (J^T J + damping diag(J^T J)) x = J^T r; of Gauss and Newton if damping is 0.
bool step(const Matrix& jacobian, const Triple& residual, double damping, Triple& x) {
    if (damping == 0) return solveLinear(jacobian, residual, x);
    Matrix normal{};
    Triple right{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            right[j] += jacobian[i][j] * residual[i];
            for (std::size_t k = 0; k < 3; ++k)
                normal[j][k] += jacobian[i][j] * jacobian[i][k];
        }
    for (std::size_t j = 0; j < 3; ++j)
        normal[j][j] *= 1 + damping;
    return solveLinear(normal, right, x);
}

} // namespace

UpliftSolver::UpliftSolver(const Matrix& xyzFromRgb, std::span<const float> illuminant) {
    // Matching functions and illuminant are linear over each 5 nm, the reflectance is not: Simpson's 3/8 rule, three
    // intervals to 5 nm (section 4.1 of the paper's code).
    const double interval = lambdaRange / double(samples - 1);
    const float* const matching[3] = {cie1931x, cie1931y, cie1931z};
    Triple white{};
    for (std::size_t i = 0; i < samples; ++i) {
        const double lambda = lambdaStart + double(i) * interval;
        double rule = 3. / 8 * interval;
        if (i > 0 && i < samples - 1) rule *= i % 3 == 0 ? 2 : 3;
        const double power = interpolate([&](std::size_t k) { return illuminant[k]; }, lambda);
        t_[i / 4][i % 4] = (lambda - lambdaStart) / lambdaRange;
        for (std::size_t j = 0; j < 3; ++j) {
            const double response = interpolate([&](std::size_t k) { return matching[j][5 * k]; }, lambda);
            weight_[j][i / 4][i % 4] = rule * power * response;
            white[j] += rule * power * response;
        }
    }
    for (std::size_t j = 0; j < 3; ++j) {
        for (auto& quad : weight_[j])
            quad /= white[j];
        for (std::size_t k = 0; k < 3; ++k)
            relativeFromRgb_[j][k] = xyzFromRgb[j][k] * (white[1] / white[j]);
    }
}

UpliftSolver::Response UpliftSolver::respond(const Triple& c) const {
    Quad value[3]{}, first[3]{}, second[3]{}, third[3]{};
    for (std::size_t i = 0; i < quads; ++i) {
        const Quad t = t_[i];
        const Quad x = (c[0] * t + c[1]) * t + c[2];
        Quad root = 1 + x * x;
        for (int lane = 0; lane < 4; ++lane)
            root[lane] = std::sqrt(root[lane]);
        const Quad inverse = 1 / root;
        const Quad sigmoid = 0.5 * x * inverse + 0.5;
        const Quad slope = 0.5 * inverse * inverse * inverse;
        for (std::size_t j = 0; j < 3; ++j) {
            const Quad w = weight_[j][i], d2 = w * slope, d1 = d2 * t;
            value[j] += w * sigmoid;
            third[j] += d2;
            second[j] += d1;
            first[j] += d1 * t;
        }
    }
    const auto sum = [](const Quad& q) { return (q[0] + q[1]) + (q[2] + q[3]); };
    Response response;
    for (std::size_t j = 0; j < 3; ++j) {
        response.value[j] = sum(value[j]);
        response.derivative[j] = {sum(first[j]), sum(second[j]), sum(third[j])};
    }
    return response;
}

UpliftSolver::Fit UpliftSolver::fit(const Triple& coefficients, const Triple& wantedLab) const {
    const Response response = respond(coefficients);
    Fit fit;
    Triple f, slope;
    for (std::size_t j = 0; j < 3; ++j)
        std::tie(f[j], slope[j]) = compress(response.value[j]);
    const Triple lab = labOf(f);
    for (std::size_t j = 0; j < 3; ++j) {
        fit.residual[j] = wantedLab[j] - lab[j];
        fit.squared += fit.residual[j] * fit.residual[j];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double dx = slope[0] * response.derivative[0][k], dy = slope[1] * response.derivative[1][k],
                     dz = slope[2] * response.derivative[2][k];
        fit.jacobian[0][k] = 116 * dy;
        fit.jacobian[1][k] = 500 * (dx - dy);
        fit.jacobian[2][k] = 200 * (dy - dz);
    }
    return fit;
}

UpliftSolver::Triple UpliftSolver::labOfRgb(const Triple& rgb) const {
    Triple f;
    for (std::size_t j = 0; j < 3; ++j) {
        const auto& row = relativeFromRgb_[j];
        f[j] = compress(row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]).first;
    }
    return labOf(f);
}

double UpliftSolver::improve(const Triple& rgb, Triple& coefficients) const {
    const Triple wantedLab = labOfRgb(rgb);
    Fit now = fit(coefficients, wantedLab);
    double damping = 0;
    for (int iteration = 0; iteration < 50 && damping < 1e6; ++iteration) {
        Triple change, next = coefficients;
        const bool solved = step(now.jacobian, now.residual, damping, change);
        for (std::size_t j = 0; solved && j < 3; ++j)
            next[j] += change[j];
        const bool inRange =
            std::all_of(next.begin(), next.end(), [](double c) { return std::abs(c) < largestCoefficient; });
        const Fit trial = solved && inRange ? fit(next, wantedLab) : now;
        // Convergence is quadratic: one step from here on nothing is left to gain.
        const bool last =
            now.squared < reached || (trial.squared < now.squared && trial.squared > now.squared * (1 - 1e-6));
        if (trial.squared < now.squared) {
            coefficients = next;
            now = trial;
            damping = damping < 1e-4 ? 0 : damping * 0.1;
        } else {
            damping = damping == 0 ? 1e-3 : damping * 10;
        }
        if (last) break;
    }
    return now.squared;
}

UpliftSolver::Triple UpliftSolver::solve(const Triple& rgb) const {
    const double grey = std::clamp((rgb[0] + rgb[1] + rgb[2]) / 3, 0.01, 0.99);
    Triple coefficients{0, 0, (grey - 0.5) / std::sqrt(grey * (1 - grey))};
    // By way of the colour half as saturated: from there the strongest ones are reached more surely.
    improve({(grey + rgb[0]) / 2, (grey + rgb[1]) / 2, (grey + rgb[2]) / 2}, coefficients);
    improve(rgb, coefficients);
    return coefficients;
}

std::array<float, 3> UpliftSolver::inNanometres(const Triple& c) {
    constexpr double s = 1 / lambdaRange, s2 = s * s;
    return {float(c[0] * s2), float(c[1] * s - 2 * c[0] * lambdaStart * s2),
            float(c[2] - c[1] * lambdaStart * s + c[0] * lambdaStart * lambdaStart * s2)};
}

} // namespace vitrine
