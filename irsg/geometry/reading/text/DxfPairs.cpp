#include "irsg/geometry/reading/text/DxfPairs.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "irsg/core/CsvTable.h"
#include "irsg/geometry/reading/text/TextWords.h"

namespace irsg {

std::string_view DxfPairs::line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    ++line_;
    constexpr std::string_view blanks = " \t";
    const auto first = line.find_first_not_of(blanks);
    if (first == line.npos)
        return {};
    return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

bool DxfPairs::next() {
    std::string_view code;
    while (code.empty()) {
        if (at_ >= text_.size())
            return false;
        code = line();
    }
    const auto [stop, error] = std::from_chars(code.data(), code.data() + code.size(), code_);
    if (error != std::errc{} || stop != code.data() + code.size())
        refuse(quoted(code), "the code of a value, a whole number");
    if (at_ >= text_.size())
        refuse("the end of the file behind a code", "its value");
    value_ = line();
    return true;
}

double DxfPairs::number() const {
    const auto number = modelNumber(value_);
    if (!number)
        refuse(quoted(value_), "a finite number");
    return *number;
}

int DxfPairs::whole() const {
    const double value = number();
    if (value != std::floor(value) || std::abs(value) > 2147483647.0)
        refuse(quoted(value_), "a whole number");
    return static_cast<int>(value);
}

void DxfPairs::refuse(std::string value, std::string expected) const {
    throw InputError(
        {file_, "line " + std::to_string(line_), std::move(value), std::move(expected)});
}

} // namespace irsg
