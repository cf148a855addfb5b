#include "image.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace ex03 {
namespace {

std::string bigEndian(uint32_t value) {
    std::string bytes;
    for (const uint32_t shift : {24U, 16U, 8U, 0U}) {
        bytes += static_cast<char>(value >> shift & 0xffU);
    }
    return bytes;
}

/// The checksum of a PNG chunk: PNG specification, 2nd edition, annex D.
uint32_t crc32(const std::string& bytes) {
    uint32_t crc = 0xffffffffU;
    for (const char byte : bytes) {
        crc ^= static_cast<uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xedb88320U : crc >> 1U;
        }
    }
    return ~crc;
}

std::string chunk(const std::string& type, const std::string& data) {
    return bigEndian(static_cast<uint32_t>(data.size())) + type + data +
           bigEndian(crc32(type + data));
}

/// A zlib stream (RFC 1950) of stored blocks (RFC 1951, 3.2.4): larger than a compressed one,
/// but any viewer reads it and no library is needed.
std::string stored(const std::string& data) {
    constexpr size_t longestBlock = 65535;
    std::string stream = "\x78\x01";
    for (size_t begin = 0; begin < data.size(); begin += longestBlock) {
        const size_t size = std::min(longestBlock, data.size() - begin);
        stream += begin + size == data.size() ? '\1' : '\0';
        for (const size_t part : {size, ~size}) {
            stream += static_cast<char>(part & 0xffU);
            stream += static_cast<char>(part >> 8U & 0xffU);
        }
        stream += data.substr(begin, size);
    }
    uint32_t a = 1;
    uint32_t b = 0;
    for (const char byte : data) {
        a = (a + static_cast<uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return stream + bigEndian(b << 16U | a);
}

std::string asPng(const Image& image) {
    std::string rows;
    for (size_t y = 0; y < image.height; ++y) {
        rows += '\0'; // this row is not filtered
        const auto* row = image.pixels.data() + y * image.width;
        rows.append(row, row + image.width);
    }
    const std::string size = bigEndian(static_cast<uint32_t>(image.width)) +
                             bigEndian(static_cast<uint32_t>(image.height));
    const std::string eightBitGrey("\x08\0\0\0\0", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + eightBitGrey) + chunk("IDAT", stored(rows)) +
           chunk("IEND", "");
}

std::string asPpm(const Image& image) {
    std::string text =
        "P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
    for (const uint8_t grey : image.pixels) {
        text.append(3, static_cast<char>(grey));
    }
    return text;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
    throw std::runtime_error(file.string() + ": cannot be written, but the picture goes there; " +
                             "name a file in a folder that you may write to with -o");
}

} // namespace

bool isPictureName(const std::filesystem::path& file) {
    return file.extension() == ".png" || file.extension() == ".ppm";
}

void requireWritable(const std::filesystem::path& file) {
    std::error_code ignored;
    const bool isThere = std::filesystem::exists(std::filesystem::symlink_status(file, ignored));
    // To append nothing keeps an older picture, should this program not live to write a new one.
    if (!std::ofstream(file, std::ios::app)) {
        fail(file);
    }
    if (!isThere) {
        std::filesystem::remove(file, ignored);
    }
}

void writeImage(const std::filesystem::path& file, const Image& image) {
    const std::string bytes = file.extension() == ".ppm" ? asPpm(image) : asPng(image);
    std::ofstream stream(file, std::ios::binary);
    stream << bytes << std::flush;
    if (!stream) {
        fail(file);
    }
}

} // namespace ex03
