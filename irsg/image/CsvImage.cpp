#include "irsg/image/CsvImage.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "irsg/core/BinaryFormats.h"
#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Remarks.h"
#include "irsg/core/Utf8.h"
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

std::string shortened(std::string_view text, std::size_t most) {
    return text.size() > most ? std::string(text.substr(0, most)) + "..." : std::string(text);
}

std::size_t filledWidth(const std::vector<ColumnCell>& cells) {
    std::size_t width = cells.size();
    while (width > 0 && cells[width - 1].text.empty() && !cells[width - 1].isQuoted)
        --width;
    return width;
}

/// The rows of a text: where the first row of numbers is, and what stands above it.
struct TextRows {
    ColumnDialect dialect;
    int numberLine = 0;       ///< of the first row of numbers; 0: there is none
    std::size_t width = 0;    ///< cells of it
    bool hasSecond = false;   ///< the row behind it is one of numbers and as wide
    int headLine = 0;         ///< the first that holds words; 0: none
    std::string_view head;    ///< that line
    int lastHeadLine = 0;     ///< the last that holds words
    std::string_view nearest; ///< that line
    bool isApart = false;     ///< nothing but separators stands between words and numbers
};

TextRows rowsOf(std::string_view text, const ColumnDialect& dialect) {
    TextRows rows;
    rows.dialect = dialect;
    std::vector<ColumnCell> cells;
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = takeLine(text);
        if (isCommentLine(line) || (number == 1 && statedSeparator(line)))
            continue;
        if (!splitColumns(line, dialect.separator, cells) || filledWidth(cells) > 0) {
            if (isNumberRow(cells, dialect)) {
                if (rows.numberLine != 0) {
                    rows.hasSecond = filledWidth(cells) == rows.width;
                    return rows;
                }
                rows.numberLine = number;
                rows.width = filledWidth(cells);
            } else if (rows.numberLine != 0) {
                return rows;
            } else {
                if (rows.headLine == 0) {
                    rows.headLine = number;
                    rows.head = trimmed(line);
                }
                rows.lastHeadLine = number;
                rows.nearest = line;
                rows.isApart = false;
            }
        } else if (rows.headLine != 0) {
            rows.isApart = true;
        }
    }
    return rows;
}

/// Whether a line names each of so many columns.
bool namesColumns(std::string_view line, const ColumnDialect& dialect, std::size_t width) {
    std::vector<ColumnCell> cells;
    if (!splitColumns(line, dialect.separator, cells))
        return false;
    std::size_t names = 0;
    for (const ColumnCell& cell : cells) {
        if (cell.text.empty())
            continue;
        if (!isLetter(cell.text.front()) || isNumberCell(cell, dialect))
            return false;
        ++names;
    }
    return names >= 2 && names >= width;
}

bool beginsWithNumber(std::string_view line, const ColumnDialect& dialect) {
    std::vector<ColumnCell> cells;
    return splitColumns(line, dialect.separator, cells) && !cells.empty() &&
           isNumberCell(cells.front(), dialect);
}

/// Whether words above the numbers are those of a camera or a program, and no names of columns.
bool areHeadLines(const TextRows& rows) {
    const char first = rows.head.empty() ? '\0' : rows.head.front();
    if (rows.numberLine == 0 || rows.headLine == 0 || first == '{' || first == '[' || first == '<')
        return false;
    if (!rows.hasSecond || rows.width < 2)
        return false;
    if (beginsWithNumber(rows.nearest, rows.dialect))
        return false;
    if (rows.isApart)
        return !namesColumns(rows.nearest, rows.dialect, rows.width);
    std::vector<ColumnCell> cells;
    splitColumns(rows.nearest, rows.dialect.separator, cells);
    const std::size_t width = filledWidth(cells);
    // A key with its value, or a line of words above many columns.
    const bool hasNumber = std::ranges::any_of(
        cells, [&](const ColumnCell& cell) { return isNumberCell(cell, rows.dialect); });
    return (width != rows.width && rows.width > 2) || (width == 2 && hasNumber && rows.width > 2);
}

/// Of the words above numbers: what they are, where they are no head lines of an image, so that one
/// sentence says it. Empty for a row of an image that is wrong in places.
std::string wordsOfHeading(std::string_view row, const ColumnDialect& dialect) {
    const std::string_view text = trimmed(row);
    const std::string cut = shortened(text, 60);
    if (text.starts_with('{') || text.starts_with('[') || text.starts_with('<'))
        return "text that is no image (" + cut + ")";
    std::vector<ColumnCell> cells;
    if (!splitColumns(text, dialect.separator, cells))
        return "";
    std::size_t names = 0;
    for (const ColumnCell& cell : cells) {
        if (cell.text.empty() && names > 0)
            continue; // a separator at the end of the row
        if (cell.text.empty() || !isLetter(cell.text.front()) || isNumberCell(cell, dialect))
            return "";
        ++names;
    }
    return names > 1 ? "a table of results (columns " + cut + ")"
                     : "text that is no image (" + cut + ")";
}

/// Collects the pixels and the header of a text, line by line.
class CsvImageParser {
  public:
    CsvImageParser(std::string file, const TextRows& rows)
        : file_(std::move(file)),
          dialect_(rows.dialect),
          numberWidth_(rows.width),
          firstLine_(areHeadLines(rows) ? rows.numberLine : 0) {}

    void line(std::string_view text) {
        ++line_;
        if (isCommentLine(text))
            comment(text);
        else if (line_ >= firstLine_ && !(line_ == 1 && statedSeparator(text)))
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
        std::string own;
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        // As a spreadsheet saves it: in quotes, as wide as the rows of numbers.
        if (numberWidth_ > 1 && dialect_.separator != ' ' &&
            splitColumns(text, dialect_.separator, cells_) &&
            (cells_.size() == numberWidth_ || cells_.front().isQuoted)) {
            text =
                text.substr(0, text.find_last_not_of(std::string(" \t") + dialect_.separator) + 1);
            if (cells_.front().isQuoted && filledWidth(cells_) == 1) {
                own = textOf(cells_.front());
                text = own;
            }
        }
        text.remove_prefix(1);
        if (text.starts_with(' '))
            text.remove_prefix(1);
        header_.read(text);
    }

    void row(std::string_view text) {
        if (height_ == 0) {
            if (std::string words = wordsOfHeading(text, dialect_); !words.empty()) {
                report(here(), std::move(words), "an image: rows of numbers");
                isNoImage_ = true;
                return;
            }
        }
        if (!splitColumns(text, dialect_.separator, cells_)) {
            report(here(), shortened(trimmed(text), 40), "a closing quote on the same line");
            return;
        }
        const std::size_t columns = filledWidth(cells_);
        for (std::size_t i = 0; i < columns && !isFull(); ++i)
            values_.push_back(number(cells_[i], i + 1));
        if (columns == 0 || isFull())
            return;

        ++height_;
        if (height_ == 1)
            width_ = columns;
        if (columns != width_)
            report(here(), std::to_string(columns) + " values",
                   std::to_string(width_) + " values, as in the first row");
    }

    float number(const ColumnCell& cell, std::size_t column) {
        const std::string_view text = cell.text;
        float value = 0.0F;
        if (dialect_.decimal == '.' && !cell.isQuoted) {
            // As most are, without a copy.
            const char* const last = text.data() + text.size();
            const auto [end, error] = std::from_chars(text.data(), last, value);
            if (end == last && error == std::errc())
                return value;
        }
        const std::optional<std::string> plain = cellNumber(cell, dialect_);
        std::string_view digits = plain ? std::string_view(*plain) : std::string_view();
        if (digits.starts_with('+'))
            digits.remove_prefix(1);
        const char* const last = digits.data() + digits.size();
        const auto [end, error] = std::from_chars(digits.data(), last, value);
        if (plain && end == last && error == std::errc())
            return value;

        // Too small for a float is zero with its sign, too large is refused.
        const bool isOutOfRange = plain && error == std::errc::result_out_of_range;
        if (isOutOfRange && isBelowOne(digits))
            return digits.starts_with('-') ? -0.0F : 0.0F;
        report(here() + ", column " + std::to_string(column),
               text.empty() ? "an empty field" : shortened(text, 40),
               isOutOfRange              ? "a number within the range of 32-bit float"
               : dialect_.decimal == ',' ? "a number, with a decimal comma as elsewhere"
                                         : "a number");
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
    ColumnDialect dialect_;
    std::size_t numberWidth_ = 0; ///< cells of the first row of numbers
    int firstLine_ = 0;           ///< what stands above it are head lines
    int line_ = 0;
    bool isNoImage_ = false;
    std::size_t width_ = 0, height_ = 0;
    std::vector<ColumnCell> cells_;
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
    std::string decoded;
    const std::string_view text = utf8Of(bytes, decoded);
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
        throw InputError({file.string(), "byte " + std::to_string(nul),
                          std::string(foundInPlaceOfText(bytes)), "text"});

    const TextRows rows = rowsOf(text, columnDialectOf(text, file.string()));
    CsvImageParser parser(file.string(), rows);
    for (std::string_view rest = text; !rest.empty() && !parser.isFull();)
        parser.line(takeLine(rest));
    RadianceImage image = parser.image();
    if (!rows.dialect.isPlain())
        remarkOn(file.string(), rows.dialect.words());
    if (!decoded.empty() && !isUtf16(bytes))
        remarkOn(file.string(), latin1Words);
    if (areHeadLines(rows))
        remarkOn(file.string(), "lines " + std::to_string(rows.headLine) + " to " +
                                    std::to_string(rows.lastHeadLine) +
                                    " are left out as head lines");
    return image;
}

bool beginsAsCsvImage(std::string_view bytes) {
    std::string decoded;
    const std::string_view text = utf8Of(bytes, decoded);
    if (text.find('\0') != std::string_view::npos)
        return false;
    std::set<std::string, std::less<>> keys;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = trimmed(takeLine(rest));
        if (!isCommentLine(line)) {
            if (!line.empty())
                break;
            continue;
        }
        const std::string_view comment = trimmed(line.substr(line.find('#') + 1));
        keys.emplace(comment.substr(0, comment.find(':')));
    }
    if (keys.contains("channel") && keys.contains("width") && keys.contains("height")) {
        // An image of ours, be its numbers wrong; only a table of results has names in their place.
        const TextRows rows = rowsOf(text, {});
        return rows.headLine == 0 ||
               wordsOfHeading(rows.head, {}).find("table") == std::string::npos;
    }
    try {
        const TextRows rows = rowsOf(text, columnDialectOf(text, ""));
        return rows.headLine == 0 ? rows.numberLine != 0
                                  : areHeadLines(rows) || beginsWithNumber(rows.head, rows.dialect);
    } catch (const InputError&) {
        return true; // numbers that can be read in two ways
    }
}

extern constinit const ImageFormat csvFormat{
    .name = "Values as text",
    .shortName = "CSV",
    .extensions = ".csv",
    .alsoRead = ".txt .dat",
    .keeps = ImageFormat::Keeps::onePlane,
    .isUsual = true,
    .isText = true,
    .recognises = beginsAsCsvImage,
    .read = [](const std::filesystem::path& file,
               const ImageReading&) { return readCsvImage(file); },
    .write = [](const RadianceImage& image, const std::filesystem::path& file,
                const ImageWriting& how) { writeCsvImage(image, file, how.channel); }};

} // namespace irsg
