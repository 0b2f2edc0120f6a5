#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "smatcore/analysis/TargetAspect.h"

namespace smat {

/// A number that a range depends on.
struct SensitivityName {
    std::string key;   ///< "aperture": the column is `sensitivity_aperture`
    std::string title; ///< "aperture of the optics"
};

/// What a range is looked at for: the numbers of the sensor that are not 0, its threshold, clutter,
/// then `extinction` of the atmosphere, `temperature` and `emissivity` of the target, and of
/// computed atmospheres `visibility` where it is given, `humidity` (that of the measurements, else
/// all water vapour) and `air_temperature` (of measurements, in K).
std::vector<SensitivityName> sensitivityNames(const DetectionRequest& request,
                                              const SceneDescription& scene);

/// A case at the range that was found.
struct FoundRange {
    AnalysisCase place;
    irsg::DetectionRange found;
    TargetLook look;
    double sampledFrom_m; ///< from where the target was sampled
};

/// The relative change of a range per relative change of each number, d ln R / d ln p, in their
/// order: the change of ratio or cycles with the number at that range through their change with the
/// range. Of numbers of the sensor by a central difference of 1 % with the target's contrast as it
/// is; of the extinction by that of the optical depth between target and sensor, with light and
/// background behind the target as they are (irsg::Outputs::throughDepth);
/// of temperatures in K and emissivities of the first entity by drawings with scales of 0.998 and
/// 1.002 (the emission of a material, whose reflection stays); of the atmosphere's parameters by
/// new atmospheres, with all that follows from them (path, background, reflected light, surface
/// temperatures that go with the air's), but the same clutter. NaN where no range was found. Throws
/// InputError.
class RangeSensitivity {
  public:
    RangeSensitivity(const DetectionScene& shared, const DetectionRequest& request);

    /// All but those of the atmosphere's parameters. `aspect` is that of the case.
    std::vector<double> at(const FoundRange& found, TargetAspect& aspect, AnalysisData& data,
                           CaseWarnings& warnings) const;
    /// Those, number by number. The target of a case is sampled once for all atmospheres.
    std::vector<std::vector<double>> ofAir(const std::vector<FoundRange>& all, AnalysisData& data,
                                           CaseWarnings& warnings) const;

  private:
    /// A request with one number changed, and what its sensor sees.
    struct Variant {
        explicit Variant(DetectionRequest changed) : request(std::move(changed)), sight(request) {}
        DetectionRequest request;
        TargetSight sight;
    };
    template <typename Value>
    struct BothSides {
        Value less, more;
    };

    double margin(TargetLook look) const;
    double marginIn(const SceneDescription& scene, const FoundRange& found, AnalysisData& data,
                    CaseWarnings& warnings) const;

    const DetectionScene& shared_;
    const DetectionRequest& request_;
    std::vector<BothSides<std::unique_ptr<Variant>>> variants_; ///< by number of the sensor
    std::unique_ptr<TargetSight> sight_;                        ///< of the request as it is
    BothSides<SceneDescription> temperature_, emissivity_;
};

} // namespace smat
