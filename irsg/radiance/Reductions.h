#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/render/sampling/FrameReduction.h"
#include "irsg/render/values/RenderReport.h"

namespace irsg {

/// What each object of a view sends in one output of a sampling, and their sum. Names, ranges and
/// everything that does not come from factors are left alone.
struct ObjectSums {
    std::vector<ObjectRadiometry> objects; ///< by entity
    ObjectRadiometry all;                  ///< sums over them, each at its own range
};

/// Radiometry of the objects of a view, in each output. `ranges_m`: by entity, sensor to reference
/// point. `varying`: by output, the number of its background in the view's layout, or -1 for one
/// that is uniform; what objects hide of a background that varies over the frame is the sum over
/// their own pixels.
/// `light`: between surfaces, or null. `bySurface`: with the sums of each pair of codes.
std::vector<ObjectSums> objectSums(const ViewGeometry& view, SurfaceRadianceTable& radiances,
                                   SceneLight* light, const SurfaceRows& rows,
                                   const std::vector<double>& ranges_m,
                                   const std::vector<int>& varying, bool bySurface = false);

/// Of which rows sums are.
enum class SummedRows { all, lobes };

/// The same of each contrast of a view, in all rows or only in those of lobes: what directional
/// surfaces send beside Lambertian ones.
std::vector<std::vector<ObjectSums>>
sublatticeDifferenceSums(const ViewGeometry& view, SurfaceRadianceTable& radiances,
                         SceneLight* light, const SurfaceRows& rows,
                         const std::vector<double>& ranges_m, const std::vector<int>& varying,
                         SummedRows of = SummedRows::all);

/// Adds the pixels of a view to a frame. `light`: between surfaces, or null.
void addPixels(const PixelGeometry& pixels, int width_px, SurfaceRadianceTable& radiances,
               SceneLight* light, FrameReduction& frame);

/// What light between surfaces gives a point source at unit distance, W sr-1.
double lightOfPoint(const PointGeometry& atUnitDistance, const SurfaceRows& rows,
                    SceneLight& light);

/// Adds a point source of unit distance (see addPointToView) to its pixel. `light`: between
/// surfaces, or null.
void addPointToPixel(const PointGeometry& atUnitDistance, const SurfaceRows& rows,
                     const PointPlace& place, SurfaceRadianceTable& radiances, SceneLight* light,
                     FrameReduction& frame);

} // namespace irsg
