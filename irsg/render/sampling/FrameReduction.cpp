#include "irsg/render/sampling/FrameReduction.h"

#include <algorithm>
#include <array>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/render/sampling/OffAxisShares.h"

namespace irsg {

namespace {

/// Bands that the rows of pixels are divided into, whatever the number of cores.
constexpr std::size_t bands = 8;

/// Calls work(band, first row, row behind the last) on all cores, for pixels of the frame.
template <typename Work>
void forEachBand(const PixelRegion& pixels, const Work& work) {
    const auto rows = static_cast<std::size_t>(pixels.height);
    parallelFor(bands, [&](std::size_t band) {
        work(band, pixels.y + static_cast<int>(beginOfPart(band, bands, rows)),
             pixels.y + static_cast<int>(beginOfPart(band + 1, bands, rows)));
    });
}

} // namespace

FrameReduction::FrameReduction(const Sensor& sensor, const std::vector<SampleTile>& tiles)
    : sensor_(sensor) {
    // Tiles that share pixels share a patch; a grown patch may reach others.
    for (const SampleTile& tile : tiles) {
        Patch patch{tile.pixels(), {}, {}, {}, {}};
        for (auto other = patches_.begin(); other != patches_.end();) {
            if (!other->pixels.intersects(patch.pixels)) {
                ++other;
                continue;
            }
            patch.pixels = patch.pixels.unitedWith(other->pixels);
            patches_.erase(other);
            other = patches_.begin();
        }
        patches_.push_back(std::move(patch));
    }
    for (Patch& patch : patches_)
        patch.makeRoom();
}

void FrameReduction::Patch::makeRoom() {
    const auto count =
        static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    for (std::vector<double>* one : {&radiance, &opacity, &projectedRadiance, &projectedOpacity})
        one->resize(count);
}

FrameReduction::Patch* FrameReduction::find(const PixelRegion& pixels) {
    const auto found = std::ranges::find_if(
        patches_, [&](const Patch& patch) { return patch.pixels.intersects(pixels); });
    return found == patches_.end() ? nullptr : &*found;
}

FrameReduction::Patch& FrameReduction::patchOf(const PixelRegion& pixels) {
    Patch* patch = find(pixels);
    if (!patch)
        throw LogicError("a window was drawn that the frame was not told of");
    return *patch;
}

void FrameReduction::add(const SampleTile& tile, const RadianceSamples& samples) {
    const PixelRegion pixels = tile.pixels();
    Patch& patch = patchOf(pixels);
    const double share = tile.share();
    const auto addRun = [&](std::size_t first, int count, int x, int y, double weight,
                            double projectedWeight) __attribute__((always_inline)) {
        const float* sample = &samples.planes[2 * first];
        double radiance = 0.0, opacity = 0.0;
        for (int s = 0; s < count; ++s, sample += 2) {
            radiance += static_cast<double>(sample[0]);
            opacity += static_cast<double>(sample[1]);
        }
        if (radiance == 0.0 && opacity == 0.0)
            return;
        const std::size_t pixel = patch.offset(x, y);
        patch.radiance[pixel] += radiance * (weight * share);
        patch.opacity[pixel] += opacity * (weight * share);
        patch.projectedRadiance[pixel] += radiance * (projectedWeight * share);
        patch.projectedOpacity[pixel] += opacity * (projectedWeight * share);
    };
    const PixelGrid grid(sensor_);
    const OffAxisShares shares(tile, grid);
    forEachBand(pixels, [&](std::size_t, int top, int bottom) {
        shares.forEachRun(tile.firstRowOf(top), tile.firstRowOf(bottom), addRun);
    });
}

void FrameReduction::addPoint(int x, int y, double radiance_W_m2_sr, double opacity,
                              double cosineShare) {
    Patch* patch = find({x, y, 1, 1});
    if (!patch) {
        patch = &patches_.emplace_back(Patch{{x, y, 1, 1}, {}, {}, {}, {}});
        patch->makeRoom();
    }
    const std::size_t pixel = patch->offset(x, y);
    patch->radiance[pixel] += radiance_W_m2_sr;
    patch->opacity[pixel] += opacity;
    patch->projectedRadiance[pixel] += cosineShare * radiance_W_m2_sr;
    patch->projectedOpacity[pixel] += cosineShare * opacity;
}

void FrameReduction::cover(int x, int y, double radiance_W_m2_sr, double opacity) {
    Patch& patch = patchOf({x, y, 1, 1});
    const std::size_t pixel = patch.offset(x, y);
    for (std::vector<double>* under : {&patch.radiance, &patch.projectedRadiance})
        (*under)[pixel] = radiance_W_m2_sr + (1.0 - opacity) * (*under)[pixel];
    for (std::vector<double>* under : {&patch.opacity, &patch.projectedOpacity})
        (*under)[pixel] = opacity + (1.0 - opacity) * (*under)[pixel];
}

ObjectRadiometry FrameReduction::objects(const FrameBackground& background, double range_m) const {
    ObjectRadiometry sum;
    sum.name = "all";
    sum.range_m = range_m;
    const PixelGrid grid(sensor_);
    for (const Patch& patch : patches_) {
        const auto add = [&](int x, int y, ObjectRadiometry& to) {
            const std::size_t i = patch.offset(x, y);
            const double radiance = patch.radiance[i], opacity = patch.opacity[i];
            if (opacity == 0.0 && radiance == 0.0)
                return;
            const auto [omega_sr, cosOffAxis] = grid.at(x, y);
            const double behind = background.behindAt(x, y);
            const double contrast = radiance - opacity * behind;
            const double projected =
                patch.projectedRadiance[i] - patch.projectedOpacity[i] * behind;
            to.intensity_W_sr += radiance * omega_sr;
            to.contrastIntensity_W_sr += contrast * omega_sr;
            to.irradiance_W_m2 += projected * omega_sr * cosOffAxis;
            to.coveredPixels += opacity;
            to.solidAngle_sr += opacity * omega_sr;
        };
        std::array<ObjectRadiometry, bands> ofBands;
        forEachBand(patch.pixels, [&](std::size_t band, int top, int bottom) {
            for (int y = top; y < bottom; ++y)
                for (int x = patch.pixels.x; x < patch.pixels.x + patch.pixels.width; ++x)
                    add(x, y, ofBands[band]);
        });
        for (const ObjectRadiometry& one : ofBands)
            sum.addSums(one);
    }
    sum.intensity_W_sr *= range_m * range_m;
    sum.contrastIntensity_W_sr *= range_m * range_m;
    return sum;
}

RadianceImage FrameReduction::compose(const FrameBackground& background) const {
    RadianceImage image(sensor_.width_px, sensor_.height_px);
    std::vector<float>& pixels = image.primary().values;
    if (background.isUniform())
        std::ranges::fill(pixels, static_cast<float>(background.centre_W_m2_sr()));
    else
        for (int y = 0; y < sensor_.height_px; ++y)
            for (int x = 0; x < sensor_.width_px; ++x)
                pixels[image.offset(x, y)] = static_cast<float>(background.at(x, y));

    for (const Patch& patch : patches_)
        forEachBand(patch.pixels, [&](std::size_t, int top, int bottom) {
            for (int y = top; y < bottom; ++y)
                for (int x = patch.pixels.x; x < patch.pixels.x + patch.pixels.width; ++x) {
                    const std::size_t i = patch.offset(x, y);
                    pixels[image.offset(x, y)] =
                        static_cast<float>(patch.radiance[i] + background.at(x, y) -
                                           patch.opacity[i] * background.behindAt(x, y));
                }
        });
    return image;
}

} // namespace irsg
