#include "irsg/image/PlainImages.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/PixelBound.h"
#include "irsg/image/RawNumbers.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

[[noreturn]] void refuse(const std::string& file, const std::string& position,
                         const std::string& value, const std::string& expected) {
    throw InputError({file, position, value, expected});
}

std::string atLine(int line) {
    return "line " + std::to_string(line);
}

/// A side of an image that a header names.
std::size_t sideOf(std::string_view text, const std::string& what, const std::string& file) {
    std::size_t side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (error != std::errc() || end != text.data() + text.size() || side < 1 ||
        side > static_cast<std::size_t>(largestImageSide_px))
        refuse(file, what, "'" + std::string(text.substr(0, 40)) + "'",
               "a whole number from 1 to " + std::to_string(largestImageSide_px));
    return side;
}

bool beginsAsGrid(std::string_view beginning) {
    const std::string word =
        lowerCase(std::string(trimmed(withoutByteOrderMark(beginning.substr(0, 64)))));
    return word.starts_with("ncols ") || word.starts_with("ncols\t") ||
           word.starts_with("nrows ") || word.starts_with("nrows\t");
}

/// The keys of a grid, which end where a line begins with a number.
struct GridHead {
    std::size_t width = 0, height = 0;
    std::optional<double> missing;
    std::vector<std::pair<std::string, std::string>> others;
    int lines = 0;
    std::string_view values;
};

GridHead gridHead(std::string_view text, const std::string& file) {
    GridHead head;
    for (std::string_view rest = text; !rest.empty();) {
        std::string_view next = rest;
        const std::string_view line = trimmed(takeLine(next));
        const std::size_t blank = line.find_first_of(" \t");
        const std::string key = lowerCase(std::string(line.substr(0, blank)));
        if (!line.empty() && (key[0] < 'a' || key[0] > 'z'))
            return head.values = rest, head;
        rest = next;
        ++head.lines;
        if (line.empty())
            continue;
        const std::string_view value =
            blank == std::string_view::npos ? std::string_view() : trimmed(line.substr(blank));
        if (key == "ncols")
            head.width = sideOf(value, atLine(head.lines), file);
        else if (key == "nrows")
            head.height = sideOf(value, atLine(head.lines), file);
        else if (key == "nodata_value") {
            const auto plain = plainNumber(value, value.find(',') == value.npos ? '.' : ',');
            head.missing = plain ? parseNumber(*plain) : std::nullopt;
        } else {
            head.others.emplace_back(key, value);
        }
    }
    return head;
}

} // namespace

RadianceImage readEsriGrid(const fs::path& file) {
    const std::string bytes = readFile(file), name = file.string();
    const GridHead head = gridHead(withoutByteOrderMark(bytes), name);
    if (head.width == 0 || head.height == 0)
        refuse(name, "", head.width == 0 ? "no ncols" : "no nrows", "ncols and nrows");
    const std::size_t count = head.width * head.height;
    checkPixelCount(count, bytes.size(), name);
    // Blanks alone separate values: a comma is a decimal sign.
    const char decimal = head.values.find(',') == std::string_view::npos ? '.' : ',';

    RadianceImage image(static_cast<int>(head.width), static_cast<int>(head.height), "L", "");
    std::vector<float>& values = image.primary().values;
    std::size_t found = 0, missing = 0;
    std::vector<ColumnCell> cells;
    int line = head.lines;
    for (std::string_view rest = head.values; !rest.empty();) {
        ++line;
        splitColumns(takeLine(rest), ' ', cells);
        for (const ColumnCell& cell : cells) {
            const auto plain = plainNumber(cell.text, decimal);
            const auto value = plain ? parseNumber(*plain) : std::nullopt;
            if (!value || std::abs(*value) > std::numeric_limits<float>::max())
                refuse(name, atLine(line), "'" + std::string(cell.text.substr(0, 40)) + "'",
                       "a number within the range of 32-bit float");
            if (found == count)
                refuse(name, atLine(line), "more values",
                       std::to_string(count) + ", as ncols and nrows say");
            const bool isMissing = head.missing && *value == *head.missing;
            missing += isMissing ? 1 : 0;
            values[found++] =
                isMissing ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(*value);
        }
    }
    if (found != count)
        refuse(name, "", std::to_string(found) + " values",
               std::to_string(count) + ", as ncols and nrows say");
    if (missing > 0)
        remarkOn(name, std::to_string(missing) + " values are NODATA_value and are read as NaN");
    for (const auto& [key, value] : head.others)
        image.attributes[key] = value;
    return image;
}

RadianceImage readPfm(const fs::path& file) {
    const std::string bytes = readFile(file), name = file.string();
    // Four words, each behind white space; one white space character ends the last.
    std::size_t at = 0;
    const auto word = [&] {
        const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n", at), bytes.size());
        at = std::min(bytes.find_first_of(" \t\r\n", begin), bytes.size());
        return std::string_view(bytes).substr(begin, std::min<std::size_t>(at - begin, 80));
    };
    const bool isColour = word() == "PF";
    const std::size_t width = sideOf(word(), "width", name),
                      height = sideOf(word(), "height", name);
    const std::string scaleText(word());
    const std::optional<double> scale = parseNumber(scaleText);
    if (!scale || *scale == 0.0)
        refuse(name, "scale", "'" + scaleText + "'", "a number other than 0");
    const std::size_t planes = isColour ? 3 : 1, begin = at + 1;
    const std::size_t needed = begin + 4 * planes * width * height;
    if (bytes.size() != needed)
        refuse(name, "", std::to_string(bytes.size()) + " bytes",
               std::to_string(needed) + " bytes, as its header says");
    if (std::abs(*scale) != 1.0)
        remarkOn(name, "its scale of " + numberText(std::abs(*scale)) +
                           " is left out; values are as stored");

    RawNumber type;
    type.isBigEndian = *scale > 0.0;
    RadianceImage image(static_cast<int>(width), static_cast<int>(height), isColour ? "R" : "L",
                        "");
    if (isColour) {
        image.channel("G");
        image.channel("B");
    }
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t plane = 0; plane < planes; ++plane)
                image.channels[plane].values[(height - 1 - y) * width + x] =
                    rawValue(bytes.data() + begin + 4 * (planes * (y * width + x) + plane), type);
    return image;
}

namespace {

/// The header of a .npy file: a dictionary of Python.
class NpyHeader {
  public:
    NpyHeader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    RawNumber type() const {
        const std::string_view descr = quoted("descr");
        RawNumber type;
        type.isBigEndian = descr.starts_with('>');
        const char kind = descr.size() > 1 ? descr[1] : '\0';
        type.kind = kind == 'i'                  ? RawNumber::Kind::integer
                    : kind == 'u' || kind == 'b' ? RawNumber::Kind::natural
                                                 : RawNumber::Kind::real;
        std::size_t size = 0;
        const auto [end, error] =
            std::from_chars(descr.data() + std::min<std::size_t>(2, descr.size()),
                            descr.data() + descr.size(), size);
        type.size_B = size;
        const bool isKind = kind == 'i' || kind == 'u' || kind == 'b' || kind == 'f';
        if (!isKind || error != std::errc() || end != descr.data() + descr.size() ||
            !type.isKnown())
            refuse(file_, "descr", "'" + std::string(descr) + "'",
                   "floats of 2, 4 or 8 bytes or integers of 1 to 8");
        return type;
    }
    bool isFortran() const { return after("fortran_order").starts_with("True"); }
    /// Its two sides; dimensions of 1 beyond them do not count.
    std::pair<std::size_t, std::size_t> shape() const {
        std::string_view rest = after("shape");
        const std::size_t close = rest.find(')');
        if (!rest.starts_with('(') || close == std::string_view::npos)
            refuse(file_, "shape", "no shape", "(rows, columns)");
        const std::string all(rest.substr(0, std::min<std::size_t>(close + 1, 80)));
        std::vector<std::size_t> sides;
        for (rest = rest.substr(1, close - 1); !trimmed(rest).empty();) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            sides.push_back(sideOf(trimmed(rest.substr(0, comma)), "shape", file_));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
        while (sides.size() > 2) {
            const auto one = std::ranges::find(sides, std::size_t{1});
            if (one == sides.end())
                break;
            sides.erase(one);
        }
        if (sides.size() != 2)
            refuse(file_, "shape", all, "two dimensions: (rows, columns)");
        return {sides[0], sides[1]};
    }

  private:
    std::string_view after(std::string_view key) const {
        const std::size_t at = text_.find(std::string("'").append(key) + "'");
        if (at == std::string_view::npos)
            return {};
        const std::size_t colon = text_.find(':', at);
        return colon == std::string_view::npos ? std::string_view()
                                               : trimmed(text_.substr(colon + 1));
    }
    std::string_view quoted(std::string_view key) const {
        const std::string_view value = after(key);
        const std::size_t end = value.size() > 1 ? value.find(value[0], 1) : value.npos;
        const bool isQuoted = value.starts_with('\'') || value.starts_with('"');
        return isQuoted && end != value.npos ? value.substr(1, end - 1) : std::string_view();
    }

    std::string_view text_;
    const std::string& file_;
};

} // namespace

RadianceImage readNpy(const fs::path& file) {
    const std::string bytes = readFile(file), name = file.string();
    const auto byte = [&](std::size_t at) {
        return static_cast<std::size_t>(
            static_cast<unsigned char>(at < bytes.size() ? bytes[at] : 0));
    };
    const bool isLong = byte(6) > 1;
    const std::size_t begin = isLong ? 12 : 10;
    const std::size_t length =
        byte(8) | byte(9) << 8 | (isLong ? byte(10) << 16 | byte(11) << 24 : std::size_t{0});
    if (bytes.size() < begin || length > bytes.size() - begin)
        refuse(name, "header", "a header beyond the end of the file", "a whole .npy file");
    const NpyHeader header(std::string_view(bytes).substr(begin, length), name);
    const RawNumber type = header.type();
    const auto [height, width] = header.shape();
    const std::size_t needed = begin + length + height * width * type.size_B;
    if (bytes.size() != needed)
        refuse(name, "", std::to_string(bytes.size()) + " bytes",
               std::to_string(needed) + " bytes, as its header says");

    RadianceImage image(static_cast<int>(width), static_cast<int>(height), "L", "");
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t place = header.isFortran() ? x * height + y : y * width + x;
            image.primary().values[y * width + x] =
                rawValue(bytes.data() + begin + length + place * type.size_B, type);
        }
    return image;
}

extern constinit const ImageFormat esriFormat{
    .name = "ESRI ASCII grid",
    .shortName = "ESRI",
    .extensions = "",
    .alsoRead = ".asc .grd",
    .isText = true,
    .recognises = beginsAsGrid,
    .read = [](const fs::path& file, const ImageReading&) { return readEsriGrid(file); }};

extern constinit const ImageFormat pfmFormat{
    .name = "Portable float map",
    .shortName = "PFM",
    .extensions = "",
    .alsoRead = ".pfm",
    .recognises =
        [](std::string_view beginning) {
            return (beginning.starts_with("PF") || beginning.starts_with("Pf")) &&
                   beginning.size() > 2 && " \t\r\n"sv.find(beginning[2]) != std::string_view::npos;
        },
    .read = [](const fs::path& file, const ImageReading&) { return readPfm(file); }};

extern constinit const ImageFormat npyFormat{
    .name = "NumPy array",
    .shortName = "NumPy",
    .extensions = "",
    .alsoRead = ".npy",
    .recognises = [](std::string_view beginning) { return beginning.starts_with("\x93NUMPY"); },
    .read = [](const fs::path& file, const ImageReading&) { return readNpy(file); }};

} // namespace irsg
