// Rays a second that each shape takes: through the Embree caster (as renders use it) and by the shape's own code alone.
// What the two differ by is the caster's doing. See docs/benchmarks.md.
#include "ray_cases.h"

#include <benchmark/benchmark.h>

namespace {

using namespace vitrine;
using namespace vitrine::bench;

/// Counts rays, and tells how many of a hundred hit something: that half of a figure's meaning is easily forgotten.
template <class CastRay>
void castAll(benchmark::State& state, const std::vector<Ray>& rays, CastRay&& cast) {
    std::size_t hits = 0, next = 0;
    for (auto _ : state) {
        const bool hit = cast(rays[next]);
        hits += hit;
        next = (next + 1) % rays.size();
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["hit%"] = 100. * double(hits) / double(state.iterations());
}

bool closestInShape(const Shape& shape, const Ray& ray, SurfacePoint& point) {
    PrimitiveHit best, hit;
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
        if (shape.intersect(prim, ray, 0, best.s, hit)) best = hit;
    if (best.s == infinityD) return false;
    point = shape.pointAt(ray, best);
    return true;
}

bool anyInShape(const Shape& shape, const Ray& ray) {
    for (unsigned prim = 0; prim < shape.primitiveCount(); ++prim)
        if (shape.occludes(prim, ray, 0, ray.tMax)) return true;
    return false;
}

void closestByCaster(benchmark::State& state, const Caster& caster, const std::vector<Ray>& rays) {
    CasterHit hit;
    castAll(state, rays, [&](const Ray& ray) {
        const bool met = caster.intersect(ray, hit);
        benchmark::DoNotOptimize(hit);
        return met;
    });
}

void anyByCaster(benchmark::State& state, const Caster& caster, const std::vector<Ray>& rays) {
    castAll(state, rays, [&](const Ray& ray) { return caster.occluded(ray); });
}

void closestByShape(benchmark::State& state, const Shape& shape, const std::vector<Ray>& rays) {
    SurfacePoint point;
    castAll(state, rays, [&](const Ray& ray) {
        const bool met = closestInShape(shape, ray, point);
        benchmark::DoNotOptimize(point);
        return met;
    });
}

void anyByShape(benchmark::State& state, const Shape& shape, const std::vector<Ray>& rays) {
    castAll(state, rays, [&](const Ray& ray) { return anyInShape(shape, ray); });
}

void addCase(const ShapeCase& which, const std::string& order, const std::vector<Ray>& rays) {
    const auto add = [&](const std::string& name, auto function) {
        benchmark::RegisterBenchmark((which.name + "/" + order + "/" + name).c_str(), function);
    };
    const ShapePtr shape = which.make();
    CasterInput input;
    input.shapes.push_back({shape, 0, true});
    const std::shared_ptr<const Caster> caster = makeEmbreeCaster(std::move(input));
    add("closest/caster", [=, &rays](benchmark::State& state) { closestByCaster(state, *caster, rays); });
    add("any/caster", [=, &rays](benchmark::State& state) { anyByCaster(state, *caster, rays); });
    if (which.casterOnly) return;
    add("closest/shape", [=, &rays](benchmark::State& state) { closestByShape(state, *shape, rays); });
    add("any/shape", [=, &rays](benchmark::State& state) { anyByShape(state, *shape, rays); });
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<Ray> coherent = makeRays(RayOrder::Coherent), random = makeRays(RayOrder::Random);
    for (const ShapeCase& which : shapeCases) {
        addCase(which, "coherent", coherent);
        addCase(which, "random", random);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
