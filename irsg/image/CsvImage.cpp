#include "irsg/image/CsvImage.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/image/AttributeText.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"

namespace irsg {

namespace {

constexpr std::size_t diagnosticsShown = 20;

void appendNumber(std::string& out, float value) {
    if (std::isnan(value)) {
        out += "nan";
        return;
    }
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 9)
            .ptr;
    out.append(text.data(), end);
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

std::string_view withoutBlanks(std::string_view text) {
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

/// nan and inf are numbers, though they begin with a letter.
bool beginsWithNumber(std::string_view text) {
    const std::string_view word = text.substr(0, text.find_first_of(" \t"));
    float ignored = 0.0F;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), ignored);
    return end == word.data() + word.size() && error != std::errc::invalid_argument;
}

/// Of the first row of a text: what it is, where it is the heading of a table or no row of numbers
/// at all, so that one sentence says it. Empty for a row of an image, be it wrong in places.
std::string wordsOfHeading(std::string_view row) {
    constexpr std::size_t shown = 60;
    const std::string_view text = withoutBlanks(row);
    const std::string cut =
        text.size() > shown ? std::string(text.substr(0, shown)) + "..." : std::string(text);
    if (text.starts_with('{') || text.starts_with('[') || text.starts_with('<'))
        return "text that is no image (" + cut + ")";
    std::size_t names = 0;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(",;\t", begin), text.size());
        std::string_view name = withoutBlanks(text.substr(begin, end - begin));
        if (name.starts_with('"'))
            name.remove_prefix(1);
        begin = end + 1;
        if (name.empty() && names > 0)
            continue; // a separator at the end of the row
        if (name.empty() || !isLetter(name.front()) || beginsWithNumber(name))
            return "";
        ++names;
    }
    return names > 1 ? "a table of results (columns " + cut + ")"
                     : "text that is no image (" + cut + ")";
}

/// The next line of a text and what is left of it behind: lines end in LF, CRLF or CR.
std::string_view nextLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, end);
    const bool isPair = rest.substr(end).starts_with("\r\n");
    rest.remove_prefix(std::min(rest.size(), end + (isPair ? 2 : 1)));
    return line;
}

/// Collects the pixels and the header of a text, line by line.
class CsvImageParser {
  public:
    explicit CsvImageParser(std::string file) : file_(std::move(file)) {}

    void line(std::string_view text) {
        ++line_;
        if (text.starts_with('#'))
            comment(text.substr(1));
        else
            row(text);
    }

    RadianceImage image() {
        if (width_ == 0 && diagnostics_.empty())
            report("", "no number", "rows of numbers separated by commas");
        if (diagnostics_.empty())
            checkSize();
        if (!diagnostics_.empty())
            throw InputError(diagnostics_);

        const auto header = [this](const char* key, std::string otherwise) {
            const auto it = header_.plane.find(key);
            return it == header_.plane.end() ? otherwise : it->second;
        };
        RadianceImage image(static_cast<int>(width_), static_cast<int>(height_),
                            header("channel", "L"), header("unit", ""));
        image.primary().values = std::move(values_);
        image.attributes = std::move(header_.attributes);
        return image;
    }

    /// Nothing that follows can be of use.
    bool isFull() const { return isNoImage_ || diagnostics_.size() >= diagnosticsShown; }

  private:
    void report(std::string position, std::string value, std::string expected) {
        diagnostics_.push_back({file_, std::move(position), std::move(value), std::move(expected)});
    }
    std::string here() const { return "line " + std::to_string(line_); }

    void comment(std::string_view text) {
        if (text.starts_with(' '))
            text.remove_prefix(1);
        header_.read(text);
    }

    void row(std::string_view text) {
        if (height_ == 0) {
            if (std::string words = wordsOfHeading(text); !words.empty()) {
                report(here(), std::move(words), "an image: rows of numbers");
                isNoImage_ = true;
                return;
            }
        }
        // Fields are numbers; blanks may stand around a separator or be one.
        const auto isSeparator = [](char c) { return c == ',' || c == ';'; };
        const auto skipBlanks = [&](std::size_t i) {
            while (i < text.size() && isBlank(text[i]))
                ++i;
            return i;
        };
        std::size_t columns = 0;
        for (std::size_t i = skipBlanks(0); i < text.size() && !isFull();) {
            std::size_t end = i;
            while (end < text.size() && !isBlank(text[end]) && !isSeparator(text[end]))
                ++end;
            ++columns;
            values_.push_back(number(text.substr(i, end - i), columns));
            i = skipBlanks(end);
            if (i < text.size() && isSeparator(text[i]))
                i = skipBlanks(i + 1);
        }
        if (columns == 0 || isFull())
            return;

        ++height_;
        if (height_ == 1)
            width_ = columns;
        if (columns != width_)
            report(here(), std::to_string(columns) + " values",
                   std::to_string(width_) + " values, as in the first row");
    }

    float number(std::string_view text, std::size_t column) {
        const bool hasPlus = text.starts_with('+') && !text.starts_with("+-");
        const std::string_view digits = hasPlus ? text.substr(1) : text;
        const char* last = digits.data() + digits.size();
        float value = 0.0F;
        const auto [end, error] = std::from_chars(digits.data(), last, value);
        if (end == last && error == std::errc())
            return value;

        // Too small for a float is zero with its sign, too large is refused.
        const bool isOutOfRange = end == last && error == std::errc::result_out_of_range;
        if (isOutOfRange && isBelowOne(digits))
            return digits.starts_with('-') ? -0.0F : 0.0F;
        const std::string shown =
            text.size() > 40 ? std::string(text.substr(0, 40)) + "..." : std::string(text);
        report(here() + ", column " + std::to_string(column),
               shown.empty() ? "an empty field" : shown,
               isOutOfRange ? "a number within the range of 32-bit float" : "a number");
        return 0.0F;
    }

    /// Of a number that is out of range: whether it is too small rather than too large.
    static bool isBelowOne(std::string_view digits) {
        const std::size_t exponent = digits.find_first_of("eE");
        if (exponent != std::string_view::npos)
            return digits.substr(exponent + 1).starts_with('-');
        return digits.find_first_of("123456789") > digits.find('.');
    }

    void checkSize() {
        const auto claim = [this](const char* key, std::size_t found) {
            const auto it = header_.plane.find(key);
            if (it != header_.plane.end() && it->second != std::to_string(found))
                report(key, std::to_string(found), it->second + ", as the header says");
        };
        claim("width", width_);
        claim("height", height_);
        const auto limit = static_cast<std::size_t>(largestImageSide_px);
        if (width_ > limit || height_ > limit)
            report("", std::to_string(width_) + " x " + std::to_string(height_) + " pixels",
                   "at most " + std::to_string(limit) + " pixels a side");
    }

    std::string file_;
    int line_ = 0;
    bool isNoImage_ = false;
    std::size_t width_ = 0, height_ = 0;
    std::vector<float> values_;
    AttributeText header_;
    std::vector<Diagnostic> diagnostics_;
};

} // namespace

void writeCsvImage(const RadianceImage& image, const std::filesystem::path& file,
                   const std::string& channel) {
    const ImageChannel* plane = channel.empty() ? &image.primary() : image.find(channel);
    if (plane == nullptr)
        throw LogicError("an image has no channel " + channel);
    if (plane->values.size() != image.pixelCount())
        throw LogicError("channel " + plane->name + " is not as large as its image");

    std::string out;
    const auto comment = [&out](const std::string& line) { out += "# " + line + "\n"; };
    comment(attributeLine("channel", plane->name));
    comment(attributeLine("unit", plane->unit));
    comment(attributeLine("width", std::to_string(image.width())));
    comment(attributeLine("height", std::to_string(image.height())));
    for (const auto& [key, value] : image.attributes)
        comment(imageAttributeLine(key, value));

    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            appendNumber(out, plane->values[image.offset(x, y)]);
            out += x + 1 < image.width() ? ',' : '\n';
        }
    writeFileDurably(file, out);
}

RadianceImage readCsvImage(const std::filesystem::path& file) {
    const std::string bytes = readFile(file);
    std::string_view rest = bytes;
    if (const std::size_t nul = rest.find('\0'); nul != std::string_view::npos)
        throw InputError({file.string(), "byte " + std::to_string(nul), "a NUL byte", "text"});
    if (rest.starts_with("\xEF\xBB\xBF"))
        rest.remove_prefix(3);

    CsvImageParser parser(file.string());
    while (!rest.empty() && !parser.isFull())
        parser.line(nextLine(rest));
    return parser.image();
}

bool beginsAsCsvImage(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    std::set<std::string, std::less<>> keys;
    while (!text.empty()) {
        const std::string_view line = withoutBlanks(nextLine(text));
        if (line.starts_with('#')) {
            const std::string_view comment = withoutBlanks(line.substr(1));
            keys.emplace(comment.substr(0, comment.find(':')));
        } else if (!line.empty()) {
            return (keys.contains("channel") && keys.contains("width") &&
                    keys.contains("height")) ||
                   beginsWithNumber(line.substr(0, line.find_first_of(",;\t")));
        }
    }
    return false;
}

extern constinit const ImageFormat csvFormat{
    .name = "Values as text",
    .shortName = "CSV",
    .extensions = ".csv",
    .alsoRead = ".txt .dat",
    .keeps = ImageFormat::Keeps::onePlane,
    .isUsual = true,
    .isText = true,
    .recognises =
        [](std::string_view beginning) {
            return beginning.find('\0') == std::string_view::npos && beginsAsCsvImage(beginning);
        },
    .read = readCsvImage,
    .write = [](const RadianceImage& image, const std::filesystem::path& file,
                const ImageWriting& how) { writeCsvImage(image, file, how.channel); }};

} // namespace irsg
