#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "irsg/sensor/DetectionRange.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/DetectionRequest.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/analysis/TargetSight.h"

namespace smat {

class BackgroundClutter;

/// The surfaces of an object that do not count.
struct LeftOut {
    std::set<int> temperatures, materials;

    bool has(const irsg::SurfaceRadiometry& surface) const {
        return temperatures.contains(surface.temperature) || materials.contains(surface.material);
    }
};

/// What all aspects of a detection share: the cases of a polar plot before the sensor.
struct DetectionScene {
    /// Makes it of the settings of `data` and tells it what there is to warn of. Throws InputError.
    DetectionScene(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                   const SceneFactory& scenes);
    /// Throws InputError for what a run would refuse of the first aspect at a range.
    void check(double range_m) const;

    const RenderDoor& door;
    AnalysisPlan plan;
    SceneDescription scene;
    CasePlacer placer;
    std::vector<LeftOut> leftOut; ///< by entity; none where nothing is left out
};

/// One aspect at any range. All that it is given must outlive it.
class TargetAspect {
  public:
    /// `scene` is that of `shared`, perhaps with other scales.
    TargetAspect(const DetectionScene& shared, const SceneDescription& scene, TargetSight& sight,
                 AnalysisCase one, AnalysisData& data, CaseWarnings& warnings);

    /// Takes the clutter of the background about the target, at the range of the case, as noise
    /// from now on. Returns it as an apparent temperature difference, K, with its error at two
    /// standard deviations. Throws InputError.
    std::pair<double, double> takeClutter(BackgroundClutter& clutter);

    /// How far the target reaches from its reference point, m; at ranges below `drawnBelow_m` it is
    /// drawn for each of them.
    double reach_m() const;
    double drawnBelow_m() const;
    /// From now on the target is sampled from this range alone and taken to be seen so from any
    /// other (irsg::Outputs::Reports::alongRangeFrom).
    void sampleFrom(double range_m);

    /// Throws InputError for a range that the scene refuses.
    TargetLook at(double range_m, bool withErrors);
    /// The same through air of so many times the optical depth of the atmosphere's, between target
    /// and sensor (irsg::Outputs::throughDepth), without errors. It is not kept.
    TargetLook throughDepth(double range_m, double depth);
    /// At the range that was found, interpolated on the grid; the relative error is that of the
    /// nearest range there.
    TargetLook between(const irsg::DetectionRange& found);
    /// The largest TargetLook::alongRangeReach_m of what that is interpolated between.
    double alongRangeReach_m(const irsg::DetectionRange& found);

  private:
    /// Whether there is no other object, which would count with it.
    bool isLone() const;
    TargetLook rendered(double range_m, const irsg::Outputs::Reports& outputs);

    const DetectionScene& shared_;
    const SceneDescription& scene_;
    TargetSight& sight_;
    AnalysisCase case_;
    AnalysisData& data_;
    CaseWarnings& warnings_;
    std::optional<double> sampledFrom_m_;
    double clutter_W_m2_sr_ = 0.0, clutterError_W_m2_sr_ = 0.0;
    std::map<std::pair<double, bool>, TargetLook> known_;
};

} // namespace smat
