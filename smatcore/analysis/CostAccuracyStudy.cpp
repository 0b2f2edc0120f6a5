#include "smatcore/analysis/CostAccuracyStudy.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/radiance/WidebandAtmosphere.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/analysis/IdleSettings.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

extern const AnalysisDefinition frontierTool; // Tools.cpp

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

/// What a way came to.
struct Found {
    const CostAccuracyStudy::Configuration* configuration;
    double trueError, statedError, time_ms, first_ms;
    bool isOnFront = false;
};

/// The light of a scene, less and less.
std::vector<std::pair<CostAccuracyStudy::Light, irsg::RenderSettings>>
lightsOf(const irsg::RenderSettings& own) {
    std::vector<std::pair<CostAccuracyStudy::Light, irsg::RenderSettings>> lights{
        {CostAccuracyStudy::allLight, own}};
    irsg::RenderSettings less = own;
    const auto add = [&](CostAccuracyStudy::Light light) {
        if (less != lights.back().second)
            lights.emplace_back(light, less);
    };
    less.bounces = 0;
    add(CostAccuracyStudy::withShadows);
    less.sunShadows = irsg::SunShadowMode::off;
    add(CostAccuracyStudy::sunAndSky);
    less.sun = less.ambientReflection = irsg::ReflectionMode::off;
    add(CostAccuracyStudy::noLight);
    return lights;
}

std::string lightWords(CostAccuracyStudy::Light light) {
    switch (light) {
    case CostAccuracyStudy::noLight:
        return ", no light of sun and sky";
    case CostAccuracyStudy::sunAndSky:
        return ", no shadows and no inter-reflection";
    case CostAccuracyStudy::withShadows:
        return ", no inter-reflection";
    case CostAccuracyStudy::allLight:
        break;
    }
    return "";
}

using Configurations = std::vector<CostAccuracyStudy::Configuration>;

/// What has most to lose of the errors of a view: all light, the finest antialiasing, the narrowest
/// bins, as many rows as are needed.
CostAccuracyStudy::Configuration baseOf(const Configurations& configurations) {
    CostAccuracyStudy::Configuration base = configurations.front();
    for (const CostAccuracyStudy::Configuration& one : configurations) {
        base.antialiasing = std::max(base.antialiasing, one.antialiasing);
        if (one.configuration.bins_per_cm == 1)
            base.configuration.bins_per_cm = 1;
        if (one.configuration.render.backgroundRows == 0)
            base.configuration.render.backgroundRows = 0;
    }
    return base;
}

/// What is chosen of a way: light, antialiasing, air and rows of the background.
std::array<int, 4> choicesOf(const CostAccuracyStudy::Configuration& one) {
    return {one.light, one.antialiasing,
            one.configuration.render.mode == irsg::CalculationMode::wideband
                ? -1
                : one.configuration.bins_per_cm,
            one.configuration.render.backgroundRows};
}

/// In how many choices it is other than the base, and in which last.
std::pair<int, std::size_t> changesFrom(const CostAccuracyStudy::Configuration& base,
                                        const CostAccuracyStudy::Configuration& one) {
    const auto own = choicesOf(one), usual = choicesOf(base);
    std::pair<int, std::size_t> changes{0, own.size()};
    for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i] != usual[i])
            changes = {changes.first + 1, i};
    return changes;
}

/// Seconds a case of a machine that draws in software, by an order, not a promise: samples of the
/// object, lines of sight and bins (docs/errors.md), and rays to the sun and between surfaces.
double configurationCost_s(const CostAccuracyStudy::Configuration& one,
                           const SceneDescription& scene) {
    constexpr std::array light_s = {0.0, 1e-3, 5e-2, 6e-2};
    constexpr double usualExtent_px = 64.0;
    const double side = one.configuration.render.tileSide_samples > 0
                            ? one.configuration.render.tileSide_samples
                            : usualExtent_px * one.configuration.render.samplesPerAxis;
    return modelledCost_s(side * side, one.configuration, scene) +
           light_s.at(static_cast<std::size_t>(one.light));
}

/// The ways that may be on the front: those that no way is both cheaper than and twice as right,
/// as the error of a way is at least that of each of its choices alone.
std::vector<std::size_t> likelyOf(const Configurations& configurations,
                                  const SceneDescription& scene,
                                  const std::map<std::size_t, double>& aloneErrors) {
    const CostAccuracyStudy::Configuration base = baseOf(configurations);
    std::array<std::map<int, double>, 4> errorOf;
    double least = 0.0;
    for (const auto& [i, error] : aloneErrors) {
        const auto [count, which] = changesFrom(base, configurations[i]);
        if (count == 0)
            least = error;
        else
            errorOf.at(which)[choicesOf(configurations[i]).at(which)] = error;
    }
    std::vector<std::pair<double, double>> known; // cost and error
    for (const CostAccuracyStudy::Configuration& one : configurations) {
        double error = least;
        const auto choices = choicesOf(one);
        for (std::size_t k = 0; k < choices.size(); ++k)
            if (const auto found = errorOf[k].find(choices[k]); found != errorOf[k].end())
                error = std::max(error, found->second);
        known.emplace_back(configurationCost_s(one, scene), error);
    }
    constexpr double margin = 2.0;
    std::vector<std::size_t> likely;
    for (std::size_t i = 0; i < configurations.size(); ++i)
        if (!aloneErrors.contains(i) && std::ranges::none_of(known, [&](const auto& other) {
                return other.first <= known[i].first && margin * other.second < known[i].second;
            }))
            likely.push_back(i);
    return likely;
}

/// By ascending error; marks those than which none is both quicker and less wrong.
void sortAndMark(std::vector<Found>& found) {
    std::ranges::stable_sort(found, [](const Found& a, const Found& b) {
        return std::pair(a.trueError, a.time_ms) < std::pair(b.trueError, b.time_ms);
    });
    double least_ms = std::numeric_limits<double>::infinity();
    for (Found& one : found) {
        one.isOnFront = one.time_ms < least_ms;
        least_ms = std::min(least_ms, one.time_ms);
    }
}

void fill(ResultTable& table, const std::vector<Found>& found, const Found* chosen) {
    table = {};
    for (const auto& [key, unit] :
         std::initializer_list<std::pair<const char*, const char*>>{{"true_error", "%"},
                                                                    {"least_time", "ms"},
                                                                    {"time", "ms"},
                                                                    {"first_time", "ms"},
                                                                    {"stated_error", "%"},
                                                                    {"antialiasing", ""},
                                                                    {"bins", "cm-1"},
                                                                    {"wideband", ""},
                                                                    {"background_rows", ""},
                                                                    {"light", ""},
                                                                    {"on_front", ""},
                                                                    {"chosen", ""}})
        table.add(key, unit);
    double least_ms = std::numeric_limits<double>::infinity();
    for (const Found& one : found) {
        least_ms = std::min(least_ms, one.time_ms);
        const CalculationConfiguration& configuration = one.configuration->configuration;
        const bool isWideband = configuration.render.mode == irsg::CalculationMode::wideband;
        table.addRow({100.0 * one.trueError, least_ms, one.time_ms, one.first_ms,
                      100.0 * one.statedError, static_cast<double>(one.configuration->antialiasing),
                      static_cast<double>(configuration.bins_per_cm), isWideband ? 1.0 : 0.0,
                      static_cast<double>(configuration.render.backgroundRows),
                      static_cast<double>(one.configuration->light), one.isOnFront ? 1.0 : 0.0,
                      &one == chosen ? 1.0 : 0.0});
    }
}

} // namespace

AnalysisKind CostAccuracyStudy::kind() {
    return AnalysisKind(frontierTool);
}

std::vector<CostAccuracyStudy::Configuration>
CostAccuracyStudy::configurationsOf(const SceneDescription& scene, bool wideband) {
    std::vector<std::pair<irsg::CalculationMode, int>> airs = {{scene.settings.mode, 0}};
    if (hasBins(scene) && scene.settings.mode == irsg::CalculationMode::spectral)
        airs = {{irsg::CalculationMode::spectral, 15},
                {irsg::CalculationMode::spectral, 5},
                {irsg::CalculationMode::spectral, 1}};
    const std::vector<irsg::Band> bands = scene.allBands();
    if (wideband && std::ranges::all_of(bands, [&](const irsg::Band& band) {
            return irsg::hasWidebandAtmosphere(scene.environment, band, scene.settings);
        }))
        airs.emplace_back(irsg::CalculationMode::wideband, 0);
    std::vector<int> rows = {scene.settings.backgroundRows};
    if (scene.settings.background == irsg::BackgroundMode::environment)
        rows = {1, 0};
    std::vector<Configuration> configurations;
    for (const auto& [light, render] : lightsOf(scene.settings))
        for (int antialiasing = 0; antialiasing <= 5; ++antialiasing)
            for (const auto& [mode, bins_per_cm] : airs)
                for (const int row : rows) {
                    CalculationConfiguration configuration{render, bins_per_cm};
                    configuration.render.tileStrategy = irsg::TileStrategy::aligned;
                    configuration.render.tileSide_samples =
                        antialiasing > 2 ? 128 << (antialiasing - 3) : 0;
                    configuration.render.samplesPerAxis = antialiasing > 2 ? 1 : 1 << antialiasing;
                    configuration.render.mode = mode;
                    configuration.render.backgroundRows = row;
                    configurations.push_back({configuration, antialiasing, light});
                }
    return configurations;
}

std::string CostAccuracyStudy::optionWords(const Options& options) {
    std::string words;
    if (options.repeats != Options().repeats)
        words += fmt::format(" --repeats {}", options.repeats);
    return words + (options.likely ? " --configurations likely" : "");
}

CostAccuracyStudy::Size CostAccuracyStudy::sizeOf(const Project& project, const Settings& settings,
                                                  const Options& options) {
    SceneDescription scene;
    scene.settings = renderSettingsOf(settings);
    scene.environment = environmentOf(project, settings);
    scene.sensor = sensorOf(project, settings);
    scene.setBands(bandsOf(project, settings));
    const std::vector<Configuration> configurations =
        configurationsOf(scene, settings[key::sensorMode] == "auto");
    const Configuration base = baseOf(configurations);
    Size size{configurations.size(), 0, 0.0, 0.0};
    const double cases = static_cast<double>(options.repeats) + 1.0;
    const double truth_s = configurationCost_s({finest(scene), 5, allLight}, scene);
    size.least_s = size.most_s = truth_s;
    for (const Configuration& one : configurations) {
        const bool isAlone = changesFrom(base, one).first < 2;
        size.alone += isAlone ? 1 : 0;
        size.most_s += cases * configurationCost_s(one, scene);
        size.least_s += isAlone ? cases * configurationCost_s(one, scene) : 0.0;
    }
    return size;
}

Settings CostAccuracyStudy::settingsOf(const ResultTable& table, std::size_t row) {
    const auto cell = [&](const char* key) {
        const ResultColumn* column = table.find(key);
        if (column == nullptr || row >= column->values.size())
            throw irsg::LogicError(std::string("no configuration of a cost-accuracy study: ") +
                                   key);
        return static_cast<int>(column->values[row]);
    };
    Settings configuration;
    configuration.set(key::renderTargetError, "none");
    configuration.set(key::renderZoom, "aligned");
    configuration.set(key::renderAntialiasing, cell("antialiasing"));
    configuration.set(key::sensorMode, cell("wideband") != 0 ? "ck" : "spectral");
    configuration.set(key::environmentBins,
                      cell("bins") == 0 ? "native" : std::to_string(cell("bins")));
    configuration.set(key::renderBackgroundRows, cell("background_rows"));
    const int light = cell("light");
    if (light < allLight)
        configuration.set(key::renderBounces, "0");
    if (light < withShadows)
        configuration.set(key::renderShadows, "off");
    if (light < sunAndSky) {
        configuration.set(key::renderSun, "off");
        configuration.set(key::renderAmbientReflection, "off");
    }
    return configuration;
}

CalculationConfiguration CostAccuracyStudy::finest(const SceneDescription& scene) {
    CalculationConfiguration configuration = CalculationConfiguration::of(scene);
    configuration.render.tileStrategy = irsg::TileStrategy::aligned;
    configuration.render.tileSide_samples = 2048;
    configuration.render.mode = irsg::CalculationMode::spectral;
    configuration.bins_per_cm = hasBins(scene) ? 1 : 0;
    if (scene.settings.background == irsg::BackgroundMode::environment)
        configuration.render.backgroundRows = 128;
    return configuration;
}

void CostAccuracyStudy::rehearse(AnalysisData& data, const RenderDoor& door,
                                 const SceneFactory& scenes, const Options& options) {
    sizeOf(data.project, data.settings, options);
    const SceneDescription scene = scenes(data.project, data.settings);
    const CasePlacer placer(door, scene);
    data.renderer = door.description(scene);
    irsg::appendUnique(data.warnings, scene.remarks);
    irsg::appendUnique(data.warnings, idleSettingRemarks(data));
    const PlacedCase placed = placer.place(scene, startingCase(data.settings));
    door.check(placed.scene, placed.view, irsg::Outputs::reports(scene.allBands()));
}

void CostAccuracyStudy::run(AnalysisData& data, const RenderDoor& door, const SceneFactory& scenes,
                            const Options& options, const ProgressCallback& progress,
                            std::stop_token stop) {
    const auto start = Clock::now();
    const SceneDescription scene = scenes(data.project, data.settings);
    const CasePlacer placer(door, scene);
    for (const irsg::Entity& entity : scene.entities)
        data.databases.push_back(entity.database);
    data.renderer = door.description(scene);
    irsg::appendUnique(data.warnings, scene.remarks);
    irsg::appendUnique(data.warnings, idleSettingRemarks(data));
    const irsg::Vec3 reference =
        scene.entities.front().pose.toWorld(placer.referencePoints().front());
    const auto places = CasePlacer::placesIn(scene);
    // Neither drawing nor line of sight is shared, and all else is alike.
    const auto placed = [&](const SceneDescription& inSomeWay, std::size_t moved) {
        constexpr double step = 1e-4;
        AnalysisCase one = startingCase(data.settings);
        one.azimuth_rad += step * static_cast<double>(moved % 100);
        one.range_m *= 1.0 + step * static_cast<double>(moved % 100);
        return placer.place(inSomeWay, places, one.viewpoint(reference));
    };
    const std::vector<Configuration> configurations =
        configurationsOf(scene, data.settings[key::sensorMode] == "auto");
    std::size_t moved = 0;
    // Which are measured, in this order: of likely ones at first each choice alone.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < configurations.size(); ++i)
        if (!options.likely || changesFrom(baseOf(configurations), configurations[i]).first < 2)
            order.push_back(i);
    const std::size_t alone = order.size();
    const auto tell = [&](std::size_t done, const std::string& what) {
        if (progress)
            progress({done, order.size() + 1, 1e-3 * milliseconds(Clock::now() - start),
                      "cost-accuracy: " + what});
    };
    const auto measured = [&](const CalculationConfiguration& configuration, std::size_t view) {
        ProbedViews one(door, scene, 1, false, [&](const SceneDescription& inSomeWay, std::size_t) {
            return placed(inSomeWay, view);
        });
        return one.measured(configuration, true);
    };
    tell(0, "what all are held against");
    const auto truth = measured(finest(scene), 0);
    for (const irsg::RenderReport& report : truth.front())
        irsg::addProvider(data.providedBy, report.providedBy);

    std::vector<Found> found;
    std::map<std::size_t, double> aloneErrors;
    for (std::size_t k = 0; k < order.size() && !stop.stop_requested(); ++k) {
        const std::size_t i = order[k];
        const CalculationConfiguration& configuration = configurations[i].configuration;
        tell(k + 1, configuration.words(scene));
        const auto begin = Clock::now();
        const auto own = measured(configuration, 0);
        Found one{&configurations[i], ProbedViews::difference(own, truth, truth),
                  ProbedViews::stated(own).sum, std::numeric_limits<double>::infinity(),
                  milliseconds(Clock::now() - begin)};
        const SceneDescription asCalculated = configuration.applied(scene);
        for (std::size_t repeat = 0; repeat < options.repeats; ++repeat) {
            const PlacedCase next = placed(asCalculated, ++moved);
            const auto began = Clock::now();
            (void)next.render(door, irsg::Outputs::reports(scene.allBands()).withErrors(false));
            one.time_ms = std::min(one.time_ms, milliseconds(Clock::now() - began));
        }
        found.push_back(one);
        aloneErrors[i] = one.trueError;
        if (options.likely && order.size() == alone && found.size() == alone) {
            const std::vector<std::size_t> more = likelyOf(configurations, scene, aloneErrors);
            order.insert(order.end(), more.begin(), more.end());
        }
    }
    if (found.size() == order.size() && order.size() < configurations.size())
        data.providedBy.push_back(fmt::format(
            "configurations: {} of {}, each choice alone and those that may be on the front; for "
            "each of the others, a cheaper one with half the error is predicted",
            order.size(), configurations.size()));
    sortAndMark(found);
    constexpr double usual_percent = 1.0;
    const double target = 0.01 * data.settings[key::renderTargetError].value_or(usual_percent);
    const Found* chosen = nullptr;
    for (const Found& one : found)
        if (one.trueError <= target && (chosen == nullptr || one.time_ms < chosen->time_ms))
            chosen = &one;
    fill(data.table, found, chosen);
    const std::string prefix =
        fmt::format("target error {} %: ", irsg::roundedText(100.0 * target, 4));
    if (chosen != nullptr)
        data.providedBy.push_back(prefix + chosen->configuration->configuration.words(scene) +
                                  lightWords(chosen->configuration->light) +
                                  fmt::format(", the quickest of {} configurations that meet it: "
                                              "{} ms a case, a true error of {} %",
                                              found.size(), irsg::roundedText(chosen->time_ms, 3),
                                              irsg::roundedText(100.0 * chosen->trueError, 2)));
    else
        data.providedBy.push_back(prefix + "no configuration meets it");
    for (const Found& one : found)
        if (one.isOnFront)
            data.summary.push_back(
                {fmt::format("mode {}, {}{}, {} ms", one.configuration->antialiasing,
                             one.configuration->configuration.words(scene),
                             lightWords(one.configuration->light),
                             irsg::roundedText(one.time_ms, 3)),
                 100.0 * one.trueError, "%"});
    data.state = found.size() == order.size() ? AnalysisState::complete : AnalysisState::partial;
    if (found.size() < order.size())
        data.warnings.push_back(
            fmt::format("stopped after {} of {} configurations", found.size(), order.size()));
    tell(order.size() + 1, "done");
    data.elapsed_s = 1e-3 * milliseconds(Clock::now() - start);
    writeProvenance(data, scene);
}

} // namespace smat
