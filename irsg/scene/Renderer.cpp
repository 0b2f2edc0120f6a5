#include "irsg/scene/Renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiance/SceneScaledView.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

/// What the air's change over an object's extent may leave wrong without a word.
constexpr double airErrorToTell = 0.0051;
constexpr const char* sillsInSums =
    "the published zoom (sills) is drawn in pictures alone: intensities, contrast and irradiances "
    "of several objects or bands are those of aligned windows";
constexpr const char* scatteringInSums =
    "scattering: images show the haze; intensities, contrast and irradiances of objects are those "
    "of their direct light";

void requireNoScales(const std::vector<Entity>& entities) {
    for (const Entity& entity : entities)
        if (!entity.temperatureScale.empty() || !entity.emissivityScale.empty())
            throw LogicError("a view as a function of scales was asked of a scaled scene");
}

ScaledValues valuesOf(const ObjectRadiometry& sum) {
    return {{sum.intensity_W_sr}, {sum.contrastIntensity_W_sr}, {sum.irradiance_W_m2}};
}

} // namespace

Renderer::Renderer() : Renderer(RadianceTerms::standard()) {}
Renderer::Renderer(const RadianceTerms& terms) : impl_(std::make_unique<Impl>(terms)) {
    if (terms.factorCount() == 0 || terms.factorCount() > mostFactors)
        throw LogicError("a list of terms has 1 to 7 drawn factors");
}
Renderer::~Renderer() {
    impl_->view.reset();
}

Rendered Renderer::render(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    Impl& p = *impl_;
    if (!outputs.scalings().empty())
        requireNoScales(scene.entities);
    Rendered result;
    const bool inBands = outputs.hasImage() || outputs.hasReports() ||
                         (!outputs.scalings().empty() && outputs.wavenumbers_per_cm().empty());
    if (inBands) {
        const Impl::Frame frame = p.frame(scene, view, outputs);
        if (outputs.hasImage())
            p.renderImage(frame, outputs, result);
        else if (outputs.hasReports())
            result.reports = p.reports(frame);
        if (!outputs.scalings().empty() && outputs.wavenumbers_per_cm().empty()) {
            const ViewFactors& factors = p.factorsOf(frame);
            const std::vector<RenderReport> nominal = p.reports(frame);
            p.timed("scaled view", [&] {
                const SceneRadiometry& radiometry = frame.evaluated->radiometry;
                const auto add = [&](std::size_t band, const ObjectRadiometry& sum,
                                     std::optional<int> only) {
                    result.scaled.push_back(std::make_unique<const SceneScaledView>(
                        factors, radiometry, frame.evaluated->radiances, frame.light.get(),
                        frame.evaluated->planck, frame.ranges_m(), radiometry.outputs()[band],
                        outputs.scalings(), false, valuesOf(sum), only));
                };
                for (std::size_t k = 0; k < frame.bands.size(); ++k) {
                    add(k, nominal[k].all, {});
                    for (std::size_t i = 0; outputs.isByObject() && i < scene.entities.size(); ++i)
                        add(k, nominal[k].objects[i], static_cast<int>(i));
                }
            });
        }
    }
    if (!outputs.wavenumbers_per_cm().empty()) {
        Scene spectral = scene;
        spectral.settings.mode = CalculationMode::spectral;
        const Impl::Frame frame = p.frame(spectral, view, outputs);
        result.spectrum = p.spectrum(frame, outputs, result);
        if (scene.settings.mode == CalculationMode::wideband)
            result.spectrum.warnings.push_back(
                "spectra are computed in the spectral mode: a quadrature point of wideband-ck "
                "stands for the band, "
                "not for its wavelength");
    }
    return result;
}

PendingRender Renderer::begin(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    if (outputs.hasImage() || !outputs.hasReports()) {
        auto made = std::make_shared<Rendered>(render(scene, view, outputs));
        return PendingRender([made] { return std::move(*made); });
    }
    auto begun = std::make_shared<Begun>(*impl_, scene, view, outputs);
    begun->drawing = impl_->beginFactors(begun->frame);
    return PendingRender(
        [this, begun] {
            Rendered made;
            made.reports =
                impl_->reports(begun->frame, impl_->factorsOf(begun->frame, *begun->drawing));
            return made;
        },
        mostThreads() > 1);
}

void Renderer::Impl::renderImage(const Frame& frame, const Outputs& outputs, Rendered& result) {
    RenderReport drawn;
    const FrameReduction reduction =
        outputs.isFollowed()
            ? followedPixels(frame, drawn.windows, drawn.warnings, drawn.layersLeftOver)
            : drawObjects(frame, drawn.windows, drawn.warnings, drawn.layersLeftOver);
    timed("composition", [&] {
        result.image = reduction.compose(frame.backgrounds.front());
        describe(frame, result.image);
        describeWindows(drawn.windows, result.image);
    });
    if (frame.scene.settings.scattering)
        scatter(frame, result.image, drawn.warnings);
    if (!outputs.hasReports()) {
        result.reports = {std::move(drawn)};
    } else {
        // Sums are those of a sweep. Where it samples as the picture does, they are the picture's.
        const bool isPictures = frame.scene.entities.size() <= 1 && frame.bands.size() == 1 &&
                                sumsSampleAsPictures(frame);
        result.reports = isPictures ? std::vector{reportOf(frame, reduction)} : reports(frame);
        if (isPictures && frame.withErrors) {
            // Lattices are told apart in sums alone.
            RenderReport sums = std::move(reports(frame).front());
            RenderReport& own = result.reports.front();
            own.all.errors = sums.all.errors;
            for (std::size_t e = 0; e < own.objects.size(); ++e)
                own.objects[e].errors = sums.objects[e].errors;
        }
        RenderReport& first = result.reports.front();
        first.windows = std::move(drawn.windows);
        for (std::string& warning : drawn.warnings)
            first.warnings.push_back(std::move(warning));
        first.layersLeftOver = drawn.layersLeftOver;
    }
    if (frame.scene.settings.truthLayers)
        addTruthLayers(frame, result.image);
}

RenderReport Renderer::Impl::reportOf(const Frame& frame, const FrameReduction& pixels) {
    RenderReport report;
    const double range_m = frame.geometry.empty() ? 0.0 : frame.geometry.front().path.range_m;
    report.all = pixels.objects(frame.backgrounds.front(), range_m);
    fillReport(frame, 0, report);
    if (!frame.geometry.empty()) {
        report.all.airError = frame.geometry.front().airError;
        report.objects.assign(1, report.all);
        report.objects.front().name = frame.scene.entities.front().name;
    }
    report.totalIrradiance_W_m2 = totalIrradiance_W_m2(frame, 0, report.all.irradiance_W_m2);
    return report;
}

std::vector<RenderReport> Renderer::Impl::reports(const Frame& frame, const ViewFactors& factors) {
    return timed("evaluation", [&] {
        // Frames share evaluated scenes, and another may have been begun since.
        frame.evaluated->turnTo(frame.scene.entities, frame.geometry);
        frame.evaluated->radiances.setBackground(frame.background);
        std::vector<int> varying;
        int number = 0;
        for (const FrameBackground& background : frame.backgrounds)
            varying.push_back(background.isUniform() ? -1 : number++);
        const std::vector<double> ranges_m = frame.ranges_m();
        std::vector<ObjectSums> sums =
            objectSums(factors, frame.evaluated->radiances, frame.light.get(), frame.surfaceRows(),
                       ranges_m, varying);
        std::vector<RenderReport> all(sums.size());
        for (std::size_t band = 0; band < sums.size(); ++band) {
            RenderReport& report = all[band];
            report.objects = std::move(sums[band].objects);
            report.all = std::move(sums[band].all);
            report.all.name = "all";
            report.all.range_m = ranges_m.empty() ? 0.0 : ranges_m.front();
            for (std::size_t e = 0; e < report.objects.size(); ++e) {
                report.objects[e].name = frame.scene.entities[e].name;
                report.objects[e].range_m = ranges_m[e];
                report.objects[e].airError = frame.geometry[e].airError;
                report.all.airError = std::max(report.all.airError, frame.geometry[e].airError);
            }
            report.layersLeftOver = factors.layersLeftOver;
            fillReport(frame, band, report);
            report.totalIrradiance_W_m2 =
                totalIrradiance_W_m2(frame, band, report.all.irradiance_W_m2);
        }
        if (frame.scene.settings.zoomsAsPublished())
            for (RenderReport& report : all)
                report.warnings.push_back(sillsInSums);
        if (frame.withErrors)
            addErrors(frame, factors, varying, all);
        return all;
    });
}

double Renderer::Impl::frameProjectedSolidAngle_sr(const Sensor& sensor) {
    const std::array<double, 3> raster{static_cast<double>(sensor.width_px),
                                       static_cast<double>(sensor.height_px),
                                       sensor.horizontalFieldOfView_rad};
    if (raster != solidAngle.raster) {
        solidAngle.raster = raster;
        solidAngle.projected_sr = PixelGrid(sensor).projectedSolidAngle_sr();
    }
    return solidAngle.projected_sr;
}

double Renderer::Impl::totalIrradiance_W_m2(const Frame& frame, std::size_t band,
                                            double contrast_W_m2) {
    const PixelGrid grid(frame.view.sensor);
    const FrameBackground& background = frame.backgrounds[band];
    if (background.isUniform())
        return contrast_W_m2 +
               background.centre_W_m2_sr() * frameProjectedSolidAngle_sr(frame.view.sensor);
    double behind_W_m2 = 0.0;
    for (int y = 0; y < frame.view.sensor.height_px; ++y)
        for (int x = 0; x < frame.view.sensor.width_px; ++x) {
            const PixelGrid::Pixel pixel = grid.at(x, y);
            behind_W_m2 += background.at(x, y) * pixel.solidAngle_sr * pixel.cosOffAxis;
        }
    return contrast_W_m2 + behind_W_m2;
}

void Renderer::Impl::fillReport(const Frame& frame, std::size_t band, RenderReport& report) const {
    report.background_W_m2_sr = frame.backgrounds[band].centre_W_m2_sr();
    report.answeredBy = frame.answeredBy;
    addAnswer(report.answeredBy, frame.backgroundReport.answeredBy);
    std::ranges::copy(frame.warnings, std::back_inserter(report.warnings));
    std::ranges::copy(frame.backgroundReport.warnings, std::back_inserter(report.warnings));
    report.flooredPixels = frame.backgroundReport.flooredPixels;
    if (report.flooredPixels > 0)
        report.warnings.push_back("the background of " + std::to_string(report.flooredPixels) +
                                  " pixels was below 0 and is 0 now");
    if (frame.scene.settings.scattering)
        report.warnings.push_back(scatteringInSums);
    for (std::size_t e = 0; e < frame.geometry.size(); ++e)
        if (frame.geometry[e].airError > airErrorToTell)
            report.warnings.push_back(
                "the air changes over the extent of '" + frame.scene.entities[e].name +
                "': its radiance may be wrong by up to " +
                roundedText(std::round(1000.0 * frame.geometry[e].airError) / 10.0, 9) + " %");
    if (frame.exchange)
        warnOfLight(*frame.exchange, frame.scene, report.warnings);
    report.renderer = frame.renderer;
}

void Renderer::Impl::describe(const Frame& frame, RadianceImage& image) const {
    const Sensor& sensor = frame.view.sensor;
    const RenderSettings& settings = frame.scene.settings;
    const Band& band = frame.bands.front();
    image.attributes["band.name"] = band.name();
    image.attributes["band.min_um"] = roundedText(band.range().min_um, 9);
    image.attributes["band.max_um"] = roundedText(band.range().max_um, 9);
    image.attributes["sensor.horizontal_field_of_view_deg"] =
        roundedText(degrees(sensor.horizontalFieldOfView_rad), 9);
    if (settings.zoomWindow > 0)
        image.attributes["zoom_window"] = std::to_string(settings.zoomWindow);
    else
        image.attributes["samples_per_axis"] = std::to_string(settings.samplesPerAxis);
    image.attributes["background_W_m2_sr"] =
        roundedText(frame.backgrounds.front().centre_W_m2_sr(), 9);
    image.attributes["renderer"] = frame.renderer;
    if (!frame.geometry.empty())
        image.attributes["range_m"] = roundedText(frame.geometry.front().path.range_m, 9);
}

void Renderer::check(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    checkScene(scene.entities, impl_->geometry(scene, view), scene.environment, view.sensor,
               outputs.bands().empty() ? std::vector<Band>{view.sensor.band} : outputs.bands(),
               scene.settings);
}

Vec3 Renderer::referencePoint(const Entity& entity) {
    return impl_->prepared.referencePoint(entity);
}
std::string Renderer::rendererDescription(const Scene& scene) {
    impl_->prepared.keep(scene.entities);
    if (scene.settings.engine == EngineChoice::automatic && !impl_->lastChosen.empty())
        return impl_->lastChosen;
    return impl_->descriptionOf(impl_->chosenEngine(scene, nullptr));
}
std::size_t Renderer::graphicsMemory_bytes() const {
    return impl_->opengl ? impl_->opengl->bytes() : 0;
}
StageTimes Renderer::stageTimes() const {
    return {impl_->stages};
}

} // namespace irsg
