#include "irsg/scene/RenderErrorEstimator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/radiance/SublatticeDifferences.h"
#include "irsg/render/rays/ExchangeMesh.h"

namespace irsg {

namespace {

/// Of the root of the energy of all differences (energyOf): two standard deviations of the sum,
/// see docs/errors.md.
constexpr double errorPerDifference = 1.25;
/// Squares of differences over rows and columns at once in terms of those over rows, or over
/// columns, of outlines in all directions: sums of k^-3 over the frequencies that each meets.
constexpr double squareOfBoth = 0.707;
/// What counts of the squares by which one kind of difference exceeds the others. Edges along rows
/// or columns make it large, which rows that are sheared and tilted take out of the sum, but not
/// out of a lattice of half their frequency: twice to four times what simulated edges have.
constexpr double ofAligned = 0.25;
/// The same of what directional surfaces send beside Lambertian ones. Their lobes are drawn at
/// least as wide as samples lie apart, on all lattices alike, which contrasts do not show, and a
/// few samples have most of a glint; measured, see docs/errors.md.
constexpr double errorPerDifferenceOfLobes = 2.5;
/// Of the difference to bins that are the next narrower: those have an error, too.
constexpr double ofNarrower = 1.5;
/// Of what inter-reflection changes, at the usual RenderSettings::lightError: two standard
/// deviations on models of others, see docs/errors.md.
constexpr double ofExchange = 0.08;
/// Standard deviations that an error is.
constexpr double deviations = 2.0;

/// Squares of the differences of a view by their kind, and of what a range curve leaves wrong.
struct Squares {
    std::array<double, sublatticeDifferenceKinds + 1> byKind{};

    void add(std::size_t difference, std::size_t count, double sum) {
        const bool isOfRange = difference + 1 == count;
        byKind[isOfRange ? sublatticeDifferenceKinds : difference % sublatticeDifferenceKinds] +=
            sum * sum;
    }
    /// As if outlines went in all directions, all kinds have the middle one of the three, and a
    /// part of what the largest has beyond that.
    double energy() const {
        std::array<double, sublatticeDifferenceKinds> kinds{};
        std::copy_n(byKind.begin(), kinds.size(), kinds.begin());
        kinds[static_cast<std::size_t>(SublatticeDifference::both)] /= squareOfBoth;
        std::ranges::sort(kinds);
        return (2.0 + squareOfBoth) * kinds[1] + ofAligned * (kinds[2] - kinds[1]) +
               byKind[sublatticeDifferenceKinds];
    }
};

struct SquaresOfSums {
    Squares intensity, contrast, irradiance;

    /// One of `count` differences of a view.
    void add(std::size_t difference, std::size_t count, const ObjectRadiometry& sums) {
        intensity.add(difference, count, sums.intensity_W_sr);
        contrast.add(difference, count, sums.contrastIntensity_W_sr);
        irradiance.add(difference, count, sums.irradiance_W_m2);
    }
};

/// Of what is in all rows and of what is in those of lobes, which is in both.
RadiometryErrors errorsOf(const SquaresOfSums& all, const SquaresOfSums& lobes) {
    const auto of = [](const Squares& every, const Squares& directional) {
        constexpr double plain = errorPerDifference * errorPerDifference,
                         more = errorPerDifferenceOfLobes * errorPerDifferenceOfLobes - plain;
        return std::sqrt(plain * every.energy() + more * directional.energy());
    };
    RadiometryErrors errors;
    errors.intensity_W_sr.sampling = of(all.intensity, lobes.intensity);
    errors.contrastIntensity_W_sr.sampling = of(all.contrast, lobes.contrast);
    errors.irradiance_W_m2.sampling = of(all.irradiance, lobes.irradiance);
    return errors;
}

/// Of samples alone, in the outputs of an evaluation. `varying`: see objectSums.
ErrorsByOutput ofSamples(const Frame& frame, const ViewGeometry& factors, EvaluatedScene& evaluated,
                         SceneLight* light, const std::vector<int>& varying) {
    const SurfaceRows& rows = evaluated.radiometry.rows();
    const std::vector<double> ranges_m = frame.evaluation().ranges_m();
    using SquaresByOutput = std::vector<std::vector<SquaresOfSums>>; // those of each entity, of all
    const auto squaresOf = [&](SummedRows of) {
        SquaresByOutput squares(varying.size(),
                                std::vector<SquaresOfSums>(frame.evaluation().geometry.size() + 1));
        if (of == SummedRows::lobes && rows.lobes().empty())
            return squares;
        const auto differences = sublatticeDifferenceSums(factors, evaluated.radiances, light, rows,
                                                          ranges_m, varying, of);
        for (std::size_t k = 0; k < differences.size(); ++k)
            for (std::size_t output = 0; output < varying.size(); ++output) {
                const ObjectSums& sums = differences[k][output];
                for (std::size_t e = 0; e < ranges_m.size(); ++e)
                    squares[output][e].add(k, differences.size(), sums.objects[e]);
                squares[output].back().add(k, differences.size(), sums.all);
            }
        return squares;
    };
    const SquaresByOutput all = squaresOf(SummedRows::all), lobes = squaresOf(SummedRows::lobes);
    ErrorsByOutput errors(varying.size());
    for (std::size_t output = 0; output < errors.size(); ++output)
        for (std::size_t e = 0; e < all[output].size(); ++e)
            errors[output].push_back(errorsOf(all[output][e], lobes[output][e]));
    return errors;
}

/// The nearer half of what an object reaches, where the atmosphere of its reference point stands
/// for all of it; none where that is so of none.
std::optional<std::vector<ObjectGeometry>> seenPlaces(std::vector<ObjectGeometry> nearer) {
    // What is seen of an object lies before its reference point.
    constexpr double before = 0.6; // of how far it reaches
    bool isMoved = false;
    for (ObjectGeometry& object : nearer)
        if (object.slices_m.size() < 2 && object.likelyAtmosphereError > 0.0) {
            object.path.range_m = std::max(
                object.path.range_m - before * 0.5 * (object.farthest_m - object.nearest_m), 0.0);
            isMoved = true;
        }
    if (!isMoved)
        return std::nullopt;
    return nearer;
}

/// Of the background behind an object in an output, W m-2 sr-1.
double ofBackground(const Frame& frame, std::size_t entity, std::size_t output) {
    const SceneEvaluation& evaluation = frame.evaluation();
    const FrameBackground& background = frame.backgrounds.ofSums[output];
    if (evaluation.behind.background) {
        // Pixel by pixel parts hide each other as they do, and rows are as fine as pictures need.
        constexpr double ofPixels = 1e-3;
        const double own = evaluation.behind.error[entity][output];
        return background.isUniform()
                   ? own
                   : std::min(own, ofPixels * evaluation.behind.radiance[entity][output]);
    }
    const BackgroundBehind& compared = evaluation.compared.behind;
    if (!compared.background)
        return 0.0;
    const ObjectGeometry& object = evaluation.compared.geometry[entity];
    if (!background.isUniform()) {
        // Line by line; a pixel that holds the horizon has the mean of both sides.
        const double horizon_rad = frame.scene().environment.horizonElevation_rad(
            object.sight.sensorAltitude_m, frame.request.bands.front().range());
        double wrong = 0.0;
        for (std::size_t j = 0; j < object.behind.size(); ++j) {
            const SightBehind& one = object.behind[j];
            ObjectGeometry alone = object;
            alone.behind = {{one.sight, 1.0}};
            if (std::abs(one.sight.elevation_rad - horizon_rad) > frame.sensor().pixelPitch())
                wrong += std::abs(one.weight * (compared.along[entity][j][output] -
                                                usedBehind(frame.request, alone, background)));
        }
        return wrong;
    }
    const double used = background.centre_W_m2_sr();
    return std::abs(compared.radiance[entity][output] - used) + compared.error[entity][output];
}

/// Of inter-reflection: a part of what it changes, the larger the farther nodes are apart.
void addOfExchange(const Frame& frame, const ViewGeometry& factors, EvaluatedScene& evaluated,
                   const SceneLight* light, const std::vector<int>& varying,
                   const std::vector<ObjectSums>& sums, ErrorsByOutput& errors) {
    if (light == nullptr)
        return;
    const std::vector<ObjectSums> without =
        objectSums(factors, evaluated.radiances, nullptr, evaluated.radiometry.rows(),
                   frame.evaluation().ranges_m(), varying);
    double coarseness = 1.0;
    for (const LightExchange::Body& body : light->exchange().bodies())
        coarseness = std::max(coarseness, body.light->nodes().coarseness());
    const double part =
        ofExchange * coarseness * ExchangeResolution::spacingFor(frame.settings().lightError);
    for (std::size_t o = 0; o < errors.size(); ++o)
        for (std::size_t e = 0; e < errors[o].size(); ++e) {
            const bool isAll = e + 1 == errors[o].size();
            const ObjectRadiometry& with = isAll ? sums[o].all : sums[o].objects[e];
            const ObjectRadiometry& alone = isAll ? without[o].all : without[o].objects[e];
            const auto of = [&](double a, double b) { return part * std::abs(a - b); };
            RadiometryErrors& own = errors[o][e];
            own.intensity_W_sr.exchange = of(with.intensity_W_sr, alone.intensity_W_sr);
            own.contrastIntensity_W_sr.exchange =
                of(with.contrastIntensity_W_sr, alone.contrastIntensity_W_sr);
            own.irradiance_W_m2.exchange = of(with.irradiance_W_m2, alone.irradiance_W_m2);
        }
}

bool knowsBackground(const Scene& scene) {
    const RenderSettings& settings = scene.settings;
    const bool isGrid = settings.backgroundRows * settings.backgroundColumns != 1;
    // Of a grid below pictures it is not known apart.
    return settings.background == BackgroundMode::environment &&
           !(isGrid && (scene.skybox || scene.terrain));
}

} // namespace

ErrorsByOutput RenderErrorEstimator::ofBands(const Frame& frame, const ViewGeometry& factors,
                                             const std::vector<ObjectSums>& sums) {
    ErrorsByOutput errors = ofSamples(frame, factors, *frame.evaluation().evaluated, frame.light(),
                                      frame.backgrounds.numbersOfVarying());
    const Environment& own = frame.scene().environment;
    other_.answers.setEnvironment(frame.settings().mode == CalculationMode::wideband
                                      ? other_.like(own)
                                      : other_.of(own, frame.request.bands.front()));
    addOfAtmosphere(frame, factors, sums, errors);
    addOfBackground(frame, sums, errors);
    addOfExchange(frame, factors, *frame.evaluation().evaluated, frame.light(),
                  frame.backgrounds.numbersOfVarying(), sums, errors);
    return errors;
}

std::vector<ObjectSums>
RenderErrorEstimator::sumsElsewhere(const Frame& frame, const ViewGeometry& factors,
                                    const std::vector<ObjectGeometry>& geometry) {
    const auto sampled = other_.sampled.of(
        other_.answers, evaluator_.airScene(frame.request, geometry), frame.request.bands,
        frame.request.withSources, evaluator_.sampler(frame.scene(), other_.answers),
        frame.evaluation().sampled->slices_m);
    const auto evaluated =
        other_.radiometry.of(terms_, frame.scene().entities, geometry, sampled, occluderStacks_);
    const BackgroundBehind behind =
        backgroundAlong(other_.answers, frame.request, sampled->bands, geometry);
    evaluated->radiances.setBackground(behind.background ? behind.background : sampled->background);
    // Backgrounds as in the middle of the field, and no light between surfaces.
    const std::vector<int> uniform(evaluated->radiances.outputs(), -1);
    return objectSums(factors, evaluated->radiances, nullptr, frame.rows(),
                      frame.evaluation().ranges_m(), uniform);
}

void RenderErrorEstimator::addOfAtmosphere(const Frame& frame, const ViewGeometry& factors,
                                           const std::vector<ObjectSums>& sums,
                                           ErrorsByOutput& errors) {
    const bool isWideband = frame.settings().mode == CalculationMode::wideband;
    const Environment& own = frame.scene().environment;
    const Environment& other = isWideband ? own : other_.of(own, frame.request.bands.front());
    const bool hasBins = !isWideband && !AtmosphereIdentity(other).isOf(own);
    const std::size_t entities = frame.evaluation().geometry.size();

    // As parts of the intensity: its error, and that of the contrast.
    struct AtmosphereParts {
        double intensity = 0.0, contrast = 0.0;
        void add(double ofIntensity, double ofSublatticeDifference) {
            intensity = std::hypot(intensity, ofIntensity);
            contrast = std::hypot(contrast, ofSublatticeDifference);
        }
    };
    std::vector<std::vector<AtmosphereParts>> parts(sums.size(),
                                                    std::vector<AtmosphereParts>(entities));
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
                const ObjectGeometry& object = frame.evaluation().geometry[e];
                if ((object.slices_m.size() > 1) == ofSliced &&
                    !frame.evaluation().sampled->ofOutput(o).isSource)
                    parts[o][e].add(object.likelyAtmosphereError, object.likelyAtmosphereError);
            }
    };
    addLikely(true); // slices are thin, and radiance nearly linear over each

    const std::optional<std::vector<ObjectGeometry>> nearer =
        seenPlaces(frame.evaluation().geometry);
    if (hasBins || nearer) {
        const std::vector<ObjectSums> there =
            sumsElsewhere(frame, factors, frame.evaluation().geometry);
        if (hasBins) {
            const std::vector<int> uniform(sums.size(), -1);
            const auto nodes = own.nodesOf(frame.request.bands.front());
            const auto others = other.nodesOf(frame.request.bands.front());
            const bool isNarrower = nodes && others && others->size() > nodes->size();
            addDifference(objectSums(factors, frame.evaluation().evaluated->radiances, nullptr,
                                     frame.rows(), frame.evaluation().ranges_m(), uniform),
                          there, isNarrower ? ofNarrower : 1.0);
        }
        try {
            if (nearer)
                addDifference(sumsElsewhere(frame, factors, *nearer), there);
        } catch (const InputError&) {
            addLikely(false); // some air answers for the path to the reference point alone
        }
    }
    for (std::size_t o = 0; isWideband && o < sums.size(); ++o)
        if (const auto* points =
                SensorCkData::of(*frame.evaluation().sampled->ofOutput(o).sampling))
            for (AtmosphereParts& one : parts[o])
                one.add(deviations * points->heldOutRms(), deviations * points->heldOutRms());

    for (std::size_t o = 0; o < sums.size(); ++o) {
        RadiometryErrors& all = errors[o].back();
        for (std::size_t e = 0; e < entities; ++e) {
            RadiometryErrors& object = errors[o][e];
            const double intensity_W_sr = std::abs(sums[o].objects[e].intensity_W_sr);
            const double range_m = frame.evaluation().geometry[e].path.range_m;
            object.intensity_W_sr.air = intensity_W_sr * parts[o][e].intensity;
            object.contrastIntensity_W_sr.air = intensity_W_sr * parts[o][e].contrast;
            object.irradiance_W_m2.air = object.contrastIntensity_W_sr.air / (range_m * range_m);
            // The air before all of them is one.
            all.intensity_W_sr.air += object.intensity_W_sr.air;
            all.contrastIntensity_W_sr.air += object.contrastIntensity_W_sr.air;
            all.irradiance_W_m2.air += object.irradiance_W_m2.air;
        }
    }
}

void RenderErrorEstimator::addOfBackground(const Frame& frame, const std::vector<ObjectSums>& sums,
                                           ErrorsByOutput& errors) {
    if (!knowsBackground(frame.scene()))
        return;
    for (std::size_t o = 0; o < frame.request.bands.size(); ++o) {
        RadiometryErrors& all = errors[o].back();
        for (std::size_t e = 0; e < frame.evaluation().geometry.size(); ++e) {
            RadiometryErrors& object = errors[o][e];
            const double range_m = frame.evaluation().geometry[e].path.range_m;
            const double error_W_m2 = ofBackground(frame, e, o) * sums[o].objects[e].solidAngle_sr;
            object.irradiance_W_m2.background = error_W_m2;
            object.contrastIntensity_W_sr.background = error_W_m2 * range_m * range_m;
            all.irradiance_W_m2.background += error_W_m2;
            all.contrastIntensity_W_sr.background += error_W_m2 * range_m * range_m;
        }
    }
}

ErrorsByOutput RenderErrorEstimator::ofSpectrum(const Frame& frame, const ViewGeometry& factors,
                                                const EvaluatedSpectrum& evaluated,
                                                SceneLight* light,
                                                const std::vector<double>& wavelengths_um,
                                                const std::vector<ObjectSums>& sums) {
    const std::size_t entities = frame.evaluation().geometry.size();
    const std::vector<double> ranges_m = frame.evaluation().ranges_m();
    const std::vector<int> uniform(sums.size(), -1);
    ErrorsByOutput errors = ofSamples(frame, factors, *evaluated.scene, light, uniform);
    addOfExchange(frame, factors, *evaluated.scene, light, uniform, sums, errors);

    // Sums along other paths and as they are, both without light between surfaces.
    const auto sumsAlong = [&](const std::vector<ObjectGeometry>& geometry) {
        const EvaluatedSpectrum there =
            evaluator_.atWavelengths(frame.request, geometry, wavelengths_um);
        return objectSums(factors, there.scene->radiances, nullptr, there.scene->radiometry.rows(),
                          ranges_m, uniform);
    };
    std::vector<ObjectSums> here, nearer;
    try {
        if (const auto places = seenPlaces(frame.evaluation().geometry)) {
            here = sumsAlong(frame.evaluation().geometry);
            nearer = sumsAlong(*places);
        }
    } catch (const InputError&) {
        nearer.clear(); // some air answers for the path to the reference point alone
    }
    const auto ofAtmosphere = [&](std::size_t k, std::size_t e) {
        const ObjectGeometry& object = frame.evaluation().geometry[e];
        const double intensity = std::abs(sums[k].objects[e].intensity_W_sr);
        if (object.slices_m.size() > 1 || nearer.empty())
            return std::pair(intensity * object.likelyAtmosphereError,
                             intensity * object.likelyAtmosphereError);
        const ObjectRadiometry &a = here[k].objects[e], &b = nearer[k].objects[e];
        if (!(a.intensity_W_sr > 0.0))
            return std::pair(0.0, 0.0);
        const double share = intensity / a.intensity_W_sr;
        return std::pair(share * std::abs(b.intensity_W_sr - a.intensity_W_sr),
                         share * std::abs(b.contrastIntensity_W_sr - a.contrastIntensity_W_sr));
    };
    BackgroundBehind compared;
    if (!evaluated.behind.background && frame.evaluation().compared.behind.background)
        compared = backgroundAlong(evaluator_.answers(), frame.request, evaluated.bands,
                                   frame.evaluation().compared.geometry);
    const auto ofBackgroundAt = [&](std::size_t k, std::size_t e) {
        if (evaluated.behind.background)
            return evaluated.behind.error[e][k];
        return compared.background ? compared.error[e][k] +
                                         std::abs(compared.radiance[e][k] -
                                                  evaluated.scene->radiances.background_W_m2_sr(k))
                                   : 0.0;
    };
    for (std::size_t e = 0; e < entities; ++e) {
        const bool isKnown = knowsBackground(frame.scene());
        for (std::size_t k = 0; k < sums.size(); ++k) {
            const auto [intensity, contrast] = ofAtmosphere(k, e);
            const double square_m2 = ranges_m[e] * ranges_m[e];
            const double background =
                (isKnown ? ofBackgroundAt(k, e) : 0.0) * sums[k].objects[e].solidAngle_sr;
            for (RadiometryErrors* one : {&errors[k][e], &errors[k].back()}) {
                one->intensity_W_sr.air += intensity;
                one->contrastIntensity_W_sr.air += contrast;
                one->irradiance_W_m2.air += contrast / square_m2;
                one->contrastIntensity_W_sr.background += background * square_m2;
                one->irradiance_W_m2.background += background;
            }
        }
    }
    return errors;
}

} // namespace irsg
