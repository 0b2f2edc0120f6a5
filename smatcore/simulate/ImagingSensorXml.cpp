#include "smatcore/simulate/ImagingSensorXml.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "irsg/core/Errors.h"

namespace smat {

namespace {

using P = ImagingSensorParameters;

constexpr std::array table = {
    ImagingSensorParameter{"CalculationMode", &P::calculationMode, 1, 2, true, "1 or 2",
                           "1 spectral, 2 wideband correlated-k."},
    ImagingSensorParameter{"AntialiasingMode", &P::antialiasingMode, 0, 5, true, "0 to 5",
                           "0 none, 1 supersampling 2x, 2 supersampling 4x, 3 zoom 128, 4 zoom "
                           "256, 5 zoom 512."},
    ImagingSensorParameter{"IsUniformBackground", &P::isUniformBackground, 0, 1, true, "0 or 1",
                           "1 uniform background, 0 rows and columns."},
    ImagingSensorParameter{"NumberOfBackgroundColumns", &P::numberOfBackgroundColumns, 1, 1024,
                           true, "a whole number from 1 to 1024",
                           "Columns of the non-uniform background."},
    ImagingSensorParameter{"NumberOfBackgroundRows", &P::numberOfBackgroundRows, 1, 1024, true,
                           "a whole number from 1 to 1024", "Rows of the non-uniform background."},
    ImagingSensorParameter{"UseSkyboxBackground", &P::useSkyboxBackground, 0, 1, true, "0 or 1",
                           "1: skybox on."},
    ImagingSensorParameter{"UseTerrainBackground", &P::useTerrainBackground, 0, 1, true, "0 or 1",
                           "1: terrain on."},
    ImagingSensorParameter{"SkyboxTextureRadianceSlope", &P::skyboxTextureRadianceSlope, -1e9, 1e9,
                           false, "-1e9 to 1e9 W m-2 sr-1",
                           "Radiance from black to white of the skybox, W m-2 sr-1."},
    ImagingSensorParameter{"SkyboxTextureColorOffset", &P::skyboxTextureColorOffset, -1e9, 1e9,
                           false, "-1e9 to 1e9", "Texture value that changes nothing, 0 to 1."},
    ImagingSensorParameter{"TerrainTextureRadianceSlope", &P::terrainTextureRadianceSlope, -1e9,
                           1e9, false, "-1e9 to 1e9 W m-2 sr-1",
                           "Radiance from black to white of the terrain, W m-2 sr-1."},
    ImagingSensorParameter{"TerrainTextureColorOffset", &P::terrainTextureColorOffset, -1e9, 1e9,
                           false, "-1e9 to 1e9", "Texture value that changes nothing, 0 to 1."},
    ImagingSensorParameter{"UseAtmosphereScattering", &P::useAtmosphereScattering, 0, 1, true,
                           "0 or 1", "1: aerosol scattering on."}};

/// Reads one document and collects what is wrong with it.
class Reader {
  public:
    explicit Reader(const irsg::KarmaXml& document) : document_(document) {}

    ImagingSensorReading read() {
        if (document_.typeName() != "ImagingSensor") {
            throw irsg::InputError(document_.diagnostic("type", "'" + document_.type() + "'",
                                                        "a type that ends in /ImagingSensor"));
        }
        for (const irsg::KarmaParameter& parameter : document_.parameters()) {
            const auto known = std::ranges::find(table, std::string_view(parameter.name),
                                                 &ImagingSensorParameter::name);
            if (known == table.end()) {
                reading_.remarks.push_back(fmt::format(
                    "line {}: {} is no parameter of ImagingSensor; it is kept and has no effect",
                    parameter.line, parameter.name));
            } else {
                readValue(*known, parameter);
            }
        }
        if (!document_.composites().empty()) {
            diagnostics_.push_back(document_.diagnostic(document_.composites().front(),
                                                        "a composition", "parameters alone"));
        }
        if (!diagnostics_.empty())
            throw irsg::InputError(diagnostics_);
        return std::move(reading_);
    }

  private:
    void readValue(const ImagingSensorParameter& known, const irsg::KarmaParameter& parameter) {
        if (parameter.kind != irsg::KarmaKind::number) {
            diagnostics_.push_back(document_.diagnostic(
                parameter, std::string("a ") + irsg::name(parameter.kind), "a double"));
            return;
        }
        const double value = parameter.numbers.front();
        if (value < known.minimum || value > known.maximum ||
            (known.isWhole && value != std::floor(value))) {
            diagnostics_.push_back(
                document_.diagnostic(parameter, irsg::numberText(value), std::string(known.range)));
            return;
        }
        reading_.parameters.*known.field = value;
    }

    const irsg::KarmaXml& document_;
    ImagingSensorReading reading_;
    std::vector<irsg::Diagnostic> diagnostics_;
};

} // namespace

std::span<const ImagingSensorParameter> imagingSensorParameters() {
    return table;
}

ImagingSensorReading imagingSensorFromKarma(const irsg::KarmaXml& document) {
    return Reader(document).read();
}

void toKarma(const ImagingSensorParameters& parameters, irsg::KarmaXml& document) {
    for (const ImagingSensorParameter& known : table) {
        const std::string name(known.name);
        const std::optional<double>& value = parameters.*known.field;
        if (!value) {
            document.remove(name);
            continue;
        }
        document.set({.name = name,
                      .kind = irsg::KarmaKind::number,
                      .numbers = {*value},
                      .text = {},
                      .documentation = document.find(name) ? "" : std::string(known.help)});
    }
}

irsg::KarmaXml toKarma(const ImagingSensorParameters& parameters,
                       const std::string& documentation) {
    irsg::KarmaXml document("/ImagingSensor/Root/Sensor/ImagingSensor", documentation);
    toKarma(parameters, document);
    return document;
}

} // namespace smat
