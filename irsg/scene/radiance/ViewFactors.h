#pragma once

#include <cstddef>
#include <vector>

#include "irsg/scene/radiance/FactorField.h"
#include "irsg/scene/radiance/Fronts.h"
#include "irsg/scene/radiance/SurfaceRows.h"
#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/FrameBackground.h"
#include "irsg/scene/view/PixelGrid.h"

namespace irsg {

/// Where the numbers of an entry lie that is summed over a whole view: coverage and each drawn
/// factor, weighted with the solid angle of their pixels (sr), then the same times cos(off-axis),
/// then the coverage in pixels, then for every background that varies over the frame the coverage
/// times its radiance, W m-2, without and with the cosine.
struct ViewLayout {
    std::size_t factorCount = 0;
    std::size_t backgrounds = 0;

    std::size_t coverage() const { return 0; }
    std::size_t factor(std::size_t f) const { return 1 + f; }
    /// Of a number above, the one with the cosine.
    std::size_t withCosine(std::size_t number) const { return number + factorCount + 1; }
    std::size_t pixels() const { return 2 * (factorCount + 1); }
    std::size_t background(std::size_t k) const { return pixels() + 1 + 2 * k; }
    std::size_t backgroundCosine(std::size_t k) const { return background(k) + 1; }
    std::size_t width() const { return background(backgrounds); }
};

/// The factors of a view, summed over all its pixels.
struct ViewFactors {
    ViewLayout layout;
    FactorField<double> field; ///< of one cell
    int layersLeftOver = 0;
};

/// Sums the factors of a view, or of each of its pixels, on all cores; the sums do not depend on
/// their number. What is in front has the numbers of `fronts`.
class FactorSums {
  public:
    /// `varying`: backgrounds that are not uniform. All must live as long.
    FactorSums(const Sensor& sensor, const SurfaceRows& rows, Fronts& fronts,
               std::size_t factorCount, std::vector<const FrameBackground*> varying = {});

    /// To the sums of the view.
    void addToView(const SampleWindow& window, const FactorSamples& samples, ViewFactors& view);
    ViewFactors emptyView() const;

    /// To the sums of the pixels, row by row: coverage and each drawn factor, as parts of a pixel.
    void addToPixels(const SampleWindow& window, const FactorSamples& samples,
                     FactorField<float>& pixels);
    FactorField<float> emptyPixels() const;

  private:
    template <std::size_t Factors>
    void addFactorsToView(const SampleWindow& window, const FactorSamples& samples,
                          ViewFactors& view);

    int width_px_, height_px_;
    PixelGrid grid_;
    const SurfaceRows& rows_;
    Fronts& fronts_;
    ViewLayout layout_;
    std::vector<const FrameBackground*> varying_;
};

/// The pixel of a point source and what it is to it.
struct PointPlace {
    int x = 0, y = 0;
    double distance_m = 0.0, solidAngle_sr = 0.0, cosOffAxis = 1.0;
};

/// A field of one source at unit distance (coverage and factors in sr m2, by drawn row), seen from
/// farther away in the middle of one pixel, added to a view.
void addPointToView(const FactorField<double>& atUnitDistance_sr_m2, const SurfaceRows& rows,
                    const PointPlace& place, const std::vector<const FrameBackground*>& varying,
                    ViewFactors& view);

} // namespace irsg
