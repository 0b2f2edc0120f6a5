#pragma once

#include <string>
#include <string_view>

#include "irsg/core/Errors.h"

namespace irsg {

/// A drawing in the exchange format of AutoCAD (.dxf) as pairs of lines: a code and a value.
class DxfPairs {
  public:
    /// The text is a plainText() and must outlive the object.
    DxfPairs(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    /// The next pair; false behind the last one. Throws InputError, with its line, where a code is
    /// no whole number or its value is missing.
    bool next();
    int code() const { return code_; }
    /// Without blanks at its ends.
    std::string_view value() const { return value_; }
    bool is(int code, std::string_view value) const { return code_ == code && value_ == value; }
    /// The value as a finite number. Throws InputError where it is none.
    double number() const;
    /// As a whole number within those of 32 bits. Throws likewise.
    int whole() const;

    [[noreturn]] void refuse(std::string value, std::string expected) const;

  private:
    std::string_view line();

    std::string_view text_, value_;
    std::string file_;
    std::size_t at_ = 0, line_ = 0;
    int code_ = 0;
};

} // namespace irsg
