#include "irsg/render/sampling/PixelAlignedStrategy.h"

#include <cmath>
#include <limits>

#include "irsg/render/sampling/Partition.h"

namespace irsg {

namespace {

/// Tiles that the longer side of an extent is cut into at least: the more, the closer a window lies
/// around its object. Fewer where there are few samples.
double fewestTiles(double samples) {
    return std::clamp(std::sqrt(samples) / 6.0, 6.0, 16.0);
}
/// The same for the shorter side, as long as every tile keeps this many samples of the budget.
constexpr double fewestTilesAcross = 8.0, enoughPerTile = 16.0;

/// The coarsest level that cuts an extent into so many tiles; whole pixels where they are enough.
int levelFor(const ImageRectangle& extent, double samples) {
    int level = 0;
    if (const double extent_px = extent.extent(); extent_px < fewestTiles(samples))
        level = static_cast<int>(
            std::ceil(std::log2(fewestTiles(samples) / std::max(extent_px, 1e-300))));
    constexpr double mostTiles = 480.0; // along the longer side: four samples of each fit a drawing
    const double shorter_px = std::min(extent.width(), extent.height());
    const auto tiles = [](double side_px, int ofLevel) {
        return std::ldexp(side_px, ofLevel) + 1.0;
    };
    while (level < SampleWindow::deepestLevel &&
           std::ldexp(shorter_px, level) < fewestTilesAcross &&
           tiles(extent.extent(), level + 1) <= mostTiles &&
           samples >=
               enoughPerTile * tiles(extent.width(), level + 1) * tiles(extent.height(), level + 1))
        ++level;
    return std::clamp(level, 0, SampleWindow::deepestLevel);
}

/// Columns of the first lattice in terms of those of a square one: the shear spares columns of
/// samples, as an upright edge meets every phase of them. A level edge does not, so that the
/// samples go to rows, as many in all.
constexpr double fewerColumns = 0.8;

/// The slope of upright rows of samples: 3.6 degrees, within which edges count as upright. An edge
/// of any length worth counting then meets every phase of the samples. Less in upright windows, of
/// which a shear must not be most.
double uprightSlope(const SampleWindow& window) {
    constexpr double steepest = 1.0 / 16.0, mostOfWidth = 0.125;
    return std::min(steepest, mostOfWidth * window.tilesWide / window.tilesHigh);
}

/// The same in flat windows, whose long level edges want rows yet more.
double columnsOfRows(const SampleWindow& window) {
    constexpr double flatFrom = 2.0;
    const double flatness = static_cast<double>(window.tilesWide) / window.tilesHigh;
    return fewerColumns * std::pow(std::min(flatFrom / flatness, 1.0), 0.25);
}

/// What a budget gives each tile of a window.
double samplesPerTile(const SampleWindow& window, double samples) {
    return samples / (static_cast<double>(window.tilesWide) * window.tilesHigh);
}

/// Greatest side that a drawing should have, samples.
constexpr int longestDrawing = 2048;

/// Columns and rows of samples in every tile: of the whole numbers near the wanted shape those that
/// use the budget, as far as one drawing holds them; at least `fewest`.
void chooseSamples(SampleWindow& window, double samples, int fewest) {
    constexpr int otherColumns = 3;
    constexpr double enough = 0.9; // of the budget: nearer shapes are better then
    const double shapeWanted = columnsOfRows(window) * columnsOfRows(window);
    const double narrowest = 0.55 * shapeWanted, widest = 2.2 * shapeWanted; // columns to rows
    const double perTile = samplesPerTile(window, samples);
    const double ofShear = uprightSlope(window) * window.tilesHigh;
    const int mostAcross =
        std::max(fewest, static_cast<int>(longestDrawing / (window.tilesWide + ofShear)));
    const int mostDown = std::max(fewest, longestDrawing / window.tilesHigh);
    const auto downFor = [&](int across) {
        return std::clamp(static_cast<int>(perTile / across), fewest, mostDown);
    };
    const int wanted = std::clamp(
        std::max(static_cast<int>(std::lround(columnsOfRows(window) * std::sqrt(perTile))),
                 static_cast<int>(perTile / mostDown)),
        fewest, mostAcross);
    int best = wanted;
    for (int off = 1; off <= otherColumns; ++off)
        for (const int across : {wanted - off, wanted + off}) {
            if (across < fewest || across > mostAcross || best * downFor(best) >= enough * perTile)
                continue;
            const int down = downFor(across);
            const double shape = static_cast<double>(across) / down;
            if (shape >= narrowest && shape <= widest && across * down <= perTile &&
                across * down > best * downFor(best))
                best = across;
        }
    window.samplesAcross = best;
    window.samplesDown = downFor(best);
}

/// Samples an axis of a pixel, the mean of both axes.
double fineness(const SampleWindow& window) {
    return std::sqrt(1.0 / window.share());
}

/// The window, or two of them one above the other: a tile has whole numbers of samples, and where
/// that leaves more than `little` of the budget unused, the upper one has one more row in every
/// tile. Time then does not depend on how pixels divide the budget; what a second window costs is
/// not worth the samples of a small one.
std::vector<SampleWindow> evenly(const SampleWindow& window, double samples, double little = 0.1) {
    const double down = samplesPerTile(window, samples) / window.samplesAcross;
    const double unused = 1.0 - window.samplesDown / down;
    constexpr double worthAWindow = 6500.0; // samples
    const int finer = static_cast<int>(std::lround((down - window.samplesDown) * window.tilesHigh));
    if (unused <= little || unused * samples < worthAWindow || finer <= 0 ||
        finer >= window.tilesHigh || finer * (window.samplesDown + 1) > longestDrawing)
        return {window};
    SampleWindow upper = window, lower = window;
    upper.tilesHigh = finer;
    ++upper.samplesDown;
    lower.tileY += finer;
    lower.tilesHigh -= finer;
    return {upper, lower};
}

/// What another lattice's variance must be below in terms of that of the best so far. Lattices that
/// mirror each other are as good for what is as high as low, and rounding must not choose: a view
/// has one lattice, in whatever way its poses were computed.
constexpr double clearlyBetter = 1.0 - 1e-6;

/// The window with the lattice that suits the edges best.
SampleWindow bestFor(const std::vector<ImageEdge>& edges, const SampleWindow& window, int size) {
    if (edges.empty())
        return window;
    const std::vector<ImageEdge> different = withEqualsCounted(edges, window);
    SampleWindow best = window;
    double least = std::numeric_limits<double>::infinity();
    for (const SampleWindow& lattice : latticesNear(window, size)) {
        double variance = 0.0;
        for (const SampleWindow& part : evenly(lattice, static_cast<double>(size) * size)) {
            const double share = static_cast<double>(part.tilesHigh) / window.tilesHigh;
            variance += share * varianceOfEdges_px4(part, different, least / share);
        }
        if (variance < clearlyBetter * least) {
            least = variance;
            best = lattice;
        }
    }
    return best;
}

/// A window for a part of an object with the tilt of rows that suits edges as the object has them:
/// those of a part are likely to go the same ways, but not farther than the part.
SampleWindow tiltedFor(const std::vector<ImageEdge>& edges, const SampleWindow& window) {
    const ImageRectangle part = window.rectangle();
    std::vector<ImageEdge> within;
    for (ImageEdge edge : edges) {
        const double times = std::max(std::abs(edge.right_px) / part.width(),
                                      std::abs(edge.down_px) / part.height());
        if (times > 1.0)
            edge.right_px /= times, edge.down_px /= times;
        within.push_back(edge);
    }
    const std::vector<ImageEdge> different = withEqualsCounted(within, window);
    SampleWindow best = window;
    double least = std::numeric_limits<double>::infinity();
    for (const int fall : {1, -1, 0}) {
        SampleWindow tilted = window;
        tilted.fall = fall;
        const double variance = varianceOfEdges_px4(tilted, different, least);
        if (variance < clearlyBetter * least) {
            least = variance;
            best = tilted;
        }
    }
    return best;
}

/// Samples of pixels of a window, beyond which a sum over them needs no more than it has by the
/// budget, or by one in each pixel.
constexpr double enoughForASum = 98'304.0;
/// What is this many times finer than the window around it is drawn apart.
constexpr double refinementFrom = 2.0;
/// The same for details: a finer window is worth its drawing the sooner the more shines from it.
constexpr double detailFrom = 1.25;
/// The same for details in a window for details, which is made for them already.
constexpr double detailAgainFrom = 4.0;
/// Samples that all details of a group have together, in terms of those of a window.
constexpr double samplesOfDetails = 1.0;
/// What a window for several parts may be larger than windows for each.
constexpr double mostWaste = 1.25;
/// Windows cut out of one; parts beyond share the ones that grow least.
constexpr std::size_t mostCuts = 256;
/// Of the budget may be unused where parts are cut out.
constexpr double mostUnused = 0.2;

double area_px2(const ImageRectangle& r) {
    return r.empty() ? 0.0 : r.width() * r.height();
}

} // namespace

std::vector<SampleWindow>
PixelAlignedStrategy::windows(const std::vector<ZoomEntityInfo>& objects) const {
    std::vector<SampleWindow> result;
    for (const EntityGroup& group : overlappingGroups(objects))
        for (SampleWindow& window : windowsOf(group))
            result.push_back(std::move(window));
    return result;
}

std::vector<SampleWindow>
PixelAlignedStrategy::windowsOfSums(const std::vector<ZoomEntityInfo>& objects) const {
    PixelAlignedStrategy ofSums(size_);
    ofSums.isOfSums_ = true;
    return ofSums.windows(objects);
}

SampleWindow PixelAlignedStrategy::windowFor(const ImageRectangle& extent, double samples) const {
    SampleWindow window = windowOnTiles(extent, levelFor(extent, samples));
    constexpr int fewest = fewestSamplesPerAxis;
    const double tiles = static_cast<double>(window.tilesWide) * window.tilesHigh;
    if (isOfSums_)
        chooseSamples(window, std::max(samples, std::min(fewest * fewest * tiles, enoughForASum)),
                      1);
    else
        chooseSamples(window, samples, fewest);
    window.shearRows = static_cast<int>(
        std::lround(window.samplesDown / (uprightSlope(window) * window.samplesAcross)));
    window.fall = 1;
    return window;
}

std::vector<SampleWindow> PixelAlignedStrategy::windowsOf(const EntityGroup& group) const {
    std::vector<ImageEdge> edges;
    for (const ZoomEntityInfo& member : group.members)
        edges.insert(edges.end(), member.edges.begin(), member.edges.end());
    SampleWindow whole = bestFor(edges, windowFor(group.extent, budget()), size_);
    whole.entities = group.entities();
    std::vector<SampleWindow> windows = evenly(whole, budget(), mostUnused);
    const std::vector<Part> parts = partsOf(group);
    for (std::size_t i = 0, coarse = windows.size(); i < coarse; ++i)
        refine(windows, i, parts, edges, mostCuts);
    if (windows.size() == 1)
        return evenly(windows.front(), budget());
    return windows;
}

std::vector<PixelAlignedStrategy::Part>
PixelAlignedStrategy::partsOf(const EntityGroup& group) const {
    std::vector<Part> parts;
    std::size_t details = 0;
    for (const ZoomEntityInfo& member : group.members) {
        parts.push_back({member.extent, budget(), refinementFrom, refinementFrom});
        details += member.details.size();
    }
    const double ofOne =
        std::min(samplesOfDetails / static_cast<double>(std::max<std::size_t>(details, 1)), 1.0);
    for (const ZoomEntityInfo& member : group.members)
        for (const ImageRectangle& detail : member.details)
            parts.push_back({detail, ofOne * budget(), detailFrom, detailAgainFrom});
    return parts;
}

void PixelAlignedStrategy::refine(std::vector<SampleWindow>& windows, std::size_t coarse,
                                  const std::vector<Part>& parts,
                                  const std::vector<ImageEdge>& edges, std::size_t most) const {
    // A part with a little around it, so that rounding puts none of it across the border; whole
    // cells of the coarse window, so that every point is drawn exactly once.
    constexpr double little = 0.1; // of a cell
    const SampleWindow around = windows[coarse];
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
            fineness(windowFor(ofPart, part.samples)) < part.finerFrom * finenessAround)
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
        SampleWindow finer =
            tiltedFor(edges, windowFor(cut.rectangle, std::min(samples, budget())));
        if (fineness(finer) < finerFrom * finenessAround)
            continue;
        finer.only = cut.rectangle;
        finer.entities = windows[coarse].entities;
        windows[coarse].leftOut.push_back(cut.rectangle);
        windows.push_back(std::move(finer));
        refine(windows, windows.size() - 1, inside, edges,
               std::max<std::size_t>(most / cuts.size(), 1));
    }
}

} // namespace irsg
