#include <cstddef>
#include <cstdint>
#include <iterator>

#include "boxes.h"
#include "triangles.h"

/// Traces rays with every combination of a triangle test, a slab test and an early out; the
/// arithmetic itself is chosen by the compiler and its flags.
namespace rule {
namespace {

constexpr int maxWaiting = 128;

} // namespace

/// What is traced; laid out as `Scene` in tests/oracle/tracers.py.
struct Scene {
    const float* vertices;
    const uint32_t* faces;
    const float *low, *high;
    const uint32_t *begin, *end, *order;
    uint64_t nodes;
    const float *origin, *direction, *tMin, *tMax;
    uint64_t rays;
};

namespace {

template <typename Real> Vec<Real> at(const float* values, size_t row) {
    return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

template <typename Real> Line<Real> lineAt(const Scene& scene, size_t ray) {
    const auto d = at<Real>(scene.direction, ray);
    return {at<Real>(scene.origin, ray), d, {1 / d.x, 1 / d.y, 1 / d.z}, scene.tMin[ray],
            scene.tMax[ray]};
}

template <typename Real> Face<Real> faceAt(const Scene& scene, size_t face) {
    const uint32_t* corners = scene.faces + 3 * face;
    return {at<Real>(scene.vertices, corners[0]), at<Real>(scene.vertices, corners[1]),
            at<Real>(scene.vertices, corners[2])};
}

bool isUsed(const Scene& scene, size_t node) {
    return node < scene.nodes && scene.end[node] != 0;
}

template <typename Real, typename Test>
Real closest(const Scene& scene, Line<Real> ray, BoxTest<Real> boxTest, bool early) {
    size_t waiting[maxWaiting] = {0};
    int count = 1;
    Real best = nothing<Real>;
    while (count > 0) {
        const size_t node = waiting[--count];
        if (!boxTest({at<Real>(scene.low, node), at<Real>(scene.high, node)}, ray)) {
            continue;
        }
        if (isUsed(scene, 2 * node + 1)) {
            waiting[count++] = 2 * node + 2;
            waiting[count++] = 2 * node + 1;
            continue;
        }
        for (uint32_t k = scene.begin[node]; k < scene.end[node]; ++k) {
            const Real t = Test::t(faceAt<Real>(scene, scene.order[k]), ray);
            best = t < best ? t : best;
        }
        if (early && best < ray.t_max) {
            ray.t_max = best;
        }
    }
    return best;
}

template <typename Real, typename Test>
void traceAll(const Scene& scene, BoxTest<Real> boxTest, bool early, float* t) {
    for (size_t ray = 0; ray < scene.rays; ++ray) {
        t[ray] = static_cast<float>(
            closest<Real, Test>(scene, lineAt<Real>(scene, ray), boxTest, early));
    }
}

template <typename Real>
using Tracer = void (*)(const Scene&, BoxTest<Real> boxTest, bool early, float* t);

template <typename Real> void traceOwn(const Scene& s, const int* choice, Tracer<Real> first,
                                       BoxTest<Real> firstBox, float* t) {
    const Tracer<Real> tracers[] = {
        first,
        traceAll<Real, PlaneAtV1<Real>>,
        traceAll<Real, PlaneAtV3<Real>>,
        traceAll<Real, PlaneOfUnitNormal<Real>>,
        traceAll<Real, PlaneOfConstant<Real>>,
        traceAll<Real, MoellerTrumbore<Real>>,
        traceAll<Real, HalfOpen<Real>>,
        traceAll<Real, Watertight<Real>>,
        traceAll<Real, DotBarycentrics<Real>>,
        traceAll<Real, AreaBarycentrics<Real>>,
        traceAll<Real, ProjectedBarycentrics<Real>>,
        traceAll<Real, Cramer<Real>>,
        traceAll<Real, Volumes<Real>>,
    };
    const BoxTest<Real> boxes[] = {firstBox, byDivision<Real>, byMinAndMax<Real>, bySign<Real>};
    tracers[choice[0]](s, boxes[choice[1]], choice[2] != 0, t);
}

} // namespace
} // namespace rule

/// Traces all rays. `choice`: number of the triangle test, of the slab test, early out or not.
/// The first test of each kind is the given one; in double, the one most like it.
extern "C" void rule_trace_float(const rule::Scene* scene, const int* choice, float* t) {
    rule::traceOwn<float>(*scene, choice, rule::traceAll<float, rule::Given<float>>, rule::given,
                          t);
}

extern "C" void rule_trace_double(const rule::Scene* scene, const int* choice, float* t) {
    rule::traceOwn<double>(*scene, choice, rule::traceAll<double, rule::PlaneAtV1<double>>,
                           rule::byDivision<double>, t);
}
