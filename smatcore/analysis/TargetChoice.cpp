#include "smatcore/analysis/TargetChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/Wording.h"

namespace smat {

namespace {

using irsg::BackgroundMode;
using irsg::CalculationMode;
using irsg::ReflectionMode;
using irsg::RenderSettings;
using irsg::SunShadowMode;
using Reports = ProbedViews::Reports;

constexpr int firstTile = 128, leastTile = 64, largestTile = 2048;
/// Of view factors between surfaces, where it is asked whether they matter.
constexpr double coarseLight = 0.1;
/// That the quadrature points of wideband-ck are trained to.
constexpr std::array widebandErrors = {0.01, 0.003, 0.001};
constexpr double ofSkipped = 1.0 / 3.0; ///< of the target, for all that is left out

std::string percent(double part) {
    return irsg::roundedText(100.0 * part, 2) + " %";
}

std::string lookedAt(const ProbedViews& views) {
    return views.count() == 1 ? "in its view" : fmt::format("in {} views", views.count());
}

/// A kind of light that may be left out.
struct Skippable {
    std::string name, reason;
    double bound;
    void (*leaveOut)(RenderSettings&);
};

/// Facets that mirror send more in some directions than light from everywhere alike tells.
bool hasSpeculars(const SceneDescription& scene) {
    return std::ranges::any_of(scene.entities, [](const irsg::Entity& entity) {
        return entity.database && std::ranges::any_of(entity.database->materials, [](auto& one) {
                   return !one.second.surfaceModel.empty();
               });
    });
}

/// Bounds of all that may be left out, from the probed views; what the scene lacks is left out.
std::vector<Skippable> boundsOfLight(ProbedViews& views, const CalculationConfiguration& start) {
    const RenderSettings& own = start.render;
    const auto with = [&](auto&& change) {
        CalculationConfiguration configuration = start;
        configuration.render.lightError = std::max(configuration.render.lightError, coarseLight);
        change(configuration.render);
        return configuration;
    };
    const auto alone = [&](auto&& change) { // no inter-reflection, no shadows
        return with([&](RenderSettings& render) {
            render.bounces = 0;
            render.sunShadows = SunShadowMode::off;
            change(render);
        });
    };
    const bool mirrors = hasSpeculars(views.scene());
    const bool queriesSun = own.sun == ReflectionMode::smart && !mirrors;
    const bool queriesFluxes = own.ambientReflection == ReflectionMode::smart && !mirrors;
    const bool asksLight = own.bounces != 0;
    enum { all, single, noSun, anySun, noFluxes, anyFluxes, lightNoSun, lightNoFluxes };
    const std::vector<CalculationConfiguration> configurations = {
        with([](RenderSettings&) {}),
        alone([](RenderSettings&) {}),
        alone([](RenderSettings& render) { render.sun = ReflectionMode::off; }),
        alone([](RenderSettings& render) { render.sun = ReflectionMode::approx; }),
        alone([](RenderSettings& render) { render.ambientReflection = ReflectionMode::off; }),
        alone([](RenderSettings& render) { render.ambientReflection = ReflectionMode::approx; }),
        with([](RenderSettings& render) { render.sun = ReflectionMode::off; }),
        with([](RenderSettings& render) { render.ambientReflection = ReflectionMode::off; })};
    std::vector<int> asked = {all, single};
    if (queriesSun)
        asked.insert(asked.end(), {noSun, anySun});
    if (queriesFluxes)
        asked.insert(asked.end(), {noFluxes, anyFluxes});
    if (asksLight && queriesSun)
        asked.push_back(lightNoSun);
    if (asksLight && queriesFluxes)
        asked.push_back(lightNoFluxes);
    std::vector<CalculationConfiguration> distinct;
    for (const int one : asked)
        distinct.push_back(configurations[static_cast<std::size_t>(one)]);
    const auto numbers = views.measured(distinct, false);
    std::map<int, const std::vector<Reports>*> of;
    for (std::size_t i = 0; i < asked.size(); ++i)
        of[asked[i]] = &numbers[i];
    const auto difference = [&](int one, int other) {
        return ProbedViews::difference(*of.at(one), *of.at(other), *of.at(all));
    };

    std::vector<Skippable> found;
    // What is reflected twice is looked at, not bounded: twice what the views show.
    constexpr double ofLooked = 2.0;
    if (queriesSun) {
        // `approx` gives every surface a quarter of what one that faces the sun has.
        const double bound = std::max(4.0 * difference(anySun, noSun),
                                      asksLight ? ofLooked * difference(all, lightNoSun) : 0.0);
        const bool shades = own.sunShadows != SunShadowMode::off;
        found.push_back({shades ? "sun and its shadows" : "sun", "as if all faced it", bound,
                         [](RenderSettings& render) {
                             render.sun = ReflectionMode::off;
                             render.sunShadows = SunShadowMode::off;
                         }});
        if (shades) // take no more than there is
            found.push_back(
                {"shadows of the sun", "as if all were shaded", difference(single, noSun),
                 [](RenderSettings& render) { render.sunShadows = SunShadowMode::off; }});
    }
    if (queriesFluxes)
        // And of sky and ground a half each, of which no surface sees more than all.
        found.push_back(
            {"light of sky and ground", "as if all saw the brighter one alone",
             std::max(2.0 * difference(anyFluxes, noFluxes),
                      asksLight ? ofLooked * difference(all, lightNoFluxes) : 0.0),
             [](RenderSettings& render) { render.ambientReflection = ReflectionMode::off; }});
    if (asksLight) {
        const CalculationConfiguration shaded =
            with([](RenderSettings& render) { render.bounces = 0; });
        const double seen =
            ProbedViews::difference(*of.at(all), views.measured(shaded, false), *of.at(all));
        found.push_back({"inter-reflection", "twice what view factors to a tenth show",
                         ofLooked * seen, [](RenderSettings& render) { render.bounces = 0; }});
    }
    std::ranges::stable_sort(found, {}, &Skippable::bound);
    return found;
}

/// Errors by cause as far as they are known, and what is expected of ways that were not tried.
class Expected {
  public:
    void learn(const CalculationConfiguration& configuration, const StatedErrors& errors) {
        sampling_[configuration.render.tileSide_samples] = errors.sampling;
        air_[atmosphereOf(configuration)] = errors.air;
        background_[configuration.render.backgroundRows] = errors.background;
        sums_.emplace_back(configuration, errors.sum);
    }
    /// What was measured, where it was.
    std::optional<double> measured(const CalculationConfiguration& configuration) const {
        for (const auto& [known, sum] : sums_)
            if (known == configuration)
                return sum;
        return std::nullopt;
    }
    /// Of what was not tried a hopeful guess, so that it is tried.
    double sum(const CalculationConfiguration& configuration) const {
        if (const auto known = measured(configuration))
            return *known;
        return std::hypot(sampling(configuration.render.tileSide_samples),
                          air(atmosphereOf(configuration)),
                          background(configuration.render.backgroundRows));
    }

  private:
    /// Mode, bins, and what the quadrature points of wideband-ck are trained to.
    using Air = std::tuple<CalculationMode, int, double>;
    static Air atmosphereOf(const CalculationConfiguration& configuration) {
        const bool hasPoints = configuration.render.mode == CalculationMode::wideband;
        return {configuration.render.mode, configuration.bins_per_cm,
                hasPoints ? configuration.render.widebandError : 0.0};
    }

    double sampling(int window) const {
        const auto above = sampling_.lower_bound(window);
        if (above != sampling_.end() && above->first == window)
            return above->second;
        // Outlines have 1.5, wires and specks 1; see docs/errors.md. Hopeful in both directions.
        const bool isSmaller = above == sampling_.begin();
        const auto& [known, error] = isSmaller ? *above : *std::prev(above);
        return error * std::pow(static_cast<double>(known) / window, isSmaller ? 1.0 : 1.6);
    }
    double air(const Air& air) const {
        const auto known = air_.find(air);
        if (known != air_.end())
            return known->second;
        double least = air_.begin()->second;
        for (const auto& [of, error] : air_) {
            // Of points trained to another error, in proportion: hopeful for fewer points.
            const double wanted = std::get<double>(air), own = std::get<double>(of);
            if (wanted > 0.0 && own > 0.0)
                return error * (wanted < own ? wanted / own : 0.5 * wanted / own);
            least = std::min(least, error);
        }
        constexpr double hoped = 0.3;
        return hoped * least;
    }
    double background(int rows) const {
        const auto known = background_.find(rows);
        if (known != background_.end())
            return known->second;
        double least = background_.begin()->second;
        for (const auto& [of, error] : background_)
            least = std::min(least, error);
        constexpr double hoped = 0.3;
        return hoped * least;
    }

    std::map<int, double> sampling_, background_;
    std::map<Air, double> air_;
    std::vector<std::pair<CalculationConfiguration, double>> sums_;
};

double cost_s(const CalculationConfiguration& configuration, const SceneDescription& scene,
              const TargetUse& use) {
    const double samples = static_cast<double>(configuration.render.tileSide_samples) *
                           configuration.render.tileSide_samples;
    return modelledCost_s(samples, configuration, scene,
                          static_cast<double>(use.linesOfSight) / static_cast<double>(use.cases));
}

/// All ways that may be chosen, cheapest first.
std::vector<CalculationConfiguration> configurationsFrom(const CalculationConfiguration& start,
                                                         const SceneDescription& scene,
                                                         const TargetUse& use) {
    struct Air {
        CalculationMode mode;
        int bins_per_cm;
        double widebandError;
    };
    const double own = start.render.widebandError;
    const bool isWideband = start.render.mode == CalculationMode::wideband;
    std::vector<Air> airs;
    if (use.mayUseBins && hasBins(scene) && !isWideband)
        for (const int bins_per_cm : {15, 5, 1})
            airs.push_back({CalculationMode::spectral, bins_per_cm, own});
    else if (!isWideband)
        airs.push_back({start.render.mode, start.bins_per_cm, own});
    if (use.mayTrain || isWideband)
        for (const double error : widebandErrors)
            airs.push_back({CalculationMode::wideband, 0, error});
    std::vector<int> rows = {start.render.backgroundRows};
    if (start.render.background == BackgroundMode::environment)
        rows = {1, 0, 128};
    std::vector<CalculationConfiguration> configurations;
    for (int window = leastTile; window <= largestTile; window *= 2)
        for (const Air& air : airs)
            for (const int row : rows) {
                CalculationConfiguration configuration = start;
                configuration.render.tileSide_samples = window;
                configuration.render.mode = air.mode;
                configuration.bins_per_cm = air.bins_per_cm;
                configuration.render.widebandError = air.widebandError;
                configuration.render.backgroundRows = row;
                configurations.push_back(configuration);
            }
    std::ranges::stable_sort(configurations, {},
                             [&](const CalculationConfiguration& configuration) {
                                 return cost_s(configuration, scene, use);
                             });
    return configurations;
}

/// The scene as it is set, where that meets the target and no search is worth its time.
std::optional<TargetChoice> asSet(ProbedViews& views, double target, const TargetUse& use) {
    const SceneDescription& scene = views.scene();
    CalculationConfiguration own = CalculationConfiguration::of(scene);
    own.render.mode = use.usualMode.value_or(own.render.mode);
    if (!use.mayStay || !own.render.usesAlignedTiles())
        return std::nullopt;
    constexpr double probes = 10.0; // eight for bounds of light, and two ways at least
    const double cost = cost_s(own, scene, use);
    const double cheapest = cost_s(configurationsFrom(own, scene, use).front(), scene, use);
    if (static_cast<double>(use.cases) * (cost - cheapest) >
        probes * static_cast<double>(views.count()) * cost)
        return std::nullopt;
    const std::vector<Reports> numbers = views.measured(own, true);
    TargetChoice choice;
    choice.reached = ProbedViews::stated(numbers).sum;
    // With no margin for views that were not looked at: those that miss it are named.
    if (choice.reached > target)
        return std::nullopt;
    choice.configuration = own;
    choice.isMet = true;
    choice.leastContrasts_W_sr = ProbedViews::leastContrasts_W_sr(numbers);
    choice.sentences.push_back("target error " + percent(target) + ": " + own.words(scene) +
                               ", as set, with errors of at most " + percent(choice.reached) + " " +
                               lookedAt(views));
    return choice;
}

} // namespace

std::vector<std::size_t> probedCases(std::size_t count) {
    const std::size_t most = count < 100 ? 4 : 6;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < std::min(count, most); ++i)
        chosen.push_back(count <= most ? i : i * (count - 1) / (most - 1));
    return chosen;
}

TargetChoice chooseForTarget(ProbedViews& views, double target, const TargetUse& use) {
    if (std::optional<TargetChoice> found = asSet(views, target, use))
        return std::move(*found);
    const SceneDescription& scene = views.scene();
    CalculationConfiguration start = CalculationConfiguration::of(scene);
    start.render.tileSide_samples = firstTile;
    start.render.tileStrategy = irsg::TileStrategy::aligned;
    if (use.mayUseBins && hasBins(scene) && start.render.mode == CalculationMode::spectral)
        start.bins_per_cm = 15;
    if (start.render.mode == CalculationMode::wideband)
        start.render.widebandError = widebandErrors.front();
    if (start.render.background == BackgroundMode::environment)
        start.render.backgroundRows = 1;

    TargetChoice choice;
    std::vector<std::string> lightSentences;
    for (const Skippable& light : boundsOfLight(views, start)) {
        const bool fits = choice.skipped + light.bound <= ofSkipped * target;
        if (fits && light.name == "shadows of the sun" && start.render.sun == ReflectionMode::off)
            continue; // with the sun
        if (fits) {
            light.leaveOut(start.render);
            choice.skipped += light.bound;
        }
        lightSentences.push_back(fmt::format("{} {}: at most {} ({})", fits ? "skipped" : "kept",
                                             light.name, percent(light.bound), light.reason));
    }

    Expected expected;
    // Views that were not looked at may be somewhat worse.
    const double ofOthers = use.cases > views.count() ? 0.85 : 1.0;
    const double allowed = ofOthers * target - choice.skipped;
    const std::vector<CalculationConfiguration> configurations =
        configurationsFrom(start, scene, use);
    // Where none is good enough, no effort that hardly helps.
    const auto least = [&] {
        constexpr double hardly = 1.25;
        double sum = std::numeric_limits<double>::infinity();
        for (const CalculationConfiguration& configuration : configurations)
            sum = std::min(sum, expected.sum(configuration));
        return *std::ranges::find_if(configurations,
                                     [&](const CalculationConfiguration& configuration) {
                                         return expected.sum(configuration) <= hardly * sum;
                                     });
    };
    const auto measure = [&](const CalculationConfiguration& configuration) {
        const std::vector<Reports> numbers = views.measured(configuration, true);
        choice.leastContrasts_W_sr = ProbedViews::leastContrasts_W_sr(numbers);
        expected.learn(configuration, ProbedViews::stated(numbers));
    };
    measure(start);
    for (;;) {
        const auto fit = std::ranges::find_if(configurations,
                                              [&](const CalculationConfiguration& configuration) {
                                                  return expected.sum(configuration) <= allowed;
                                              });
        choice.isMet = fit != configurations.end();
        choice.configuration = choice.isMet ? *fit : least();
        if (expected.measured(choice.configuration))
            break;
        measure(choice.configuration);
    }
    choice.reached = *expected.measured(choice.configuration) + choice.skipped;
    const std::string prefix = "target error " + percent(target) + ": ";
    choice.sentences.push_back(
        prefix + choice.configuration.words(scene) +
        (choice.isMet ? ", the cheapest with errors of at most "
                      : "; no configuration meets it, this one has errors of up to ") +
        percent(choice.reached) + " " + lookedAt(views));
    for (const std::string& sentence : lightSentences)
        choice.sentences.push_back(prefix + sentence);
    return choice;
}

} // namespace smat
