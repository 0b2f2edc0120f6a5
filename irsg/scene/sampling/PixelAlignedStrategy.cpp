#include "irsg/scene/sampling/PixelAlignedStrategy.h"

#include <cmath>

#include "irsg/scene/sampling/Uniting.h"

namespace irsg {

namespace {

/// Tiles that an extent is cut into at least: the more, the closer a window lies around its object.
constexpr double fewestTiles = 16.0;

/// The coarsest level that cuts an extent into so many tiles; whole pixels where they are enough.
int levelFor(double extent_px) {
    if (extent_px >= fewestTiles)
        return 0;
    const int level =
        static_cast<int>(std::ceil(std::log2(fewestTiles / std::max(extent_px, 1e-300))));
    return std::clamp(level, 0, SampleWindow::deepestLevel);
}

/// The slope of upright rows of samples: 3.6 degrees, within which edges count as upright. An edge
/// of any length worth counting then meets every phase of the samples.
constexpr double uprightSlope = 1.0 / 16.0;

/// The window of an extent, with sheared rows. The shear spares columns of samples: an upright edge
/// meets every phase of them. A level edge does not, so that the samples go to rows, as many in
/// all.
SampleWindow sampleWindow(const ImageRectangle& extent, int size) {
    SampleWindow window = windowOnTiles(extent, levelFor(extent.extent()));
    constexpr double fewerColumns = 0.8;
    constexpr int fewest = PixelAlignedStrategy::fewestSamplesPerAxis;
    const double perTile = static_cast<double>(size) / std::max(window.tilesWide, window.tilesHigh);
    window.samplesAcross = std::max(fewest, static_cast<int>(std::lround(fewerColumns * perTile)));
    window.samplesDown =
        std::max(fewest, static_cast<int>(perTile * perTile / window.samplesAcross));
    window.shearRows =
        static_cast<int>(std::lround(window.samplesDown / (uprightSlope * window.samplesAcross)));
    return window;
}

/// The window, or two of them one above the other: a tile has whole numbers of samples, and where
/// that leaves much of the window's size unused, the upper one has one more row in every tile.
/// Time then does not depend on how pixels divide the size; what a second window costs is not worth
/// the samples of a small one.
std::vector<SampleWindow> evenly(const SampleWindow& window, int size) {
    const double perTile = static_cast<double>(size) / std::max(window.tilesWide, window.tilesHigh);
    const double down = perTile * perTile / window.samplesAcross;
    const double unused = 1.0 - window.samplesDown / down;
    constexpr double little = 0.1, worthAWindow = 6500.0; // samples
    const int finer = static_cast<int>(std::lround((down - window.samplesDown) * window.tilesHigh));
    if (unused <= little || unused * size * size < worthAWindow || finer <= 0 ||
        finer >= window.tilesHigh)
        return {window};
    SampleWindow upper = window, lower = window;
    upper.tilesHigh = finer;
    ++upper.samplesDown;
    lower.tileY += finer;
    lower.tilesHigh -= finer;
    return {upper, lower};
}

/// The window with the lattice that suits the edges best.
SampleWindow bestFor(const std::vector<ImageEdge>& edges, const SampleWindow& window, int size) {
    if (edges.empty())
        return window;
    const std::vector<ImageEdge> different = withEqualsCounted(edges, window);
    SampleWindow best = window;
    double least = std::numeric_limits<double>::infinity();
    for (const SampleWindow& lattice : latticesNear(window, size)) {
        double variance = 0.0;
        for (const SampleWindow& part : evenly(lattice, size)) {
            const double share = static_cast<double>(part.tilesHigh) / window.tilesHigh;
            variance += share * varianceOfEdges_px4(part, different, least / share);
        }
        if (variance < least) {
            least = variance;
            best = lattice;
        }
    }
    return best;
}

/// What is this many times finer than the window around it is drawn apart.
constexpr double refinementFrom = 2.0;
/// The same for details: a finer window is worth its drawing the sooner the more shines from it.
constexpr double detailFrom = 1.25;
/// Samples that all details of a group have together, in terms of those of a window.
constexpr double samplesOfDetails = 2.0;

} // namespace

std::vector<SampleWindow>
PixelAlignedStrategy::windows(const std::vector<ZoomEntityInfo>& objects) const {
    std::vector<SampleWindow> result;
    for (const EntityGroup& group : overlappingGroups(objects))
        for (SampleWindow& window : windowsOf(group))
            result.push_back(std::move(window));
    return result;
}

std::vector<SampleWindow> PixelAlignedStrategy::windowsOf(const EntityGroup& group) const {
    std::vector<ImageEdge> edges;
    for (const ZoomEntityInfo& member : group.members)
        edges.insert(edges.end(), member.edges.begin(), member.edges.end());
    std::vector<SampleWindow> windows{bestFor(edges, sampleWindow(group.extent, size_), size_)};
    windows.front().entities = group.entities();
    refine(windows, 0, partsOf(group));
    if (windows.size() == 1)
        return evenly(windows.front(), size_);
    return windows;
}

std::vector<PixelAlignedStrategy::Part>
PixelAlignedStrategy::partsOf(const EntityGroup& group) const {
    std::vector<Part> parts;
    std::size_t details = 0;
    for (const ZoomEntityInfo& member : group.members) {
        parts.push_back({member.extent, size_, refinementFrom});
        details += member.details.size();
    }
    const double ofOne =
        std::sqrt(samplesOfDetails / static_cast<double>(std::max<std::size_t>(details, 1)));
    for (const ZoomEntityInfo& member : group.members)
        for (const ImageRectangle& detail : member.details)
            parts.push_back({detail, static_cast<int>(std::min(ofOne, 1.0) * size_), detailFrom});
    return parts;
}

void PixelAlignedStrategy::refine(std::vector<SampleWindow>& windows, std::size_t coarse,
                                  const std::vector<Part>& parts) {
    // A part with a cell of the coarse window around it, so that no sample at the border of the
    // finer one meets it; whole cells, so that every point is drawn exactly once. Parts whose
    // cells overlap become one.
    struct Cut {
        ImageRectangle cells;
        std::vector<Part> parts;
        int size;
        double finerFrom;
    };
    const SampleWindow& around = windows[coarse];
    std::vector<Cut> cuts;
    for (const Part& part : parts) {
        ImageRectangle wider = part.extent;
        wider.left -= around.cellWidth_px(), wider.right += around.cellWidth_px();
        wider.top -= around.cellHeight_px(), wider.bottom += around.cellHeight_px();
        const ImageRectangle cells = around.cellsAround(wider);
        if (!cells.empty() &&
            sampleWindow(cells, part.size).density() >= part.finerFrom * around.density())
            cuts.push_back({cells, {part}, part.size, part.finerFrom});
    }
    uniteAll(
        cuts, [](const Cut& a, const Cut& b) { return a.cells.intersects(b.cells); },
        [](Cut a, const Cut& b) {
            a.cells = a.cells.unitedWith(b.cells);
            a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
            a.size = std::max(a.size, b.size);
            a.finerFrom = std::min(a.finerFrom, b.finerFrom);
            return a;
        });

    for (Cut& cut : cuts) {
        SampleWindow finer = sampleWindow(cut.cells, cut.size);
        if (finer.density() < cut.finerFrom * windows[coarse].density())
            continue;
        finer.only = cut.cells;
        finer.entities = windows[coarse].entities;
        windows[coarse].leftOut.push_back(cut.cells);
        windows.push_back(std::move(finer));
        for (Part& part : cut.parts)
            part.finerFrom = refinementFrom;
        refine(windows, windows.size() - 1, cut.parts);
    }
}

} // namespace irsg
