#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/render/background/FieldRays.h"
#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

/// Of the root of the summed squares of all contrasts: two standard deviations of the sum, see
/// docs/errors.md.
constexpr double errorPerContrast = 1.25;
/// The same of objects with directional surfaces. Their lobes are drawn at least as wide as samples
/// lie apart, on all lattices alike, which contrasts do not show, and a few samples have most of a
/// glint; measured, see docs/errors.md.
constexpr double errorPerContrastOfLobes = 2.5;
/// Of the difference to bins that are the next narrower: those have an error, too.
constexpr double ofNarrower = 1.5;
/// Standard deviations that an error is.
constexpr double deviations = 2.0;

/// Squares of contrasts.
struct Squares {
    double intensity = 0.0, contrast = 0.0, irradiance = 0.0;

    void add(const ObjectRadiometry& sums) {
        intensity += sums.intensity_W_sr * sums.intensity_W_sr;
        contrast += sums.contrastIntensity_W_sr * sums.contrastIntensity_W_sr;
        irradiance += sums.irradiance_W_m2 * sums.irradiance_W_m2;
    }
    RadiometryErrors errors(bool haveLobes) const {
        const double scale = haveLobes ? errorPerContrastOfLobes : errorPerContrast;
        RadiometryErrors errors;
        errors.intensity_W_sr.sampling = scale * std::sqrt(intensity);
        errors.contrastIntensity_W_sr.sampling = scale * std::sqrt(contrast);
        errors.irradiance_W_m2.sampling = scale * std::sqrt(irradiance);
        return errors;
    }
};

/// Which entities have directional surfaces, by entity, and whether any has.
std::vector<bool> haveLobes(const SurfaceRows& rows, std::size_t entities) {
    std::vector<bool> have(entities + 1, false);
    for (std::size_t drawn = 0; drawn < rows.keys().size(); ++drawn)
        if (rows.firstLobe(static_cast<int>(drawn)) >= 0)
            have[static_cast<std::size_t>(rows.keys()[drawn].first)] = have.back() = true;
    return have;
}

} // namespace

std::vector<std::vector<RadiometryErrors>>
Renderer::Impl::samplingErrors(const Frame& frame, const ViewFactors& factors,
                               KindRadiances& radiances, SceneLight* light, const SurfaceRows& rows,
                               const std::vector<int>& varying) {
    const std::vector<double> ranges_m = frame.ranges_m();
    std::vector<std::vector<Squares>> squares(varying.size(),
                                              std::vector<Squares>(frame.geometry.size() + 1));
    for (const std::vector<ObjectSums>& sums :
         contrastSums(factors, radiances, light, rows, ranges_m, varying)) {
        for (std::size_t output = 0; output < sums.size(); ++output) {
            for (std::size_t e = 0; e < ranges_m.size(); ++e)
                squares[output][e].add(sums[output].objects[e]);
            squares[output].back().add(sums[output].all);
        }
    }
    const std::vector<bool> lobes = haveLobes(rows, ranges_m.size());
    std::vector<std::vector<RadiometryErrors>> errors(varying.size());
    for (std::size_t output = 0; output < errors.size(); ++output)
        for (std::size_t e = 0; e < squares[output].size(); ++e)
            errors[output].push_back(squares[output][e].errors(lobes[e]));
    return errors;
}

void Renderer::Impl::addSamplingErrors(const Frame& frame, const ViewFactors& factors,
                                       const std::vector<int>& varying,
                                       std::vector<RenderReport>& reports) {
    const auto errors = samplingErrors(frame, factors, frame.evaluated->radiances,
                                       frame.light.get(), frame.surfaceRows(), varying);
    for (std::size_t output = 0; output < reports.size(); ++output) {
        for (std::size_t e = 0; e < frame.geometry.size(); ++e)
            reports[output].objects[e].errors = errors[output][e];
        reports[output].all.errors = errors[output].back();
    }
}

std::vector<ObjectSums> Renderer::Impl::sumsElsewhere(const Frame& frame,
                                                      const ViewFactors& factors,
                                                      const std::vector<ObjectGeometry>& geometry) {
    const RenderSettings& settings = frame.scene.settings;
    const AirScene scene{terms, frame.scene.entities, geometry, settings, frame.centre};
    const auto sampled =
        otherAir.sampled.of(otherAir.answers, scene, frame.bands, frame.withSources,
                            sampler(frame, otherAir.answers), frame.sampled->slices_m);
    const auto evaluated =
        otherAir.radiometry.of(terms, frame.scene.entities, geometry, sampled, fronts);
    evaluated->radiances.setBackground(sampled->background);
    // Backgrounds as in the middle of the field, and no light between surfaces.
    const std::vector<int> uniform(evaluated->radiances.outputs(), -1);
    return objectSums(factors, evaluated->radiances, nullptr, frame.surfaceRows(), frame.ranges_m(),
                      uniform);
}

std::optional<std::vector<ObjectGeometry>> Renderer::Impl::seenPlaces(const Frame& frame) {
    // What is seen of an object lies before its reference point.
    constexpr double before = 0.6; // of how far it reaches
    std::vector<ObjectGeometry> nearer = frame.geometry;
    bool isMoved = false;
    for (ObjectGeometry& object : nearer)
        if (object.slices_m.size() < 2 && object.likelyAirError > 0.0) {
            object.path.range_m = std::max(
                object.path.range_m - before * 0.5 * (object.farthest_m - object.nearest_m), 0.0);
            isMoved = true;
        }
    if (!isMoved)
        return std::nullopt;
    return nearer;
}

void Renderer::Impl::addAirErrors(const Frame& frame, const ViewFactors& factors,
                                  std::vector<RenderReport>& reports) {
    const bool isWideband = frame.scene.settings.mode == CalculationMode::wideband;
    const Environment& own = frame.scene.environment;
    const Environment& other = isWideband ? own : otherAir.of(own, frame.bands.front());
    const bool hasBins = !isWideband && !AirIdentity(other).isOf(own);
    const std::size_t entities = frame.geometry.size();

    // As parts of the intensity: its error, and that of the contrast.
    struct AirParts {
        double intensity = 0.0, contrast = 0.0;
        void add(double ofIntensity, double ofContrast) {
            intensity = std::hypot(intensity, ofIntensity);
            contrast = std::hypot(contrast, ofContrast);
        }
    };
    std::vector<std::vector<AirParts>> parts(reports.size(), std::vector<AirParts>(entities));
    const auto addDifference = [&](const std::vector<ObjectSums>& a,
                                   const std::vector<ObjectSums>& b, double times = 1.0) {
        for (std::size_t o = 0; o < parts.size(); ++o)
            for (std::size_t e = 0; e < entities; ++e) {
                const ObjectRadiometry &one = a[o].objects[e], &two = b[o].objects[e];
                if (two.intensity_W_sr > 0.0)
                    parts[o][e].add(
                        times * (one.intensity_W_sr - two.intensity_W_sr) / two.intensity_W_sr,
                        times * (one.contrastIntensity_W_sr - two.contrastIntensity_W_sr) /
                            two.intensity_W_sr);
            }
    };
    const auto addLikely = [&](bool ofSliced) {
        for (std::size_t o = 0; o < parts.size(); ++o)
            for (std::size_t e = 0; e < entities; ++e) {
                const ObjectGeometry& object = frame.geometry[e];
                if ((object.slices_m.size() > 1) == ofSliced &&
                    !frame.sampled->ofOutput(o).isSource)
                    parts[o][e].add(object.likelyAirError, object.likelyAirError);
            }
    };
    addLikely(true); // slices are thin, and radiance nearly linear over each

    const std::optional<std::vector<ObjectGeometry>> nearer = seenPlaces(frame);
    if (hasBins || nearer) {
        const std::vector<ObjectSums> there = sumsElsewhere(frame, factors, frame.geometry);
        if (hasBins) {
            const std::vector<int> uniform(reports.size(), -1);
            const auto nodes = own.nodesOf(frame.bands.front());
            const auto others = other.nodesOf(frame.bands.front());
            const bool isNarrower = nodes && others && others->size() > nodes->size();
            addDifference(objectSums(factors, frame.evaluated->radiances, nullptr,
                                     frame.surfaceRows(), frame.ranges_m(), uniform),
                          there, isNarrower ? ofNarrower : 1.0);
        }
        try {
            if (nearer)
                addDifference(sumsElsewhere(frame, factors, *nearer), there);
        } catch (const InputError&) {
            addLikely(false); // some air answers for the path to the reference point alone
        }
    }
    for (std::size_t o = 0; isWideband && o < reports.size(); ++o)
        if (const auto* points = SensorCkData::of(*frame.sampled->ofOutput(o).sampling))
            for (AirParts& one : parts[o])
                one.add(deviations * points->heldOutRms(), deviations * points->heldOutRms());

    for (std::size_t o = 0; o < reports.size(); ++o) {
        RadiometryErrors& all = *reports[o].all.errors;
        for (std::size_t e = 0; e < entities; ++e) {
            ObjectRadiometry& object = reports[o].objects[e];
            const double intensity_W_sr = std::abs(object.intensity_W_sr);
            const double range_m = frame.geometry[e].path.range_m;
            object.errors->intensity_W_sr.air = intensity_W_sr * parts[o][e].intensity;
            object.errors->contrastIntensity_W_sr.air = intensity_W_sr * parts[o][e].contrast;
            object.errors->irradiance_W_m2.air =
                object.errors->contrastIntensity_W_sr.air / (range_m * range_m);
            // The air before all of them is one.
            all.intensity_W_sr.air += object.errors->intensity_W_sr.air;
            all.contrastIntensity_W_sr.air += object.errors->contrastIntensity_W_sr.air;
            all.irradiance_W_m2.air += object.errors->irradiance_W_m2.air;
        }
    }
}

std::vector<double>
Renderer::Impl::backgroundErrors(const Frame& frame, std::size_t entity, const SeenAlong& seenAlong,
                                 const std::function<double(double x, double y)>& grid) {
    std::optional<ImageRectangle> extent;
    for (const auto* objects : {&frame.seen, &frame.alongRange})
        for (const ZoomEntityInfo& object : *objects)
            if (object.entity == static_cast<int>(entity))
                extent = object.extent;
    const std::vector<double> centre = seenAlong(frame.centre);
    std::vector<double> mean(centre.size(), 0.0), least, most;
    if (!extent)
        return mean;

    // Down through the middle of the object: its mean as over a disc.
    constexpr std::array heights = {-0.7071, 0.0, 0.7071}; // of half the extent
    constexpr std::array weights = {0.25, 0.5, 0.25};
    const FieldRays rays(frame.view.sensor, frame.view.viewpoint);
    const double middle = 0.5 * (extent->left + extent->right);
    // By steps of a small part of what the object takes up, so that cases share lines of sight; of
    // a grid, whose errors are smaller than a step makes, where they are.
    constexpr double stepsOfExtent = 16.0;
    const double extent_rad =
        std::abs(elevationOf_rad(rays.at(rays.u(middle), rays.v(extent->top))) -
                 elevationOf_rad(rays.at(rays.u(middle), rays.v(extent->bottom))));
    const double step_rad = std::exp2(std::floor(
        std::log2(std::max(extent_rad / stepsOfExtent, std::numeric_limits<double>::min()))));
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double y = 0.5 * (extent->top + extent->bottom + heights[i] * extent->height());
        const Vec3 direction = rays.at(rays.u(middle), rays.v(y));
        const double used = grid ? grid(middle, y) : 1.0;
        const double exact_rad = elevationOf_rad(direction);
        const double elevation_rad = grid ? exact_rad : step_rad * std::round(exact_rad / step_rad);
        std::vector<double> difference =
            seenAlong({frame.centre.sensorAltitude_m, elevation_rad, azimuthOf_rad(direction)});
        for (std::size_t k = 0; k < difference.size(); ++k) {
            difference[k] -= used * centre[k];
            mean[k] += weights[i] * difference[k];
            if (i > 0) {
                least[k] = std::min(least[k], difference[k]);
                most[k] = std::max(most[k], difference[k]);
            }
        }
        if (i == 0)
            least = most = difference;
    }
    // Objects are no discs: more of one may be seen before the brighter part.
    constexpr double ofShape = 0.12;
    for (std::size_t k = 0; k < mean.size(); ++k)
        mean[k] = std::abs(mean[k]) + ofShape * (most[k] - least[k]);
    return mean;
}

double Renderer::Impl::backgroundError_W_m2_sr(const Frame& frame, std::size_t entity,
                                               std::size_t band) {
    const Environment& environment = otherAir.answers.environment();
    const auto sampling = otherAirNodes(frame, frame.bands[band]);
    const auto seenAlong = [&](const LineOfSight& sight) {
        return std::vector<double>{sampling->integrate(
            *otherAir.answers
                 .at(AtmosphericQuery::backgroundRadiance(steadied(sight), environment.sun),
                     sampling)
                 .value)};
    };
    // What is used there, in the bins of what it is compared with.
    const Sensor& sensor = frame.view.sensor;
    const double own = frame.evaluated->radiances.background_W_m2_sr(band);
    const auto pixel = [](double place, int size) {
        return static_cast<int>(std::clamp(place, 0.0, size - 1.0));
    };
    std::function<double(double, double)> grid;
    if (frame.scene.settings.backgroundRows * frame.scene.settings.backgroundColumns != 1)
        grid = [&](double x, double y) {
            return own > 0.0 ? frame.backgrounds[band].at(pixel(x, sensor.width_px),
                                                          pixel(y, sensor.height_px)) /
                                   own
                             : 1.0;
        };
    return backgroundErrors(frame, entity, seenAlong, grid).front();
}

bool Renderer::Impl::knowsBackgroundError(const Frame& frame) const {
    const RenderSettings& settings = frame.scene.settings;
    const bool isGrid = settings.backgroundRows * settings.backgroundColumns != 1;
    // Of a grid below pictures it is not known apart.
    return settings.background == BackgroundMode::environment &&
           !(isGrid && (frame.scene.skybox || frame.scene.terrain));
}

std::shared_ptr<const SpectralSampling> Renderer::Impl::otherAirNodes(const Frame& frame,
                                                                      const Band& band) {
    std::shared_ptr<const SpectralSampling> nodes;
    if (frame.scene.settings.mode == CalculationMode::spectral)
        nodes = sampling.nodes(otherAir.answers.environment(), band);
    for (std::size_t k = 0; !nodes && k < frame.bands.size(); ++k)
        if (frame.bands[k] == band)
            return samplingOf(frame, k);
    return nodes;
}

void Renderer::Impl::addBackgroundErrors(const Frame& frame, std::vector<RenderReport>& reports) {
    if (!knowsBackgroundError(frame))
        return;
    for (std::size_t o = 0; o < frame.bands.size(); ++o) {
        RadiometryErrors& all = *reports[o].all.errors;
        for (std::size_t e = 0; e < frame.geometry.size(); ++e) {
            ObjectRadiometry& object = reports[o].objects[e];
            const double range_m = frame.geometry[e].path.range_m;
            const double error_W_m2 = backgroundError_W_m2_sr(frame, e, o) * object.solidAngle_sr;
            object.errors->irradiance_W_m2.background = error_W_m2;
            object.errors->contrastIntensity_W_sr.background = error_W_m2 * range_m * range_m;
            all.irradiance_W_m2.background += error_W_m2;
            all.contrastIntensity_W_sr.background += error_W_m2 * range_m * range_m;
        }
    }
}

void Renderer::Impl::addErrors(const Frame& frame, const ViewFactors& factors,
                               const std::vector<int>& varying,
                               std::vector<RenderReport>& reports) {
    addSamplingErrors(frame, factors, varying, reports);
    const Environment& own = frame.scene.environment;
    otherAir.answers.setEnvironment(frame.scene.settings.mode == CalculationMode::wideband
                                        ? otherAir.like(own)
                                        : otherAir.of(own, frame.bands.front()));
    addAirErrors(frame, factors, reports);
    addBackgroundErrors(frame, reports);
}

} // namespace irsg
