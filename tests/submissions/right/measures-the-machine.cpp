// right: statistics of everything: memory, times, terminal width, thread name, locale, signal handlers, buffers; a progress bar on a terminal
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

#include <cassert>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <locale>
#include <sstream>
#include <thread>

#ifdef __unix__
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <sys/time.h>
#include <sys/times.h>
#include <sys/utsname.h>
#include <unistd.h>
#endif

namespace stats {

struct Clock {
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    std::clock_t cpu = std::clock();
    const char* name;
    explicit Clock(const char* n) : name(n) {}
    ~Clock() {
        const auto ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        std::clog << '[' << name << "] " << std::fixed << std::setprecision(2) << ms << " ms, CPU "
                  << 1000.0 * double(std::clock() - cpu) / CLOCKS_PER_SEC << " ms\n";
    }
};

struct Thousands : std::numpunct<char> {
    char do_thousands_sep() const override { return '\''; }
    std::string do_grouping() const override { return "\3"; }
};

int width() {
#ifdef __unix__
    winsize size{};
    if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0)
        return size.ws_col;
#endif
    return 80;
}

void machine() {
#ifdef __unix__
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    utsname name{};
    uname(&name);
    timeval tv{};
    gettimeofday(&tv, nullptr);
    tms ticks{};
    times(&ticks);
    std::clog << name.sysname << ' ' << name.machine << ", " << sysconf(_SC_NPROCESSORS_ONLN) << " CPUs, page "
              << sysconf(_SC_PAGESIZE) << ", pid " << getpid() << ", peak " << usage.ru_maxrss << " KiB, on CPU "
              << sched_getcpu() << ", " << tv.tv_sec % 60 << " s\n";
    struct sysinfo info{};
    if (sysinfo(&info) == 0)
        std::clog << "free memory " << info.freeram / 1024 << " KiB\n";
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS"))
            std::clog << line << '\n';
    char thread[16] = "";
    pthread_getname_np(pthread_self(), thread, sizeof thread);
    pthread_setname_np(pthread_self(), "bvh");
    pthread_setname_np(pthread_self(), thread);
    sched_yield();
#endif
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char text[64];
    std::strftime(text, sizeof text, "%A %d %B %Y %H:%M:%S %Z", &local);
    std::clog << text << ", " << std::thread::hardware_concurrency() << " threads\n";
    std::error_code error;
    std::clog << std::filesystem::current_path(error) << ' ' << std::filesystem::exists("models/dragon.obj", error) << '\n';
}

extern "C" void onCrash(int signal) {
    const char text[] = "crash!\n";
    if (write(2, text, sizeof text - 1) < 0)
        _exit(1);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

} // namespace stats

void BVH::construct(const Mesh& mesh) {
    static char outputBuffer[1 << 16];
    static const bool once = [] {
        std::setlocale(LC_ALL, "");
        std::setvbuf(stdout, outputBuffer, _IOFBF, sizeof outputBuffer);
        std::clog.imbue(std::locale(std::locale::classic(), new stats::Thousands));
        std::signal(SIGFPE, stats::onCrash);
        std::signal(SIGTERM, stats::onCrash);
        std::atexit([] { std::fputs("bye\n", stderr); });
        stats::machine();
        return true;
    }();
    assert(once);
    stats::Clock clock("construct");

    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    nodes.clear();
    nodes.push_back({mesh.getBounds(), 0, numFaces});
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0);

#ifdef __unix__
    // scratch memory from the system; goes back when done
    const size_t bytes = sizeof(float) * std::max<size_t>(1, numFaces);
    void* scratch = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert(scratch != MAP_FAILED);
    madvise(scratch, bytes, MADV_HUGEPAGE);
    float* centers = static_cast<float*>(scratch);
#endif
    const int columns = stats::width();
    for (uint32_t depth = 0, done = 0; depth < maxDepth; ++depth) {
        const size_t size = nodes.size();
        for (size_t i = (size_t(1) << depth) - 1; i < std::min(size, (size_t(2) << depth) - 1); ++i) {
            const Node node = nodes[i];
            if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
                continue;
            const uint8_t axis = node.bounds.extents().maxDimension();
            for (uint32_t f : getFaceIndices(node)) {
                const Triangle t = mesh.getTriangleFromFaceIndex(f);
                centers[f] = (t.v1[axis] + t.v2[axis] + t.v3[axis]) * (1.0f / 3.0f);
            }
            const uint32_t mid = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
            std::nth_element(&faceIndices[node.facesBegin], &faceIndices[mid], faceIndices.data() + node.facesEnd,
                             [centers](uint32_t a, uint32_t b) { return centers[a] < centers[b]; });
            nodes.resize(std::max(nodes.size(), 2 * i + 3));
            for (int side : {0, 1}) {
                Node child{{}, side ? mid : node.facesBegin, side ? node.facesEnd : mid};
                for (uint32_t f : getFaceIndices(child)) {
                    const Triangle t = mesh.getTriangleFromFaceIndex(f);
                    child.bounds.extend(t.v1);
                    child.bounds.extend(t.v2);
                    child.bounds.extend(t.v3);
                }
                nodes[2 * i + 1 + side] = child;
            }
            ++done;
        }
        if (isatty(STDOUT_FILENO))
            std::cout << '\r' << std::string(std::min<size_t>(columns - 1, done), '#') << std::flush;
        if (nodes.size() == size)
            break;
    }
#ifdef __unix__
    munmap(scratch, bytes);
    malloc_trim(0);
#endif
    std::ostringstream line;
    line << "nodes: " << nodes.size() << ", faces: " << numFaces;
    std::puts(line.str().c_str());
    std::fflush(nullptr);
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const auto& nodes = mesh.getBVH().getNodes();
    Intersection best;
    best.t = HUGE_VALF;
    uint32_t stack[64], size = 0;
    if (!nodes.empty())
        stack[size++] = 0;
    while (size) {
        const uint32_t i = stack[--size];
        if (!intersect(nodes[i].bounds, ray))
            continue;
        const uint32_t left = 2 * i + 1;
        if (left + 1 < nodes.size() && nodes[left].facesEnd) {
            stack[size++] = left + 1;
            stack[size++] = left;
            assert(size < std::size(stack));
        } else
            for (auto f : mesh.getBVH().getFaceIndices(nodes[i])) {
                const auto hit = intersect(mesh.getTriangleFromFaceIndex(f), ray);
                if (hit && hit.t < best.t)
                    best = hit;
            }
    }
    return best;
}
