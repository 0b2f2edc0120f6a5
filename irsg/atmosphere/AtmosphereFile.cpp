#include "irsg/atmosphere/AtmosphereFile.h"

#include <span>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"
#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;
using Opened = std::shared_ptr<const Atmosphere>;

Opened fromKarmaXml(const fs::path& file) {
    const KarmaXml document = KarmaXml::read(file);
    if (document.typeName() == "AtmosphereSmart")
        return AtmosphereSmart::fromXml(file);
    if (document.typeName() == "AtmosphereScatteringLUT")
        return std::make_shared<AtmosphereScatteringLut>(
            AtmosphereScatteringLut::fromKarma(document));
    throw InputError(document.diagnostic(
        "type", document.type().empty() ? "no type" : "'" + document.type() + "'",
        document.typeName() == "Environment"
            ? "one atmosphere: an Environment holds several"
            : "a type that ends in /AtmosphereSmart or /AtmosphereScatteringLUT"));
}

} // namespace

const std::vector<AtmosphereFormat>& atmosphereFormats() {
    static const std::vector<AtmosphereFormat> all = {
        {".xml of AtmosphereSmart, .xml of AtmosphereScatteringLUT", isXml, fromKarmaXml},
        {".csv of a radiative output", SpectraAtmosphere::isSpectraCsv,
         [](const fs::path& file) -> Opened {
             return std::make_shared<SpectraAtmosphere>(SpectraAtmosphere::fromCsv(file));
         }},
        {".smatatm", TabulatedAtmosphere::isTableFile,
         [](const fs::path& file) -> Opened {
             return std::make_shared<TabulatedAtmosphere>(TabulatedAtmosphere::read(file));
         }},
        {"tape7, .csv or .json of MODTRAN", TabulatedAtmosphere::canImport,
         [](const fs::path& file) -> Opened {
             return std::make_shared<TabulatedAtmosphere>(
                 TabulatedAtmosphere::import(std::span(&file, 1)));
         }},
        {".csv of homogeneous air",
         [](const fs::path& file) {
             const std::string extension = lowerCase(file.extension().string());
             if (extension != ".txt" && extension != ".tsv")
                 return extension == ".csv";
             // Of other texts its column tells.
             constexpr std::size_t beginning_B = std::size_t{1} << 16;
             return readFileBeginning(file, beginning_B).find("extinction [km-1]") !=
                    std::string::npos;
         },
         [](const fs::path& file) -> Opened {
             return std::make_shared<BeerLambert>(BeerLambert::fromCsv(file));
         }},
    };
    return all;
}

std::string atmosphereFormatWords() {
    std::vector<std::string> words;
    for (const AtmosphereFormat& format : atmosphereFormats())
        words.emplace_back(format.words);
    return alternatives(words);
}

std::shared_ptr<const Atmosphere> loadAtmosphere(const fs::path& file) {
    for (const AtmosphereFormat& format : atmosphereFormats())
        if (format.recognises(file))
            return format.open(file);
    throw InputError(
        {file.string(), "", "no atmosphere of a kind that is known", atmosphereFormatWords()});
}

} // namespace irsg
