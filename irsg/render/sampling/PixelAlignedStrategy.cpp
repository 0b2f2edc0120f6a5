#include "irsg/render/sampling/PixelAlignedStrategy.h"

#include <cmath>
#include <limits>

#include "irsg/render/sampling/Partition.h"

namespace irsg {

namespace {

/// Tiles that the longer side of an extent is cut into at least: the more, the closer a tile lies
/// around its object. Fewer where there are few samples.
double fewestBlocks(double samples) {
    return std::clamp(std::sqrt(samples) / 6.0, 6.0, 16.0);
}
/// The same for the shorter side, as long as every block keeps this many samples of the budget.
constexpr double fewestBlocksAcross = 8.0, enoughPerBlock = 16.0;

/// The coarsest level that cuts an extent into so many blocks; whole pixels where they are enough.
int levelFor(const ImageRectangle& extent, double samples) {
    int level = 0;
    if (const double extent_px = extent.extent(); extent_px < fewestBlocks(samples))
        level = static_cast<int>(
            std::ceil(std::log2(fewestBlocks(samples) / std::max(extent_px, 1e-300))));
    constexpr double mostBlocks =
        480.0; // along the longer side: four samples of each fit a drawing
    const double shorter_px = std::min(extent.width(), extent.height());
    const auto blocks = [](double side_px, int ofLevel) {
        return std::ldexp(side_px, ofLevel) + 1.0;
    };
    while (level < SampleTile::deepestLevel && std::ldexp(shorter_px, level) < fewestBlocksAcross &&
           blocks(extent.extent(), level + 1) <= mostBlocks &&
           samples >= enoughPerBlock * blocks(extent.width(), level + 1) *
                          blocks(extent.height(), level + 1))
        ++level;
    return std::clamp(level, 0, SampleTile::deepestLevel);
}

/// Columns of the first lattice in terms of those of a square one: the shear spares columns of
/// samples, as an upright edge meets every phase of them. A level edge does not, so that the
/// samples go to rows, as many in all.
constexpr double fewerColumns = 0.8;

/// The slope of upright rows of samples: 3.6 degrees, within which edges count as upright. An edge
/// of any length worth counting then meets every phase of the samples. Less in upright tiles, of
/// which a shear must not be most.
double uprightSlope(const SampleTile& tile) {
    constexpr double steepest = 1.0 / 16.0, mostOfWidth = 0.125;
    return std::min(steepest, mostOfWidth * tile.blocksWide / tile.blocksHigh);
}

/// The same in flat tiles, whose long level edges want rows yet more.
double columnsOfRows(const SampleTile& tile) {
    constexpr double flatFrom = 2.0;
    const double flatness = static_cast<double>(tile.blocksWide) / tile.blocksHigh;
    return fewerColumns * std::pow(std::min(flatFrom / flatness, 1.0), 0.25);
}

/// What a budget gives each block of a tile.
double samplesPerBlock(const SampleTile& tile, double samples) {
    return samples / (static_cast<double>(tile.blocksWide) * tile.blocksHigh);
}

/// Greatest side that a drawing should have, samples.
constexpr int longestDrawing = 2048;

/// Columns and rows of samples in every block: of the whole numbers near the wanted shape those
/// that use the budget, as far as one drawing holds them; at least `fewest`.
void chooseSamples(SampleTile& tile, double samples, int fewest) {
    constexpr int otherColumns = 3;
    constexpr double enough = 0.9; // of the budget: nearer shapes are better then
    const double shapeWanted = columnsOfRows(tile) * columnsOfRows(tile);
    const double narrowest = 0.55 * shapeWanted, widest = 2.2 * shapeWanted; // columns to rows
    const double perBlock = samplesPerBlock(tile, samples);
    const double ofShear = uprightSlope(tile) * tile.blocksHigh;
    const int mostAcross =
        std::max(fewest, static_cast<int>(longestDrawing / (tile.blocksWide + ofShear)));
    const int mostDown = std::max(fewest, longestDrawing / tile.blocksHigh);
    const auto downFor = [&](int across) {
        return std::clamp(static_cast<int>(perBlock / across), fewest, mostDown);
    };
    const int wanted = std::clamp(
        std::max(static_cast<int>(std::lround(columnsOfRows(tile) * std::sqrt(perBlock))),
                 static_cast<int>(perBlock / mostDown)),
        fewest, mostAcross);
    int best = wanted;
    for (int off = 1; off <= otherColumns; ++off)
        for (const int across : {wanted - off, wanted + off}) {
            if (across < fewest || across > mostAcross || best * downFor(best) >= enough * perBlock)
                continue;
            const int down = downFor(across);
            const double shape = static_cast<double>(across) / down;
            if (shape >= narrowest && shape <= widest && across * down <= perBlock &&
                across * down > best * downFor(best))
                best = across;
        }
    tile.samplesAcross = best;
    tile.samplesDown = downFor(best);
}

/// Samples an axis of a pixel, the mean of both axes.
double fineness(const SampleTile& tile) {
    return std::sqrt(1.0 / tile.share());
}

/// The tile, or two of them one above the other: a block has whole numbers of samples, and where
/// that leaves more than `little` of the budget unused, the upper one has one more row in every
/// block. Time then does not depend on how pixels divide the budget; what a second tile costs is
/// not worth the samples of a small one.
std::vector<SampleTile> evenly(const SampleTile& tile, double samples, double little = 0.1) {
    const double down = samplesPerBlock(tile, samples) / tile.samplesAcross;
    const double unused = 1.0 - tile.samplesDown / down;
    constexpr double worthATile = 6500.0; // samples
    const int finer = static_cast<int>(std::lround((down - tile.samplesDown) * tile.blocksHigh));
    if (unused <= little || unused * samples < worthATile || finer <= 0 ||
        finer >= tile.blocksHigh || finer * (tile.samplesDown + 1) > longestDrawing)
        return {tile};
    SampleTile upper = tile, lower = tile;
    upper.blocksHigh = finer;
    ++upper.samplesDown;
    lower.blockY += finer;
    lower.blocksHigh -= finer;
    return {upper, lower};
}

/// What another lattice's variance must be below in terms of that of the best so far. Lattices that
/// mirror each other are as good for what is as high as low, and rounding must not choose: a view
/// has one lattice, in whatever way its poses were computed.
constexpr double clearlyBetter = 1.0 - 1e-6;

/// The tile with the lattice that suits the edges best.
SampleTile bestFor(const std::vector<ImageEdge>& edges, const SampleTile& tile, int size) {
    if (edges.empty())
        return tile;
    const std::vector<ImageEdge> different = withEqualsCounted(edges, tile);
    SampleTile best = tile;
    double least = std::numeric_limits<double>::infinity();
    for (const SampleTile& lattice : latticesNear(tile, size)) {
        double variance = 0.0;
        for (const SampleTile& part : evenly(lattice, static_cast<double>(size) * size)) {
            const double share = static_cast<double>(part.blocksHigh) / tile.blocksHigh;
            variance += share * varianceOfEdges_px4(part, different, least / share);
        }
        if (variance < clearlyBetter * least) {
            least = variance;
            best = lattice;
        }
    }
    return best;
}

/// A tile for a part of an object with the tilt of rows that suits edges as the object has them:
/// those of a part are likely to go the same ways, but not farther than the part.
SampleTile tiltedFor(const std::vector<ImageEdge>& edges, const SampleTile& tile) {
    const ImageRectangle part = tile.rectangle();
    std::vector<ImageEdge> within;
    for (ImageEdge edge : edges) {
        const double times = std::max(std::abs(edge.right_px) / part.width(),
                                      std::abs(edge.down_px) / part.height());
        if (times > 1.0)
            edge.right_px /= times, edge.down_px /= times;
        within.push_back(edge);
    }
    const std::vector<ImageEdge> different = withEqualsCounted(within, tile);
    SampleTile best = tile;
    double least = std::numeric_limits<double>::infinity();
    for (const int fall : {1, -1, 0}) {
        SampleTile tilted = tile;
        tilted.fall = fall;
        const double variance = varianceOfEdges_px4(tilted, different, least);
        if (variance < clearlyBetter * least) {
            least = variance;
            best = tilted;
        }
    }
    return best;
}

/// What is this many times finer than the tile around it is drawn apart.
constexpr double refinementFrom = 2.0;
/// The same for details: a finer tile is worth its drawing the sooner the more shines from it.
constexpr double detailFrom = 1.25;
/// The same for details in a tile for details, which is made for them already.
constexpr double detailAgainFrom = 4.0;
/// Samples that all details of a group have together, in terms of those of a tile.
constexpr double samplesOfDetails = 1.0;
/// What a tile for several parts may be larger than tiles for each.
constexpr double mostWaste = 1.25;
/// Tiles cut out of one; parts beyond share the ones that grow least.
constexpr std::size_t mostCuts = 256;
/// Of the budget may be unused where parts are cut out.
constexpr double mostUnused = 0.2;

double area_px2(const ImageRectangle& r) {
    return r.empty() ? 0.0 : r.width() * r.height();
}

} // namespace

std::vector<SampleTile>
PixelAlignedStrategy::tiles(const std::vector<ObjectExtent>& objects) const {
    std::vector<SampleTile> result;
    for (const EntityGroup& group : overlappingGroups(objects))
        for (SampleTile& tile : tilesOf(group))
            result.push_back(std::move(tile));
    return result;
}

SampleTile PixelAlignedStrategy::tileFor(const ImageRectangle& extent, double samples) const {
    SampleTile tile = tileOnBlocks(extent, levelFor(extent, samples));
    chooseSamples(tile, samples, fewestSamplesPerAxis);
    tile.shearRows =
        static_cast<int>(std::lround(tile.samplesDown / (uprightSlope(tile) * tile.samplesAcross)));
    tile.fall = 1;
    return tile;
}

std::vector<SampleTile> PixelAlignedStrategy::tilesOf(const EntityGroup& group) const {
    std::vector<ImageEdge> edges;
    for (const ObjectExtent& member : group.members)
        edges.insert(edges.end(), member.edges.begin(), member.edges.end());
    SampleTile whole = bestFor(edges, tileFor(group.extent, budget()), size_);
    whole.entities = group.entities();
    std::vector<SampleTile> tiles = evenly(whole, budget(), mostUnused);
    const std::vector<Part> parts = partsOf(group);
    for (std::size_t i = 0, coarse = tiles.size(); i < coarse; ++i)
        refine(tiles, i, parts, edges, mostCuts);
    if (tiles.size() == 1)
        return evenly(tiles.front(), budget());
    return tiles;
}

std::vector<PixelAlignedStrategy::Part>
PixelAlignedStrategy::partsOf(const EntityGroup& group) const {
    std::vector<Part> parts;
    std::size_t details = 0;
    for (const ObjectExtent& member : group.members) {
        parts.push_back({member.extent, budget(), refinementFrom, refinementFrom});
        details += member.details.size();
    }
    const double ofOne =
        std::min(samplesOfDetails / static_cast<double>(std::max<std::size_t>(details, 1)), 1.0);
    for (const ObjectExtent& member : group.members)
        for (const ImageRectangle& detail : member.details)
            parts.push_back({detail, ofOne * budget(), detailFrom, detailAgainFrom});
    return parts;
}

void PixelAlignedStrategy::refine(std::vector<SampleTile>& tiles, std::size_t coarse,
                                  const std::vector<Part>& parts,
                                  const std::vector<ImageEdge>& edges, std::size_t most) const {
    // A part with a little around it, so that rounding puts none of it across the border; whole
    // cells of the coarse tile, so that every point is drawn exactly once.
    constexpr double little = 0.1; // of a cell
    const SampleTile around = tiles[coarse];
    const double finenessAround = fineness(around);
    std::vector<ImageRectangle> cells;
    std::vector<Part> finerParts;
    for (Part part : parts) {
        ImageRectangle wider = part.extent;
        wider.left -= little * around.cellWidth_px(), wider.right += little * around.cellWidth_px();
        wider.top -= little * around.cellHeight_px();
        wider.bottom += little * around.cellHeight_px();
        const ImageRectangle ofPart = around.cellsAround(wider);
        part.samples *= std::min(1.0, area_px2(ofPart) / area_px2(wider)); // what of it is here
        if (ofPart.empty() ||
            fineness(tileFor(ofPart, part.samples)) < part.finerFrom * finenessAround)
            continue;
        cells.push_back(ofPart);
        finerParts.push_back(part);
    }

    const std::vector<Enclosure> cuts = partition(cells, mostWaste, most);
    for (const Enclosure& cut : cuts) {
        double samples = 0.0, finerFrom = std::numeric_limits<double>::infinity();
        std::vector<Part> inside;
        for (const std::size_t i : cut.things) {
            Part& part = inside.emplace_back(finerParts[i]);
            samples += part.samples * area_px2(cells[i].intersectedWith(cut.rectangle)) /
                       area_px2(cells[i]);
            finerFrom = std::min(finerFrom, part.finerFrom);
            part.finerFrom = part.finerAgainFrom;
        }
        SampleTile finer = tiltedFor(edges, tileFor(cut.rectangle, std::min(samples, budget())));
        if (fineness(finer) < finerFrom * finenessAround)
            continue;
        finer.only = cut.rectangle;
        finer.entities = tiles[coarse].entities;
        tiles[coarse].leftOut.push_back(cut.rectangle);
        tiles.push_back(std::move(finer));
        refine(tiles, tiles.size() - 1, inside, edges,
               std::max<std::size_t>(most / cuts.size(), 1));
    }
}

} // namespace irsg
