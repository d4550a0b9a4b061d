// The error of evaluating Bezier curves in the Bernstein basis and in the power basis, held against de Casteljau in a
// hundred digits, and what each costs: the tables of docs/revolution.md, section "Evaluation".
#include "../tests/support/exact_bezier.h"
#include "core/random.h"
#include "shapes/revolution/bezier_curve.h"

#include <chrono>
#include <cstdio>

namespace {

using namespace vitrine;
using namespace vitrine::test;

constexpr int curves = 20, parameters = 25;

/// Wild: points anywhere in a square. Calm: points along a line, off it by a tenth at most, as one draws a profile.
std::vector<V2d> randomPoints(RandomStream& random, int degree, bool calm) {
    std::vector<V2d> points;
    for (int i = 0; i <= degree; ++i) {
        const double along = double(i) / degree;
        points.push_back(calm ? V2d(0.5 + random.uniform(-0.1, 0.1), along + random.uniform(-0.1, 0.1))
                              : V2d(random.uniform(-1, 1), random.uniform(-1, 1)));
    }
    return points;
}

struct Errors {
    std::vector<double> values;

    void add(const V2d& p, const ExactPoint& exact, double size) {
        constexpr double eps = std::numeric_limits<double>::epsilon();
        values.push_back(error(p, exact) / (eps * size));
    }
    double largest() const { return *std::max_element(values.begin(), values.end()); }
    double median() {
        std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
        return values[values.size() / 2];
    }
};

template <class Form>
double nanoseconds(const std::vector<Form>& forms) {
    double best = 1e9, sum = 0;
    constexpr int rounds = 7, repeats = 2000;
    for (int round = 0; round < rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < repeats; ++i)
            for (const Form& form : forms) {
                const CurvePoint c = form.evaluate(0.1 + 0.8 * i / repeats);
                sum += c.p.x + c.d1.y + c.d2.x;
            }
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        best = std::min(best, time.count() / (repeats * double(forms.size())));
    }
    return std::isfinite(sum) ? best : 0;
}

void row(int degree, bool calm) {
    RandomStream random(20240601, degree, calm);
    Errors stable[3], middle[3], end;
    int picked = 0;
    std::vector<BernsteinForm> bernsteinForms;
    std::vector<PowerForm> powerForms;
    for (int i = 0; i < curves; ++i) {
        const std::vector<V2d> points = randomPoints(random, degree, calm);
        const BernsteinForm bernstein(points);
        const PowerForm aboutMiddle(points), aboutEnd(points, 0);
        picked += BezierCurve(points).usesPowerBasis();
        std::vector<ExactPoint> exact[3];
        for (int order = 0; order < 3; ++order)
            exact[order] = exactHodograph(points, order);
        for (int k = 0; k < parameters; ++k) {
            const double t = random.uniformDouble();
            const CurvePoint b = bernstein.evaluate(t), m = aboutMiddle.evaluate(t);
            const V2d byBernstein[3] = {b.p, b.d1, b.d2}, byPower[3] = {m.p, m.d1, m.d2};
            for (int order = 0; order < std::min(3, degree + 1); ++order) {
                const ExactPoint c = exactPoint(exact[order], t);
                const double size = largest(exact[order]);
                stable[order].add(byBernstein[order], c, size);
                middle[order].add(byPower[order], c, size);
                if (order == 0) end.add(aboutEnd.point(t), c, size);
            }
        }
        bernsteinForms.push_back(bernstein);
        powerForms.push_back(aboutMiddle);
    }
    std::printf("| %d |", degree);
    for (Errors* e : {&stable[0], &middle[0], &end})
        std::printf(" %.2g / %.2g |", e->largest(), e->median());
    for (int order = 1; order < 3; ++order)
        for (Errors* e : {&stable[order], &middle[order]})
            e->values.empty() ? std::printf(" |") : std::printf(" %.2g |", e->largest());
    std::printf(" %.0f / %.0f | %d %% |\n", nanoseconds(bernsteinForms), nanoseconds(powerForms),
                100 * picked / curves);
    std::fflush(stdout);
}

} // namespace

int main() {
    for (const bool calm : {false, true}) {
        std::printf("%s curves\n\n| n | p: Bernstein | p: power, middle | p: power, end | p': Bernstein | p': power "
                    "| p'': Bernstein | p'': power | ns | picks power |\n|--|--|--|--|--|--|--|--|--|--|\n",
                    calm ? "\nCalm" : "Wild");
        for (int degree = 1; degree <= BezierCurve::maxDegree; ++degree)
            if (!calm || degree <= 12 || degree % 6 == 0) row(degree, calm);
    }
}
