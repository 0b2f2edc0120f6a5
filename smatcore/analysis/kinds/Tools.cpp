#include "smatcore/analysis/kinds/AnalysisDefinition.h"

namespace smat {

// Tools make tables of their own accord; a name is what the provenance of such a table calls it, so
// that none is taken for that of an analysis.

extern constinit const AnalysisDefinition radiativeTool{.name = "radiative",
                                                        .title = "Radiative output",
                                                        .help =
                                                            "What the air gives over the spectrum",
                                                        .icon = "radiative",
                                                        .form = AnalysisForm::table};

extern constinit const AnalysisDefinition temperatureProfileTool{
    .name = "temperature-profile",
    .title = "Temperature profile",
    .help = "Temperature of the air over altitude",
    .icon = "thermometer",
    .form = AnalysisForm::table};

extern constinit const AnalysisDefinition otherTable{.name = "table",
                                                     .title = "Table",
                                                     .help =
                                                         "A table of no analysis of this program",
                                                     .icon = "range",
                                                     .form = AnalysisForm::table};

} // namespace smat
