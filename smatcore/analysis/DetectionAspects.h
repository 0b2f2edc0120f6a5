#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "smatcore/analysis/BackgroundClutter.h"
#include "smatcore/analysis/TargetAspect.h"

namespace smat {

/// How far a run of several loops is.
struct DetectionProgress {
    explicit DetectionProgress(const RunControl& ofRun) : control(ofRun) {}

    const RunControl& control;
    std::size_t done = 0, total = 0;
    double elapsed_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

  private:
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// A clutter of the background as a temperature difference, with its error at two standard
/// deviations.
struct ClutterOfAspect {
    double deviation_K = 0.0, error_K = 0.0;
};

/// The cases of a detection, one after the other. All that it is given must outlive it.
class DetectionAspects {
  public:
    /// Throws InputError.
    DetectionAspects(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                     const SceneFactory& scenes);

    struct Case {
        std::size_t number, drawn; ///< of the case, and of the scene
        const AnalysisCase& place;
        TargetAspect& aspect;
        ClutterOfAspect clutter; ///< of a request that measures it
    };
    /// Calls `use` for each case, in each of `drawn`, the scene with other scales. A stop ends it.
    /// `prefix` is put before the names of cases.
    void each(const std::vector<SceneDescription>& drawn, DetectionProgress& progress,
              const std::function<void(const Case&)>& use, const std::string& prefix = "");
    /// Adds what the cases warned of to the data.
    void tellWarnings();

    const DetectionScene& shared() const { return shared_; }
    TargetSight& sight() { return sight_; }
    CaseWarnings& warnings() { return warnings_; }

  private:
    AnalysisData& data_;
    const DetectionRequest& request_;
    DetectionScene shared_;
    TargetSight sight_;
    std::optional<BackgroundClutter> clutter_;
    CaseWarnings warnings_;
};

/// What was found of a case.
struct AspectRange {
    irsg::DetectionRange found;
    TargetLook look;            ///< at that range
    double sampledFrom_m = 0.0; ///< from where the target was sampled
    double error_m = 0.0;       ///< at two standard deviations; NaN where there is no bound
    double extent = 0.0;        ///< side of the target's image in pixels
    bool isResolved = false;
    /// Whether it ends because the scene refuses longer ranges, at which it may still be seen.
    bool isRefusedBeyond = false;

    /// 0 found, -1 nowhere, 1 beyond, or beyond the ranges that the scene does not refuse.
    double outcome() const;
    /// Whether the contrast ends in a step to 0 there: something hides all of the target beyond.
    bool isHiddenBeyond() const;
    /// "" for nothing.
    std::string warning() const;
};

/// Seeks the range of cases, and keeps count of what there is to warn of. The target is sampled
/// once for an aspect, from where that of the aspect before was found, and again only where it is
/// found so far from there that it matters.
class RangeSearch {
  public:
    RangeSearch(const DetectionRequest& request, TargetSight& sight)
        : request_(request), sight_(sight), wanted_(sight.wanted()) {}

    AspectRange find(TargetAspect& aspect);
    /// Adds what holds for some of the cases.
    void tell(std::vector<std::string>& warnings) const;

  private:
    /// The target sampled from where it is found, as near as matters.
    AspectRange sampled(TargetAspect& aspect);
    static bool isSampledOnceAt(TargetAspect& aspect, double range_m);
    /// Of the target's contrast, with its sign; none at a range that the scene refuses.
    std::optional<double> ratio(TargetAspect& aspect, double range_m);

    const DetectionRequest& request_;
    TargetSight& sight_;
    double wanted_;
    std::optional<double> latest_m_; ///< where the last aspect's target was found
    /// Whether one sampling of it stood for all ranges, which terrain behind it prevents.
    std::optional<bool> isSampledOnce_;
    std::size_t done_ = 0, resolved_ = 0, never_ = 0, beyond_ = 0, hidden_ = 0, full_ = 0;
    std::size_t refusedBeyond_ = 0;
    /// A range that the scene refuses: a path into the ground, say.
    struct Refused {
        double range_m = std::numeric_limits<double>::infinity();
        std::string why;
    };
    std::map<double, std::string> refused_; ///< ranges of the aspect
    Refused leastRefused_;                  ///< of the aspects whose range it may change
};

} // namespace smat
