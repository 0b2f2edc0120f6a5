#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/geometry/Entity.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Sensor.h"
#include "irsg/radiance/ScaledView.h"
#include "irsg/render/values/RenderReport.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

class Skybox;
class Terrain;

/// What there is to see, and how it is to be computed: a value.
struct Scene {
    Environment environment = Environment::vacuum();
    std::vector<Entity> entities;
    RenderSettings settings;
    /// Pictures around the eye and ground under it, added to the background; null for none.
    std::shared_ptr<const Skybox> skybox;
    std::shared_ptr<const Terrain> terrain;
};

/// Who looks, and from where.
struct SensorView {
    Sensor sensor;
    Viewpoint viewpoint;
};

/// What of a view is asked for; whatever is not asked for is not computed.
struct Wanted {
    /// The radiance image of the first band.
    bool image = false;
    /// The image is one of a window that follows edits: for the second one of a view what each
    /// pixel takes of each surface is drawn and kept, and from then on another time, temperature,
    /// spectrum or air is a sum, equal to an image within the rounding of float.
    bool followed = false;
    /// The radiometry of the objects, in double: with an image that of its samples, else from
    /// factors that are kept and drawn anew only when geometry, viewpoint, raster, transparency or
    /// N change. A report for each band.
    bool reports = false;
    /// The reports are of one of many ranges along a line of sight. The object that the sensor
    /// looks at is not drawn for each: its factors are interpolated between those of a few
    /// distances, the same for every range, so that a curve has no noise of drawings and costs few.
    /// At a single range it then differs from an image by the sampling errors of both. See
    /// RangeFactors for when; else it is drawn as without. Without effect on images.
    bool alongRange = false;
    /// Behind the reports of the bands one more of each, in the same order, of the source: what
    /// leaves the objects towards the sensor, lit as they are, with no air between and nothing
    /// behind them. Its intensity is that of contrast, and from the same drawings. A measured
    /// spectrum is taken as it was measured, at its reference distance. Without effect on
    /// images.
    bool source = false;
    /// The sums of the reports, and spectra, come with their errors (ErrorParts). Not scales.
    bool errors = false;
    /// In-band quantities are asked for in these, from the same drawings; none: in the sensor's.
    std::vector<Band> bands = {};
    /// Wavenumbers of a spectrum, cm-1, > 0, in any order; it is computed in the spectral mode,
    /// whichever is set.
    std::vector<double> wavenumbers_per_cm = {};
    /// The view as a function of these scales, in each band, or at the wavenumbers where there are
    /// any. The entities' own scales must be empty then (LogicError).
    std::vector<ScalingInput> scalings = {};
    /// Behind the view of all objects in a band one of each object alone, in their order. Without
    /// effect on spectra.
    bool scaledObjects = false;
};

struct Rendered {
    RadianceImage image; ///< "L"; with truth layers the other planes (TruthLayers.h)
    /// By band, then of the sources; of an image alone one, which says how it was drawn (windows,
    /// warnings, layers left over) and has no sums.
    std::vector<RenderReport> reports;
    IntensitySpectrum spectrum;
    std::vector<std::unique_ptr<const ScaledView>> scaled; ///< by band, or one of the spectrum
};

} // namespace irsg
