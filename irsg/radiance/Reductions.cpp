#include "irsg/radiance/Reductions.h"

#include <algorithm>
#include <array>

#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t reductionParts = 16;

/// Sum of what factors make of a kind; `numbers` begin with the coverage.
template <typename Real>
double radianceOf(const SurfaceStackRadiance& kind, const Real* numbers) {
    double sum = kind.constant * static_cast<double>(numbers[0]);
    for (std::size_t f = 0; f < kind.perFactor.size(); ++f)
        sum += kind.perFactor[f] * static_cast<double>(numbers[1 + f]);
    return sum;
}

double dotProduct(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

/// By key of rows: its place among those of its entity.
std::vector<std::size_t> placesOfSurfaces(const SurfaceRows& rows) {
    std::vector<std::size_t> places;
    std::vector<std::size_t> counts;
    for (const SurfaceKey& key : rows.keys()) {
        const auto entity = static_cast<std::size_t>(key.first);
        counts.resize(std::max(counts.size(), entity + 1));
        places.push_back(counts[entity]++);
    }
    return places;
}

/// The surface of a row in the sums of its object; null where nobody asked for surfaces.
SurfaceRadiometry* surfaceIn(ObjectRadiometry& object, const std::vector<std::size_t>& places,
                             const SurfaceRows& rows, int drawn) {
    return places.empty()
               ? nullptr
               : &object.surfaces[places[static_cast<std::size_t>(rows.surfaceOf(drawn))]];
}

bool isOf(SummedRows of, const SurfaceRows& rows, int drawn) {
    return of == SummedRows::all || rows.isLobe(drawn);
}

/// Adds the light between surfaces to the sums over objects.
void addLightBetween(const LightSums& sums, SceneLight& light, const SurfaceRows& rows,
                     const std::vector<double>& ranges_m, const std::vector<std::size_t>& surfaces,
                     SummedRows of, std::vector<ObjectSums>& result) {
    std::vector<SurfaceStackId> kinds = light.inOrder(sums);
    std::erase_if(kinds, [&](const SurfaceStackId& kind) {
        return !isOf(of, rows, rows.renderedOf(kind.row));
    });
    const auto addTo = [&](const SurfaceStackId& kind, std::size_t output, double plain_W_m2,
                           double cosine_W_m2) {
        const int drawn = rows.renderedOf(kind.row);
        const auto entity = static_cast<std::size_t>(rows.keyOf(drawn).first);
        ObjectRadiometry& object = result[output].objects[entity];
        const double intensity_W_sr = plain_W_m2 * ranges_m[entity] * ranges_m[entity];
        object.intensity_W_sr += intensity_W_sr;
        object.contrastIntensity_W_sr += intensity_W_sr;
        object.irradiance_W_m2 += cosine_W_m2;
        if (SurfaceRadiometry* surface = surfaceIn(object, surfaces, rows, drawn)) {
            surface->intensity_W_sr += intensity_W_sr;
            surface->contrastIntensity_W_sr += intensity_W_sr;
            surface->irradiance_W_m2 += cosine_W_m2;
        }
    };
    if (light.sumsAtReceivers()) {
        for (const SurfaceStackId& kind : kinds)
            for (std::size_t output = 0; output < result.size(); ++output) {
                const auto [plain_W_m2, cosine_W_m2] =
                    light.sumAtReceivers(kind, output, sums.at({kind.stack, kind.row}));
                addTo(kind, output, plain_W_m2, cosine_W_m2);
            }
        return;
    }
    light.prepare(kinds);
    std::vector<std::array<std::vector<double>, 2>> all(kinds.size());
    parallelFor(kinds.size(), [&](std::size_t k) {
        const ReceiverSums& own = sums.at({kinds[k].stack, kinds[k].row});
        for (const bool withCosine : {false, true})
            all[k][withCosine ? 1 : 0] = light.contracted(kinds[k].row, own, withCosine);
    });
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (std::size_t output = 0; output < result.size(); ++output) {
            const std::span<const double> integrals = light.integrals(kinds[k], output);
            addTo(kinds[k], output, dotProduct(all[k][0], integrals),
                  dotProduct(all[k][1], integrals));
        }
}

/// Makes what sums over views take of the light between surfaces.
void prepareReceivers(std::span<const ViewGeometry> views, SceneLight* light) {
    if (light == nullptr || !light->sumsAtReceivers())
        return;
    std::vector<const LightSums*> sums;
    for (const ViewGeometry& view : views)
        sums.push_back(&view.light);
    light->prepareReceivers(sums);
}

} // namespace

namespace {

/// Of factors whose kinds are prepared.
std::vector<ObjectSums> sumsOf(const ViewGeometry& view, const SurfaceRadianceTable& radiances,
                               SceneLight* light, const SurfaceRows& rows,
                               const std::vector<double>& ranges_m, const std::vector<int>& varying,
                               bool bySurface, SummedRows of = SummedRows::all) {
    const ViewLayout& layout = view.layout;
    struct Seen {
        std::size_t entity;
        int drawn;
        const double* numbers;
        SurfaceRadianceTable::InOutputs radiance;
    };
    std::vector<Seen> seen;
    view.field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const SurfaceStackId& kind = view.field.kinds()[number];
        const int drawn = rows.renderedOf(kind.row);
        if (!isOf(of, rows, drawn))
            return;
        seen.push_back({static_cast<std::size_t>(rows.keyOf(drawn).first), drawn, numbers.data(),
                        radiances.inOutputs(kind)});
    });
    std::vector<ObjectSums> result(radiances.outputs());
    for (ObjectSums& sums : result)
        sums.objects.resize(ranges_m.size());
    std::vector<std::size_t> surfaces; // by key, empty where nobody asked
    if (bySurface) {
        surfaces = placesOfSurfaces(rows);
        for (ObjectSums& sums : result)
            for (const auto& [entity, codes] : rows.keys())
                sums.objects[static_cast<std::size_t>(entity)].surfaces.push_back(
                    {codes.temperature, codes.material});
    }

    const auto add = [&](const Seen& one, std::size_t output) {
        const SurfaceStackRadiance radiance = one.radiance.at(output);
        const double* plain = one.numbers + layout.coverage();
        const double* cosine = one.numbers + layout.withCosine(layout.coverage());

        // The background that this surface hides, as seen through what is in front of it.
        double hidden_W_m2 = radiance.hidden * *plain;
        double hiddenCos_W_m2 = radiance.hidden * *cosine;
        if (const int k = varying[output]; k >= 0) {
            const auto background = static_cast<std::size_t>(k);
            hidden_W_m2 = radiance.opacity * one.numbers[layout.background(background)];
            hiddenCos_W_m2 = radiance.opacity * one.numbers[layout.backgroundCosine(background)];
        }
        const double square_m2 = ranges_m[one.entity] * ranges_m[one.entity];
        const double sent_W_m2 = radianceOf(radiance, plain);
        ObjectRadiometry& object = result[output].objects[one.entity];
        const double contrast_W_sr = (sent_W_m2 - hidden_W_m2) * square_m2;
        const double irradiance_W_m2 = radianceOf(radiance, cosine) - hiddenCos_W_m2;
        object.intensity_W_sr += sent_W_m2 * square_m2;
        object.contrastIntensity_W_sr += contrast_W_sr;
        object.irradiance_W_m2 += irradiance_W_m2;
        object.coveredPixels += radiance.opacity * one.numbers[layout.pixels()];
        object.solidAngle_sr += radiance.opacity * *plain;
        if (SurfaceRadiometry* surface = surfaceIn(object, surfaces, rows, one.drawn)) {
            surface->intensity_W_sr += sent_W_m2 * square_m2;
            surface->contrastIntensity_W_sr += contrast_W_sr;
            surface->irradiance_W_m2 += irradiance_W_m2;
            surface->solidAngle_sr += radiance.opacity * *plain;
        }
    };
    // Outputs do not meet, so that some can be summed on a core of their own.
    parallelFor(reductionParts, [&](std::size_t part) {
        const std::size_t first = beginOfPart(part, reductionParts, result.size());
        const std::size_t last = beginOfPart(part + 1, reductionParts, result.size());
        for (const Seen& one : seen)
            for (std::size_t output = first; output < last; ++output)
                add(one, output);
    });
    if (light)
        addLightBetween(view.light, *light, rows, ranges_m, surfaces, of, result);
    for (ObjectSums& sums : result)
        for (const ObjectRadiometry& object : sums.objects)
            sums.all.addSums(object);
    return result;
}

} // namespace

std::vector<ObjectSums> objectSums(const ViewGeometry& view, SurfaceRadianceTable& radiances,
                                   SceneLight* light, const SurfaceRows& rows,
                                   const std::vector<double>& ranges_m,
                                   const std::vector<int>& varying, bool bySurface) {
    radiances.prepare(view.field.kinds());
    prepareReceivers({&view, 1}, light);
    return sumsOf(view, radiances, light, rows, ranges_m, varying, bySurface);
}

std::vector<std::vector<ObjectSums>>
sublatticeDifferenceSums(const ViewGeometry& view, SurfaceRadianceTable& radiances,
                         SceneLight* light, const SurfaceRows& rows,
                         const std::vector<double>& ranges_m, const std::vector<int>& varying,
                         SummedRows of) {
    for (const ViewGeometry& contrast : view.sublatticeDifferences)
        radiances.prepare(contrast.field.kinds());
    std::vector<std::vector<ObjectSums>> all(view.sublatticeDifferences.size());
    const auto sum = [&](std::size_t k) {
        all[k] = sumsOf(view.sublatticeDifferences[k], radiances, light, rows, ranges_m, varying,
                        false, of);
    };
    prepareReceivers(view.sublatticeDifferences, light);
    // Else light between surfaces is prepared as it is asked for.
    if (light == nullptr || light->sumsAtReceivers()) {
        parallelFor(all.size(), sum);
        return all;
    }
    for (std::size_t k = 0; k < all.size(); ++k)
        sum(k);
    return all;
}

void addPixels(const PixelGeometry& pixels, int width_px, SurfaceRadianceTable& radiances,
               SceneLight* light, FrameReduction& frame) {
    radiances.prepare(pixels.field.kinds());
    std::vector<SurfaceStackRadiance> known;
    for (const SurfaceStackId& kind : pixels.field.kinds())
        known.push_back(radiances.of(kind));
    std::vector<double> ofReceivers;
    if (light)
        ofReceivers = radiancesOf(pixels.light.kinds(), pixels.receivers, *light);
    for (std::size_t cell = 0; cell < pixels.field.cells(); ++cell) {
        double sent = 0.0, opacity = 0.0;
        bool isSeen = false;
        if (light)
            pixels.light.forEach(cell, [&](std::size_t kind, std::span<const float> numbers) {
                sent += ofReceivers[kind] * static_cast<double>(numbers[0]);
            });
        pixels.field.forEach(cell, [&](std::size_t kind, std::span<const float> numbers) {
            sent += radianceOf(known[kind], numbers.data());
            opacity += known[kind].opacity * static_cast<double>(numbers[0]);
            isSeen = true;
        });
        if (isSeen)
            frame.addPoint(static_cast<int>(cell) % width_px, static_cast<int>(cell) / width_px,
                           sent, opacity);
    }
}

double lightOfPoint(const PointGeometry& atUnitDistance, const SurfaceRows& rows,
                    SceneLight& light) {
    double sent = 0.0;
    for (const auto& [drawn, sums] : atUnitDistance.light_sr_m2) {
        const SurfaceStackId kind{drawn.first, rows.first(drawn.second)};
        if (!light.matters(rows.renderedOf(kind.row)))
            continue;
        light.prepare({kind});
        sent += dotProduct(light.contracted(kind.row, sums, false), light.integrals(kind, 0));
    }
    return sent;
}

void addPointToPixel(const PointGeometry& atUnitDistance, const SurfaceRows& rows,
                     const PointPlace& place, SurfaceRadianceTable& radiances, SceneLight* light,
                     FrameReduction& frame) {
    const double scale = 1.0 / (place.distance_m * place.distance_m * place.solidAngle_sr);
    double sent = 0.0, opacity = 0.0;
    if (light)
        sent += scale * lightOfPoint(atUnitDistance, rows, *light);
    const GeometryBuffer<double>& field = atUnitDistance.sums_sr_m2;
    field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const SurfaceStackId& drawn = field.kinds()[number];
        const SurfaceStackId kind{drawn.stack, rows.first(drawn.row)};
        radiances.prepare({kind});
        const SurfaceStackRadiance radiance = radiances.of(kind);
        sent += scale * radianceOf(radiance, numbers.data());
        opacity += scale * radiance.opacity * numbers[0];
    });
    frame.addPoint(place.x, place.y, sent, opacity, place.cosineShare);
}

} // namespace irsg
