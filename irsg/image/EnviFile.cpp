#include "irsg/image/EnviFile.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"
#include "irsg/core/Wording.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/RawNumbers.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largestHeader_B = std::uint64_t{16} << 20;
constexpr std::array<const char*, 9> dataExtensions = {"",     ".img", ".dat", ".raw", ".bin",
                                                       ".bsq", ".bil", ".bip", ".envi"};

bool beginsAsEnvi(std::string_view beginning) {
    return trimmed(takeLine(beginning = withoutByteOrderMark(beginning))) == "ENVI";
}

bool isRegular(const fs::path& file) {
    std::error_code unknown;
    return fs::is_regular_file(file, unknown);
}

bool isHeader(const fs::path& file) {
    return isRegular(file) && beginsAsEnvi(readFileBeginning(file, 64));
}

/// A file by a name that may have other upper and lower case; empty where there is none.
fs::path regularFile(const fs::path& named) {
    if (isRegular(named))
        return named;
    const fs::path found = findWritten(named.parent_path(), named.filename().string()).file;
    return isRegular(found) ? found : fs::path();
}

/// The keys of a header with their values, which may go over lines in braces.
class EnviHeader {
  public:
    explicit EnviHeader(const fs::path& file) : file_(file.string()) {
        const std::string bytes = readFile(file, largestHeader_B);
        std::string_view rest = withoutByteOrderMark(bytes);
        for (int line = 1; !rest.empty(); ++line) {
            const std::string_view content = trimmed(takeLine(rest));
            const std::size_t equal = content.find('=');
            if (line == 1 || content.empty() || content.starts_with(';') ||
                equal == std::string_view::npos)
                continue;
            const int begin = line;
            std::string value(trimmed(content.substr(equal + 1)));
            while (value.starts_with('{') && value.find('}') == std::string::npos &&
                   !rest.empty()) {
                value += ' ';
                value += trimmed(takeLine(rest));
                ++line;
            }
            if (value.starts_with('{'))
                value = std::string(trimmed(std::string_view(value).substr(
                    1, value.find('}') == std::string::npos ? std::string::npos
                                                            : value.find('}') - 1)));
            values_[lowerCase(std::string(trimmed(content.substr(0, equal))))] = {value, begin};
        }
    }

    bool has(const char* key) const { return values_.contains(key); }
    std::string text(const char* key) const {
        const auto found = values_.find(key);
        return found == values_.end() ? "" : found->second.first;
    }
    /// A whole number in a range; `otherwise` where the key is missing, InputError without it.
    long whole(const char* key, long least, long most, std::optional<long> otherwise = {}) const {
        if (!has(key) && otherwise)
            return *otherwise;
        const auto value = parseNumber(text(key));
        if (!value || *value != std::floor(*value) || *value < static_cast<double>(least) ||
            *value > static_cast<double>(most))
            refuse(key,
                   "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        return static_cast<long>(*value);
    }
    [[noreturn]] void refuse(const char* key, const std::string& expected) const {
        const auto found = values_.find(key);
        throw InputError(
            {file_, found == values_.end() ? "" : "line " + std::to_string(found->second.second),
             found == values_.end() ? "no " + std::string(key)
                                    : std::string(key) + " = " + found->second.first,
             expected});
    }
    std::vector<std::string> list(const char* key) const {
        std::vector<std::string> items;
        std::string_view rest = values_.contains(key) ? values_.at(key).first : std::string_view();
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            items.emplace_back(trimmed(rest.substr(0, comma)));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
        return items;
    }
    /// A number for each band; none where the key is missing, InputError for another count.
    std::vector<double> perBand(const char* key, std::size_t bands) const {
        std::vector<double> numbers;
        for (const std::string& item : list(key)) {
            const auto number = parseNumber(item);
            if (!number)
                refuse(key, "numbers between commas");
            numbers.push_back(*number);
        }
        if (has(key) && numbers.size() != bands)
            refuse(key, std::to_string(bands) + " numbers, one for each band, not " +
                            std::to_string(numbers.size()));
        return numbers;
    }
    const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::map<std::string, std::pair<std::string, int>> values_;
};

RawNumber typeOf(const EnviHeader& header) {
    using Kind = RawNumber::Kind;
    RawNumber type;
    type.isBigEndian = header.whole("byte order", 0, 1, 0) == 1;
    switch (header.whole("data type", 1, 15)) {
    case 1:
        type.kind = Kind::natural, type.size_B = 1;
        break;
    case 2:
        type.kind = Kind::integer, type.size_B = 2;
        break;
    case 3:
        type.kind = Kind::integer, type.size_B = 4;
        break;
    case 4:
        type.kind = Kind::real, type.size_B = 4;
        break;
    case 5:
        type.kind = Kind::real, type.size_B = 8;
        break;
    case 12:
        type.kind = Kind::natural, type.size_B = 2;
        break;
    case 13:
        type.kind = Kind::natural, type.size_B = 4;
        break;
    case 14:
        type.kind = Kind::integer, type.size_B = 8;
        break;
    case 15:
        type.kind = Kind::natural, type.size_B = 8;
        break;
    default:
        header.refuse("data type", "1 to 5 or 12 to 15: no complex numbers");
    }
    return type;
}

/// The data beside a header.
fs::path dataOf(const fs::path& header, const fs::path& asked) {
    if (asked != header)
        return asked;
    const fs::path stem = fs::path(header).replace_extension();
    for (const char* const extension : dataExtensions) {
        const fs::path data = regularFile(stem.string() + extension);
        if (!data.empty() && data != header)
            return data;
    }
    throw InputError({header.string(), "", "no data beside this header",
                      stem.filename().string() + ".img, or the same name with .dat, .raw, .bsq, "
                                                 ".bil, .bip or without an ending"});
}

std::vector<std::string> bandNames(const EnviHeader& header, std::size_t bands) {
    std::vector<std::string> names = header.list("band names");
    bool areSound = names.size() == bands;
    for (std::size_t i = 0; areSound && i < names.size(); ++i)
        areSound = !names[i].empty() && names[i].size() <= 200 &&
                   std::count(names.begin(), names.end(), names[i]) == 1;
    if (bands == 1)
        return {"L"};
    if (!areSound) {
        names.clear();
        for (std::size_t i = 0; i < bands; ++i)
            names.push_back("band" + std::to_string(i + 1));
    }
    return names;
}

} // namespace

fs::path enviHeaderOf(const fs::path& file) {
    for (const fs::path& header :
         {file, fs::path(file.string() + ".hdr"), fs::path(file).replace_extension(".hdr")})
        if (fs::path found = regularFile(header); !found.empty() && isHeader(found))
            return found;
    return {};
}

RadianceImage readEnvi(const fs::path& file) {
    const fs::path headerFile = enviHeaderOf(file);
    if (headerFile.empty())
        throw InputError({file.string(), "", "no ENVI header", "a header that begins with ENVI"});
    const EnviHeader header(headerFile);
    const auto width = static_cast<std::size_t>(header.whole("samples", 1, largestImageSide_px));
    const auto height = static_cast<std::size_t>(header.whole("lines", 1, largestImageSide_px));
    const auto bands = static_cast<std::size_t>(header.whole("bands", 1, 4096, 1));
    const auto offset = static_cast<std::size_t>(header.whole("header offset", 0, 1L << 30, 0));
    const RawNumber type = typeOf(header);
    const std::string interleave =
        header.has("interleave") ? lowerCase(header.text("interleave")) : "bsq";
    if (interleave != "bsq" && interleave != "bil" && interleave != "bip")
        header.refuse("interleave", "bsq, bil or bip");

    const fs::path dataFile = dataOf(headerFile, file);
    const std::string bytes = readFile(dataFile);
    const std::size_t needed = offset + width * height * bands * type.size_B;
    if (bytes.size() != needed)
        throw InputError(
            {dataFile.string(), "", std::to_string(bytes.size()) + " bytes",
             std::to_string(needed) + " bytes, as " + headerFile.filename().string() + " says"});

    // The values in the order of the file, each to its place.
    const std::vector<std::string> names = bandNames(header, bands);
    RadianceImage image(static_cast<int>(width), static_cast<int>(height), names.front(), "");
    for (const std::string& name : names)
        image.channel(name);
    const auto ignored = parseNumber(header.text("data ignore value"));
    const std::vector<double> gains = header.perBand("data gain values", bands);
    const std::vector<double> offsets = header.perBand("data offset values", bands);
    const bool isScaled = !gains.empty() || !offsets.empty();
    std::size_t missing = 0;
    for (std::size_t b = 0; b < bands; ++b)
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x) {
                const std::size_t place = interleave == "bsq"   ? (b * height + y) * width + x
                                          : interleave == "bil" ? (y * bands + b) * width + x
                                                                : (y * width + x) * bands + b;
                float value = rawValue(bytes.data() + offset + place * type.size_B, type);
                if (ignored && value == static_cast<float>(*ignored)) {
                    value = std::numeric_limits<float>::quiet_NaN();
                    ++missing;
                } else if (isScaled) {
                    value = static_cast<float>((gains.empty() ? 1.0 : gains[b]) * value +
                                               (offsets.empty() ? 0.0 : offsets[b]));
                }
                image.channels[b].values[y * width + x] = value;
            }
    if (missing > 0)
        remarkOn(header.file(), std::to_string(missing) + " values are the 'data ignore value' and "
                                                          "are read as NaN");
    if (isScaled)
        remarkOn(header.file(),
                 "values are gain * stored value + offset, as 'data gain values' and "
                 "'data offset values' say");
    for (const char* const key : {"description", "wavelength", "wavelength units", "sensor type"})
        if (header.has(key))
            image.attributes[key] = header.text(key);
    for (const char* const key : {"reflectance scale factor", "data reflectance gain values",
                                  "data reflectance offset values"})
        if (header.has(key))
            remarkOn(header.file(), "'" + std::string(key) + "' is left out: values are " +
                                        (isScaled ? "not those of reflectance" : "as stored"));
    return image;
}

extern constinit const ImageFormat enviFormat{
    .name = "ENVI image",
    .shortName = "ENVI",
    .extensions = "",
    .alsoRead = ".hdr .img .raw .bsq .bil .bip",
    .isText = true,
    .recognises = beginsAsEnvi,
    .read = [](const fs::path& file, const ImageReading&) { return readEnvi(file); }};

} // namespace irsg
