#include "obj.h"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace ex03 {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Cuts the first word off `line`; empty if there is none left.
std::string_view takeWord(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

/// Says whether the whole of `word` is a number, and which one: what is too small for a float is
/// the nearest one, as in a literal, and what is too large is infinite.
template <typename Number> bool parse(std::string_view word, Number& number) {
    if (word.starts_with('+')) {
        word.remove_prefix(1);
    }
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, number);
    if constexpr (std::is_floating_point_v<Number>) {
        if (result.ec == std::errc::result_out_of_range) {
            // `number` is unchanged then, whether it would be tiny or huge.
            number = std::strtof(std::string(word).c_str(), nullptr);
            return result.ptr == end;
        }
    }
    return result.ec == std::errc{} && result.ptr == end;
}

std::string quoted(std::string_view word) {
    constexpr size_t longest = 40;
    std::string text = "'";
    for (const char c : word.substr(0, longest)) {
        text += c >= ' ' && c <= '~' ? c : '?'; // what a terminal must not see in raw form
    }
    return text + (word.size() > longest ? "...'" : "'");
}

class ObjReader {
  public:
    explicit ObjReader(std::string name) : name(std::move(name)) {}

    void readLine(std::string_view line) {
        ++lineNumber;
        const std::string_view keyword = takeWord(line);
        if (keyword == "v") {
            vertices.push_back(readVertex(line));
        } else if (keyword == "f") {
            readFace(line);
        }
    }

    Mesh finish() {
        if (vertices.empty()) {
            throw std::runtime_error(name + ": no vertices found, but an OBJ file has lines "
                                            "'v x y z' and 'f 1 2 3'");
        }
        return {std::move(vertices), std::move(faces)};
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw std::runtime_error(name + ":" + std::to_string(lineNumber) + ": " + message);
    }

    Vertex readVertex(std::string_view line) const {
        Vertex vertex;
        for (size_t axis = 0; axis < 3; ++axis) {
            const std::string_view word = takeWord(line);
            if (!parse(word, vertex[axis]) || !std::isfinite(vertex[axis])) {
                fail("coordinate " + std::to_string(axis + 1) + " is " + quoted(word) +
                     ", but three finite numbers are expected after 'v'");
            }
        }
        return vertex;
    }

    /// One corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`. Negative numbers count from the last vertex.
    uint32_t readCorner(std::string_view word) const {
        int64_t number = 0;
        if (!parse(word.substr(0, word.find('/')), number) || number == 0) {
            fail("corner is " + quoted(word) +
                 ", but a vertex number like 1, -1 or 1/2/3 is expected");
        }
        const auto known = static_cast<int64_t>(vertices.size());
        const int64_t index = number > 0 ? number - 1 : known + number;
        if (index < 0 || index >= known) {
            fail("face uses vertex " + std::to_string(number) + ", but " + std::to_string(known) +
                 " vertices are given above this line");
        }
        return static_cast<uint32_t>(index);
    }

    /// A polygon becomes a fan of triangles around its first corner.
    void readFace(std::string_view line) {
        size_t numCorners = 0;
        uint32_t first = 0;
        uint32_t previous = 0;
        for (auto word = takeWord(line); !word.empty(); word = takeWord(line), ++numCorners) {
            const uint32_t corner = readCorner(word);
            if (numCorners == 0) {
                first = corner;
            } else if (numCorners >= 2) {
                faces.push_back({first, previous, corner});
            }
            previous = corner;
        }
        if (numCorners < 3) {
            fail("face has " + std::to_string(numCorners) +
                 " corners, but at least 3 are expected");
        }
    }

    std::string name;
    size_t lineNumber{0};
    std::vector<Point3D> vertices;
    std::vector<TriangleIndices> faces;
};

std::string readWhole(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!std::filesystem::is_regular_file(file) || !stream) {
        throw std::runtime_error(file.string() + ": cannot be opened, but an OBJ file is expected");
    }
    std::string text(std::filesystem::file_size(file), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<size_t>(stream.gcount()));
    return text;
}

} // namespace

Mesh readObj(const std::filesystem::path& file) {
    const std::string text = readWhole(file);
    ObjReader reader(file.string());
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        reader.readLine(line.substr(0, line.find('#')));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
    return reader.finish();
}

} // namespace ex03
