// make_uplift_table FILE: writes the UpliftTable of sRGB. Runs when the library is built; the result does not depend on
// the number of threads.
#include "spectrum/uplift_solver.h"
#include "spectrum/uplift_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

using namespace vitrine;

namespace {

#include "spectrum/data/illuminants.inc"

/// XYZ of linear sRGB, to the six digits that the paper's code and pbrt-v4's table were made with.
constexpr UpliftSolver::Matrix xyzFromSrgb{
    {{0.412453, 0.357580, 0.180423}, {0.212671, 0.715160, 0.072169}, {0.019334, 0.119193, 0.950227}}};

constexpr int resolution = UpliftTable::resolution;

class TableMaker {
  public:
    TableMaker() : solver_(xyzFromSrgb, std::span(illuminantD65).subspan(12)) {
        // Smoothstep twice: dense at both ends, where the coefficients change fastest.
        const auto smoothstep = [](double x) { return x * x * (3 - 2 * x); };
        for (int k = 0; k < resolution; ++k)
            table_->nodes[k] = float(smoothstep(smoothstep(double(k) / (resolution - 1))));
    }

    const UpliftTable& fill() {
        std::vector<std::thread> threads;
        const int count = std::max(1, int(std::thread::hardware_concurrency()));
        for (int first = 0; first < count; ++first)
            threads.emplace_back([this, first, count] {
                for (int row = first; row < 3 * resolution; row += count)
                    for (int i = 0; i < resolution; ++i)
                        fillColumn(row / resolution, row % resolution, i);
            });
        for (auto& thread : threads)
            thread.join();
        return *table_;
    }

  private:
    /// One chromaticity at all brightnesses. A rather dark colour is reached from any start; each further one starts
    /// from its neighbour's solution.
    void fillColumn(int largest, int j, int i) {
        constexpr int start = resolution / 5;
        UpliftSolver::Triple coefficients{};
        for (int k = start; k < resolution; ++k)
            solveCell(largest, k, j, i, coefficients);
        coefficients = {};
        for (int k = start; k >= 0; --k) {
            // Far below zero the sigmoid goes as 1/(4 x^2): a darker colour is the same polynomial, scaled. Black itself
            // has no finite solution, and is given the polynomial of a sixteenth of the first node.
            if (k < start) {
                const double ratio = k > 0 ? double(table_->nodes[k + 1]) / double(table_->nodes[k]) : 16;
                for (double& c : coefficients)
                    c *= std::sqrt(ratio);
            }
            if (k > 0) solveCell(largest, k, j, i, coefficients);
        }
        store(largest, 0, j, i, coefficients);
    }

    void solveCell(int largest, int k, int j, int i, UpliftSolver::Triple& coefficients) {
        const double z = double(table_->nodes[k]);
        UpliftSolver::Triple rgb;
        rgb[std::size_t(largest)] = z;
        rgb[std::size_t(largest + 1) % 3] = z * i / (resolution - 1);
        rgb[std::size_t(largest + 2) % 3] = z * j / (resolution - 1);
        solver_.improve(rgb, coefficients);
        store(largest, k, j, i, coefficients);
    }

    void store(int largest, int k, int j, int i, const UpliftSolver::Triple& coefficients) {
        const auto c = UpliftSolver::inNanometres(coefficients);
        std::copy(c.begin(), c.end(), table_->coefficients[largest][k][j][i]);
    }

    UpliftSolver solver_;
    std::unique_ptr<UpliftTable> table_ = std::make_unique<UpliftTable>();
};

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_uplift_table FILE\n");
        return 1;
    }
    TableMaker maker;
    const UpliftTable& table = maker.fill();
    std::ofstream out(argv[1], std::ios::binary);
    out.write(reinterpret_cast<const char*>(&table), sizeof table);
    if (!out.flush()) {
        std::fprintf(stderr, "make_uplift_table: cannot write %s\n", argv[1]);
        return 1;
    }
}
