#include "irsg/radiometry/Errors.h"

#include <array>
#include <charconv>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "irsg/radiometry/Offences.h"

namespace irsg {

namespace {

constexpr std::size_t mostOffences = 100;

/// How many more offences a sentence stands for that bounded() made; 0 for any other.
std::size_t moreIn(const Offence& offence) {
    std::size_t count = 0;
    const char* const end = offence.value.data() + offence.value.size();
    const auto [stop, error] = std::from_chars(offence.value.data(), end, count);
    const bool isMore = error == std::errc{} && std::string_view(stop, end) == " more";
    return isMore && offence.position.empty() && offence.expected.empty() ? count : 0;
}

/// The first offences of each file; nobody reads more, and a file of nothing but offences would
/// take its size in sentences.
std::vector<Offence> bounded(std::vector<Offence> offences) {
    if (offences.size() <= mostOffences) {
        return offences;
    }
    std::vector<Offence> kept;
    std::map<std::string, std::size_t> counts;
    for (Offence& offence : offences) {
        std::size_t& count = counts[offence.file];
        const std::size_t more = moreIn(offence);
        count += more > 0 ? more : 1;
        if (more == 0 && count <= mostOffences) {
            kept.push_back(std::move(offence));
        }
    }
    for (const auto& [file, count] : counts) {
        if (count > mostOffences) {
            kept.push_back({file, "", std::to_string(count - mostOffences) + " more", ""});
        }
    }
    return kept;
}

std::string messageOf(const std::vector<Offence>& offences) {
    if (offences.empty()) {
        throw LogicError("an InputError needs at least one offence");
    }
    std::string text;
    for (const Offence& offence : offences) {
        text += (text.empty() ? "" : "\n") + offence.message();
    }
    return text;
}

} // namespace

std::string Offence::message() const {
    std::string text;
    for (const std::string& place : {file, position}) {
        if (!place.empty()) {
            text += (text.empty() ? "" : ": ") + place;
        }
    }
    std::string finding;
    if (!value.empty()) {
        finding = (moreIn(*this) > 0 ? "and " : "found ") + value;
    }
    if (!expected.empty()) {
        finding += (finding.empty() ? "expected " : ", expected ") + expected;
    }
    if (!text.empty() && !finding.empty()) {
        text += ": ";
    }
    return text + finding;
}

void keepFirstOffences(std::vector<Offence>& offences) {
    if (offences.size() > 10 * mostOffences) {
        offences = bounded(std::move(offences));
    }
}

InputError::InputError(Offence offence) : InputError(std::vector<Offence>{std::move(offence)}) {}

InputError::InputError(std::vector<Offence> offences)
    : InputError(Bounded{bounded(std::move(offences))}) {}

InputError::InputError(Bounded offences)
    : std::runtime_error(messageOf(offences.list)), offences_(std::move(offences.list)) {}

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

} // namespace irsg
