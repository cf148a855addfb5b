// Renders an OBJ file with the submission's construct() and intersect().

#include "abi/access.h"
#include "image.h"
#include "intersection.h"
#include "obj.h"
#include "src/counters.h"

#include <charconv>
#include <chrono>
#include <exception>
#include <iomanip>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ex03 {
namespace {

constexpr std::string_view usage =
    "usage: preview MODEL.obj [-o PICTURE.png|PICTURE.ppm] [--width N] [--height N]\n"
    "Renders MODEL.obj to preview.png, 640 x 480, unless told otherwise.\n";

constexpr size_t largestSide = 16384;

struct Options {
    std::string model;
    std::string output{"preview.png"};
    size_t width{640};
    size_t height{480};
};

/// Says which argument makes no sense, and what is expected.
struct BadUsage : std::runtime_error {
    using std::runtime_error::runtime_error;
};

size_t parseSide(const std::string& name, const std::string& text) {
    size_t side = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, side);
    if (result.ec != std::errc{} || result.ptr != end || side < 1 || side > largestSide) {
        throw BadUsage(name + " is '" + text + "', but a number of pixels from 1 to " +
                       std::to_string(largestSide) + " is expected");
    }
    return side;
}

std::string parseOutput(const std::string& name) {
    if (!isPictureName(name)) {
        throw BadUsage("-o is '" + name + "', but a name that ends in .png or .ppm is expected");
    }
    return name;
}

/// Reads the option at `i` and its value; `i` is the value's place then.
void parseOption(const std::vector<std::string>& arguments, size_t& i, Options& options) {
    const std::string& name = arguments[i];
    if (name != "-o" && name != "--width" && name != "--height") {
        throw BadUsage("there is no option '" + name + "'");
    }
    if (++i == arguments.size()) {
        throw BadUsage(name + " stands last, but its value is expected after it");
    }
    if (name == "-o") {
        options.output = parseOutput(arguments[i]);
    } else {
        (name == "--width" ? options.width : options.height) = parseSide(name, arguments[i]);
    }
}

Options parseArguments(const std::vector<std::string>& arguments) {
    Options options;
    for (size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i].starts_with('-')) {
            parseOption(arguments, i, options);
        } else if (options.model.empty()) {
            options.model = arguments[i];
        } else {
            throw BadUsage("'" + arguments[i] + "' is a second model, but one is expected");
        }
    }
    if (options.model.empty()) {
        throw BadUsage("no model is named");
    }
    return options;
}

class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

  private:
    std::chrono::steady_clock::time_point start{std::chrono::steady_clock::now()};
};

/// Looks at the mesh from the front, a little from the right and from above.
struct Camera {
    Point3D eye;
    Vector3D forward;
    Vector3D right;
    Vector3D up;

    explicit Camera(const AABB& bounds) {
        constexpr float distanceInRadii = 2.4f; // the bounding sphere fills most of the picture
        const float radius = std::max(bounds.extents().norm() / 2, 1e-3f);
        forward = Vector3D{-0.45f, -0.35f, -1}.normalized();
        right = cross(forward, Vector3D{0, 1, 0}).normalized();
        up = cross(right, forward);
        eye = bounds.center() - forward * (radius * distanceInRadii);
    }

    /// The ray through `x`, `y`, where the shorter side of the picture goes from -1 to 1.
    Ray rayThrough(float x, float y) const {
        constexpr float slope = 0.46f; // tan of half the opening angle: asin(1 / 2.4) and a margin
        const Vector3D direction = forward + right * (slope * x) + up * (slope * y);
        return {eye, direction.normalized()};
    }
};

uint8_t shade(const Intersection& hit, const Ray& ray) {
    constexpr uint8_t background = 24;
    const float facing = std::abs(dot(hit.normal, ray.direction));
    const float light = 50 + 200 * std::min(facing, 1.0f);
    return hit && light > 0 ? static_cast<uint8_t>(light) : background;
}

Image render(const Mesh& mesh, const Options& options) {
    const Camera camera(mesh.getBounds());
    Image image{options.width, options.height, {}};
    image.pixels.reserve(image.width * image.height);
    const Stopwatch watch;
    double reported = 1; // nobody needs progress in the first second
    for (size_t y = 0; y < image.height; ++y) {
        for (size_t x = 0; x < image.width; ++x) {
            const auto side = static_cast<float>(std::min(image.width, image.height));
            const float column = 2 * static_cast<float>(x) + 1 - static_cast<float>(image.width);
            const float row = static_cast<float>(image.height) - 2 * static_cast<float>(y) - 1;
            const Ray ray = camera.rayThrough(column / side, row / side);
            image.pixels.push_back(shade(intersect(mesh, ray), ray));
            const double seconds = watch.seconds();
            if (seconds > reported) {
                reported = seconds + 1;
                const auto done = static_cast<double>(image.pixels.size());
                const double left =
                    seconds / done * static_cast<double>(image.width * image.height) - seconds;
                std::cerr << "tracing: row " << y + 1 << " of " << image.height << ", about "
                          << std::ceil(left) << " s left\n";
            }
        }
    }
    return image;
}

void preview(const Options& options) {
    requireWritable(options.output); // before minutes of rendering
    Mesh mesh = readObj(options.model);
    std::cout << "model:     " << mesh.getFaces().size() << " faces\n" << std::fixed;

    const Stopwatch constructing;
    Access::bvh(mesh).construct(mesh);
    std::cout << "construct: " << std::setprecision(3) << constructing.seconds() << " s, "
              << mesh.getBVH().getNodes().size() << " nodes\n"
              << std::flush;

    counters = {};
    const Stopwatch tracing;
    const Image image = render(mesh, options);
    const double seconds = tracing.seconds();
    const auto rays = static_cast<double>(image.pixels.size());
    std::cout << "trace:     " << seconds << " s, " << image.pixels.size() << " rays, per ray "
              << std::setprecision(1) << static_cast<double>(counters.boxes) / rays
              << " box tests and " << static_cast<double>(counters.triangles) / rays
              << " triangle tests\n";
    writeImage(options.output, image);
    std::cout << "picture:   " << options.output << "\n";
}

} // namespace
} // namespace ex03

int main(int argc, char** argv) {
    try {
        ex03::preview(ex03::parseArguments({argv + 1, argv + argc}));
    } catch (const ex03::BadUsage& error) {
        std::cerr << "preview: " << error.what() << "\n" << ex03::usage;
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "preview: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
