#include "exercise03_abi.h"

#include "access.h"
#include "copies.h"
#include "counters.h"
#include "intersection.h"
#include "not_written.h"
#include "path.h"

#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <exception>
#include <latch>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <type_traits>

static_assert(sizeof(Point3D) == 12 && std::is_trivially_copyable_v<Point3D>);
static_assert(sizeof(TriangleIndices) == 12 && std::is_trivially_copyable_v<TriangleIndices>);
static_assert(sizeof(BVH::Node) == 32 && std::is_trivially_copyable_v<BVH::Node>);
static_assert(sizeof(Ray) == 32 && std::is_trivially_copyable_v<Ray>);
static_assert(sizeof(Intersection) == 28 && std::is_trivially_copyable_v<Intersection>);
static_assert(offsetof(BVH::Node, facesBegin) == 24 && offsetof(BVH::Node, facesEnd) == 28);
static_assert(offsetof(Ray, direction) == 12 && offsetof(Ray, t_min) == 24);
static_assert(offsetof(Intersection, t) == 12 && offsetof(Intersection, normal) == 16);
static_assert(std::endian::native == std::endian::little);

namespace ex03 {
namespace {

/// The object behind a handle: a tree or a mesh, which stays const if it was.
template <typename Handle> auto& unwrap(Handle* handle) {
    constexpr bool isMesh = std::is_same_v<std::remove_const_t<Handle>, ex03_mesh>;
    using Plain = std::conditional_t<isMesh, Mesh, BVH>;
    return *reinterpret_cast<std::conditional_t<std::is_const_v<Handle>, const Plain, Plain>*>(
        handle);
}

/// How a call into the submission ended. Fixed size: reporting must not need memory.
struct Outcome {
    int32_t status{EX03_OK};
    std::array<char, 1024> text{};

    void fail(int32_t newStatus, const char* what) {
        status = newStatus;
        std::strncpy(text.data(), what, text.size() - 1);
    }
};

Outcome lastFailure;
int32_t report(const Outcome& outcome) {
    if (outcome.status != EX03_OK) {
        lastFailure = outcome;
    }
    return outcome.status;
}

/// Runs `action` and turns everything it throws into a value.
template <typename Action> Outcome guarded(const Action& action) {
    Outcome outcome;
    try {
        action();
    } catch (const std::bad_alloc& error) {
        outcome.fail(EX03_OUT_OF_MEMORY, error.what());
    } catch (const std::length_error& error) {
        outcome.fail(EX03_OUT_OF_MEMORY, error.what());
    } catch (const NotWritten& error) {
        outcome.fail(EX03_NOT_WRITTEN, error.what());
    } catch (const std::exception& error) {
        outcome.fail(EX03_THREW, error.what());
    } catch (...) {
        outcome.fail(EX03_THREW, "an exception that is not a std::exception");
    }
    return outcome;
}

/// Whether two rays are the same, bit by bit.
bool isSame(const Ray& a, const Ray& b) {
    using Bits = std::array<uint32_t, sizeof(Ray) / sizeof(uint32_t)>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// Traces the whole batch as thread number `part`, which has its own slice of the results.
void trace(const Mesh& mesh, const ex03_batch& batch, uint64_t part) {
    const auto* rays = static_cast<const Ray*>(batch.rays);
    auto* hits = static_cast<Intersection*>(batch.hits) + part * batch.count;
    uint32_t* tests = batch.tests == nullptr ? nullptr : batch.tests + 2 * part * batch.count;
    // As in an array of rays: at a multiple of 4 bytes that is none of 16, and nothing behind it.
    alignas(16) std::array<std::byte, 4 + sizeof(IntersectionRay)> room;
    const IntersectionRay* ray = nullptr;
    for (uint64_t i = 0; i < batch.count; ++i) {
        if (ray == nullptr || !isSame(rays[i], rays[i - 1])) {
            ray = new (room.data() + 4) IntersectionRay(rays[i]);
        }
        const Counters before = counters;
        hits[i] = intersect(mesh, *ray);
        if (tests != nullptr) {
            tests[2 * i] = static_cast<uint32_t>(counters.boxes - before.boxes);
            tests[2 * i + 1] = static_cast<uint32_t>(counters.triangles - before.triangles);
        }
        if (batch.done != nullptr) {
            std::atomic_ref(*batch.done).fetch_add(1, std::memory_order_relaxed);
        }
    }
}

/// One thread of `ex03_intersect_threads` and what is left of it when it has finished.
struct Tracer {
    Outcome outcome;
    Counters used;
    std::thread thread;

    void run(const Mesh& mesh, const ex03_batch& batch, uint64_t part) {
        outcome = guarded([&] { trace(mesh, batch, part); });
        used = counters;
    }
};

/// Starts all tracers behind one line, lets them go together and waits for them.
void traceTogether(std::vector<Tracer>& tracers, const Mesh& mesh, const ex03_batch& batch) {
    std::latch line(1);
    std::atomic<bool> cancelled{false};
    try {
        for (uint64_t part = 0; part < tracers.size(); ++part) {
            tracers[part].thread = std::thread([&, part] {
                line.wait();
                if (!cancelled) {
                    tracers[part].run(mesh, batch, part);
                }
            });
        }
    } catch (const std::system_error& error) {
        cancelled = true;
        tracers.front().outcome.fail(EX03_NO_THREAD, error.what());
    }
    line.count_down();
    for (Tracer& tracer : tracers) {
        if (tracer.thread.joinable()) {
            tracer.thread.join();
        }
    }
}

} // namespace
} // namespace ex03

using namespace ex03;

uint32_t ex03_abi_version(void) {
    return 3;
}

uint64_t ex03_size_of(uint32_t what) {
    constexpr std::array<uint64_t, 6> sizes{sizeof(Point3D),      sizeof(TriangleIndices),
                                            sizeof(BVH::Node),    sizeof(Ray),
                                            sizeof(Intersection), sizeof(Step)};
    return what < sizes.size() ? sizes[what] : 0;
}

uint32_t ex03_max_depth(void) {
    return BVH::maxDepth;
}

uint32_t ex03_faces_per_leaf(void) {
    return BVH::numFacesPerLeaf;
}

ex03_mesh* ex03_mesh_create(const float* vertices, uint64_t vertex_count, const uint32_t* faces,
                            uint64_t face_count) {
    Mesh* mesh = nullptr;
    report(guarded([&] {
        mesh = new Mesh(copyIn<Point3D>(vertices, vertex_count),
                        copyIn<TriangleIndices>(faces, face_count));
    }));
    return reinterpret_cast<ex03_mesh*>(mesh);
}

void ex03_mesh_destroy(ex03_mesh* mesh) {
    delete reinterpret_cast<Mesh*>(mesh);
}

int32_t ex03_mesh_replace(ex03_mesh* mesh, const float* vertices, uint64_t vertex_count,
                          const uint32_t* faces, uint64_t face_count) {
    return report(guarded([&] {
        unwrap(mesh) = Mesh(copyIn<Point3D>(vertices, vertex_count),
                            copyIn<TriangleIndices>(faces, face_count));
    }));
}

ex03_bvh* ex03_mesh_bvh(ex03_mesh* mesh) {
    return reinterpret_cast<ex03_bvh*>(&Access::bvh(unwrap(mesh)));
}

uint64_t ex03_copy_vertices(const ex03_mesh* mesh, float* out, uint64_t capacity) {
    return copyOut(unwrap(mesh).getVertices(), out, capacity);
}

uint64_t ex03_copy_faces(const ex03_mesh* mesh, uint32_t* out, uint64_t capacity) {
    return copyOut(unwrap(mesh).getFaces(), out, capacity);
}

ex03_bvh* ex03_bvh_create(void) {
    return reinterpret_cast<ex03_bvh*>(new (std::nothrow) BVH);
}

void ex03_bvh_destroy(ex03_bvh* bvh) {
    delete reinterpret_cast<BVH*>(bvh);
}

int32_t ex03_construct(ex03_bvh* bvh, const ex03_mesh* mesh) {
    return report(guarded([&] { unwrap(bvh).construct(unwrap(mesh)); }));
}

const void* ex03_nodes(const ex03_bvh* bvh) {
    return unwrap(bvh).getNodes().data();
}

const uint32_t* ex03_face_indices(const ex03_bvh* bvh) {
    return Access::faceIndices(unwrap(bvh)).data();
}

uint64_t ex03_copy_nodes(const ex03_bvh* bvh, void* out, uint64_t capacity) {
    return copyOut(unwrap(bvh).getNodes(), out, capacity);
}

uint64_t ex03_copy_face_indices(const ex03_bvh* bvh, uint32_t* out, uint64_t capacity) {
    return copyOut(Access::faceIndices(unwrap(bvh)), out, capacity);
}

int32_t ex03_set_tree(ex03_bvh* bvh, const void* nodes, uint64_t node_count,
                      const uint32_t* face_indices, uint64_t face_count) {
    return report(guarded([&] {
        Access::nodes(unwrap(bvh)) = copyIn(nodes, node_count, BVH::Node{AABB{}, 0, 1});
        Access::faceIndices(unwrap(bvh)) = copyIn<uint32_t>(face_indices, face_count);
    }));
}

int32_t ex03_intersect(const ex03_mesh* mesh, const ex03_batch* batch) {
    return report(guarded([&] { trace(unwrap(mesh), *batch, 0); }));
}

int32_t ex03_intersect_threads(const ex03_mesh* mesh, const ex03_batch* batch, uint32_t threads) {
    std::vector<Tracer> tracers;
    Outcome outcome = guarded([&] {
        tracers.resize(threads);
        traceTogether(tracers, unwrap(mesh), *batch);
    });
    for (const Tracer& tracer : tracers) {
        counters.boxes += tracer.used.boxes;
        counters.triangles += tracer.used.triangles;
        if (outcome.status == EX03_OK) {
            outcome = tracer.outcome;
        }
    }
    return report(outcome);
}

int32_t ex03_record(const ex03_mesh* mesh, const ex03_recording* recording) {
    Path recorded{&unwrap(mesh), static_cast<Step*>(recording->steps), recording->capacity};
    path = &recorded;
    const int32_t status = report(guarded([&] {
        const Ray& ray = *static_cast<const Ray*>(recording->ray);
        *static_cast<Intersection*>(recording->hit) = intersect(unwrap(mesh), ray);
        *recording->count = recorded.count;
    }));
    path = nullptr;
    return status;
}

void ex03_read_counters(uint64_t out[2]) {
    out[0] = counters.boxes;
    out[1] = counters.triangles;
}

void ex03_reset_counters(void) {
    counters = {};
}

uint64_t ex03_last_error(char* out, uint64_t capacity) {
    const auto& text = lastFailure.text;
    const uint64_t length = std::strlen(text.data());
    if (capacity > 0) {
        std::memcpy(out, text.data(), std::min(length + 1, capacity));
    }
    return length;
}
