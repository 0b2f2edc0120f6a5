#include "smatcore/analysis/DetectionComparison.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "irsg/atmosphere/SolarPosition.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/MaterialLibrary.h"
#include "smatcore/analysis/ChangedAir.h"
#include "smatcore/analysis/DetectionAspects.h"
#include "smatcore/analysis/DetectionProvenance.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"

namespace smat {

namespace {

using Air = irsg::AtmosphereSmartParameters;

/// One value, and what it changes.
struct Variation {
    std::string name;            ///< "wind 5 m/s"
    std::vector<double> columns; ///< of the table
    std::optional<double> time_s = {};
    std::optional<irsg::SpectralRange> band = {};
    std::function<void(SceneDescription&)> change = [](SceneDescription&) {};
};

[[noreturn]] void refuse(const std::string& word, const std::string& value,
                         const std::string& expected) {
    throw irsg::InputError({"", word, value, expected});
}

double numberOf(const std::string& word, const std::string& text, double least, double most,
                const char* unit) {
    const auto value = irsg::parseNumber(irsg::trimmed(text));
    if (!value || *value < least || *value > most)
        refuse(word, text,
               fmt::format("a number from {} to {}{}{}", irsg::numberText(least),
                           irsg::numberText(most), *unit == 0 ? "" : " ", unit));
    return *value;
}

/// What a computed atmosphere is asked to change, and why it may not.
struct AirChange {
    const char* unit;
    double least, most;
    bool (*set)(Air& air, double value);
    const char* expected;
};

AirChange airChangeOf(RangeAgainst against) {
    constexpr int navy = 3, desert = 7, byMeasurements = 2;
    switch (against) {
    case RangeAgainst::wind:
        return {"m/s", 0.1, 30.0,
                [](Air& air, double value) {
                    air.windSpeed_m_s = air.windSpeedAverage24_m_s = value;
                    return air.aerosols != 0 &&
                           (air.aerosolModel == navy || air.aerosolModel == desert);
                },
                "an AtmosphereSmart with Navy maritime or desert aerosol (AerosolModel 3 or 7), on "
                "which wind has an effect"};
    case RangeAgainst::visibility:
        return {"m", 10.0, 300000.0,
                [](Air& air, double value) {
                    air.visibility_m = value;
                    return air.aerosols != 0;
                },
                "an AtmosphereSmart with aerosol"};
    default:
        return {"%", 0.0, 100.0,
                [](Air& air, double value) {
                    air.relativeHumidityMH_percent = value;
                    return air.meteoModel == byMeasurements;
                },
                "an AtmosphereSmart that follows measurements (MeteoModel 2)"};
    }
}

Variation ofAir(RangeAgainst against, const std::string& word, const std::string& text) {
    const AirChange change = airChangeOf(against);
    const double value = numberOf(word, text, change.least, change.most, change.unit);
    Variation made{fmt::format("{} {} {}", word, irsg::numberText(value), change.unit), {value}};
    made.change = [change, value, word](SceneDescription& scene) {
        auto changed = withAir(scene.environment, [&](Air& air) { return change.set(air, value); });
        if (!changed)
            refuse(word, "the atmospheres of the scene", change.expected);
        scene.environment = std::move(*changed);
    };
    return made;
}

bool dependsOnTime(const SceneDescription& scene) {
    for (const irsg::Entity& entity : scene.entities) {
        if (!entity.database)
            continue;
        for (const auto& [index, entry] : entity.database->temperatures) {
            const auto isOverTime = [](const irsg::ComponentFactor& factor) {
                return !factor.time.empty() && factor.selection == irsg::FactorSelection::table;
            };
            if (entry.mode == irsg::EmissionMode::temperature
                    ? !entry.terms.time.empty()
                    : std::ranges::any_of(entry.factors, isOverTime))
                return true;
        }
    }
    return false;
}

/// Whether the sun is seen at all: by surfaces, as a disc, or by air.
bool dependsOnSun(const SceneDescription& scene) {
    const auto isAir = [](const std::shared_ptr<const irsg::Atmosphere>& one) {
        return dynamic_cast<const irsg::Vacuum*>(one.get()) == nullptr;
    };
    return scene.settings.sun != irsg::ReflectionMode::off || scene.settings.sunDisc ||
           std::ranges::any_of(scene.environment.atmospheres(), isAir);
}

Variation ofHour(const RangeComparison& comparison, const std::string& text) {
    const double hour = numberOf("hour", text, 0.0, 24.0, "h");
    Variation made{fmt::format("hour {}", irsg::numberText(hour)), {hour}};
    made.time_s = 3600.0 * hour;
    made.change = [](const SceneDescription& scene) {
        if (!dependsOnTime(scene))
            refuse("hour", "a scene without temperatures over time",
                   "temperature tables over time in the database of a model, or a day and a place "
                   "whose sun is seen");
    };
    if (!comparison.place)
        return made;
    const auto& [date, latitude_deg, longitude_deg] = *comparison.place;
    irsg::UniversalTime time = irsg::UniversalTime::fromText(date, "00:00", "");
    const irsg::Geographic place{irsg::radians(latitude_deg), irsg::radians(longitude_deg), 0.0};
    // The algorithm goes on beyond the ends of the day.
    time.hour = hour - longitude_deg / 15.0;
    const irsg::SunPosition sun = irsg::sunPosition(time, place);
    made.change = [sun](SceneDescription& scene) {
        if (!dependsOnTime(scene) && !dependsOnSun(scene))
            refuse("hour", "a scene without sun and temperatures over time",
                   "a sun that shines on the target or its air, or temperature tables over time");
        scene.environment.sun = sun;
    };
    return made;
}

Variation ofBand(const std::string& text) {
    const std::size_t dash = text.find('-', 1);
    const auto from_um = irsg::parseNumber(irsg::trimmed(text.substr(0, dash)));
    const auto to_um = dash == std::string::npos
                           ? std::nullopt
                           : irsg::parseNumber(irsg::trimmed(text.substr(dash + 1)));
    if (!from_um || !to_um || *from_um <= 0.0 || *to_um <= *from_um)
        refuse("band", text, "a band MIN-MAX with 0 < MIN < MAX in um");
    Variation made{fmt::format("band {} um", text), {*from_um, *to_um}};
    made.band = irsg::SpectralRange{*from_um, *to_um};
    return made;
}

/// The materials that faces of a target have.
std::set<int> materialsOf(const irsg::Entity& target) {
    std::set<int> all;
    for (const auto& [codes, use] : target.model->codes())
        all.insert(target.database->materials.contains(codes.material) || !target.fallbackMaterial
                       ? codes.material
                       : *target.fallbackMaterial);
    return all;
}

Variation ofPaint(const RangeComparison& comparison, const std::string& text, double column) {
    Variation made{"paint " + text, {column}};
    made.change = [paint = comparison.paint, text](SceneDescription& scene) {
        auto& target = scene.entities.front();
        auto database = std::make_shared<irsg::SignatureDatabase>(*target.database);
        std::vector<std::string> known;
        const irsg::Material* other = nullptr;
        for (const irsg::SignatureDatabase* from :
             {target.database.get(), &irsg::materialLibrary()})
            for (const auto& [index, material] : from->materials)
                if (other == nullptr && material.name == text)
                    other = &material;
        irsg::Material grey;
        if (const auto emissivity = irsg::parseNumber(text); !other && emissivity) {
            grey.name = paint;
            grey.emissivity = irsg::Spectrum::constant(numberOf("paint", text, 0.0, 1.0, ""));
            grey.transmissivity = irsg::Spectrum::constant(0.0);
            other = &grey;
        }
        if (other == nullptr)
            refuse("paint", text,
                   "an emissivity from 0 to 1, or the name of a material of the target's database "
                   "or of the library");
        bool isThere = false;
        const std::set<int> seen = materialsOf(target);
        for (auto& [index, material] : database->materials) {
            if (!seen.contains(index))
                continue;
            known.push_back(material.name);
            if (material.name != paint)
                continue;
            const std::string name = material.name;
            material = *other;
            material.name = name;
            isThere = true;
        }
        if (!isThere)
            refuse("paint that is replaced", paint, irsg::alternatives(known));
        target.database = std::move(database);
    };
    return made;
}

std::vector<Variation> variationsOf(const RangeComparison& comparison) {
    const std::string& word = rangeAgainstWords()[static_cast<std::size_t>(comparison.against)];
    const bool areNumbers = std::ranges::all_of(comparison.values, [](const std::string& text) {
        return irsg::parseNumber(text).has_value();
    });
    std::vector<Variation> all;
    for (const std::string& text : comparison.values)
        switch (comparison.against) {
        case RangeAgainst::hour:
            all.push_back(ofHour(comparison, text));
            break;
        case RangeAgainst::band:
            all.push_back(ofBand(text));
            break;
        case RangeAgainst::paint:
            all.push_back(ofPaint(comparison, text,
                                  areNumbers ? *irsg::parseNumber(text)
                                             : static_cast<double>(all.size() + 1)));
            break;
        default:
            all.push_back(ofAir(comparison.against, word, text));
        }
    if (all.empty())
        refuse(word, "nothing", "at least one value");
    return all;
}

void addColumns(ResultTable& table, const DetectionRequest& request) {
    const RangeComparison& comparison = *request.comparison;
    switch (comparison.against) {
    case RangeAgainst::wind:
        table.add("wind", "m s-1");
        break;
    case RangeAgainst::visibility:
        table.add("visibility", "m");
        break;
    case RangeAgainst::humidity:
        table.add("humidity", "%");
        break;
    case RangeAgainst::hour:
        table.add("hour", "h");
        break;
    case RangeAgainst::band:
        table.add("band_from", "um");
        table.add("band_to", "um");
        break;
    case RangeAgainst::paint:
        table.add(std::ranges::all_of(
                      comparison.values,
                      [](const std::string& text) { return irsg::parseNumber(text).has_value(); })
                      ? "emissivity"
                      : "paint",
                  "");
        break;
    }
    for (const char* key :
         {"detection_range", "error_detection_range", "least_range", "greatest_range"})
        table.add(key, "m");
    table.add("nowhere", "");
    table.add("beyond", "");
    if (request.measuresClutter)
        table.add("clutter", "K");
}

/// What the cases of a value come to.
struct OfValue {
    std::vector<double> ranges_m, errors_m, clutters_K;
    std::size_t nowhere = 0, beyond = 0;

    std::vector<double> row(std::vector<double> row, bool withClutter) const {
        row.insert(row.end(), {meanOf(ranges_m), meanOf(errors_m), std::ranges::min(ranges_m),
                               std::ranges::max(ranges_m), static_cast<double>(nowhere),
                               static_cast<double>(beyond)});
        if (withClutter)
            row.push_back(meanOf(clutters_K));
        return row;
    }
};

} // namespace

void runDetectionComparison(AnalysisData& data, const DetectionRequest& request,
                            const RenderDoor& door, const SceneFactory& scenes,
                            const RunControl& control) {
    const std::vector<Variation> variations = variationsOf(*request.comparison);
    const Settings settings = data.settings;
    DetectionProgress progress(control);
    addColumns(data.table, request);
    bool isStopped = false;
    for (const Variation& one : variations) {
        DetectionRequest changed = request;
        if (one.band) {
            changed.sensor.detector.band = *one.band;
            changed.sensor.check();
        }
        data.settings = settings;
        data.databases.clear(); // those of the last value
        if (one.time_s)
            data.settings.set(key::stateTime, *one.time_s);
        DetectionAspects aspects(data, changed, door,
                                 [&](const Project& project, const Settings& of) {
                                     SceneDescription scene = scenes(project, of);
                                     one.change(scene);
                                     return scene;
                                 });
        const std::size_t cases = aspects.shared().plan.cases.size();
        if (control.isRehearsal) {
            aspects.shared().check(request.limits.nearest_m);
            continue;
        }
        progress.total = cases * variations.size();
        RangeSearch search(changed, aspects.sight());
        OfValue all;
        aspects.each(
            {aspects.shared().scene}, progress,
            [&](const DetectionAspects::Case& place) {
                const AspectRange seen = search.find(place.aspect);
                all.ranges_m.push_back(seen.found.range_m);
                all.errors_m.push_back(seen.error_m);
                all.clutters_K.push_back(place.clutter.deviation_K);
                all.nowhere += seen.outcome() < 0.0;
                all.beyond += seen.outcome() > 0.0;
            },
            one.name + ", ");
        isStopped = all.ranges_m.size() < cases;
        if (isStopped)
            break;
        aspects.tellWarnings();
        std::vector<std::string> ofSearch;
        search.tell(ofSearch);
        for (const std::string& sentence : ofSearch)
            data.warnings.push_back(one.name + ": " + sentence);
        std::string ofRow;
        for (const std::string& sentence : ofSearch)
            ofRow += (ofRow.empty() ? "" : "; ") + sentence;
        data.table.addRow(all.row(one.columns, request.measuresClutter), ofRow);
        data.summary.push_back({"Mean detection range, " + one.name, meanOf(all.ranges_m), "m"});
    }
    data.settings = settings;
    if (control.isRehearsal)
        return;
    if (isStopped)
        data.warnings.push_back(
            fmt::format("stopped after {} of {} values", data.table.rowCount(), variations.size()));
    data.state = isStopped ? AnalysisState::partial : AnalysisState::complete;
    data.elapsed_s = progress.elapsed_s();
    data.databases.clear();
    const DetectionAspects nominal(data, request, door, scenes);
    tellDetection(data, nominal.shared(), request, TargetSight(request));
    const RangeComparison& comparison = *request.comparison;
    data.table.provenance.add("detection.against",
                              rangeAgainstWords()[static_cast<std::size_t>(comparison.against)]);
    for (const std::string& value : comparison.values)
        data.table.provenance.add("detection.value", value);
    if (comparison.against == RangeAgainst::paint)
        data.table.provenance.add("detection.paint", comparison.paint);
    if (comparison.place)
        data.table.provenance.add(
            "detection.place",
            fmt::format("{}, latitude {} deg, longitude {} deg", comparison.place->date,
                        comparison.place->latitude_deg, comparison.place->longitude_deg));
}

std::string comparisonOptions(const RangeComparison& comparison) {
    std::string values;
    for (const std::string& value : comparison.values)
        values += (values.empty() ? "" : ",") + value;
    std::string options = " --against " +
                          rangeAgainstWords()[static_cast<std::size_t>(comparison.against)] +
                          " --values " + shellQuoted(values);
    if (comparison.against == RangeAgainst::paint)
        options += " --paint " + shellQuoted(comparison.paint);
    if (comparison.place)
        options += fmt::format(" --sun-of {},{},{}", comparison.place->date,
                               irsg::numberText(comparison.place->latitude_deg),
                               irsg::numberText(comparison.place->longitude_deg));
    return options;
}

} // namespace smat
