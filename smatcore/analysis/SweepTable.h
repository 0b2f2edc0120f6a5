#pragma once

#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// The columns of a result: where the cases are, then the sums of all objects in each band, then
/// those of each object where there are several: `intensity`, or `intensity@3-5um` of one of
/// several bands, and `NAME.range`, `NAME.intensity@3-5um`, ... of an object at its own range.
/// Behind the numbers of a band, where they are asked for, their errors, `error_intensity@3-5um`,
/// and those by cause, `error_sampling_intensity@3-5um`, `error_air_...`, `error_background_...`,
/// `error_exchange_...`; not a number where a source does not know them.
/// Where the plan asks for parts, then what those of each object add to its sums, in each band:
/// `OBJECT/PART.intensity@3-5um`; the object is named where there is one, too. See PartColumns.
/// Where the horizon may hide objects, the last columns are the part of the height of each that it
/// hides, 0 to 1: `hidden_by_horizon`, `NAME.hidden_by_horizon`.
/// Names of objects are made distinct as distinctLabels does.
class SweepTable {
  public:
    SweepTable(const AnalysisPlan& plan, const SceneDescription& scene, ResultTable& table,
               bool withHorizon = false);

    /// One case of an image or a sweep, with a report for each band, and then one for each source
    /// where the plan asks for it, and what it warns of.
    void addCase(const AnalysisCase& one, const std::vector<irsg::RenderReport>& reports,
                 std::string warning = {});
    std::vector<double> rowOf(const AnalysisCase& one,
                              const std::vector<irsg::RenderReport>& reports) const;
    void addSpectrum(const irsg::IntensitySpectrum& spectrum);

  private:
    void addColumns(const std::string& object);
    void addErrorColumns(const std::vector<irsg::Quantity>& quantities, const std::string& object,
                         const std::string& band);
    void addErrors(std::vector<double>& row, const irsg::ObjectRadiometry& sums,
                   const irsg::ObjectRadiometry* source) const;
    void addPartColumns(const SceneDescription& scene);
    void appendParts(std::vector<double>& row,
                     const std::vector<irsg::RenderReport>& reports) const;
    void addColumn(irsg::Quantity quantity, const std::string& object, const std::string& band);
    /// The sums in a band; `source`: without air, null where nobody asked.
    static void append(std::vector<double>& row, const irsg::ObjectRadiometry& sums,
                       const irsg::ObjectRadiometry* source);

    AnalysisForm form_;
    bool withSource_;
    bool withHorizon_;
    ErrorColumns errors_;
    std::vector<irsg::Quantity> coordinates_;
    std::vector<std::string> objects_; ///< empty where there is one
    std::vector<std::string> bands_;   ///< one "" where there is one
    PartsBy partsBy_;
    std::vector<std::vector<ObjectPart>> parts_; ///< by entity
    ResultTable& table_;
};

} // namespace smat
