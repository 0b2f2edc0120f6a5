#include "irsg/geometry/reading/text/ModelText.h"

#include <algorithm>
#include <cstdint>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/reading/OpenableFiles.h"

namespace irsg {

namespace {

/// Marks at the beginning of a text; that of UTF-16 begins that of UTF-32.
struct Encoding {
    std::string_view mark;
    std::size_t unit_B;
    bool bigEndian;
    const char* name;
};
constexpr Encoding encodings[] = {{{"\xEF\xBB\xBF", 3}, 1, false, "UTF-8"},
                                  {{"\xFF\xFE\0\0", 4}, 4, false, "UTF-32"},
                                  {{"\0\0\xFE\xFF", 4}, 4, true, "UTF-32"},
                                  {{"\xFF\xFE", 2}, 2, false, "UTF-16"},
                                  {{"\xFE\xFF", 2}, 2, true, "UTF-16"}};

const Encoding* encodingOf(std::string_view bytes) {
    for (const Encoding& encoding : encodings)
        if (bytes.starts_with(encoding.mark))
            return &encoding;
    return nullptr;
}

void appendCharacter(std::string& text, std::uint32_t c) {
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (c < 0x80) {
        add(c);
    } else if (c < 0x800) {
        add(0xC0 | c >> 6);
        add(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        add(0xE0 | c >> 12);
        add(0x80 | (c >> 6 & 0x3F));
        add(0x80 | (c & 0x3F));
    } else {
        add(0xF0 | c >> 18);
        add(0x80 | (c >> 12 & 0x3F));
        add(0x80 | (c >> 6 & 0x3F));
        add(0x80 | (c & 0x3F));
    }
}

std::string converted(std::string_view bytes, const Encoding& encoding, const std::string& file) {
    const auto refuse = [&](std::size_t at, const std::string& value) {
        throw InputError(
            {file, "byte " + std::to_string(at), value, std::string("a text in ") + encoding.name});
    };
    const auto unit = [&](std::size_t at) {
        if (bytes.size() - at < encoding.unit_B)
            refuse(at, "the end of the file within a character");
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < encoding.unit_B; ++i)
            value =
                value << 8 | static_cast<unsigned char>(
                                 bytes[at + (encoding.bigEndian ? i : encoding.unit_B - 1 - i)]);
        return value;
    };
    const auto isHalf = [](std::uint32_t value) { return value >= 0xD800 && value < 0xE000; };
    std::string text;
    text.reserve(bytes.size() / encoding.unit_B);
    for (std::size_t at = encoding.mark.size(); at < bytes.size(); at += encoding.unit_B) {
        std::uint32_t c = unit(at);
        if (encoding.unit_B == 2 && c >= 0xD800 && c < 0xDC00 && at + 2 < bytes.size()) {
            const std::uint32_t low = unit(at + 2);
            if (low >= 0xDC00 && low < 0xE000) {
                c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
                at += 2;
            }
        }
        if (isHalf(c) || c > 0x10FFFF)
            refuse(at, "a character that there is not");
        appendCharacter(text, c);
    }
    return text;
}

/// In place.
void endLinesAlike(std::string& text) {
    const auto first = text.find('\r');
    if (first == text.npos)
        return;
    std::size_t to = first;
    for (std::size_t from = first; from < text.size(); ++from) {
        if (text[from] != '\r') {
            text[to++] = text[from];
            continue;
        }
        text[to++] = '\n';
        if (from + 1 < text.size() && text[from + 1] == '\n')
            ++from;
    }
    text.resize(to);
}

/// A zero byte near the beginning, after what may be a mark, is none of a text.
bool isBinary(std::string_view bytes) {
    return bytes.substr(0, 256).find('\0') != bytes.npos;
}

} // namespace

bool hasMark(std::string_view bytes) {
    return encodingOf(bytes) != nullptr;
}

std::string plainText(std::string bytes, const std::string& file) {
    if (const Encoding* encoding = encodingOf(bytes)) {
        if (encoding->unit_B == 1)
            bytes.erase(0, encoding->mark.size());
        else
            bytes = converted(bytes, *encoding, file);
    }
    endLinesAlike(bytes);
    if (bytes.ends_with('\x1A'))
        bytes.pop_back();
    return bytes;
}

std::string readModelBytes(const std::filesystem::path& place, const std::filesystem::path& file) {
    std::string bytes = readFile(place, largestModel_B);
    const std::string extension = lowerCase(file.extension().string());
    if (extension.empty() || !hasTextForm(std::string_view(extension).substr(1)))
        return bytes;
    return !hasMark(bytes) && isBinary(bytes) ? bytes : plainText(std::move(bytes), file.string());
}

bool hasTextForm(std::string_view extension) {
    static constexpr std::string_view known[] = {"osgt", "osg", "osgx", "gltf", "fbx", "dae",
                                                 "obj",  "stl", "ply",  "ac",   "dxf", "x"};
    return std::ranges::find(known, extension) != std::end(known);
}

} // namespace irsg
