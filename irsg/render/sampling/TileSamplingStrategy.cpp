#include "irsg/render/sampling/TileSamplingStrategy.h"

#include <cmath>

namespace irsg {

RenderedTile RenderedTile::of(const SampleTile& tile) {
    const double blocksOfPixel = std::ldexp(1.0, tile.level);
    return {tile.region(), blocksOfPixel * tile.samplesAcross, blocksOfPixel * tile.samplesDown,
            tile.entities};
}

std::vector<RenderedTile> RenderedTile::of(const std::vector<SampleTile>& tiles) {
    std::vector<RenderedTile> result;
    for (const SampleTile& tile : tiles)
        result.push_back(of(tile));
    return result;
}

FrameReduction TileSamplingStrategy::draw(const CameraFrame& camera,
                                          const std::vector<ObjectExtent>& objects, RttPass& pass) {
    const std::vector<SampleTile> planned = tiles(objects);
    drawn_ = RenderedTile::of(planned);
    const std::vector<SampleTile> pieces = piecesOf(planned, pass.largestSide());
    FrameReduction frame(camera.sensor(), pieces);
    for (const SampleSheet& sheet : sheetsOf(pieces, pass.largestSide())) {
        pass.draw(camera, sheet, samples_);
        for (const SampleTile& tile : sheet.tiles)
            frame.add(tile, samples_);
    }
    if (samples_.planes.size() > 2 * mostSamplesCached)
        samples_ = {};
    return frame;
}

std::vector<SampleTile> piecesOf(const std::vector<SampleTile>& tiles, int largestSide) {
    std::vector<SampleTile> result;
    for (const SampleTile& tile : tiles)
        for (SampleTile& piece : tile.pieces(largestSide))
            result.push_back(std::move(piece));
    return result;
}

} // namespace irsg
