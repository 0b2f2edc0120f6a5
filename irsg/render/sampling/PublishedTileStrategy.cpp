#include "irsg/render/sampling/PublishedTileStrategy.h"

#include <cmath>

#include "irsg/render/sampling/EntityGroups.h"
#include "irsg/render/sampling/MultipassComposer.h"
#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/render/sampling/TileCamera.h"

namespace irsg {

namespace {

ObjectTexture textureOf(const RadianceSamples& samples) {
    ObjectTexture texture(samples.width);
    for (int row = 0; row < samples.height; ++row)
        for (int column = 0; column < samples.width; ++column) {
            // GL's rows run from the bottom up.
            const std::size_t sample = texture.offset(column, samples.height - 1 - row);
            const std::size_t texel = texture.offset(column, row);
            texture.radiance[texel] = static_cast<double>(samples.planes[2 * sample]);
            texture.opacity[texel] = static_cast<double>(samples.planes[2 * sample + 1]);
        }
    return texture;
}

} // namespace

std::pair<double, double> bilinear(const ObjectTexture& texture, double u, double v) {
    const auto place = [&](double coordinate) {
        return std::clamp(coordinate * texture.side - 0.5, 0.0, texture.side - 1.0);
    };
    const double x = place(u), y = place(v);
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, texture.side - 1);
    const int bottom = std::min(top + 1, texture.side - 1);
    const auto mix = [&](const std::vector<double>& plane) {
        const auto at = [&](int column, int row) { return plane[texture.offset(column, row)]; };
        return std::lerp(std::lerp(at(left, top), at(right, top), x - left),
                         std::lerp(at(left, bottom), at(right, bottom), x - left), y - top);
    };
    return {mix(texture.radiance), mix(texture.opacity)};
}

std::vector<SampleTile>
PublishedTileStrategy::tiles(const std::vector<ObjectExtent>& objects) const {
    return PixelAlignedStrategy(size_).tiles(objects);
}

FrameReduction PublishedTileStrategy::draw(const CameraFrame& camera,
                                           const std::vector<ObjectExtent>& objects,
                                           RttPass& pass) {
    // The whole frame is one patch: quads and objects lie upon one another.
    SampleTile all;
    all.blocksWide = camera.sensor().width_px;
    all.blocksHigh = camera.sensor().height_px;
    FrameReduction frame(camera.sensor(), {all});
    drawn_.clear();

    std::vector<ObjectExtent> farToNear = objects;
    std::ranges::stable_sort(farToNear, std::greater{}, [&](const ObjectExtent& object) {
        return length(object.centre_m - camera.viewpoint().position_m);
    });
    for (const ObjectExtent& object : farToNear) {
        const double diameter_px = sphereDiameter_px(camera, object.centre_m, object.radius_m);
        if (lod_.usesTexture(object.entity, diameter_px))
            renderTexture(camera, object, pass, frame);
        else
            renderAsItIs(camera, object, pass, frame);
    }
    return frame;
}

void PublishedTileStrategy::renderTexture(const CameraFrame& camera, const ObjectExtent& object,
                                          RttPass& pass, FrameReduction& frame) {
    // Phase 1: a camera of its own. Phase 2: averages.
    const double diameter_px = sphereDiameter_px(camera, object.centre_m, object.radius_m);
    const int side_px = std::min(nextPowerOfTwo(diameter_px), size_);
    const CameraFrame zoom = tileCamera(camera, object.centre_m, side_px, size_);
    RadianceSamples samples;
    pass.draw(zoom, SampleSheet::of(SampleTile::ofFrame(size_, {object.entity})), samples);
    const ObjectTexture texture = MultipassComposer(size_, side_px).apply(textureOf(samples));

    // Phase 3: the square in the frame.
    const Billboard billboard(zoom, object.centre_m);
    const PixelRegion pixels = billboard.pixels(camera);
    PixelRegion covered;
    for (int y = pixels.y; y < pixels.y + pixels.height; ++y)
        for (int x = pixels.x; x < pixels.x + pixels.width; ++x)
            if (const auto place = billboard.at(camera, x + 0.5, y + 0.5)) {
                const auto [radiance, opacity] = bilinear(texture, place->first, place->second);
                frame.cover(x, y, radiance, opacity);
                covered = covered.unitedWith({x, y, 1, 1});
            }
    const double samplesOfPixel = static_cast<double>(size_) / side_px;
    if (!covered.empty())
        drawn_.push_back({covered.rectangle(), samplesOfPixel, samplesOfPixel, {object.entity}});
}

void PublishedTileStrategy::renderAsItIs(const CameraFrame& camera, const ObjectExtent& object,
                                         RttPass& pass, FrameReduction& frame) {
    SampleTile whole = tileOnBlocks(object.extent, 0);
    whole.entities = {object.entity};
    drawn_.push_back(RenderedTile::of(whole));
    RadianceSamples samples;
    for (const SampleTile& tile : whole.pieces(pass.largestSide())) {
        pass.draw(camera, SampleSheet::of(tile), samples);
        tile.forEachRun([&](std::size_t first, int, int x, int y, double) {
            frame.cover(x, y, static_cast<double>(samples.planes[2 * first]),
                        static_cast<double>(samples.planes[2 * first + 1]));
        });
    }
}

} // namespace irsg
