#include "irsg/radiometry/SpectralHead.h"

#include <algorithm>
#include <utility>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr std::pair<std::string_view, std::string_view> spellings[] = {
    {"\u00b5", "u"}, {"\u03bc", "u"}, {"\xb5", "u"}, // the last in Latin-1
    {"\u207b", "-"}, {"\u2212", "-"}, {"\u00b9", "1"}, {"\xb9", "1"}, {"\u03bb", "lambda"}};

/// Lower case, ASCII, each other character as a blank but for what units are written with.
std::string plainWords(std::string_view head) {
    std::string text;
    while (!head.empty()) {
        const auto found = std::ranges::find_if(
            spellings, [&](const auto& pair) { return head.starts_with(pair.first); });
        if (found != std::end(spellings)) {
            text += found->second;
            head.remove_prefix(found->first.size());
            continue;
        }
        const char c = head.front();
        const bool isSmall = c >= 'a' && c <= 'z', isDigit = c >= '0' && c <= '9';
        if (c >= 'A' && c <= 'Z')
            text += static_cast<char>(c - 'A' + 'a');
        else if (isSmall || isDigit || c == '-')
            text += c;
        else if (c != '^')
            text += ' ';
        head.remove_prefix(1);
    }
    return text;
}

std::vector<std::string> wordsOf(std::string_view head) {
    std::vector<std::string> words;
    std::string text = plainWords(head);
    // 1/cm has become two words.
    if (const std::size_t at = text.find("1 cm"); at != std::string::npos)
        text.replace(at, 4, "cm-1");
    std::string word;
    for (const char c : text + " ")
        if (c != ' ')
            word += c;
        else if (!word.empty())
            words.push_back(std::exchange(word, ""));
    return words;
}

bool isAmong(const std::string& word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

std::optional<SpectralAxis> unitNamed(const std::string& word) {
    if (isAmong(word, {"um", "micron", "microns", "micrometer", "micrometers", "micrometre",
                       "micrometres", "mum"}))
        return SpectralAxis::wavelength;
    if (isAmong(word, {"nm", "nanometer", "nanometers", "nanometre", "nanometres"}))
        return SpectralAxis::nanometres;
    if (isAmong(word, {"cm-1", "cm1", "kayser", "kaysers"}))
        return SpectralAxis::wavenumber;
    return std::nullopt;
}

} // namespace

std::optional<SpectralHead> spectralHead(std::string_view head) {
    SpectralHead result;
    bool isWavelength = false, isWavenumber = false;
    for (const std::string& word : wordsOf(head)) {
        if (const auto unit = unitNamed(word)) {
            if (result.axis)
                return std::nullopt;
            result.axis = unit;
        } else if (isAmong(word, {"wavelength", "wavelengths", "lambda", "wl", "wvl", "wave",
                                  "length"})) {
            isWavelength = true;
        } else if (isAmong(word, {"wavenumber", "wavenumbers", "nu", "number"})) {
            isWavenumber = true;
        } else if (word == "air") {
            result.isInAir = true;
        } else if (!isAmong(word, {"vac", "vacuum", "in"})) {
            return std::nullopt;
        }
    }
    if (!result.axis && isWavenumber)
        result.axis = SpectralAxis::wavenumber;
    const bool countsWaves = result.axis == SpectralAxis::wavenumber;
    const bool contradicts = (isWavelength && countsWaves && !isWavenumber) ||
                             (isWavenumber && result.axis && !countsWaves);
    if ((!result.axis && !isWavelength) || contradicts)
        return std::nullopt;
    return result;
}

const std::string& spectralHeads() {
    static const std::string all =
        "'um', 'nm', 'cm-1', 'wavelength [um]', 'wavelength [nm]' or 'wavenumber [cm-1]'";
    return all;
}

std::optional<SpectralAxis> axisOfValues(const std::vector<double>& values, bool isWavelength) {
    if (values.empty())
        return std::nullopt;
    const auto [least, most] = std::ranges::minmax(values);
    if (least >= 0.1 && most <= 100.0)
        return SpectralAxis::wavelength;
    if (isWavelength && least >= 100.0 && most <= 1e5)
        return SpectralAxis::nanometres;
    return std::nullopt;
}

double wavelengthOn_um(SpectralAxis axis, double value) {
    return axis == SpectralAxis::wavelength   ? value
           : axis == SpectralAxis::nanometres ? value / 1000.0
                                              : wavelengthFromWavenumber_um(value);
}

const char* axisUnit(SpectralAxis axis) {
    return axis == SpectralAxis::wavelength   ? "um"
           : axis == SpectralAxis::nanometres ? "nm"
                                              : "cm-1";
}

} // namespace irsg
