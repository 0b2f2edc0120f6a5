#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "irsg/radiance/ScaledView.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

/// What of a view is asked for; whatever is not asked for is not computed. It is made by the named
/// functions below, which hold what goes together and nothing else:
///
///     Outputs::image()
///     Outputs::reports({midWave, longWave}).withErrors()
///     Outputs::spectrum(wavenumbers_per_cm)
class Outputs {
  public:
    class ImageWithReports;
    class Reports;
    class OfSpectrum;
    class OfScales;

    /// The radiance image in the sensor's band, and a report of how it was drawn (windows,
    /// warnings), which has no sums.
    static Outputs image();
    /// The same of what is behind the objects, none of which is drawn: sky, ground, skybox, sun and
    /// terrain, in the apparent directions of the object that is looked at.
    static Outputs background();
    /// The same with the radiometry of the objects.
    static ImageWithReports imageWithReports();
    /// An image of a window that follows edits: for the second one of a view what each pixel takes
    /// of each surface is drawn and kept, and from then on another time, temperature, spectrum or
    /// air is a sum, equal to an image within the rounding of float.
    static Outputs followedImage();
    /// The radiometry of the objects, in double, from factors that are kept and drawn anew only
    /// when geometry, viewpoint, raster, transparency or N change: a report for each band, from the
    /// same drawings; without bands one in the sensor's.
    static Reports reports(std::vector<Band> bands = {});
    /// The radiometry of the objects at these wavenumbers, cm-1, > 0, in any order; it is computed
    /// in the spectral mode, whichever is set.
    static OfSpectrum spectrum(std::vector<double> wavenumbers_per_cm);
    /// The view as a function of these scales, in each band, without bands in the sensor's. The
    /// entities' own scales must be empty (LogicError).
    static OfScales scaledView(std::vector<ScalingInput> scalings, std::vector<Band> bands = {});
    /// The same of a spectrum().
    static Outputs scaledSpectrum(std::vector<ScalingInput> scalings,
                                  std::vector<double> wavenumbers_per_cm);

    /// The same as if the air between each object and the sensor had `depth` times its optical
    /// depth at each wavelength, > 0 (LogicError): see PathDepth.h. Objects and what is behind them
    /// are lit as they are; what is behind is seen through that air, too, and textures of skyboxes
    /// and terrain stay as they are seen.
    Outputs throughDepth(double depth) const {
        Outputs made = *this;
        made.pathDepth_ = depth;
        return made;
    }

    bool hasImage() const { return image_; }
    bool hasObjects() const { return objects_; }
    bool isFollowed() const { return followed_; }
    bool hasReports() const { return reports_; }
    bool isAlongRange() const { return alongRange_; }
    /// Of reports along a range: where the object is sampled for all of it; none: at nodes.
    std::optional<double> sampledFrom_m() const { return sampledFrom_m_; }
    bool hasSource() const { return source_; }
    /// Whether the sums come with their errors; not set: as RenderSettings::errors says.
    std::optional<bool> errors() const { return errors_; }
    bool isByObject() const { return byObject_; }
    bool isBySurface() const { return bySurface_; }
    /// None: that of the sensor.
    const std::vector<Band>& bands() const { return bands_; }
    /// Of a spectrum; none of anything else.
    const std::vector<double>& wavenumbers_per_cm() const { return wavenumbers_per_cm_; }
    const std::vector<ScalingInput>& scalings() const { return scalings_; }
    /// The optical depth of the air between objects and sensor in that of the atmosphere.
    double pathDepth() const { return pathDepth_; }
    /// Quantities in bands, not those of wavenumbers.
    bool isInBands() const { return wavenumbers_per_cm_.empty(); }

  private:
    Outputs() = default;

    bool objects_ = true, image_ = false, followed_ = false, reports_ = false, alongRange_ = false,
         source_ = false, byObject_ = false, bySurface_ = false;
    std::optional<double> sampledFrom_m_;
    double pathDepth_ = 1.0;
    std::optional<bool> errors_;
    std::vector<Band> bands_;
    std::vector<double> wavenumbers_per_cm_;
    std::vector<ScalingInput> scalings_;
};

class Outputs::ImageWithReports : public Outputs {
  public:
    /// The sums come with their errors (ErrorParts) or without, whatever the settings say.
    ImageWithReports withErrors(bool on = true) const {
        ImageWithReports made = *this;
        made.errors_ = on;
        return made;
    }

  private:
    friend class Outputs;
    explicit ImageWithReports(Outputs outputs) : Outputs(std::move(outputs)) {}
};

class Outputs::Reports : public Outputs {
  public:
    /// The reports are of one of many ranges along a line of sight. The object that the sensor
    /// looks at is not drawn for each: its factors are interpolated between those of a few
    /// distances, the same for every range, so that a curve has no noise of drawings and costs few.
    /// At a single range it then differs from an image by the sampling errors of both. See
    /// RangeGeometry for when; else it is drawn as without.
    Reports alongRange(bool on = true) const {
        Reports made = *this;
        made.alongRange_ = on;
        return made;
    }
    /// The same with one drawing for the whole line of sight, from this range, m, > 0: what is
    /// sampled there is taken to be seen from any other range, times the square of the ratio of
    /// ranges. From the range itself this is as good as a drawing; from another one it is off by up
    /// to twice the difference of the nearness (object's reach over range), which the errors hold.
    /// For a search that asks for one range and looks at many.
    Reports alongRangeFrom(double sampledAt_m) const {
        Reports made = alongRange();
        made.sampledFrom_m_ = sampledAt_m;
        return made;
    }
    /// Behind the reports of the bands one more of each, in the same order, of the source: what
    /// leaves the objects towards the sensor, lit as they are, with no air between and nothing
    /// behind them. Its intensity is that of contrast, and from the same drawings. A measured
    /// spectrum is taken as it was measured, at its reference distance.
    Reports withSource(bool on = true) const {
        Reports made = *this;
        made.source_ = on;
        return made;
    }
    /// See Outputs::throughDepth.
    Reports throughDepth(double depth) const {
        Reports made = *this;
        made.pathDepth_ = depth;
        return made;
    }
    /// The sums of each object come with those of its surfaces by their codes
    /// (ObjectRadiometry::surfaces).
    Reports bySurface(bool on = true) const {
        Reports made = *this;
        made.bySurface_ = on;
        return made;
    }
    /// The sums come with their errors (ErrorParts) or without, whatever the settings say.
    Reports withErrors(bool on = true) const {
        Reports made = *this;
        made.errors_ = on;
        return made;
    }

  private:
    friend class Outputs;
    explicit Reports(Outputs outputs) : Outputs(std::move(outputs)) {}
};

class Outputs::OfSpectrum : public Outputs {
  public:
    /// Its numbers come with their errors (ErrorParts) or without, whatever the settings say.
    OfSpectrum withErrors(bool on = true) const {
        OfSpectrum made = *this;
        made.errors_ = on;
        return made;
    }

  private:
    friend class Outputs;
    explicit OfSpectrum(Outputs outputs) : Outputs(std::move(outputs)) {}
};

class Outputs::OfScales : public Outputs {
  public:
    /// Behind the view of all objects in a band one of each object alone, in their order.
    OfScales byObject() const {
        OfScales made = *this;
        made.byObject_ = true;
        return made;
    }

  private:
    friend class Outputs;
    explicit OfScales(Outputs outputs) : Outputs(std::move(outputs)) {}
};

} // namespace irsg
