#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

// The number of faces chooses what construct does.
namespace {

volatile int zero = 0;

int deeper(int depth) {
    volatile char frame[4096] = {};
    return depth < 0 ? 0 : deeper(depth + 1) + frame[depth % 4096];
}

// Writes into the result file what only the worker should write there.
void claim(uint64_t finished, uint64_t status) {
    const uint64_t header[2] = {finished, status};
    for (int fd = 3; fd < 32; ++fd) {
        if (pwrite(fd, header, sizeof header, 16) > 0) {
            continue;
        }
    }
    _exit(0);
}

void flood(int fd) {
    const std::string line(1 << 20, 'x');
    for (int i = 0; i < 32; ++i) {
        if (write(fd, line.data(), line.size()) < 0) {
            return;
        }
    }
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const auto faces = static_cast<uint32_t>(mesh.getFaces().size());
    std::vector<uint32_t> small(3 + zero);
    switch (faces) {
    case 1: while (zero == 0) {} break;
    case 2: *reinterpret_cast<volatile int*>(zero) = 1; break;
    case 3: std::abort();
    case 4: throw std::runtime_error("own words");
    case 5: small.reserve(50'000'000'000); break;
    case 6: std::exit(0);
    case 7: flood(1); flood(2); break;
    case 8: deeper(zero); break;
    case 9: throw 42;
    case 10: small[0] = small.data()[3]; break; // line 57: heap overflow
    case 11: small[0] = 1 << (40 + zero); break; // line 58: shift
    case 12: small[3 + zero] = 1; break; // line 59: assertion
    case 13: std::exit(86);
    case 14: flood(2); small[0] = small.data()[3]; break; // line 61: heap overflow
    case 15: claim(999, 0); break;
    case 16: claim(0, 101); break;
    case 17: claim(0, 3); break;
    case 18: claim(0, 100); break;
    case 19: claim(0, ~0ull); break;
    case 20: _exit(7);
    case 21: throw std::runtime_error(std::string(5000, 'y') + "\x1b[31m");
    case 22: close(2); small[0] = small.data()[3]; break;
    case 23: small[0] = *reinterpret_cast<uint32_t*>(1 + (char*)small.data()); break; // line 70
    default: break;
    }
    nodes.push_back(Node{mesh.getBounds(), 0, faces});
    faceIndices.assign(faces, small[0]);
}

// Two box tests and a triangle test for a ray; a ray of negative t_max takes all memory.
Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    if (ray.t_max < 0) {
        try {
            while (true) {
                new char[1 << 16];
            }
        } catch (const std::bad_alloc&) {
        }
    }
    const AABB& box = mesh.getBVH().getNodes()[0].bounds;
    const bool inside = intersect(box, ray) && intersect(box, ray);
    const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(0), ray);
    return {ray.origin, ray.t_min + (inside ? 100 : 0), hit ? hit.normal : ray.direction};
}
