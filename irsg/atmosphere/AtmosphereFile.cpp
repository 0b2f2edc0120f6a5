#include "irsg/atmosphere/AtmosphereFile.h"

#include <span>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"
#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"

namespace irsg {

namespace {

std::shared_ptr<const Atmosphere> fromKarmaXml(const std::filesystem::path& file) {
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

std::shared_ptr<const Atmosphere> loadAtmosphere(const std::filesystem::path& file) {
    if (isXml(file)) {
        return fromKarmaXml(file);
    }
    if (SpectraAtmosphere::isSpectraCsv(file)) {
        return std::make_shared<SpectraAtmosphere>(SpectraAtmosphere::fromCsv(file));
    }
    if (TabulatedAtmosphere::isTableFile(file)) {
        return std::make_shared<TabulatedAtmosphere>(TabulatedAtmosphere::read(file));
    }
    if (TabulatedAtmosphere::canImport(file)) {
        return std::make_shared<TabulatedAtmosphere>(
            TabulatedAtmosphere::import(std::span(&file, 1)));
    }
    if (file.extension() == ".csv") {
        return std::make_shared<BeerLambert>(BeerLambert::fromCsv(file));
    }
    throw InputError({file.string(), "", "no atmosphere of a kind that is known",
                      "an .xml of AtmosphereSmart or AtmosphereScatteringLUT, a .csv of a "
                      "homogeneous atmosphere or of a "
                      "radiative output, a .smatatm, or "
                      "MODTRAN's tape7, CSV or JSON"});
}

} // namespace irsg
