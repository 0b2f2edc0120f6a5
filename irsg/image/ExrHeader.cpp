#include "irsg/image/ExrHeader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/PixelBound.h"

namespace irsg {

namespace {

constexpr std::uint32_t severalParts = 0x1000;

/// Types of one length, which the library reads whatever length the file states.
constexpr std::array<std::pair<std::string_view, std::uint32_t>, 23> fixedSizes = {{
    {"int", 4},      {"float", 4},     {"double", 8},      {"box2i", 16},   {"box2f", 16},
    {"v2i", 8},      {"v2f", 8},       {"v2d", 16},        {"v3i", 12},     {"v3f", 12},
    {"v3d", 24},     {"m33f", 36},     {"m33d", 72},       {"m44f", 64},    {"m44d", 128},
    {"rational", 8}, {"timecode", 8},  {"keycode", 28},    {"tiledesc", 9}, {"chromaticities", 32},
    {"envmap", 1},   {"lineOrder", 1}, {"compression", 1},
}};

/// A place in the bytes, which only moves forward and never behind their end.
class Walk {
  public:
    Walk(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    std::uint32_t number() {
        need(4, "a number of 4 bytes");
        std::uint32_t value = 0;
        for (int i = 3; i >= 0; --i)
            value = value << 8 | static_cast<unsigned char>(bytes_[at_ + static_cast<unsigned>(i)]);
        at_ += 4;
        return value;
    }
    std::string_view name() {
        const auto end = bytes_.find('\0', at_);
        if (end == bytes_.npos || end - at_ > 255)
            refuse("a name without an end", "at most 255 characters and a zero byte");
        const std::string_view name = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return name;
    }
    void skip(std::uint32_t count, const std::string& what) {
        need(count, what);
        at_ += count;
    }
    void need(std::uint32_t count, const std::string& what) const {
        if (count > bytes_.size() - at_)
            refuse(what + " of " + std::to_string(count) + " bytes",
                   "at most the " + std::to_string(bytes_.size() - at_) +
                       " bytes that are left in the file");
    }
    [[noreturn]] void refuse(const std::string& value, const std::string& expected) const {
        throw InputError({file_, "byte " + std::to_string(at_), value,
                          "an OpenEXR image, undamaged and complete: " + expected});
    }
    std::size_t at() const { return at_; }

  private:
    std::string_view bytes_;
    const std::string& file_;
    std::size_t at_ = 4;
};

/// Each with its length, up to the end of the attribute.
void walkStrings(Walk& walk, std::size_t end) {
    while (walk.at() < end) {
        const std::uint32_t length = walk.number();
        if (walk.at() > end || length > end - walk.at())
            walk.refuse("a text of " + std::to_string(length) + " bytes",
                        "texts that end with their attribute");
        walk.skip(length, "a text");
    }
}

/// A name and 16 bytes each, and an empty name behind the last.
std::uint64_t walkChannels(Walk& walk, std::size_t end) {
    std::uint64_t channels = 0;
    for (; !walk.name().empty(); ++channels)
        walk.skip(16, "a channel");
    if (walk.at() != end)
        walk.refuse("a list of channels that does not end with its attribute", "one that does");
    return channels;
}

/// Two corners; the library makes a table of all rows between them.
std::uint64_t walkDataWindow(Walk& walk) {
    std::array<std::int64_t, 4> corners{};
    for (std::int64_t& corner : corners)
        corner = static_cast<std::int32_t>(walk.number());
    const std::int64_t width = corners[2] - corners[0] + 1, height = corners[3] - corners[1] + 1;
    if (width < 1 || height < 1 || width > largestImageSide_px || height > largestImageSide_px)
        walk.refuse(std::to_string(width) + " x " + std::to_string(height) + " pixels",
                    "1 to " + std::to_string(largestImageSide_px) + " pixels a side");
    return static_cast<std::uint64_t>(width * height);
}

/// What a part holds.
struct Extent {
    std::uint64_t pixels = 0, channels = 1;
};

void walkAttribute(Walk& walk, std::string_view attribute, Extent& extent) {
    const std::string_view type = walk.name();
    const std::uint32_t size = walk.number();
    walk.need(size, "an attribute");
    const std::size_t end = walk.at() + size;
    for (const auto& [name, fixed] : fixedSizes)
        if (type == name && size != fixed)
            walk.refuse("a " + std::string(type) + " of " + std::to_string(size) + " bytes",
                        std::to_string(fixed));
    if (attribute == "dataWindow" && type == "box2i") {
        extent.pixels = walkDataWindow(walk);
    } else if (type == "stringvector") {
        walkStrings(walk, end);
    } else if (type == "chlist") {
        extent.channels = walkChannels(walk, end);
    } else if (type == "preview") {
        const std::uint64_t width = walk.number(), height = walk.number();
        if (8 + 4 * width * height != size)
            walk.refuse("a preview of " + std::to_string(width) + " x " + std::to_string(height) +
                            " pixels in " + std::to_string(size) + " bytes",
                        "4 bytes a pixel");
        walk.skip(size - 8, "a preview");
    } else {
        walk.skip(size, "an attribute");
    }
}

} // namespace

void checkExrHeader(std::string_view bytes, const std::string& file) {
    Walk walk(bytes, file);
    const std::uint32_t version = walk.number();
    do {
        std::size_t attributes = 0;
        Extent extent;
        for (auto name = walk.name(); !name.empty(); name = walk.name(), ++attributes)
            walkAttribute(walk, name, extent);
        if (attributes == 0)
            return; // behind the last part
        checkPixelCount(extent.pixels * std::max<std::uint64_t>(1, extent.channels), bytes.size(),
                        file);
    } while ((version & severalParts) != 0);
}

} // namespace irsg
