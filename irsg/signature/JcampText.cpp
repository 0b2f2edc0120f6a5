#include "irsg/signature/JcampText.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"

namespace irsg {

namespace {

constexpr std::size_t mostPoints = std::size_t{1} << 20;

/// One number of a packed line, and how it is meant.
struct Token {
    enum class Kind { value, difference, repetition };
    Kind kind = Kind::value;
    double number = 0.0;
};

/// The first digit with its sign that a letter stands for, of the letters from `zero` on:
/// '@' is 0, 'A' to 'I' are 1 to 9, 'a' to 'i' are -1 to -9.
std::optional<int> digitOf(char c, char zero, char positive, char negative) {
    if (c == zero)
        return 0;
    if (c >= positive && c < positive + 9)
        return c - positive + 1;
    if (c >= negative && c < negative + 9)
        return -(c - negative + 1);
    return std::nullopt;
}

class Packed {
  public:
    Packed(std::string_view line, const std::string& file, int number)
        : rest_(trimmed(line)), file_(file), line_(number) {}

    std::optional<Token> next() {
        while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t' || rest_[0] == ','))
            rest_.remove_prefix(1);
        if (rest_.empty())
            return std::nullopt;
        const char c = rest_[0];
        if (const auto digit = digitOf(c, '@', 'A', 'a'))
            return packed(Token::Kind::value, *digit);
        if (const auto digit = digitOf(c, '%', 'J', 'j'))
            return packed(Token::Kind::difference, *digit);
        if (c >= 'S' && c <= 'Z')
            return packed(Token::Kind::repetition, c - 'S' + 1);
        if (c == 's')
            return packed(Token::Kind::repetition, 9);
        return plain();
    }

  private:
    Token packed(Token::Kind kind, int first) {
        rest_.remove_prefix(1);
        std::string digits = std::to_string(first);
        while (!rest_.empty() && ((rest_[0] >= '0' && rest_[0] <= '9') || rest_[0] == '.')) {
            digits += rest_[0];
            rest_.remove_prefix(1);
        }
        return {kind, number(digits)};
    }

    Token plain() {
        std::size_t end = 1;
        while (end < rest_.size()) {
            const char c = rest_[end];
            const bool isExponent = c == 'E' && end + 1 < rest_.size() &&
                                    (rest_[end + 1] == '+' || rest_[end + 1] == '-');
            const bool isSignOfExponent = (c == '+' || c == '-') && rest_[end - 1] == 'E';
            if (!(c >= '0' && c <= '9') && c != '.' && !isExponent && !isSignOfExponent)
                break;
            ++end;
        }
        const std::string digits(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return {Token::Kind::value, number(digits)};
    }

    double number(const std::string& digits) const {
        const auto plain = plainNumber(digits, '.');
        const auto value = plain ? parseNumber(*plain) : std::nullopt;
        if (!value)
            throw InputError({file_, "line " + std::to_string(line_), "'" + digits + "'",
                              "a number of JCAMP-DX"});
        return *value;
    }

    std::string_view rest_;
    const std::string& file_;
    int line_;
};

class Reader {
  public:
    Reader(std::string_view text, const std::string& file) : file_(file) {
        bool isData = false;
        for (int line = 1; !text.empty(); ++line) {
            std::string_view content = takeLine(text);
            content = trimmed(content.substr(0, content.find("$$")));
            if (content.empty())
                continue;
            if (content.starts_with("##")) {
                if (isData)
                    break;
                isData = label(content, line);
            } else if (isData && isPoints_) {
                points(content, line);
            } else if (isData) {
                ordinates(content, line);
            }
        }
        if (!isData)
            refuse(0, "no XYDATA", "##XYDATA=(X++(Y..Y)) or ##XYPOINTS=(XY..XY)");
    }

    JcampText result() {
        JcampText text;
        const auto take = [&](const char* key, std::string& into, int& line) {
            const auto found = labels_.find(key);
            if (found != labels_.end())
                std::tie(into, line) = found->second;
        };
        int ignored = 0;
        take("TITLE", text.title, ignored);
        take("XUNITS", text.xUnits, text.xUnitsLine);
        take("YUNITS", text.yUnits, text.yUnitsLine);
        if (isPoints_)
            text.x = x_;
        else
            abscissas(text.x);
        const double factor = numberOf("YFACTOR").value_or(1.0);
        for (const double y : y_)
            text.y.push_back(factor * y);
        text.lines = lines_;
        return text;
    }

  private:
    [[noreturn]] void refuse(int line, const std::string& value,
                             const std::string& expected) const {
        throw InputError({file_, line > 0 ? "line " + std::to_string(line) : "", value, expected});
    }

    /// Reads "##KEY= value"; true where data follow.
    bool label(std::string_view content, int line) {
        const std::size_t equal = content.find('=');
        if (equal == std::string_view::npos)
            refuse(line, "'" + std::string(content.substr(0, 60)) + "'", "##LABEL= VALUE");
        std::string key;
        for (const char c : content.substr(2, equal - 2))
            if (c != ' ' && c != '-' && c != '_' && c != '/')
                key += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        const std::string value(trimmed(content.substr(equal + 1)));
        if (key == "NTUPLES" || key == "PEAKTABLE")
            refuse(line, key, "one spectrum: XYDATA or XYPOINTS");
        const bool isTable = key == "XYDATA" || key == "XYPOINTS";
        isPoints_ = isPoints_ || key == "XYPOINTS";
        const bool isList = value.starts_with("(XY..XY)");
        if (isTable && !isList && !value.starts_with("(X++(Y..Y))"))
            refuse(line, "'" + value + "'", "(X++(Y..Y)) or (XY..XY)");
        isPoints_ = isPoints_ || (isTable && isList);
        labels_.try_emplace(key, value, line);
        return isTable;
    }

    std::optional<double> numberOf(const char* key) const {
        const auto found = labels_.find(key);
        if (found == labels_.end())
            return std::nullopt;
        const auto& [text, line] = found->second;
        const auto plain = plainNumber(text, '.');
        const auto value = plain ? parseNumber(*plain) : std::nullopt;
        if (!value)
            refuse(line, "'" + text + "'", "a number");
        return value;
    }

    /// Pairs "x, y; x, y" or "x y".
    void points(std::string_view content, int line) {
        std::string text(content);
        std::ranges::replace(text, ';', ' ');
        Packed packed(text, file_, line);
        const double xFactor = numberOf("XFACTOR").value_or(1.0);
        while (const auto x = packed.next()) {
            const auto y = packed.next();
            if (!y)
                refuse(line, "an abscissa alone", "pairs of numbers");
            x_.push_back(xFactor * x->number);
            add(y->number, line);
        }
    }

    void add(double y, int line) {
        if (y_.size() >= mostPoints)
            refuse(line, "more points", "at most " + std::to_string(mostPoints));
        y_.push_back(y);
        lines_.push_back(line);
    }

    /// The abscissa of a line and its ordinates.
    void ordinates(std::string_view content, int line) {
        Packed packed(content, file_, line);
        const auto x = packed.next();
        if (!x)
            return;
        starts_.push_back({x->number, y_.size(), line});
        Token last;
        double difference = 0.0;
        bool isFirst = true;
        const bool isCheck = endsInDifference_;
        while (const auto token = packed.next()) {
            if (token->kind == Token::Kind::repetition) {
                if (isFirst)
                    refuse(line, "a repetition", "an ordinate before it");
                for (int i = 1; i < static_cast<int>(std::min(token->number, 1e7)); ++i)
                    put(last, difference, line);
                continue;
            }
            // Behind a line of differences the first ordinate repeats the last one as a check.
            if (isFirst && isCheck && token->kind == Token::Kind::value) {
                if (std::abs(token->number - y_.back()) > 0.5)
                    refuse(line, "the check value " + numberText(token->number),
                           numberText(y_.back()) + ", the last ordinate of the line before");
                starts_.back().first = y_.size() - 1;
                last = *token;
                isFirst = false;
                continue;
            }
            isFirst = false;
            last = *token;
            difference = token->number;
            put(last, difference, line);
        }
        endsInDifference_ = last.kind == Token::Kind::difference;
    }

    void put(const Token& token, double difference, int line) {
        if (token.kind != Token::Kind::difference)
            add(token.number, line);
        else if (y_.empty())
            refuse(line, "a difference", "an ordinate before it");
        else
            add(y_.back() + difference, line);
    }

    /// From FIRSTX and LASTX, checked with the abscissas of the lines.
    void abscissas(std::vector<double>& x) const {
        const auto first = numberOf("FIRSTX"), last = numberOf("LASTX");
        if (!first || !last)
            refuse(0, !first ? "no FIRSTX" : "no LASTX", "##FIRSTX= and ##LASTX=");
        if (const auto count = numberOf("NPOINTS");
            count && *count != static_cast<double>(y_.size()))
            refuse(labels_.at("NPOINTS").second, std::to_string(y_.size()) + " ordinates",
                   numberText(*count) + ", as NPOINTS says");
        if (y_.size() < 2)
            refuse(0, std::to_string(y_.size()) + " ordinates", "at least two");
        const double step = (*last - *first) / static_cast<double>(y_.size() - 1);
        for (std::size_t i = 0; i < y_.size(); ++i)
            x.push_back(*first + step * static_cast<double>(i));
        const double factor = numberOf("XFACTOR").value_or(1.0);
        for (const Start& start : starts_)
            if (start.first < x.size() &&
                std::abs(start.x * factor - x[start.first]) > std::abs(step) + std::abs(factor))
                refuse(start.line, "the abscissa " + numberText(start.x * factor),
                       "about " + numberText(x[start.first]) + " (FIRSTX, LASTX, NPOINTS)");
    }

    struct Start {
        double x = 0.0;
        std::size_t first = 0; ///< ordinate that it belongs to
        int line = 0;
    };

    const std::string& file_;
    std::map<std::string, std::pair<std::string, int>> labels_;
    bool isPoints_ = false, endsInDifference_ = false;
    std::vector<double> x_, y_;
    std::vector<int> lines_;
    std::vector<Start> starts_;
};

} // namespace

JcampText readJcampText(std::string_view text, const std::string& file) {
    return Reader(text, file).result();
}

} // namespace irsg
