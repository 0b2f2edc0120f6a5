#pragma once

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/MonteCarloData.h"

namespace smat {

/// Where the values of a Monte Carlo run stand.
struct MonteCarloAxis {
    irsg::Quantity abscissa;
    std::vector<double> wavenumbers_per_cm = {}; ///< of a spectrum, whose abscissa is wavelength
};

/// The columns of the table and, in its provenance, what is drawn: all that is known before. The
/// labels of the bands are filled in.
void beginRealisations(MonteCarloData& data, const MonteCarloAxis& axis);
/// What is drawn, and how often, in the provenance: before who answered and what is warned of.
void tellRealisations(MonteCarloData& data, const MonteCarloAxis& axis, std::size_t realisations);
/// The row of an abscissa.
std::vector<double> rowOfRealisations(const MonteCarloData& data, const MonteCarloAxis& axis,
                                      std::size_t abscissa);

/// Adds to a result whose provenance tells of its scene the table, the summary and what was drawn.
void reportRealisations(MonteCarloData& data, const MonteCarloAxis& axis);

/// Says in table, summary and provenance what a Monte Carlo analysis found: its values, abscissae,
/// statistic and ranking are filled in.
void reportMonteCarlo(MonteCarloData& data, const AnalysisPlan& plan,
                      const SceneDescription& scene);

} // namespace smat
