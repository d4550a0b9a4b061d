// Campaigns of random (profile, ray) pairs against the oracles of tests/support, the parity of rays through the closed
// goblet, and what the 2018 system's Newton method misses. See docs/revolution.md.
#include "shapes/revolution/revolution.h"
#include "support/newton2018.h"
#include "support/revolution_campaign.h"
#include "support/revolution_exact.h"

#include <CLI/CLI.hpp>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>

namespace {

using namespace vitrine;
using namespace vitrine::test;

struct Options {
    long pairs = 0, parity = 0, newton = 0;
    std::string oracle = "exact", commit = "unknown";
    std::uint64_t seed = 20260201, firstBlock = 0;
    int threads = 1;
};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void tell(const std::string& text) {
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
}

/// All blocks, by number, on some threads; sums and maxima do not depend on who ran which.
template <class Tally, class RunBlock, class Line>
Tally runBlocks(long blocks, const Options& options, RunBlock&& runBlock, Line&& line) {
    Tally total;
    std::mutex mutex;
    std::atomic<long> next = 0;
    long done = 0;
    const auto start = std::chrono::steady_clock::now();
    const auto work = [&] {
        for (long block; (block = next++) < blocks;) {
            const Tally tally = runBlock(std::uint64_t(block));
            const std::lock_guard lock(mutex);
            total.add(tally);
            if (++done % std::max(1L, blocks / 20) == 0 || done == blocks)
                std::printf("[%s] %5.1f %% %7.0f s  %s\n", options.commit.c_str(), 100. * double(done) / double(blocks),
                            secondsSince(start), line(total).c_str()),
                    std::fflush(stdout);
        }
    };
    std::vector<std::thread> threads;
    for (int i = 1; i < options.threads; ++i)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads)
        thread.join();
    return total;
}

std::string lineOf(const CampaignTally& t) {
    return fmt::format("pairs {} with hits {} crossings {} excused {} (noisy {}, most {}) missed {} spurious {} off "
                       "surface {} wrong first/any "
                       "{} worst backward error {:.2f} (point) {:.2f} (ray) n eps",
                       t.pairs, t.pairsWithHits, t.crossings, t.excused, t.noisyTouches, t.mostAtATouch, t.missed,
                       t.spurious, t.offSurface, t.wrongInInterval, t.worstPoint, t.worstOnRay);
}

bool runPairs(const Options& options) {
    const bool exact = options.oracle == "exact";
    const int raysEach = exact ? 50 : 4000;
    const Campaign campaign(exact ? OracleKind::Exact : OracleKind::Slow, options.seed, raysEach, tell);
    const CampaignTally t = runBlocks<CampaignTally>(
        (options.pairs + raysEach - 1) / raysEach, options,
        [&](std::uint64_t block) { return campaign.runBlock(options.firstBlock + block); }, lineOf);
    std::printf(
        "\n%ld profiles refused; %ld pairs looked at closely, in %ld the slow solver was wrong outside the band; "
        "%ld first-hit and any-hit calls\n",
        t.refused, t.judged, t.overruled, t.intervals);
    std::printf("\n| rays | pairs | in the band and not alike |\n|---|---:|---:|\n");
    for (int i = 0; i < rayKinds; ++i)
        std::printf("| %s | %ld | %ld |\n", toString(RayKind(i)), t.pairsByKind[std::size_t(i)],
                    t.excusedByKind[std::size_t(i)]);
    std::printf("\n| degree | pairs | with hits |\n|---:|---:|---:|\n");
    for (std::size_t n = 1; n <= 20; ++n)
        std::printf("| %zu | %ld | %ld |\n", n, t.pairsByDegree[n], t.hitsByDegree[n]);
    return t.isClean();
}

bool runParity(const Options& options) {
    constexpr int raysEach = 10000;
    const ParityTally t = runBlocks<ParityTally>(
        (options.parity + raysEach - 1) / raysEach, options,
        [&](std::uint64_t block) { return runParityBlock(options.seed, block, raysEach, tell); },
        [](const ParityTally& p) {
            return fmt::format(
                "rays {} with hits {} crossings {} odd {} wrong walks {} wrong normals {} grazing {} rounded {}",
                p.rays, p.raysWithHits, p.crossings, p.odd, p.wrongWalk, p.wrongNormal, p.grazing, p.rounded);
        });
    return t.isClean();
}

/// Of rays that hit, the share whose first hit Newton does not find, by degree and number of starts.
void runNewton(const Options& options) {
    constexpr int starts[] = {5, 10, 20, 40}, raysEach = 200;
    std::printf("| degree | rays that hit |");
    for (const int count : starts)
        std::printf(" %d starts |", count);
    std::printf("\n|---:|---:|---:|---:|---:|---:|\n");
    for (const int degree : {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20}) {
        long rays = 0, missed[std::size(starts)] = {};
        for (long block = 0; block * raysEach < options.newton; ++block) {
            RandomStream random(options.seed, block, degree, 4713);
            const ProfilePoints points = randomProfile(random, degree);
            const ExactOracle oracle(points);
            std::vector<Newton2018> newtons;
            for (const int count : starts)
                newtons.emplace_back(points, count);
            for (int i = 0; i < raysEach; ++i) {
                const Ray ray = randomRay(random, RayKind::Generic, points);
                const double doubt = 1e-6 * sizeOf(points) / ray.d.length();
                double first = infinityD;
                for (const OracleHit& hit : oracle.hits(ray))
                    if (hit.s > doubt) first = std::min(first, hit.s);
                if (first == infinityD) continue;
                ++rays;
                for (std::size_t k = 0; k < newtons.size(); ++k) {
                    const auto hit = newtons[k].closest(ray, doubt, infinityD);
                    missed[k] += !hit || std::abs(hit->s - first) > doubt;
                }
            }
        }
        std::printf("| %d | %ld |", degree, rays);
        for (const long count : missed)
            std::printf(" %.3g %% |", 100. * double(count) / double(rays));
        std::printf("\n");
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Surfaces of revolution against slow oracles");
    app.add_option("--pairs", options.pairs, "random (profile, ray) pairs");
    app.add_option("--oracle", options.oracle, "exact: integers; long: long double, the exact one where they differ")
        ->check(CLI::IsMember({"exact", "long"}));
    app.add_option("--parity", options.parity, "rays at the closed goblet");
    app.add_option("--newton", options.newton, "rays for each degree at the 2018 Newton baseline");
    app.add_option("--seed", options.seed);
    app.add_option("--from", options.firstBlock, "number of the first profile: to look again at one from a longer run");
    app.add_option("--threads", options.threads);
    app.add_option("--commit", options.commit, "printed in front of every line");
    CLI11_PARSE(app, argc, argv);
    bool clean = true;
    if (options.pairs > 0) clean = runPairs(options) && clean;
    if (options.parity > 0) clean = runParity(options) && clean;
    if (options.newton > 0) runNewton(options);
    std::printf("%s\n", clean ? "clean" : "NOT CLEAN");
    return clean ? 0 : 1;
}
