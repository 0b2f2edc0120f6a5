#include "irsg/radiometry/Errors.h"

#include <array>
#include <charconv>
#include <utility>

namespace irsg {

namespace {

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
        finding = "found " + value;
    }
    if (!expected.empty()) {
        finding += (finding.empty() ? "expected " : ", expected ") + expected;
    }
    if (!text.empty() && !finding.empty()) {
        text += ": ";
    }
    return text + finding;
}

InputError::InputError(Offence offence) : InputError(std::vector<Offence>{std::move(offence)}) {}

InputError::InputError(std::vector<Offence> offences)
    : std::runtime_error(messageOf(offences)), offences_(std::move(offences)) {}

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

} // namespace irsg
