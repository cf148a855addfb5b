#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ex03 {

/// A grey picture, row by row from the top, 0 is black.
struct Image {
    size_t width{0};
    size_t height{0};
    std::vector<uint8_t> pixels;
};

/// Says whether the name ends in `.png` or `.ppm`.
bool isPictureName(const std::filesystem::path& file);

/// Throws std::runtime_error if the file cannot be written. Changes nothing.
void requireWritable(const std::filesystem::path& file);

/// Writes a PNG file, or a PPM file if the name ends in `.ppm`.
///
/// Throws std::runtime_error if the file cannot be written.
void writeImage(const std::filesystem::path& file, const Image& image);

} // namespace ex03
