#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/render/sampling/SampleTile.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Where the numbers of an entry lie that is summed over a whole view: coverage and each drawn
/// factor, weighted with the solid angle of their pixels (sr), then the same times cos(off-axis),
/// then the coverage in pixels, then for every background that varies over the frame the coverage
/// times its radiance, W m-2, without and with the cosine.
struct ViewLayout {
    std::size_t factorCount = 0;
    std::size_t backgrounds = 0;

    static constexpr std::size_t coverage() { return 0; }
    std::size_t factor(std::size_t f) const { return 1 + f; }
    /// Of a number above, the one with the cosine.
    std::size_t withCosine(std::size_t number) const { return number + factorCount + 1; }
    std::size_t pixels() const { return 2 * (factorCount + 1); }
    std::size_t background(std::size_t k) const { return pixels() + 1 + 2 * k; }
    std::size_t backgroundCosine(std::size_t k) const { return background(k) + 1; }
    std::size_t width() const { return background(backgrounds); }
};

/// The factors of a view, summed over all its pixels.
struct ViewGeometry {
    ViewLayout layout;
    GeometryBuffer<double> field; ///< of one cell
    LightSums light;              ///< of receivers of light, where surfaces light each other
    int layersLeftOver = 0;
    /// The same sums with signs, by which interleaved lattices of the samples differ
    /// (SublatticeDifferences): what the error of the sums follows from; the last is what
    /// interpolation between distances is likely to leave wrong (RangeGeometry). None where nobody
    /// asked for it.
    std::vector<ViewGeometry> sublatticeDifferences = {};
};

/// The factors of each pixel: coverage and each drawn factor, as parts of a pixel, and the
/// receivers of light in it.
struct PixelGeometry {
    GeometryBuffer<float> field;
    GeometryBuffer<float> light; ///< of width 1, its rows numbered by `receivers`
    ReceiverRows receivers;
};

/// Sums the factors of a view, or of each of its pixels, on all cores; the sums do not depend on
/// their number. What is in front has the numbers of `occluderStacks`.
class GeometrySums {
  public:
    /// `varying`: backgrounds that are not uniform. All must live as long.
    GeometrySums(const Sensor& sensor, const SurfaceRows& rows, OccluderStacks& occluderStacks,
                 std::size_t factorCount, std::vector<const FrameBackground*> varying = {},
                 std::shared_ptr<const LightExchange> exchange = nullptr,
                 bool withSublatticeDifferences = false);

    /// To the sums of the view.
    void addToView(const SampleTile& tile, const GeometrySamples& samples, ViewGeometry& view);
    ViewGeometry emptyView() const;

    /// To the sums of the pixels, row by row: coverage and each drawn factor, as parts of a pixel.
    void addToPixels(const SampleTile& tile, const GeometrySamples& samples, PixelGeometry& pixels);
    PixelGeometry emptyPixels() const;

  private:
    template <std::size_t Factors>
    void addGeometryToView(const SampleTile& tile, const GeometrySamples& samples,
                           ViewGeometry& view);

    int width_px_, height_px_;
    PixelGrid grid_;
    const SurfaceRows& rows_;
    OccluderStacks& occluderStacks_;
    ViewLayout layout_;
    std::vector<const FrameBackground*> varying_;
    std::shared_ptr<const LightExchange> exchange_;
    bool withSublatticeDifferences_;
};

/// The pixel of a point source, with its solid angle, and the source's own distance and cosine.
struct PointPlace {
    int x = 0, y = 0;
    double distance_m = 0.0, solidAngle_sr = 0.0, cosOffAxis = 1.0;
    double cosineShare = 1.0; ///< that cosine over the one of the pixel's centre
};

/// Factors of one source at unit distance: coverage and factors in sr m2, in the one cell of a
/// field, and its receivers of light likewise, by drawn row.
struct PointGeometry {
    GeometryBuffer<double> sums_sr_m2;
    LightSums light_sr_m2;
    std::vector<PointGeometry> sublatticeDifferences = {}; ///< see ViewGeometry
};

/// Such a source, seen from farther away in the middle of one pixel, added to a view.
void addPointToView(const PointGeometry& atUnitDistance, const SurfaceRows& rows,
                    const PointPlace& place, const std::vector<const FrameBackground*>& varying,
                    ViewGeometry& view);

} // namespace irsg
