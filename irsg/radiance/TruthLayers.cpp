#include "irsg/radiance/TruthLayers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "irsg/render/sampling/OffAxisShares.h"

namespace irsg {

namespace {

const char* const backgroundChannel = "background";
const char* const sunVisibilityChannel = "sun_visibility";
const char* const skyVisibilityChannel = "sky_visibility";
const char* const interReflectionChannel = "inter_reflection";
const char* const radianceUnit = "W m-2 sr-1";

} // namespace

TruthLayers::TruthLayers(const Sensor& sensor, const SceneRadiometry& radiometry,
                         SurfaceRadianceTable& radiances, OccluderStacks& occluderStacks,
                         const FrameBackground& background, SceneLight* light, RadianceImage& image)
    : grid_(sensor),
      radiometry_(radiometry),
      radiances_(radiances),
      occluderStacks_(occluderStacks),
      background_(background),
      light_(light),
      image_(image),
      walk_(radiometry.rows()) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    for (const char* index : {"temperature_index", "material_index"})
        std::ranges::fill(image_.channel(index).values, none);
    const auto& keys = radiometry.rows().keys();
    hasObjects_ = std::ranges::any_of(keys, [](const SurfaceKey& key) { return key.first > 0; });
    if (hasObjects_)
        std::ranges::fill(image_.channel("object_index").values, none);
    std::ranges::fill(image_.channel("range", "m").values, none);
    const std::vector<RadianceTerm>& list = radiometry.terms().terms;
    for (std::size_t k = 0; k < list.size(); ++k) {
        if (list[k].surface == SurfaceQuantity::specular && radiometry.rows().lobes().empty())
            continue;
        shown_.push_back(k);
        image_.channel(list[k].name, radianceUnit);
    }
    if (light_)
        image_.channel(interReflectionChannel, radianceUnit);
    std::vector<float>& behind = image_.channel(backgroundChannel, radianceUnit).values;
    for (int y = 0; y < image_.height(); ++y)
        for (int x = 0; x < image_.width(); ++x)
            behind[image_.offset(x, y)] = static_cast<float>(background_.at(x, y));
    offMiddle_px_.assign(behind.size(), std::numeric_limits<float>::infinity());
}

const TruthLayers::SurfaceStackTerms& TruthLayers::termsOf(const SurfaceStackId& kind) {
    const auto number = static_cast<std::size_t>(kinds_.kindOf(kind));
    if (number >= terms_.size()) {
        const SurfaceStackId shared{
            occluderStacks_.numberOf(walk_.occluderStacks().materials(kind.stack)), kind.row};
        radiances_.prepare({shared});
        terms_.push_back({radiances_.terms(shared), radiances_.of(shared).opacity});
        if (light_ && light_->matters(radiometry_.rows().renderedOf(kind.row)))
            terms_.back().light = &light_->atReceivers(shared);
    }
    return terms_[number];
}

void TruthLayers::add(const SampleTile& tile, const GeometrySamples& samples) {
    const std::vector<RadianceTerm>& list = radiometry_.terms().terms;
    const SurfaceRows& rows = radiometry_.rows();
    const double share = tile.share();
    const ImageRectangle place = tile.rectangle();
    const double across_px = tile.blockSide_px() / tile.samplesAcross;
    const double down_px = tile.blockSide_px() / tile.samplesDown;
    std::vector<float>& temperatureIndex = image_.channel("temperature_index").values;
    std::vector<float>& materialIndex = image_.channel("material_index").values;
    std::vector<float>* const objectIndex =
        hasObjects_ ? &image_.channel("object_index").values : nullptr;
    std::vector<float>& range = image_.channel("range").values;
    std::vector<std::vector<float>*> planes; // of the terms, then of the background
    std::vector<float> unseen(shown_.size() < list.size() ? temperatureIndex.size() : 0);
    for (std::size_t k = 0; k < list.size(); ++k)
        planes.push_back(std::ranges::find(shown_, k) == shown_.end()
                             ? &unseen
                             : &image_.channel(list[k].name).values);
    const std::size_t ofOthers = planes.size();
    if (light_)
        planes.push_back(&image_.channel(interReflectionChannel).values);
    planes.push_back(&image_.channel(backgroundChannel).values);

    std::vector<float>* skyVisibility = nullptr;
    if (!samples.skyVisibility.empty())
        skyVisibility = &image_.channel(skyVisibilityChannel).values;
    std::vector<float>* sunVisibility = nullptr;
    if (!samples.sunVisibility.empty())
        sunVisibility = &image_.channel(sunVisibilityChannel).values;

    std::vector<double> sums(planes.size());
    const OffAxisShares shares(tile, grid_);
    shares.forEachRun(
        0, tile.height(), [&](std::size_t first, int count, int x, int y, double weight, double) {
            const std::size_t pixel = image_.offset(x, y);
            const std::size_t last = first + static_cast<std::size_t>(count);
            std::ranges::fill(sums, 0.0);
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t standing = samples.standingFor(i, tile.stride());
                if (samples.isEmpty(standing))
                    continue;
                std::optional<GeometrySamples::Layer> nearest;
                const auto addReceived = [&](const SurfaceStackId& kind, float part,
                                             const GeometrySamples::Layer& layer) {
                    const SurfaceStackTerms& known = termsOf(kind);
                    if (!known.light || !layer.place)
                        return;
                    const SceneLight::AtReceiver at =
                        lightAt(light_->exchange(), *known.light, *layer.place);
                    const double of =
                        static_cast<double>(part) * static_cast<double>(layer.coverage);
                    if (light_->skyTerm() >= 0)
                        sums[static_cast<std::size_t>(light_->skyTerm())] += of * at[0];
                    if (light_->groundTerm() >= 0)
                        sums[static_cast<std::size_t>(light_->groundTerm())] += of * at[1];
                    sums[ofOthers] += of * at[2];
                };
                walk_.forEachLayer(
                    samples, standing,
                    [&](const SurfaceStackId& kind, float part,
                        const GeometrySamples::Layer& layer) {
                        if (!nearest)
                            nearest = layer;
                        const SurfaceStackTerms& known = termsOf(kind);
                        for (std::size_t k = 0; k < list.size(); ++k) {
                            const TermGeometryFactor& factor = list[k].factor;
                            const auto coverage = static_cast<double>(layer.coverage);
                            double drawn = coverage;
                            if (factor.drawn >= 0)
                                drawn = static_cast<double>(
                                    layer.factors[static_cast<std::size_t>(factor.drawn)]);
                            if (factor.complement)
                                drawn = coverage - drawn;
                            sums[k] += static_cast<double>(part) * drawn * known.terms[k];
                        }
                        addReceived(kind, part, layer);
                        sums.back() -= static_cast<double>(part * layer.coverage) * known.opacity *
                                       background_.behindAt(x, y);
                    },
                    addReceived);

                if (!nearest) // a gas that it only touches
                    continue;
                // GL's rows run from the bottom up.
                const std::size_t drawn = i - tile.firstSample;
                const int row = tile.height() - 1 - static_cast<int>(drawn / tile.stride());
                const auto drawnColumn = static_cast<double>(drawn % tile.stride());
                const double column = drawnColumn - tile.shift(row);
                const double right_px = place.left + (column + 0.5) * across_px - (x + 0.5);
                const double below_px =
                    place.top + (row + 0.5 + tile.drop(drawnColumn)) * down_px - (y + 0.5);
                const auto off_px = static_cast<float>(std::hypot(right_px, below_px));
                if (off_px < offMiddle_px_[pixel]) {
                    offMiddle_px_[pixel] = off_px;
                    const auto& [entity, codes] =
                        rows.keys()[static_cast<std::size_t>(nearest->row)];
                    if (objectIndex != nullptr)
                        (*objectIndex)[pixel] = static_cast<float>(entity);
                    temperatureIndex[pixel] = static_cast<float>(codes.temperature);
                    materialIndex[pixel] = static_cast<float>(codes.material);
                    range[pixel] = standing == i ? nearest->distance_m : samples.distances_m[i];
                }
            }
            for (std::size_t i = first; skyVisibility && i < last; ++i)
                (*skyVisibility)[pixel] +=
                    static_cast<float>(weight * share) *
                    samples.skyVisibility[samples.standingFor(i, tile.stride())];
            for (std::size_t i = first; sunVisibility && i < last; ++i)
                (*sunVisibility)[pixel] +=
                    static_cast<float>(weight * share) *
                    samples.sunVisibility[samples.standingFor(i, tile.stride())];
            for (std::size_t term = 0; term < planes.size(); ++term)
                (*planes[term])[pixel] += static_cast<float>(sums[term] * weight * share);
        });
}

} // namespace irsg
