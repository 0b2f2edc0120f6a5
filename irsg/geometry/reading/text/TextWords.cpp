#include "irsg/geometry/reading/text/TextWords.h"

#include <algorithm>

#include "irsg/core/ColumnText.h"
#include "irsg/core/CsvTable.h"

namespace irsg {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

} // namespace

bool TextWords::next() {
    words_.clear();
    bool continued = false;
    while (at_ < text_.size() && (words_.empty() || continued)) {
        std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line = text_.substr(at_, end - at_);
        if (!continued)
            line_ = breaks_ + 1;
        ++breaks_;
        at_ = end + 1;
        const auto last = line.find_last_not_of(blanks);
        line = line.substr(0, last == line.npos ? 0 : last + 1);
        continued = line.ends_with('\\');
        if (continued)
            line.remove_suffix(1);
        for (std::size_t begin = line.find_first_not_of(blanks); begin != line.npos;) {
            const std::size_t stop = std::min(line.find_first_of(blanks, begin), line.size());
            words_.push_back(line.substr(begin, stop - begin));
            begin = line.find_first_not_of(blanks, stop);
        }
    }
    return !words_.empty();
}

std::string_view TextWords::line() const {
    const char* const end = words_.back().data() + words_.back().size();
    return {words_[0].data(), static_cast<std::size_t>(end - words_[0].data())};
}

std::string TextWords::rest() const {
    if (words_.size() < 2)
        return "";
    // Names have blanks in them.
    const char* const begin = words_[1].data();
    const char* const end = words_.back().data() + words_.back().size();
    return begin < end ? std::string(begin, end) : std::string(words_[1]);
}

Diagnostic TextWords::diagnostic(std::string value, std::string expected) const {
    return {file_, "line " + std::to_string(line_), std::move(value), std::move(expected)};
}

bool TextWords::numbers(std::size_t from, std::size_t count, double* into,
                        std::vector<Diagnostic>& diagnostics) const {
    if (words_.size() < from + count) {
        diagnostics.push_back(
            diagnostic(std::to_string(words_.size() - std::min(from, words_.size())) +
                           " numbers behind \"" + std::string(words_[0]) + "\"",
                       std::to_string(count)));
        return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = modelNumber(words_[from + i]);
        if (!number) {
            diagnostics.push_back(diagnostic(quoted(words_[from + i]), "a finite number"));
            return false;
        }
        into[i] = *number;
    }
    return true;
}

std::optional<double> modelNumber(std::string_view word) {
    const auto number = parseNumber(word);
    if (number || word.find_first_of("dD") == word.npos)
        return number;
    const auto plain = plainNumber(word, '.');
    return plain ? parseNumber(*plain) : std::nullopt;
}

std::string quoted(std::string_view word) {
    constexpr std::size_t most = 40;
    return "\"" + std::string(word.substr(0, most)) + (word.size() > most ? "...\"" : "\"");
}

} // namespace irsg
