#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/CaseWarnings.h"
#include "smatcore/analysis/MonteCarloData.h"
#include "smatcore/analysis/PlacedCase.h"

namespace smat {

/// The cases of a Monte Carlo analysis, each drawn once and from then on a function of the scales.
class MonteCarloViews {
  public:
    /// Is told of every drawing before it begins: "case 2 of 5, phase 1 of 4".
    using Telling = std::function<void(std::string)>;

    /// All must outlive it.
    MonteCarloViews(const RenderDoor& door, const AnalysisPlan& plan, const SceneDescription& scene,
                    MonteCarloData& data)
        : door_(door), plan_(plan), scene_(scene), data_(data) {}

    /// Draws the cases and, for the numerical error, their subpixel shifts. Abscissae, nominal
    /// values, their errors and warnings go to the data. A stop ends it after the first
    /// drawing.
    void draw(const Telling& tell, const std::stop_token& stop);
    /// What the last case warns of.
    const std::vector<CaseRemark>& remarks() const { return warnings_.remarks(); }
    bool areAll() const { return views_.size() == plan_.cases.size(); }
    /// The quantity at every place that was drawn. May be asked by several threads at a time.
    std::vector<double> valuesAt(const std::vector<double>& scales) const;
    /// What the views remember of the last scales; for one thread at a time.
    using Memos = std::vector<std::unique_ptr<irsg::ScaledView::Memo>>;
    Memos memos() const;
    /// The same bit by bit: for draws that differ from earlier ones in a few scales.
    std::vector<double> valuesNear(const std::vector<double>& scales, Memos& memos) const;

  private:
    struct RenderedView {
        std::vector<double> abscissae;
        std::vector<std::vector<double>> values; ///< by band
        std::vector<std::string> providedBy;
        std::vector<std::vector<irsg::ErrorParts>> errors; ///< of the case in its own place
    };
    /// In its own place, whose warnings and errors count, or at a phase.
    RenderedView renderOne(const AnalysisCase& one, const PlacedCase& placed, bool isInPlace);
    void renderPhases(const AnalysisCase& one, PlacedCase placed, const Telling& tell,
                      const std::stop_token& stop);
    /// Whether results have an error_numerical, for which cases are drawn at phases.
    bool hasNumericalError() const { return data_.options.subpixelShifts > 1; }
    void addNumericalError(const std::vector<RenderedView>& atPhases);

    const RenderDoor& door_;
    const AnalysisPlan& plan_;
    const SceneDescription& scene_;
    MonteCarloData& data_;
    std::vector<irsg::Band> bands_ = scene_.allBands();
    /// By case, then by band.
    std::vector<std::vector<std::unique_ptr<const irsg::ScaledView>>> views_;
    /// By band, then by abscissa.
    std::vector<std::vector<double>> nominal_, numericalError_;
    std::vector<std::vector<irsg::ErrorParts>> errors_;
    CaseWarnings warnings_;
};

} // namespace smat
