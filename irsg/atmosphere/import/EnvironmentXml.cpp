#include "irsg/atmosphere/import/EnvironmentXml.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/core/Collect.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr const char* azimuthName = "SunAzimuth";
constexpr const char* elevationName = "SunElevation";
constexpr const char* wavelengthsName = "BackgroundRadianceWavelengths";
constexpr const char* valuesName = "BackgroundRadianceValues";
constexpr std::array known = {azimuthName, elevationName, wavelengthsName, valuesName};

class EnvironmentReader {
  public:
    explicit EnvironmentReader(const KarmaXml& document) : document_(document) {}

    EnvironmentReading read() {
        if (document_.typeName() != "Environment")
            throw InputError(document_.diagnostic("type", "'" + document_.type() + "'",
                                                  "a type that ends in /Environment"));
        SunPosition& sun = reading_.parameters.sun;
        readAngle(azimuthName, sun.azimuth_rad, 0.0, mostFullTurn_rad, "0 to 2 pi rad");
        readAngle(elevationName, sun.elevation_rad, -mostQuarterTurn_rad, mostQuarterTurn_rad,
                  "-pi/2 to pi/2 rad");
        readBackground();
        readComposition();
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        for (const KarmaParameter& parameter : document_.parameters())
            if (std::ranges::find(known, parameter.name) == known.end())
                reading_.remarks.push_back("line " + std::to_string(parameter.line) + ": " +
                                           parameter.name +
                                           " is no parameter of Environment; it is kept and has "
                                           "no effect");
        return std::move(reading_);
    }

  private:
    /// The parameter where it is there and of that kind.
    const KarmaParameter* find(const char* name, KarmaKind kind) {
        const KarmaParameter* found = document_.find(name);
        if (!found || found->kind == kind)
            return found;
        diagnostics_.push_back(document_.diagnostic(*found,
                                                    std::string("a ") + irsg::name(found->kind),
                                                    std::string("a ") + irsg::name(kind)));
        return nullptr;
    }

    void readAngle(const char* name, double& angle_rad, double least_rad, double most_rad,
                   const char* range) {
        const KarmaParameter* found = find(name, KarmaKind::number);
        if (!document_.find(name))
            reading_.remarks.push_back(std::string("no ") + name + ": taken as " +
                                       numberText(angle_rad) + " rad");
        if (!found)
            return;
        angle_rad = found->numbers.front();
        if (!(angle_rad >= least_rad && angle_rad <= most_rad))
            diagnostics_.push_back(
                document_.diagnostic(*found, numberText(angle_rad) + " rad", range));
    }

    void readBackground() {
        const KarmaParameter* wavelengths = find(wavelengthsName, KarmaKind::vector);
        const KarmaParameter* values = find(valuesName, KarmaKind::vector);
        if (!wavelengths && !values)
            return;
        if (!wavelengths || !values) {
            const char* missing = wavelengths ? valuesName : wavelengthsName;
            if (!document_.find(missing))
                diagnostics_.push_back(document_.diagnostic(
                    *(wavelengths ? wavelengths : values), "no " + std::string(missing),
                    "wavelengths and values of the background, or neither"));
            return;
        }
        const std::size_t before = diagnostics_.size();
        const std::vector<double>& x = wavelengths->numbers;
        if (x.size() < 2 || x.front() <= 0.0 ||
            std::ranges::adjacent_find(x, std::greater_equal()) != x.end())
            diagnostics_.push_back(
                document_.diagnostic(*wavelengths,
                                     "wavelengths that are fewer than two, not "
                                     "positive or not ascending",
                                     "at least two ascending wavelengths in um"));
        if (values->numbers.size() != x.size())
            diagnostics_.push_back(document_.diagnostic(
                *values, std::to_string(values->numbers.size()) + " numbers",
                std::string("as many as ") + wavelengthsName + ", " + std::to_string(x.size())));
        for (const double value : values->numbers)
            if (value < 0.0)
                diagnostics_.push_back(document_.diagnostic(
                    *values, numberText(value) + " W m-2 sr-1 um-1", "radiances of at least 0"));
        if (diagnostics_.size() == before)
            reading_.parameters.background =
                Spectrum(x, values->numbers, Spectrum::Outside::zero, "default background");
    }

    void readComposition() {
        std::vector<KarmaComposite>& composition = reading_.parameters.composition;
        composition = document_.composites();
        for (const KarmaComposite& composite : composition)
            if (composite.composition != "none")
                diagnostics_.push_back(
                    document_.diagnostic(composite, "composition '" + composite.composition + "'",
                                         "none: atmospheres are not composed of components"));
        std::ranges::stable_sort(composition, {}, &KarmaComposite::priority);
        if (composition.empty())
            reading_.remarks.push_back("no composition: no atmosphere");
    }

    const KarmaXml& document_;
    EnvironmentReading reading_;
    std::vector<Diagnostic> diagnostics_;
};

} // namespace

bool isEnvironmentXml(const std::filesystem::path& file) {
    if (!isXml(file))
        return false;
    try {
        return KarmaXml::read(file).typeName() == "Environment";
    } catch (const InputError&) {
        return false;
    }
}

EnvironmentReading environmentFromKarma(const KarmaXml& document) {
    return EnvironmentReader(document).read();
}

void toKarma(const EnvironmentParameters& parameters, KarmaXml& document) {
    const auto write = [&](const char* name, KarmaKind kind, std::vector<double> numbers,
                           const char* documentation) {
        document.set({.name = name,
                      .kind = kind,
                      .numbers = std::move(numbers),
                      .text = {},
                      .documentation = document.find(name) ? "" : documentation});
    };
    write(azimuthName, KarmaKind::number, {parameters.sun.azimuth_rad},
          "Sun azimuth, rad, East of North, 0 to 2 pi.");
    write(elevationName, KarmaKind::number, {parameters.sun.elevation_rad},
          "Sun elevation, rad, -pi/2 to pi/2.");
    if (parameters.background) {
        write(wavelengthsName, KarmaKind::vector, parameters.background->wavelengths_um(),
              "Wavelengths of the default background, um.");
        write(valuesName, KarmaKind::vector, parameters.background->values(),
              "Default background radiance, W m-2 sr-1 um-1.");
    } else {
        document.remove(wavelengthsName);
        document.remove(valuesName);
    }
    document.setComposites(parameters.composition);
}

KarmaXml toKarma(const EnvironmentParameters& parameters, const std::string& documentation) {
    KarmaXml document("/Environment/Root/Environment", documentation);
    toKarma(parameters, document);
    return document;
}

LoadedEnvironment loadEnvironment(const std::filesystem::path& file) {
    const KarmaXml document = KarmaXml::read(file);
    EnvironmentReading reading = environmentFromKarma(document);
    LoadedEnvironment loaded{.environment = {}, .remarks = std::move(reading.remarks)};
    loaded.environment.sun = reading.parameters.sun;
    loaded.environment.sun.elevation_rad =
        std::clamp(loaded.environment.sun.elevation_rad, -0.5 * pi, 0.5 * pi);
    loaded.environment.defaultBackground = reading.parameters.background;

    std::vector<Diagnostic> diagnostics;
    for (const KarmaComposite& composite : reading.parameters.composition) {
        collect(diagnostics, [&] {
            const std::string position = document.diagnostic(composite, "", "").position;
            loaded.environment.add(
                loadAtmosphere(resolveKarmaPath(composite.parameters, file, position)));
        });
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return loaded;
}

} // namespace irsg
