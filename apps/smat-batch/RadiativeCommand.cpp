#include <algorithm>

#include "apps/smat-batch/AtmosphereArguments.h"
#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/SunOptions.h"
#include "irsg/core/Collect.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/support/NearestNames.h"
#include "smatcore/tools/RadiativeOutput.h"

namespace smat::batch {

namespace {

/// "all", "transmittance", "path", ...
std::vector<std::string> quantityWords() {
    std::vector<std::string> words{"all"};
    for (const RadiativeQuantity& known : radiativeQuantities())
        words.emplace_back(known.word);
    return words;
}

/// `smat-batch radiative ATMOSPHERE... --quantity path --sensor-altitude m --los-elevation deg
/// --range m --out FILE.csv`.
class RadiativeCommand {
  public:
    explicit RadiativeCommand(CLI::App& command)
        : air_(command), numbers_(command), moment_(command), files_(command) {
        command
            .add_option("--quantity", quantities_,
                        "What is tabulated, " + oneOf(quantityWords(), "") +
                            "; may be given more than once")
            ->type_name("WORD")
            ->expected(1)
            ->take_all();
        command.add_option("--band", band_, "Spectral band MIN-MAX")
            ->type_name("um")
            ->capture_default_str();
        numbers_.add("--sensor-altitude", "m", "Where the line of sight begins");
        numbers_.add("--los-elevation", "deg", "From the sensor, up positive");
        numbers_.add("--los-azimuth", "deg", "From the sensor, east of north; 0 when not given");
        numbers_.add("--altitude", "m", "Of the target");
        numbers_.add("--range", "m", "From sensor to target");
        command
            .add_option("--reference-distance", references_,
                        "That a spectrum of a plume was measured from: adds the transmittance of "
                        "the last so many metres, with which an analysis of such plumes accepts "
                        "the file; may be given more than once")
            ->type_name("m")
            ->expected(1)
            ->take_all();
        command.add_flag("--to-space", toSpace_, "A path without target, up to 100 km altitude");
        numbers_.add("--resolution", "cm-1", "Width of the spectral bins: 1, 5 or 15");
        command
            .add_option("--sun", sun_,
                        "off: no light of the sun in any quantity, as at night; on, or as scenes "
                        "have it, smart and approx: that of the sun's place")
            ->type_name("WORD")
            ->capture_default_str();
        numbers_.add("--sun-azimuth", "deg",
                     "East of north; when not given that of an Environment file, or 180");
        numbers_.add("--sun-elevation", "deg",
                     "Above the horizon; when not given that of an Environment file, or 45");
        numbers_.add("--day-of-year", "",
                     "1 to 366, for the distance of the sun; the mean one "
                     "when not given");
    }

    int run(Context& context) const {
        files_.check("spectra.csv", context.json);
        const RadiativeRequest request = requestOf(context);
        irsg::Environment environment;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            environment = environmentOf();
        }
        RadiativeOutput output;
        {
            const StageTimer::Scope scope(&context.timer, "compute");
            output = radiativeOutput(environment, request);
        }
        const StageTimer::Scope scope(&context.timer, "save");
        files_.write(name(AnalysisKind::radiative), output.table, output.summary, output.warnings,
                     context.json);
        return done;
    }

  private:
    /// Every diagnostic of the options at once.
    RadiativeRequest requestOf(const Context& context) const {
        std::vector<irsg::Diagnostic> diagnostics;
        const auto collect = [&](const auto& work) { irsg::collect(diagnostics, work); };
        RadiativeRequest request;
        request.commandLine = context.commandLine;
        collect([&] { request.band = irsg::Band::fromText(band_).range(); });
        collect([&] { numbers_.check(); });
        addQuantities(request, diagnostics);
        addReferences(request, diagnostics);
        checkLimits("--sun-azimuth", 0.0, 360.0, " deg", diagnostics);
        checkLimits("--sun-elevation", -90.0, 90.0, " deg", diagnostics);
        checkLimits("--day-of-year", 1.0, 366.0, "", diagnostics);
        collect([&] { checkMoment(diagnostics); });
        if (sun_ != "on" && sun_ != "off" && sun_ != "smart" && sun_ != "approx")
            diagnostics.push_back({"--sun", "", sun_, "on, off, smart or approx"});
        const auto resolution = numbers_.value("--resolution");
        if (resolution && *resolution != 1.0 && *resolution != 5.0 && *resolution != 15.0) {
            diagnostics.push_back(
                {"--resolution", "", irsg::numberText(*resolution), "1, 5 or 15"});
        }
        request.geometry = {.sensorAltitude_m = numbers_.value("--sensor-altitude"),
                            .losElevation_deg = numbers_.value("--los-elevation"),
                            .losAzimuth_deg = numbers_.value("--los-azimuth").value_or(0.0),
                            .targetAltitude_m = numbers_.value("--altitude"),
                            .range_m = numbers_.value("--range"),
                            .toSpace = toSpace_};
        collect([&] { solveGeometry(request.geometry); });
        if (!diagnostics.empty())
            throw irsg::InputError(std::move(diagnostics));
        return request;
    }

    void addQuantities(RadiativeRequest& request,
                       std::vector<irsg::Diagnostic>& diagnostics) const {
        for (const std::string& word : quantities_) {
            bool isKnown = word == "all";
            request.leaveOutMissing = request.leaveOutMissing || isKnown;
            for (const RadiativeQuantity& known : radiativeQuantities()) {
                if ((word == "all" || word == known.word) &&
                    std::ranges::find(request.quantities, known.property) ==
                        request.quantities.end()) {
                    request.quantities.push_back(known.property);
                }
                isKnown = isKnown || word == known.word;
            }
            if (!isKnown)
                diagnostics.push_back({"--quantity", "", word, oneOf(quantityWords(), word)});
        }
        if (quantities_.empty())
            diagnostics.push_back({"--quantity", "", "nothing", oneOf(quantityWords(), "")});
    }

    void addReferences(RadiativeRequest& request,
                       std::vector<irsg::Diagnostic>& diagnostics) const {
        for (const std::string& text : references_) {
            const std::optional<double> distance_m = irsg::parseNumber(text);
            if (distance_m && *distance_m > 0.0)
                request.referenceDistances_m.push_back(*distance_m);
            else
                diagnostics.push_back({"--reference-distance", "", text, "a number above 0 m"});
        }
    }

    void checkLimits(const char* option, double least, double most, const char* unit,
                     std::vector<irsg::Diagnostic>& diagnostics) const {
        const auto value = numbers_.value(option);
        if (value && !(*value >= least && *value <= most)) {
            diagnostics.push_back({option, "", irsg::numberText(*value),
                                   "a number from " + irsg::numberText(least) + " to " +
                                       irsg::numberText(most) + unit});
        }
    }

    /// A moment gives the whole sun.
    void checkMoment(std::vector<irsg::Diagnostic>& diagnostics) const {
        if (!moment_.sun())
            return;
        for (const char* option : {"--sun-azimuth", "--sun-elevation", "--day-of-year"}) {
            if (const auto value = numbers_.value(option)) {
                diagnostics.push_back({option, "", irsg::numberText(*value),
                                       "nothing beside --date and --utc, which give it"});
            }
        }
    }

    /// The sun of the command line goes before that of an Environment file.
    irsg::Environment environmentOf() const {
        irsg::Environment environment;
        const auto resolution = numbers_.value("--resolution");
        const irsg::SunPosition sun =
            air_.addTo(environment,
                       resolution ? std::optional(static_cast<int>(*resolution)) : std::nullopt)
                .value_or(irsg::SunPosition{irsg::radians(180.0), irsg::radians(45.0)});
        const auto azimuth_deg = numbers_.value("--sun-azimuth");
        const auto elevation_deg = numbers_.value("--sun-elevation");
        const auto day = numbers_.value("--day-of-year");
        environment.sun = {azimuth_deg ? irsg::radians(*azimuth_deg) : sun.azimuth_rad,
                           elevation_deg ? irsg::radians(*elevation_deg) : sun.elevation_rad,
                           day ? irsg::sunDistance_au(static_cast<int>(*day)) : sun.distance_au};
        if (const auto moment = moment_.sun())
            environment.sun = moment->position;
        if (sun_ == "off")
            environment.sun.elevation_rad = irsg::radians(-90.0);
        return environment;
    }

    AtmosphereArguments air_;
    std::vector<std::string> quantities_, references_;
    std::string band_ = "3-5";
    std::string sun_ = "on";
    bool toSpace_ = false;
    NumberOptions numbers_;
    SunOptions moment_;
    TableFiles files_;
};

} // namespace

void addRadiativeCommand(CLI::App& app, Context& context) {
    addCommand<RadiativeCommand>(app, context, AnalysisKind::radiative);
}

} // namespace smat::batch
