#include "irsg/radiometry/SpectralHead.h"

#include <algorithm>
#include <utility>

#include "irsg/core/ColumnWords.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Small letters, digits and -; each other character as a blank.
std::string plainWords(std::string_view head) {
    std::string text = " ";
    for (const char c : lowerCase(plainHead(head))) {
        const bool isKept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        if (c != '^')
            text += isKept ? c : ' ';
    }
    return text + " ";
}

/// Replaces a text of several words, blanks about it, by one word, wherever it stands.
void replaceWords(std::string& text, const std::string& words, std::string_view by) {
    for (std::size_t at = text.find(" " + words + " "); at != std::string::npos;
         at = text.find(" " + words + " "))
        text.replace(at + 1, words.size(), by);
}

bool isAxisName(std::string_view name) {
    return name == "wavelength" || name == "wavenumber";
}

std::vector<std::string> wordsOf(std::string_view head) {
    std::string text = plainWords(head);
    replaceWords(text, "1 cm", "cm-1"); // 1/cm has become two words
    for (std::size_t at = text.find("  "); at != std::string::npos; at = text.find("  "))
        text.erase(at, 1);
    for (const ColumnWord& word : columnWords())
        if (isAxisName(word.name) && word.word.find(' ') != std::string_view::npos)
            replaceWords(text, std::string(word.word), word.name);
    std::vector<std::string> words;
    std::string word;
    for (const char c : text)
        if (c != ' ')
            word += c;
        else if (!word.empty())
            words.push_back(std::exchange(word, ""));
    return words;
}

bool isAmong(const std::string& word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

/// Capitals do not count here: no unit of another quantity can stand beside a wavelength.
std::optional<SpectralAxis> unitNamed(const std::string& word) {
    constexpr SpectralAxis all[] = {SpectralAxis::wavelength, SpectralAxis::nanometres,
                                    SpectralAxis::angstroms, SpectralAxis::wavenumber};
    for (const ColumnUnit& unit : columnUnits())
        for (const SpectralAxis axis : all)
            if (unit.spelling == word && unit.unit == axisUnit(axis))
                return axis;
    return std::nullopt;
}

/// The name of an axis that a word means; "" for other words.
std::string_view axisNamed(const std::string& word) {
    for (const ColumnWord& one : columnWords())
        if (one.word == word && isAxisName(one.name))
            return one.name;
    return isAxisName(word) ? std::string_view(word) : std::string_view();
}

} // namespace

std::optional<SpectralHead> spectralHead(std::string_view head) {
    SpectralHead result;
    bool isWavelength = false, isWavenumber = false;
    for (const std::string& word : wordsOf(head)) {
        const std::string_view name = axisNamed(word);
        if (const auto unit = unitNamed(word)) {
            if (result.axis)
                return std::nullopt;
            result.axis = unit;
        } else if (name == "wavelength") {
            isWavelength = true;
        } else if (name == "wavenumber") {
            isWavenumber = true;
        } else if (isAmong(word, {"air", "luft"})) {
            result.isInAir = true;
        } else if (!isAmong(word, {"vac", "vacuum", "vakuum", "vide", "in", "im", "en", "dans",
                                   "le", "l"})) {
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
        "'um', 'nm', 'angstrom', 'cm-1', 'wavelength [um]', 'wavelength [nm]', "
        "'wavelength [angstrom]' or 'wavenumber [cm-1]'";
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
           : axis == SpectralAxis::angstroms  ? value / 10000.0
                                              : wavelengthFromWavenumber_um(value);
}

const char* axisUnit(SpectralAxis axis) {
    return axis == SpectralAxis::wavelength   ? "um"
           : axis == SpectralAxis::nanometres ? "nm"
           : axis == SpectralAxis::angstroms  ? "angstrom"
                                              : "cm-1";
}

} // namespace irsg
