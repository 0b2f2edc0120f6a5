#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiance/ScaledView.h"
#include "irsg/scene/Irsg.h"
#include "smatcore/data/OwnState.h"

namespace smat {

/// A scene as a renderer takes it: checked, loaded, in radians.
struct SceneDescription {
    std::vector<irsg::Entity> entities; ///< the first is the target
    /// Entities whose database holds edits that its file does not.
    std::set<std::size_t> unsavedDatabases;
    irsg::Environment environment;
    irsg::Sensor sensor;           ///< with the first of its bands
    std::vector<irsg::Band> bands; ///< of the sensor, in order; empty: that of `sensor` alone
    irsg::RenderSettings render;
    std::shared_ptr<const irsg::Skybox> skybox;   ///< null for none
    std::shared_ptr<const irsg::Terrain> terrain; ///< null for none
    std::vector<std::string> remarks;             ///< what loading had to say, each said once
    /// What entities do by themselves, in the states above already; empty: all do the same.
    std::vector<OwnState> own;
    /// What was drawn of scaling files: "temperature 5 (exhaust): 1.03, uniform, 0.9 to 1.1".
    std::vector<std::string> drawnScales;

    OwnState ownOf(std::size_t entity) const {
        return entity < own.size() ? own[entity] : OwnState();
    }
    std::vector<irsg::Band> allBands() const {
        return bands.empty() ? std::vector<irsg::Band>{sensor.band} : bands;
    }
};

/// Gives a renderer all of a scene but its entities and where it is seen from.
void setView(irsg::Irsg& irsg, const SceneDescription& scene);

/// What smatcore asks of a renderer: the seam between analyses and irsg::Irsg, so that analyses are
/// tested against closed forms without OpenGL. May be used from any one thread at a time.
class ImageSource {
  public:
    virtual ~ImageSource() = default;

    /// Takes a scene. Throws InputError with every diagnostic where it cannot be drawn.
    virtual void configure(const SceneDescription& scene) = 0;
    /// Takes the sensor, the environment and the settings of a scene, in which stand the entities
    /// that it already holds; their poses and states stay undefined until they are set.
    virtual void setView(const SceneDescription& scene) { configure(scene); }
    /// Reference point of an entity in its own model axes.
    virtual irsg::Vec3 referencePointInModel(std::size_t entity) = 0;
    virtual void setPose(std::size_t entity, const irsg::Pose& pose) = 0;
    virtual void setState(std::size_t entity, const irsg::EntityState& state) = 0;
    virtual void setViewpoint(const irsg::Viewpoint& viewpoint) = 0;

    virtual irsg::RenderedImage render() = 0;
    /// The same with the errors of its sums, where the source knows them.
    virtual irsg::RenderedImage renderWithErrors() { return render(); }
    /// The same with a report that says how the image was drawn and need not have sums: for callers
    /// that measure() several bands together.
    virtual irsg::RenderedImage renderImage() { return render(); }
    /// Says what the pixels of render()'s image are made of: called with a column and a row, the
    /// top left pixel is 0, 0. Of what is set at present; it must not outlive this source.
    virtual std::function<irsg::PixelExplanation(int x, int y)> explainer() {
        throw irsg::LogicError("this source does not explain pixels");
    }
    virtual irsg::RenderReport measure() = 0;
    /// A report for each of these bands, in place of the sensor's own, from the same drawing.
    virtual std::vector<irsg::RenderReport> measure(const std::vector<irsg::Band>& bands) = 0;
    /// The same at one of many ranges along a line of sight, which a source may know from few of
    /// them (irsg::Wanted::alongRange).
    virtual std::vector<irsg::RenderReport>
    measureAlongRange(const std::vector<irsg::Band>& bands) {
        return measure(bands);
    }
    using Reports = std::vector<irsg::RenderReport>;
    struct Measure {
        std::vector<irsg::Band> bands;
        bool alongRange = false;
        /// Behind the reports of the bands those of the source (irsg::Wanted::source).
        bool source = false;
        /// The sums have their errors, where the source knows them.
        bool errors = false;
    };
    /// Begins measure(), or measureAlongRange(), of what is set at present: drawing goes on while
    /// the caller sets the next case. Called once, the result waits for the reports; it must not
    /// outlive this source. LogicError for the source of one that does not know it.
    virtual std::function<Reports()> beginMeasure(const Measure& wanted) {
        if (wanted.source)
            throw irsg::LogicError("this image source does not measure without air");
        return [reports = wanted.alongRange ? measureAlongRange(wanted.bands)
                                            : measure(wanted.bands)] { return reports; };
    }
    /// True where beginMeasure() returns before all is drawn, so that it is worth beginning the
    /// next case before this one is finished.
    virtual bool drawsBeside() const { return false; }
    virtual irsg::IntensitySpectrum
    measureSpectrum(const std::vector<double>& wavenumbers_per_cm) = 0;
    /// The same with the errors of its numbers, where the source knows them.
    virtual irsg::IntensitySpectrum
    measureSpectrumWithErrors(const std::vector<double>& wavenumbers_per_cm) {
        return measureSpectrum(wavenumbers_per_cm);
    }

    /// The view as a function of scales: in the sensor's band, or, with wavenumbers, per
    /// wavenumber.
    virtual std::unique_ptr<const irsg::ScaledView>
    scaledView(const std::vector<irsg::ScalingInput>& inputs,
               const std::vector<double>& wavenumbers_per_cm) = 0;
    /// The view in each of these bands, in place of the sensor's own, from the same drawing.
    virtual std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledViews(const std::vector<irsg::ScalingInput>& inputs,
                const std::vector<irsg::Band>& bands) = 0;
    /// The same, and in each band behind the view of all objects that of each alone, in their
    /// order. An input of no entity (-1) scales nothing.
    virtual std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledObjects(const std::vector<irsg::ScalingInput>& /*inputs*/,
                  const std::vector<irsg::Band>& /*bands*/) {
        throw irsg::LogicError("this image source does not tell scales of objects");
    }

    virtual std::string rendererDescription() = 0;
    /// Time spent inside the renderer by stage since the last reset.
    virtual irsg::StageTimes stageTimes() const = 0;
    virtual void resetStageTimes() = 0;
};

/// The infrared scene generator behind the seam. Throws InputError where this machine has no
/// OpenGL.
std::unique_ptr<ImageSource> makeIrsgImageSource();

} // namespace smat
