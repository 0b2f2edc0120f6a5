#include "irsg/scene/antialiasing/PixelAlignedStrategy.h"

#include <bit>
#include <cmath>

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

/// A window with sheared rows. The shear spares columns of samples: an upright edge meets every
/// phase of them. A level edge does not, so that the samples go to rows, as many in all.
SampleWindow shearedWindow(const ImageRectangle& extent, int level, int size) {
    SampleWindow window = windowOnTiles(extent, level);
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

/// A window without shear whose number of samples is a power of two, so that finer windows begin at
/// a sample of it.
SampleWindow divisibleWindow(const ImageRectangle& extent, int level, int size) {
    SampleWindow window = windowOnTiles(extent, level);
    const int samples = std::max(PixelAlignedStrategy::fewestSamplesPerAxis,
                                 size / std::max(window.tilesWide, window.tilesHigh));
    window.samplesAcross = window.samplesDown =
        static_cast<int>(std::bit_floor(static_cast<unsigned>(samples)));
    return window;
}

/// A member this many times finer than its group is drawn apart.
constexpr double refinementFrom = 2.0;

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
    const int level = levelFor(group.extent.extent());
    std::vector<SampleWindow> windows{divisibleWindow(group.extent, level, size_)};
    const double density = windows.front().density();
    for (const ZoomEntityInfo& member : group.members)
        addRefinements(member, density, windows);
    if (windows.size() == 1)
        windows.front() = shearedWindow(group.extent, level, size_);

    // What two windows hold is drawn by the finer one, or by the later of equals.
    for (std::size_t i = 0; i < windows.size(); ++i) {
        windows[i].entities = group.entities();
        for (std::size_t j = 0; j < windows.size(); ++j) {
            const bool finer = windows[j].density() > windows[i].density() ||
                               (windows[j].density() == windows[i].density() && j > i);
            if (finer && windows[i].rectangle().intersects(windows[j].rectangle()))
                windows[i].leftOut.push_back(windows[j].rectangle());
        }
    }
    return windows;
}

void PixelAlignedStrategy::addRefinements(const ZoomEntityInfo& member, double density,
                                          std::vector<SampleWindow>& windows) const {
    // Tiles no smaller than the samples around them, step by step, until they fit the object.
    const int wanted = levelFor(member.extent.extent());
    for (int level = -1; level < wanted;) {
        level = std::min(wanted, static_cast<int>(std::lround(std::log2(density))));
        SampleWindow finer = divisibleWindow(member.extent, level, size_);
        if (finer.density() < refinementFrom * density)
            return;
        density = finer.density();
        windows.push_back(std::move(finer));
    }
}

} // namespace irsg
