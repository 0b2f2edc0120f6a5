#include "smatcore/analysis/CalculationConfigurations.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace smat {

namespace {

/// A difference as a part of a number; all of it where there is no number.
double partOf(double difference, double number) {
    if (difference == 0.0)
        return 0.0;
    return number == 0.0 ? 1.0 : std::abs(difference / number);
}

} // namespace

SceneDescription CalculationConfiguration::applied(const SceneDescription& scene) const {
    SceneDescription made = scene;
    made.settings = render;
    if (bins_per_cm > 0)
        made.environment = irsg::withBins(scene.environment, bins_per_cm);
    return made;
}

std::string CalculationConfiguration::words(const SceneDescription& scene) const {
    std::string text = render.tileSide_samples > 0
                           ? fmt::format("windows of {} samples a side", render.tileSide_samples)
                           : fmt::format("{} samples per axis of a pixel", render.samplesPerAxis);
    if (render.mode == irsg::CalculationMode::wideband)
        text += fmt::format(", wideband-ck trained to {} %",
                            irsg::roundedText(100.0 * render.widebandError, 2));
    else if (bins_per_cm > 0 && hasBins(scene))
        text += fmt::format(", spectral in bins of {} cm-1", bins_per_cm);
    if (render.background == irsg::BackgroundMode::environment)
        text += render.backgroundRows == 0
                    ? std::string(", background of automatic rows")
                    : fmt::format(", background of {} row{}", render.backgroundRows,
                                  render.backgroundRows == 1 ? "" : "s");
    return text;
}

double modelledCost_s(double samples, const CalculationConfiguration& configuration,
                      const SceneDescription& scene, double linesPerCase) {
    const double drawing_s = 2e-3 + 6e-8 * samples;
    double lines = 1.0;
    if (scene.settings.background == irsg::BackgroundMode::environment)
        lines +=
            0.3 *
            (configuration.render.backgroundRows == 0 ? 4 : configuration.render.backgroundRows);
    // Quadrature points by the error that they are trained to: about 20, 45 and 80 for 1, 0.3 and
    // 0.1 %.
    const double ofBins = configuration.render.mode == irsg::CalculationMode::wideband
                              ? 3e-3 * std::pow(0.003 / configuration.render.widebandError, 0.6)
                          : configuration.bins_per_cm == 0 ? 8e-3
                                                           : 8e-3 * 5.0 / configuration.bins_per_cm;
    return drawing_s + ofBins * lines * linesPerCase;
}

bool hasBins(const SceneDescription& scene) {
    const std::vector<irsg::Band> bands = scene.allBands();
    const irsg::Environment narrow = irsg::withBins(scene.environment, 1),
                            wide = irsg::withBins(scene.environment, 15);
    return std::ranges::all_of(bands, [&](const irsg::Band& band) {
        const auto one = narrow.nodesOf(band), other = wide.nodesOf(band);
        return one && other && one->size() != other->size();
    });
}

ProbedViews::ProbedViews(RenderDoor door, const SceneDescription& scene, std::size_t views,
                         bool alongRange, Place place)
    : door_(std::move(door)),
      scene_(scene),
      views_(views),
      alongRange_(alongRange),
      place_(std::move(place)) {}

std::vector<ProbedViews::Reports>
ProbedViews::measured(const CalculationConfiguration& configuration, bool errors) {
    return measured(std::vector<CalculationConfiguration>{configuration}, errors).front();
}

std::vector<std::vector<ProbedViews::Reports>>
ProbedViews::measured(const std::vector<CalculationConfiguration>& configurations, bool errors) {
    std::vector<std::vector<Reports>> all(configurations.size());
    const irsg::Outputs outputs =
        irsg::Outputs::reports(scene_.allBands()).alongRange(alongRange_).withErrors(errors);
    std::vector<SceneDescription> scenes;
    for (const CalculationConfiguration& configuration : configurations)
        scenes.push_back(configuration.applied(scene_));
    for (std::size_t view = 0; view < views_; ++view)
        for (std::size_t i = 0; i < configurations.size(); ++i)
            all[i].push_back(place_(scenes[i], view).render(door_, outputs).reports);
    return all;
}

std::vector<double> ProbedViews::leastContrasts_W_sr(const std::vector<Reports>& numbers) {
    constexpr double ofLargest = 0.1;
    std::vector<double> least(numbers.front().size(), 0.0);
    for (const Reports& view : numbers)
        for (std::size_t band = 0; band < view.size(); ++band)
            least[band] =
                std::max(least[band], ofLargest * std::abs(view[band].all.contrastIntensity_W_sr));
    return least;
}

double ProbedViews::difference(const std::vector<Reports>& one, const std::vector<Reports>& other,
                               const std::vector<Reports>& of) {
    const std::vector<double> least = leastContrasts_W_sr(of);
    double largest = 0.0;
    for (std::size_t view = 0; view < of.size(); ++view)
        for (std::size_t band = 0; band < of[view].size(); ++band) {
            const irsg::ObjectRadiometry &a = one[view][band].all, &b = other[view][band].all,
                                         &whole = of[view][band].all;
            largest = std::max(
                {largest, partOf(a.intensity_W_sr - b.intensity_W_sr, whole.intensity_W_sr),
                 partOf(a.contrastIntensity_W_sr - b.contrastIntensity_W_sr,
                        std::max(std::abs(whole.contrastIntensity_W_sr), least[band]))});
        }
    return largest;
}

StatedErrors ProbedViews::stated(const Reports& numbers,
                                 const std::vector<double>& leastContrasts) {
    StatedErrors largest;
    for (std::size_t band = 0; band < numbers.size(); ++band) {
        const irsg::ObjectRadiometry& all = numbers[band].all;
        if (!all.errors)
            throw irsg::LogicError("a source that does not know its errors has no target of them");
        const auto take = [&](const irsg::ErrorParts& error, double number) {
            largest.sampling = std::max(largest.sampling, partOf(error.sampling, number));
            largest.air = std::max(largest.air, partOf(error.air, number));
            largest.background = std::max(largest.background, partOf(error.background, number));
            // What inter-reflection is off by, no choice of samples, air or background changes.
            largest.sum = std::max(largest.sum, partOf(error.withoutExchange(), number));
        };
        take(all.errors->intensity_W_sr, all.intensity_W_sr);
        take(all.errors->contrastIntensity_W_sr,
             std::max(std::abs(all.contrastIntensity_W_sr), leastContrasts.at(band)));
    }
    return largest;
}

StatedErrors ProbedViews::stated(const std::vector<Reports>& numbers) {
    const std::vector<double> least = leastContrasts_W_sr(numbers);
    StatedErrors largest;
    for (const Reports& view : numbers) {
        const StatedErrors own = stated(view, least);
        largest.sampling = std::max(largest.sampling, own.sampling);
        largest.air = std::max(largest.air, own.air);
        largest.background = std::max(largest.background, own.background);
        largest.sum = std::max(largest.sum, own.sum);
    }
    return largest;
}

} // namespace smat
