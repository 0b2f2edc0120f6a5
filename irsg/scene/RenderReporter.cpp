#include "irsg/scene/RenderReporter.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/image/ImageIntensity.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/EarthHorizon.h"
#include "irsg/scene/InterReflection.h"

namespace irsg {

namespace {

/// What the air's change over an object's extent may leave wrong without a word.
constexpr double atmosphereErrorToTell = 0.0051;
constexpr const char* publishedTilesInSums =
    "the published zoom (sills) is drawn in pictures alone: intensities, contrast and irradiances "
    "of several objects or bands are those of aligned windows";
constexpr const char* scatteringInSums =
    "scattering: intensities, contrast and irradiances hold the haze that falls into the frame, as "
    "its picture does";

/// What is to be taken off every pixel of an image, so that the sum is that of what objects differ
/// from the background behind them: of a background that varies, its mean over the solid angle.
double meanBackground_W_m2_sr(const Frame& frame, const FrameBackground& background, int width,
                              int height) {
    if (background.isUniform())
        return frame.backgrounds.ofSums.front().centre_W_m2_sr();
    const PixelSolidAngles angles(width, height, degrees(frame.sensor().horizontalFieldOfView_rad));
    double sum_W_m2 = 0.0, solidAngle_sr = 0.0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double angle_sr = angles.at_sr(x, y);
            sum_W_m2 += background.at(x, y) * angle_sr;
            solidAngle_sr += angle_sr;
        }
    return sum_W_m2 / solidAngle_sr;
}

} // namespace

RenderReport RenderReporter::report(const Frame& frame, const FrameReduction& pixels,
                                    const FrameBackground& background) {
    RenderReport report;
    const double range_m = frame.evaluation().geometry.empty()
                               ? 0.0
                               : frame.evaluation().geometry.front().path.range_m;
    report.all = pixels.objects(background, range_m);
    fill(frame, 0, report);
    if (!frame.evaluation().geometry.empty()) {
        report.all.atmosphereError = frame.evaluation().geometry.front().atmosphereError;
        report.all.hiddenByHorizon =
            hiddenByHorizon(frame.scene().entities.front(), frame.evaluation().geometry.front());
        report.objects.assign(1, report.all);
        report.objects.front().name = frame.scene().entities.front().name;
    }
    report.totalIrradiance_W_m2 =
        totalIrradiance_W_m2(frame, background, report.all.irradiance_W_m2);
    return report;
}

std::vector<RenderReport> RenderReporter::reports(const Frame& frame, const ViewGeometry& factors) {
    return clock_.timed("evaluation", [&] {
        // Frames share evaluated scenes, and another may have been begun since.
        EvaluatedScene& evaluated = frame.evaluation().turned(frame.scene().entities);
        const std::vector<double> ranges_m = frame.evaluation().ranges_m();
        std::vector<ObjectSums> sums =
            objectSums(factors, evaluated.radiances, frame.light(), frame.rows(), ranges_m,
                       frame.backgrounds.numbersOfVarying(), frame.request.bySurface);
        frame.evaluation().behind.takeOwn(frame.request, frame.evaluation().geometry,
                                          frame.backgrounds.ofSums, sums);
        ErrorsByOutput errors;
        if (frame.request.withErrors)
            errors = errors_.ofBands(frame, factors, sums);
        return reportsOf(frame, std::move(sums), errors, factors.layersLeftOver);
    });
}

std::vector<RenderReport> RenderReporter::reports(const Frame& frame) {
    return clock_.timed("evaluation", [&] {
        const SceneEvaluation& evaluation = frame.evaluation();
        ObjectSums sums = frame.spectra->at({*evaluation.sampled, evaluation.background(),
                                             evaluation.geometry.front().path.range_m,
                                             frame.sensor().pixelPitch()});
        return reportsOf(frame, {std::move(sums)}, {}, frame.spectra->layersLeftOver());
    });
}

std::vector<RenderReport> RenderReporter::reportsOf(const Frame& frame,
                                                    std::vector<ObjectSums> sums,
                                                    const ErrorsByOutput& errors,
                                                    int layersLeftOver) {
    const std::vector<double> ranges_m = frame.evaluation().ranges_m();
    std::vector<RenderReport> all(sums.size());
    for (std::size_t band = 0; band < sums.size(); ++band) {
        RenderReport& report = all[band];
        report.objects = std::move(sums[band].objects);
        report.all = std::move(sums[band].all);
        report.all.name = "all";
        report.all.range_m = ranges_m.empty() ? 0.0 : ranges_m.front();
        for (std::size_t e = 0; e < report.objects.size(); ++e) {
            report.objects[e].name = frame.scene().entities[e].name;
            report.objects[e].range_m = ranges_m[e];
            report.objects[e].hiddenByHorizon =
                hiddenByHorizon(frame.scene().entities[e], frame.evaluation().geometry[e]);
            report.objects[e].atmosphereError = frame.evaluation().geometry[e].atmosphereError;
            report.all.atmosphereError = std::max(report.all.atmosphereError,
                                                  frame.evaluation().geometry[e].atmosphereError);
        }
        for (std::size_t e = 0; frame.request.withErrors && e < report.objects.size(); ++e)
            report.objects[e].errors = errors[band][e];
        if (frame.request.withErrors)
            report.all.errors = errors[band].back();
        report.layersLeftOver = layersLeftOver;
        for (const AlongRange& one : frame.plan.alongRange)
            report.alongRangeReach_m = std::max(report.alongRangeReach_m, one.reach_m);
        fill(frame, band, report);
        report.totalIrradiance_W_m2 = totalIrradiance_W_m2(frame, frame.backgrounds.byOutput[band],
                                                           report.all.irradiance_W_m2);
    }
    if (frame.settings().usesPublishedTiles())
        for (RenderReport& report : all)
            report.warnings.push_back(publishedTilesInSums);
    return all;
}

double RenderReporter::projectedSolidAngle_sr(const Sensor& sensor) {
    const std::array<double, 3> raster{static_cast<double>(sensor.width_px),
                                       static_cast<double>(sensor.height_px),
                                       sensor.horizontalFieldOfView_rad};
    if (raster != solidAngle_.raster) {
        solidAngle_.raster = raster;
        solidAngle_.projected_sr = PixelGrid(sensor).projectedSolidAngle_sr();
    }
    return solidAngle_.projected_sr;
}

double RenderReporter::totalIrradiance_W_m2(const Frame& frame, const FrameBackground& background,
                                            double contrast_W_m2) {
    const PixelGrid grid(frame.sensor());
    if (background.isUniform())
        return contrast_W_m2 + background.centre_W_m2_sr() * projectedSolidAngle_sr(frame.sensor());
    double behind_W_m2 = 0.0;
    for (int y = 0; y < frame.sensor().height_px; ++y)
        for (int x = 0; x < frame.sensor().width_px; ++x) {
            const PixelGrid::Pixel pixel = grid.at(x, y);
            behind_W_m2 += background.at(x, y) * pixel.solidAngle_sr * pixel.cosOffAxis;
        }
    return contrast_W_m2 + behind_W_m2;
}

void RenderReporter::fill(const Frame& frame, std::size_t output, RenderReport& report) {
    report.background_W_m2_sr = frame.backgrounds.ofSums[output].centre_W_m2_sr();
    report.providedBy = frame.evaluation().sampled->providedBy;
    addProvider(report.providedBy, frame.backgrounds.report.providedBy);
    for (const auto* warnings : {&frame.evaluation().sampled->warnings, &frame.shading().warnings,
                                 &frame.backgrounds.report.warnings})
        report.warnings.insert(report.warnings.end(), warnings->begin(), warnings->end());
    report.flooredPixels = frame.backgrounds.report.flooredPixels;
    if (report.flooredPixels > 0)
        report.warnings.push_back("the background of " + std::to_string(report.flooredPixels) +
                                  " pixels was below 0 and is 0 now");
    if (frame.settings().scattering)
        report.warnings.push_back(scatteringInSums);
    for (std::size_t e = 0; e < frame.evaluation().geometry.size(); ++e)
        if (frame.evaluation().geometry[e].atmosphereError > atmosphereErrorToTell)
            report.warnings.push_back(
                "the air changes over the extent of '" + frame.scene().entities[e].name +
                "': its radiance may be wrong by up to " +
                roundedText(
                    std::round(1000.0 * frame.evaluation().geometry[e].atmosphereError) / 10.0, 9) +
                " %");
    for (std::size_t e = 0; e < frame.evaluation().geometry.size(); ++e)
        if (const HiddenPart hidden = frame.evaluation().geometry[e].hidden;
            hidden != HiddenPart::none)
            report.warnings.push_back("'" + frame.scene().entities[e].name +
                                      (hidden == HiddenPart::all ? "' is behind the horizon"
                                                                 : "' is partly behind the "
                                                                   "horizon"));
    if (frame.exchange())
        warnOfExchange(*frame.exchange(), frame.scene(), report.warnings);
    report.renderer = frame.surfaces.engine.description;
}

void RenderReporter::describe(const Frame& frame, const FrameBackground& background,
                              RadianceImage& image) {
    const Sensor& sensor = frame.sensor();
    const RenderSettings& settings = frame.settings();
    const Band& band = frame.request.bands.front();
    image.attributes["band.name"] = band.name();
    image.attributes["band.min_um"] = roundedText(band.range().min_um, 9);
    image.attributes["band.max_um"] = roundedText(band.range().max_um, 9);
    image.attributes["sensor.horizontal_field_of_view_deg"] =
        roundedText(degrees(sensor.horizontalFieldOfView_rad), 9);
    if (settings.tileSide_samples > 0)
        image.attributes["zoom_window"] = std::to_string(settings.tileSide_samples);
    else
        image.attributes["samples_per_axis"] = std::to_string(settings.samplesPerAxis);
    image.attributes["background_W_m2_sr"] =
        roundedText(meanBackground_W_m2_sr(frame, background, image.width(), image.height()), 9);
    image.attributes["renderer"] = frame.surfaces.engine.description;
    if (!frame.evaluation().geometry.empty())
        image.attributes["range_m"] =
            roundedText(frame.evaluation().geometry.front().path.range_m, 9);
}

} // namespace irsg
