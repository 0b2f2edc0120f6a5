#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "smatcore/analysis/PlacedCase.h"

namespace smat {

/// One of the ways to calculate a scene: windows or samples a pixel, the bins of computed air or
/// wideband-ck, rows of the background, and what of the light is left out.
struct CalculationConfiguration {
    irsg::RenderSettings render;
    int bins_per_cm = 0; ///< of computed air, 1, 5 or 15; 0: as it is

    static CalculationConfiguration of(const SceneDescription& scene) {
        return {scene.settings, 0};
    }
    SceneDescription applied(const SceneDescription& scene) const;
    /// "windows of 256 samples a side, spectral in bins of 5 cm-1, background of 1 row". The air is
    /// told where there is some in `scene`, the background where the environment gives it.
    std::string words(const SceneDescription& scene) const;
    bool operator==(const CalculationConfiguration&) const = default;
};

/// True where computed air with bins answers for every band, so that
/// CalculationConfiguration::bins_per_cm makes a difference.
bool hasBins(const SceneDescription& scene);

/// Seconds that a case with so many samples takes this way on a machine that draws in software,
/// `linesPerCase` of whose lines of sight differ from those of other cases: an order, not a
/// promise, so that what is chosen by it is no matter of the day. See docs/errors.md.
double modelledCost_s(double samples, const CalculationConfiguration& configuration,
                      const SceneDescription& scene, double linesPerCase = 1.0);

/// How wrong the numbers of some views are said to be, as parts of intensity and contrast: the
/// largest over views and bands, by cause and of their sum. A contrast below a tenth of the largest
/// of all views counts as that tenth.
struct StatedErrors {
    double sampling = 0.0, air = 0.0, background = 0.0, sum = 0.0;
};

/// A few views of a scene in any of the ways: what --target-error and frontier know of it. The
/// numbers of a view in a way are asked for once.
class ProbedViews {
  public:
    /// View i of `views` is what `place` makes of the scene, calculated in some way. `alongRange`:
    /// they are of one line of sight (irsg::Outputs::Reports::alongRange).
    using Place = std::function<PlacedCase(const SceneDescription& scene, std::size_t view)>;
    ProbedViews(RenderDoor door, const SceneDescription& scene, std::size_t views, bool alongRange,
                Place place);

    std::size_t count() const { return views_; }
    const SceneDescription& scene() const { return scene_; }

    using Reports = std::vector<irsg::RenderReport>;
    /// By view: a report for each band, with errors where `errors` and the renderer knows them.
    std::vector<Reports> measured(const CalculationConfiguration& configuration, bool errors);
    /// The same in several ways, view by view: ways of one view share its drawing. By way.
    std::vector<std::vector<Reports>>
    measured(const std::vector<CalculationConfiguration>& configurations, bool errors);

    /// What `one` says less what `other` does, as a part of what `of` says, of intensities and
    /// contrasts: the largest over views and bands.
    static double difference(const std::vector<Reports>& one, const std::vector<Reports>& other,
                             const std::vector<Reports>& of);
    /// LogicError where there are none.
    static StatedErrors stated(const std::vector<Reports>& numbers);
    /// By band: the contrast below which errors are no longer told as a part of it, W sr-1.
    static std::vector<double> leastContrasts_W_sr(const std::vector<Reports>& numbers);
    /// Of one view, where the least contrasts are those.
    static StatedErrors stated(const Reports& numbers, const std::vector<double>& leastContrasts);

  private:
    RenderDoor door_;
    const SceneDescription& scene_;
    std::size_t views_;
    bool alongRange_;
    Place place_;
};

} // namespace smat
