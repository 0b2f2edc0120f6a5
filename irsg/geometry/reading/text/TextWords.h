#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// Readers of models stop after so many complaints about a file.
inline constexpr std::size_t mostModelDiagnostics = 100;

/// A text model line by line, as words between blanks. A line that ends in a backslash goes on.
class TextWords {
  public:
    /// The text must outlive the object.
    TextWords(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    /// The words of the next line that has any; false at the end.
    bool next();
    const std::vector<std::string_view>& words() const { return words_; }
    /// All of it, from the first word to the last.
    std::string_view line() const;
    /// All of the line behind the first word, without blanks at its ends.
    std::string rest() const;

    /// About the line that was read last.
    Diagnostic diagnostic(std::string value, std::string expected) const;
    /// The finite numbers of `count` words from one on; notes a diagnostic where one is not.
    bool numbers(std::size_t from, std::size_t count, double* into,
                 std::vector<Diagnostic>& diagnostics) const;

  private:
    std::string_view text_;
    std::string file_;
    std::vector<std::string_view> words_;
    std::size_t at_ = 0, line_ = 0, breaks_ = 0;
};

/// The finite number that a word of a text model is, with an exponent of Fortran as well
/// (`1.5D+02`).
std::optional<double> modelNumber(std::string_view word);

/// The first part of a word from a file, for messages.
std::string quoted(std::string_view word);

} // namespace irsg
