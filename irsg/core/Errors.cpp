#include "irsg/core/Errors.h"

#include <array>
#include <charconv>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "irsg/core/Diagnostics.h"
#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

constexpr std::size_t mostDiagnostics = 100;

/// How many more diagnostics a sentence stands for that bounded() made; 0 for any other.
std::size_t moreIn(const Diagnostic& diagnostic) {
    std::size_t count = 0;
    const char* const end = diagnostic.value.data() + diagnostic.value.size();
    const auto [stop, error] = std::from_chars(diagnostic.value.data(), end, count);
    const bool isMore = error == std::errc{} && std::string_view(stop, end) == " more";
    return isMore && diagnostic.position.empty() && diagnostic.expected.empty() ? count : 0;
}

/// The first diagnostics of each file; nobody reads more, and a file of nothing but diagnostics
/// would take its size in sentences.
std::vector<Diagnostic> bounded(std::vector<Diagnostic> diagnostics) {
    if (diagnostics.size() <= mostDiagnostics)
        return diagnostics;
    std::vector<Diagnostic> kept;
    std::map<std::string, std::size_t> counts;
    for (Diagnostic& diagnostic : diagnostics) {
        std::size_t& count = counts[diagnostic.file];
        const std::size_t more = moreIn(diagnostic);
        count += more > 0 ? more : 1;
        if (more == 0 && count <= mostDiagnostics)
            kept.push_back(std::move(diagnostic));
    }
    for (const auto& [file, count] : counts)
        if (count > mostDiagnostics)
            kept.push_back({file, "", std::to_string(count - mostDiagnostics) + " more", ""});
    return kept;
}

std::string messageOf(const std::vector<Diagnostic>& diagnostics) {
    if (diagnostics.empty())
        throw LogicError("an InputError needs at least one diagnostic");
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
        text += (text.empty() ? "" : "\n") + diagnostic.message();
    return text;
}

} // namespace

std::string Diagnostic::message() const {
    std::string text;
    for (const std::string& place : {file, position})
        if (!place.empty())
            text += (text.empty() ? "" : ": ") + utf8Text(place);
    std::string finding;
    if (!value.empty())
        finding = (moreIn(*this) > 0 ? "and " : "found ") + utf8Text(value);
    if (!expected.empty())
        finding += (finding.empty() ? "expected " : ", expected ") + expected;
    if (!text.empty() && !finding.empty())
        text += ": ";
    return text + finding;
}

void keepFirstDiagnostics(std::vector<Diagnostic>& diagnostics) {
    if (diagnostics.size() > 10 * mostDiagnostics)
        diagnostics = bounded(std::move(diagnostics));
}

InputError::InputError(Diagnostic diagnostic)
    : InputError(std::vector<Diagnostic>{std::move(diagnostic)}) {}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : InputError(Bounded{bounded(std::move(diagnostics))}) {}

InputError::InputError(Bounded diagnostics)
    : std::runtime_error(messageOf(diagnostics.list)), diagnostics_(std::move(diagnostics.list)) {}

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

} // namespace irsg
