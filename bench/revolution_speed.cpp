// Rays a second on turned Bezier profiles: the exact surface, the 2018 system's Newton method, and Embree on the same
// surface in triangles, in turns on one thread. With --degrees the cost by degree; with --povray the scenes that
// compare_povray.py gives to POV-Ray. See docs/revolution.md.
#include "accel/caster.h"
#include "accel/embree_device.h"
#include "revolution_povray.h"
#include "shapes/mesh.h"
#include "shapes/revolution/tessellate.h"
#include "shapes/sphere.h"
#include "support/newton2018.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <ctime>
#include <functional>

namespace {

using namespace vitrine;
using namespace vitrine::bench;

/// Casts rays in a row and tells how many of them hit.
using CastAll = std::function<long(std::span<const Ray>)>;

struct Contender {
    std::string name;
    CastAll castAll;
    std::size_t rays = std::size_t(-1); ///< the slow ones get only so many, spread over all
};

/// So many of the rays, one from each of as many stretches, its place in the stretch by turns: a regular step could be
/// that of a picture's columns.
std::vector<Ray> spread(const std::vector<Ray>& rays, std::size_t count) {
    if (count >= rays.size()) return rays;
    const std::size_t step = rays.size() / count;
    std::vector<Ray> own;
    for (std::size_t k = 0; k < count; ++k)
        own.push_back(rays[k * step + k * 7 % step]);
    return own;
}

template <class Cast>
CastAll castAll(Cast cast) {
    return [cast = std::move(cast)](std::span<const Ray> rays) mutable {
        long hits = 0;
        for (const Ray& ray : rays)
            hits += cast(ray);
        return hits;
    };
}

double median(std::vector<double> x) {
    std::sort(x.begin(), x.end());
    return x.size() % 2 ? x[x.size() / 2] : (x[x.size() / 2 - 1] + x[x.size() / 2]) / 2;
}

/// Processor time of this thread: others on the machine cost less of it than of the clock's.
double threadNanoseconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

/// Nanoseconds a ray of every contender, a round a row: in a round all take their turns.
std::vector<std::vector<double>> measure(const std::vector<Contender>& contenders, const std::vector<Ray>& rays,
                                         int rounds, std::vector<double>& hitShare) {
    std::vector<std::vector<double>> times(contenders.size());
    hitShare.assign(contenders.size(), 0);
    for (int round = -1; round < rounds; ++round) // the first warms up
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            const std::vector<Ray> own = spread(rays, contenders[i].rays);
            const double start = threadNanoseconds();
            const long hits = contenders[i].castAll(own);
            const double time = threadNanoseconds() - start;
            hitShare[i] = double(hits) / double(own.size());
            if (round >= 0) times[i].push_back(time / double(own.size()));
        }
    return times;
}

CastAll closestByShape(ShapePtr shape) {
    return castAll([shape = std::move(shape)](const Ray& ray) {
        PrimitiveHit best, hit;
        for (unsigned prim = 0; prim < shape->primitiveCount(); ++prim)
            if (shape->intersect(prim, ray, 0, best.s, hit)) best = hit;
        return best.s < infinityD;
    });
}

std::shared_ptr<const Caster> casterOf(const std::vector<ShapePtr>& shapes) {
    CasterInput input;
    for (const ShapePtr& shape : shapes)
        input.shapes.push_back({shape, 0, true});
    return makeEmbreeCaster(std::move(input));
}

CastAll closestByCaster(std::shared_ptr<const Caster> caster) {
    return castAll([caster = std::move(caster), hit = CasterHit()](const Ray& ray) mutable {
        return caster->intersect(ray, hit);
    });
}

CastAll anyByCaster(std::shared_ptr<const Caster> caster) {
    return castAll([caster = std::move(caster)](const Ray& ray) { return caster->occluded(ray); });
}

/// Embree and nothing else: single precision, no surface point.
CastAll closestByEmbree(const Shape& mesh) {
    embree::GeometryPtr geometry = embree::newGeometry(RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices(), 0, 12,
                               mesh.vertexCount());
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices(), 0, 12,
                               mesh.primitiveCount());
    rtcCommitGeometry(geometry.get());
    const std::shared_ptr<RTCSceneTy> scene = embree::newScene();
    rtcAttachGeometry(scene.get(), geometry.get());
    rtcCommitScene(scene.get());
    embree::throwIfFailed();
    return castAll([scene](const Ray& ray) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray.org_x = float(ray.o.x), query.ray.org_y = float(ray.o.y), query.ray.org_z = float(ray.o.z);
        query.ray.dir_x = float(ray.d.x), query.ray.dir_y = float(ray.d.y), query.ray.dir_z = float(ray.d.z);
        query.ray.tfar = infinity;
        query.ray.mask = 1;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene.get(), &context, &query);
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    });
}

struct Options {
    int rounds = 15, side = 256;
    std::vector<std::uint64_t> triangles{100000, 4000000};
    bool degrees = false;
    std::string povray, json;
};

constexpr int newtonStarts[] = {5, 10, 20, 40};

/// Of the rays that hit, the share whose first hit Newton's method misses or puts elsewhere.
void printNewtonsMisses(const Subject& subject, const std::vector<Ray>& rays) {
    const std::shared_ptr<const Revolution> shape = subject.shape();
    std::printf("  first hits that Newton's method of 2018 misses or puts elsewhere:");
    for (const int starts : newtonStarts) {
        const test::Newton2018 newton(subject.points, starts);
        long hits = 0, wrong = 0;
        for (const Ray& ray : rays) {
            PrimitiveHit best, hit;
            for (unsigned prim = 0; prim < shape->primitiveCount(); ++prim)
                if (shape->intersect(prim, ray, 0, best.s, hit)) best = hit;
            if (best.s == infinityD) continue;
            const auto found = newton.closest(ray, 0, infinityD);
            ++hits;
            wrong += !found || std::abs(found->s - best.s) > 1e-6 * subject.half.y;
        }
        std::printf("  %d starts: %.3f %%", starts, 100. * double(wrong) / double(hits));
    }
    std::printf("\n");
}

std::vector<Contender> contendersFor(const Subject& subject, const Options& options) {
    constexpr std::size_t newtonRays = 2048;
    const std::shared_ptr<const Revolution> shape = subject.shape();
    const std::shared_ptr<const Caster> caster = casterOf({shape});
    M44d place;
    place.translate(subject.middle);
    const double radius = subject.half.y;
    std::vector<Contender> contenders{
        {"exact, shape alone", closestByShape(shape)},
        {"exact, caster", closestByCaster(caster)},
        {"exact, caster, any hit", anyByCaster(caster)},
        {"sphere, shape alone",
         closestByShape(std::make_shared<Sphere>(Transform(place), false, radius, -radius, radius, 360))}};
    for (const int starts : newtonStarts) {
        const test::Newton2018 newton(subject.points, starts);
        contenders.push_back(
            {fmt::format("Newton 2018, {} starts", starts),
             castAll([newton](const Ray& ray) { return newton.closest(ray, 0, infinityD).has_value(); }), newtonRays});
    }
    for (const std::uint64_t triangles : options.triangles) {
        const Profile profile = subject.profile();
        const std::vector<ShapePtr> mesh = makeMeshShapes(
            tessellate(profile, 360, toleranceForTriangles(profile, 360, triangles)), Transform(), false);
        const std::string name = fmt::format("{:.2g} triangles, ", double(mesh.front()->primitiveCount()));
        const std::shared_ptr<const Caster> meshCaster = casterOf(mesh);
        contenders.push_back({name + "caster", closestByCaster(meshCaster)});
        contenders.push_back({name + "caster, any hit", anyByCaster(meshCaster)});
        contenders.push_back({name + "Embree alone", closestByEmbree(*mesh.front())});
    }
    return contenders;
}

/// What a contender is to be compared with: the exact surface by the same kind of call.
std::size_t rivalOf(const std::string& name) {
    if (name.find("any hit") != std::string::npos) return 2;
    return name.find("caster") != std::string::npos ? 1 : 0;
}

void compare(const Options& options) {
    nlohmann::json all;
    for (const Subject& subject : subjects()) {
        const std::vector<Contender> contenders = contendersFor(subject, options);
        for (const RaySource source : raySources) {
            std::vector<double> hits;
            const std::vector<Ray> rays = makeRays(subject, source, options.side);
            const auto times = measure(contenders, rays, options.rounds, hits);
            std::printf("%s, rays from %s\n  %-34s %8s %9s %6s  %s\n", subject.name.c_str(), toString(source), "",
                        "ns a ray", "Mrays/s", "hit %", "times the exact surface's");
            for (std::size_t i = 0; i < contenders.size(); ++i) {
                std::vector<double> ratios;
                for (std::size_t k = 0; k < times[i].size(); ++k)
                    ratios.push_back(times[i][k] / times[rivalOf(contenders[i].name)][k]);
                const double ns = median(times[i]);
                std::printf("  %-34s %8.0f %9.3f %6.1f  %.2f\n", contenders[i].name.c_str(), ns, 1e3 / ns,
                            100 * hits[i], median(ratios));
                all.push_back({{"subject", subject.name},
                               {"rays", toString(source)},
                               {"contender", contenders[i].name},
                               {"ns", ns},
                               {"ratio", median(ratios)}});
            }
            printNewtonsMisses(subject, spread(rays, 16384));
            std::fflush(stdout);
        }
    }
    if (!options.json.empty()) fmt::output_file(options.json).print("{}\n", all.dump(1));
}

/// Curves from (0,-1) to (0,1) whose inner control points have radii at random: eight of each degree.
Subject randomSubject(int degree, int number) {
    RandomStream random(std::uint64_t(degree), number);
    std::vector<V2d> points;
    for (int i = 0; i <= degree; ++i)
        points.emplace_back((i == 0 || i == degree) && degree > 1 ? 0 : random.uniform(0.2, 1.4), -1 + 2. * i / degree);
    return Subject("random", {points}, V3d(0.5, 1, 4));
}

void sweepDegrees(const Options& options) {
    constexpr int maxDegree = 30, curves = 8;
    std::printf("degree,parts,camera ns,random ns,surface ns\n");
    for (int degree = 1; degree <= maxDegree; ++degree) {
        double parts = 0, sums[3] = {};
        for (int number = 0; number < curves; ++number) {
            const Subject subject = randomSubject(degree, number);
            parts += double(subject.profile().parts().size()) / curves;
            for (const RaySource source : raySources) {
                std::vector<double> hits;
                const auto times = measure({{"", closestByShape(subject.shape())}}, makeRays(subject, source, 64),
                                           options.rounds, hits);
                sums[int(source)] += median(times[0]) / curves;
            }
        }
        std::printf("%d,%.1f,%.1f,%.1f,%.1f\n", degree, parts, sums[0], sums[1], sums[2]);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Rays a second on turned Bezier profiles");
    app.add_option("--rounds", options.rounds, "turns that everybody takes")->check(CLI::PositiveNumber);
    app.add_option("--side", options.side, "rays: the square of this")->check(CLI::PositiveNumber);
    app.add_option("--triangles", options.triangles, "sizes of the meshes");
    app.add_option("--json", options.json, "also write the figures to this file");
    app.add_flag("--degrees", options.degrees, "the cost by degree instead, as CSV");
    app.add_option("--povray", options.povray, "write scenes for POV-Ray to this folder instead");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!options.povray.empty())
            for (const Subject& subject : subjects())
                writePovray(subject, options.povray);
        else if (options.degrees)
            sweepDegrees(options);
        else
            compare(options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_revolution_speed: %s\n", e.what());
        return 1;
    }
    return 0;
}
