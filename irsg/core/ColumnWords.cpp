#include "irsg/core/ColumnWords.h"

#include <algorithm>
#include <utility>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Utf8.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

constexpr ColumnWord words[] = {
    // Axes of spectra.
    {"wavelengths", "wavelength"},
    {"wave length", "wavelength"},
    {"wave", "wavelength"},
    {"lambda", "wavelength"},
    {"wl", "wavelength"},
    {"wvl", "wavelength"},
    {"wellenlaenge", "wavelength"},
    {"wellenlaengen", "wavelength"},
    {"longueur d onde", "wavelength"},
    {"longueurs d onde", "wavelength"},
    {"wavenumbers", "wavenumber"},
    {"wave number", "wavenumber"},
    {"nu", "wavenumber"},
    {"wellenzahl", "wavenumber"},
    {"wellenzahlen", "wavenumber"},
    {"nombre d onde", "wavenumber"},
    {"nombres d onde", "wavenumber"},
    // Surfaces and paths.
    {"emittance", "emissivity"},
    {"emissionsgrad", "emissivity"},
    {"emissivitaet", "emissivity"},
    {"emissivite", "emissivity"},
    {"reflectivity", "reflectance"},
    {"reflexionsgrad", "reflectance"},
    {"reflektanz", "reflectance"},
    {"facteur de reflexion", "reflectance"},
    {"reflectivite", "reflectance"},
    {"transmissivity", "transmittance"},
    {"transmission", "transmittance"},
    {"transmissionsgrad", "transmittance"},
    {"facteur de transmission", "transmittance"},
    {"transmissivite", "transmittance"},
    {"refractive index", "n"},
    {"brechungsindex", "n"},
    {"brechzahl", "n"},
    {"indice de refraction", "n"},
    {"extinktion", "extinction"},
    {"extinction coefficient", "k"}, // of a length with the unit of one
    {"extinktionskoeffizient", "k"},
    {"coefficient d extinction", "k"},
    {"incidence angle", "incidence"},
    {"angle of incidence", "incidence"},
    {"einfallswinkel", "incidence"},
    {"angle d incidence", "incidence"},
    // Time, place and attitude.
    {"t", "time"},
    {"zeit", "time"},
    {"temps", "time"},
    {"winkel", "angle"},
    {"hoehe", "altitude"},
    {"hauteur", "altitude"},
    {"gierwinkel", "yaw"},
    {"lacet", "yaw"},
    {"nickwinkel", "pitch"},
    {"tangage", "pitch"},
    {"rollwinkel", "roll"},
    {"roulis", "roll"},
    {"machzahl", "mach"},
    {"mach number", "mach"},
    {"nombre de mach", "mach"},
    // Air.
    {"T", "temperature"},
    {"temperatur", "temperature"},
    {"lufttemperatur", "air_temperature"},
    {"temperature de l air", "air_temperature"},
    {"p", "pressure"},
    {"druck", "pressure"},
    {"luftdruck", "pressure"},
    {"pression", "pressure"},
    {"RH", "relative_humidity"},
    {"rel humidity", "relative_humidity"},
    {"relative feuchte", "relative_humidity"},
    {"rel feuchte", "relative_humidity"},
    {"relative luftfeuchte", "relative_humidity"},
    {"relative feuchtigkeit", "relative_humidity"},
    {"relative luftfeuchtigkeit", "relative_humidity"},
    {"humidite relative", "relative_humidity"},
    {"dewpoint", "dew_point"},
    {"taupunkt", "dew_point"},
    {"point de rosee", "dew_point"},
};

constexpr ColumnUnit units[] = {
    {"um", "um"},
    {"micron", "um"},
    {"microns", "um"},
    {"micrometer", "um"},
    {"micrometers", "um"},
    {"micrometre", "um"},
    {"micrometres", "um"},
    {"mikrometer", "um"},
    {"mum", "um"},
    {"nm", "nm"},
    {"nanometer", "nm"},
    {"nanometers", "nm"},
    {"nanometre", "nm"},
    {"nanometres", "nm"},
    {"angstrom", "angstrom"},
    {"angstroms", "angstrom"},
    {"angstroem", "angstrom"},
    {"cm-1", "cm-1"},
    {"cm1", "cm-1"},
    {"1/cm", "cm-1"},
    {"kayser", "cm-1"},
    {"kaysers", "cm-1"},
    {"km-1", "km-1"},
    {"1/km", "km-1"},
    {"per km", "km-1"},
    {"pro km", "km-1"},
    {"par km", "km-1"},
    {"m-1", "m-1"},
    {"1/m", "m-1"},
    {"per m", "m-1"},
    {"pro m", "m-1"},
    {"par m", "m-1"},
    {"m", "m"},
    {"meter", "m"},
    {"meters", "m"},
    {"metre", "m"},
    {"metres", "m"},
    {"s", "s"},
    {"sec", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"seconde", "s"},
    {"secondes", "s"},
    {"sekunde", "s"},
    {"sekunden", "s"},
    {"deg", "deg"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"degre", "deg"},
    {"degres", "deg"},
    {"K", "K"},
    {"kelvin", "K"},
    {"C", "C"},
    {"degc", "C"},
    {"deg c", "C"},
    {"celsius", "C"},
    {"grad celsius", "C"},
    {"degrees celsius", "C"},
    {"degres celsius", "C"},
    {"hPa", "hPa"},
    {"hectopascal", "hPa"},
    {"hektopascal", "hPa"},
    {"mbar", "hPa"},
    {"millibar", "hPa"},
    {"%", "%"},
    {"percent", "%"},
    {"per cent", "%"},
    {"prozent", "%"},
    {"pourcent", "%"},
    {"pour cent", "%"},
    {"ppmv", "ppmv"},
    {"1", ""},
    {"-", ""},
    {"--", ""},
};

/// Up to here capitals count: K and k, M and m are different units.
constexpr std::size_t longestSymbol = 3;
constexpr std::size_t longestNameSymbol = 2;

/// ASCII of one character; the next one tells an Å from the beginning of Ångström.
std::string plainLetters(char32_t c, char32_t next) {
    constexpr std::pair<std::u32string_view, const char*> letters[] = {
        {U"\u00e0\u00e1\u00e2", "a"},
        {U"\u00c0\u00c1\u00c2", "A"},
        {U"\u00e4", "ae"},
        {U"\u00c4", "Ae"},
        {U"\u00e7", "c"},
        {U"\u00c7", "C"},
        {U"\u00e8\u00e9\u00ea\u00eb", "e"},
        {U"\u00c8\u00c9\u00ca\u00cb", "E"},
        {U"\u00ee\u00ef", "i"},
        {U"\u00ce\u00cf", "I"},
        {U"\u00f4", "o"},
        {U"\u00d4", "O"},
        {U"\u00f6", "oe"},
        {U"\u00d6", "Oe"},
        {U"\u00f9\u00fb", "u"},
        {U"\u00d9\u00db", "U"},
        {U"\u00fc", "ue"},
        {U"\u00dc", "Ue"},
        {U"\u00df", "ss"},
        {U"\u00b5\u03bc", "u"},
        {U"\u03bb", "lambda"},
        {U"\u03bd", "nu"},
        {U"\u00b0\u00ba\u02da", "deg"},
        {U"\u2103", "degC"},
        {U"\u207b\u2212\u2010\u2011\u2013", "-"},
        {U"\u00b9", "1"},
        {U"\u00b2", "2"},
        {U"\u00b3", "3"},
        {U"\u00a0\u2007\u2009\u202f\u2019\u00b7\u22c5", " "},
        {U"\u0300\u0301\u0302\u0327\ufeff", ""}}; // accents behind their letters
    if (c < 0x80)
        return {static_cast<char>(c)};
    if (c == U'\u00c5' || c == U'\u00e5' || c == U'\u212b')
        return next == U'n' || next == U'N' ? "a" : "angstrom";
    for (const auto& [characters, plain] : letters)
        if (characters.find(c) != characters.npos)
            return plain;
    return "?";
}

/// Without `^`, and blanks and _ as single blanks.
std::string spaced(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const bool isBlank = c == ' ' || c == '\t' || c == '_' || c == '\'' || c == '`';
        if (isBlank ? !result.empty() && result.back() != ' ' : c != '^')
            result += isBlank ? ' ' : c;
    }
    if (result.ends_with(' '))
        result.pop_back();
    return result;
}

/// Of a text of plain letters.
std::optional<std::string_view> unitOf(std::string_view plain) {
    std::string text = spaced(plain);
    if (text.starts_with('/')) // per km
        text.insert(0, "1");
    const std::string small = lowerCase(text);
    for (const ColumnUnit& unit : units)
        if (unit.spelling == (text.size() <= longestSymbol ? text : small))
            return unit.unit;
    return std::nullopt;
}

/// Small letters, digits and single blanks.
std::string nameWords(std::string_view plain) {
    std::string text;
    for (const char c : plain) {
        const bool isKept = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                            (c >= 'A' && c <= 'Z') || c == '?' || c == '+';
        if (isKept)
            text += c;
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
    }
    if (text.ends_with(' '))
        text.pop_back();
    return text.size() <= longestNameSymbol ? text : lowerCase(std::move(text));
}

std::string nameOf(std::string_view plain) {
    std::string text = nameWords(plain);
    for (const ColumnWord& word : words)
        if (word.word == text)
            return std::string(word.name);
    if (text.size() > 1) // n and N are different ones
        text = lowerCase(std::move(text));
    std::ranges::replace(text, ' ', '_');
    return text;
}

/// Takes a per cent sign or its words out of a text.
bool takePercent(std::string& text) {
    const std::string small = lowerCase(text);
    for (const ColumnUnit& unit : units) {
        const std::size_t at = unit.unit == "%" ? small.find(unit.spelling) : std::string::npos;
        if (at != std::string::npos) {
            text.replace(at, unit.spelling.size(), " ");
            text = trimmed(text);
            if (text.ends_with(" in") || text.ends_with(" en"))
                text.resize(text.size() - 3);
            return true;
        }
    }
    return false;
}

/// The place of the bracket that closes at the end of a text.
std::size_t openBracket(std::string_view text) {
    const bool isSquare = text.ends_with(']');
    if (!isSquare && !text.ends_with(')'))
        return std::string_view::npos;
    std::size_t depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        depth += text[i] == (isSquare ? ']' : ')') ? 1 : 0;
        if (text[i] == (isSquare ? '[' : '(') && --depth == 0)
            return i;
    }
    return std::string_view::npos;
}

} // namespace

std::span<const ColumnWord> columnWords() {
    return words;
}

std::span<const ColumnUnit> columnUnits() {
    return units;
}

std::optional<std::string_view> columnUnit(std::string_view text) {
    return unitOf(trimmed(plainHead(text)));
}

std::string plainHead(std::string_view head) {
    const std::u32string all = charactersOf(utf8Text(head));
    std::string plain;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto at = [&](std::size_t place) { return place < all.size() ? all[place] : U'\0'; };
        const bool hasRing = at(i + 1) == U'\u030a', hasDots = at(i + 1) == U'\u0308';
        if (hasRing && (all[i] == U'A' || all[i] == U'a'))
            plain += plainLetters(U'\u00c5', at(i + 2));
        else
            plain += plainLetters(all[i], at(i + 1));
        if (hasDots && std::u32string_view(U"aouAOU").find(all[i]) != std::u32string_view::npos)
            plain += 'e';
        i += hasRing || hasDots ? 1 : 0;
    }
    return plain;
}

ColumnHead columnHead(std::string_view head) {
    std::string text(trimmed(plainHead(head)));
    if (const std::size_t open = openBracket(text); open != std::string::npos) {
        const std::string inside(trimmed(text.substr(open + 1, text.size() - open - 2)));
        text.resize(open);
        if (const auto unit = unitOf(inside))
            return {nameOf(text), std::string(*unit)};
        std::string rest = inside;
        return {nameOf(text), takePercent(rest) ? "%" : inside};
    }
    if (takePercent(text))
        return {nameOf(text), "%"};
    // What stands behind the last of these is a unit, if it is known.
    for (const std::string_view before : {" in ", " en ", "/", ",", "_", " "}) {
        const std::size_t at = text.rfind(before);
        if (at == std::string::npos || at == 0)
            continue;
        const std::string_view behind = trimmed(std::string_view(text).substr(at + before.size()));
        if (const auto unit = unitOf(behind); unit && !unit->empty())
            return {nameOf(std::string_view(text).substr(0, at)), std::string(*unit)};
    }
    return {nameOf(text), ""};
}

} // namespace irsg
