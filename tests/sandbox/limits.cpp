#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <unistd.h>

// The number of faces chooses what construct uses, the first vertex how much of it.
namespace {

double seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Looks at the clock now and then only: time in the kernel is not what is tried here.
void spin(clockid_t clock, double until) {
    volatile unsigned turns = 0;
    while (seconds(clock) < until) {
        for (int i = 0; i < 5'000'000; ++i) {
            turns = turns + 1;
        }
    }
}

[[gnu::noinline]] int deeper(int mebibytes) {
    volatile char frame[1 << 20] = {};
    return mebibytes <= 1 ? frame[7] : deeper(mebibytes - 1) + frame[mebibytes];
}

// Each thread allocates, so that it has a stack and an arena of its own.
int threads(int count) {
    std::mutex gate;
    std::vector<std::thread> started;
    int made = 0;
    gate.lock();
    try {
        for (; made < count; ++made) {
            started.emplace_back([&gate] {
                std::vector<char> own(5000);
                std::lock_guard wait(gate);
            });
        }
    } catch (const std::system_error&) {
    }
    gate.unlock();
    for (std::thread& each : started) {
        each.join();
    }
    return made;
}

int files(int count) {
    int opened = 0;
    while (opened < count && open("/dev/null", O_RDONLY) >= 0) {
        ++opened;
    }
    return opened;
}

void print(int count) {
    const std::string text(static_cast<size_t>(count), 'x');
    for (size_t done = 0; done < text.size();) {
        done += static_cast<size_t>(write(1, text.data() + done, text.size() - done));
    }
}

} // namespace

void BVH::construct(const Mesh& mesh) {
    *this = {};
    const float amount = mesh.getVertices()[0].x;
    const int count = static_cast<int>(amount);
    std::vector<char> memory;
    switch (mesh.getFaces().size()) {
    case 1: spin(CLOCK_PROCESS_CPUTIME_ID, amount); break;
    case 2: {
        std::thread other([amount] { spin(CLOCK_THREAD_CPUTIME_ID, amount); });
        spin(CLOCK_THREAD_CPUTIME_ID, amount);
        other.join();
        break;
    }
    case 3:
        std::signal(SIGXCPU, SIG_IGN);
        spin(CLOCK_PROCESS_CPUTIME_ID, amount);
        break;
    case 4: sleep(static_cast<unsigned>(count)); break;
    case 5: memory.reserve(static_cast<size_t>(count) << 20); break;
    case 6: throw std::runtime_error(std::to_string(threads(count)) + " threads");
    case 7: throw std::runtime_error(std::to_string(files(count)) + " files");
    case 8: deeper(count); break;
    case 9: print(count); break;
    case 10: std::ofstream("/tmp/debug") << "a debug file"; break;
    case 11: nodes.resize(static_cast<size_t>(count) - 1); break;
    case 12: memory.resize(8); memory.data()[8] = 1; break; // overflow
    default: break;
    }
    nodes.push_back(Node{mesh.getBounds(), 0, static_cast<uint32_t>(mesh.getFaces().size())});
    faceIndices.assign(mesh.getFaces().size(), 0);
}

Intersection intersect(const Mesh&, const IntersectionRay&) { return {}; }
