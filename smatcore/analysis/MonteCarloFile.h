#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/analysis/MonteCarloData.h"

namespace smat {

/// The files that saveMonteCarlo() writes for one that is asked for, of a run with a ranking or
/// without.
std::vector<std::filesystem::path> monteCarloFiles(const std::filesystem::path& file,
                                                   bool hasRanking);
/// Bands as CSV, or everything as JSON; with a CSV of bands the ranking goes to FILE-ranking.csv
/// beside it. Throws InputError for another extension and for a file that cannot be written.
/// Returns the files written.
std::vector<std::filesystem::path> saveMonteCarlo(const MonteCarloData& data,
                                                  const std::filesystem::path& file);
/// The single values of all draws, which no table holds, as an image of 32-bit floats: place after
/// place, draw after draw, in rows of 4096, the rest of the last row 0. LogicError before a run.
irsg::RadianceImage realisationsImage(const MonteCarloData& data);
/// The raw draws: a row a draw with its number, `draw`, its scales, `scale NAME`, and the quantity
/// at each place, `contrast_intensity at 90 deg@3-5um`, over several axes `contrast_intensity at
/// azimuth 90 deg elevation 5 deg`. Of a run that was read back the quantities
/// have the 7 digits that it keeps. LogicError before a run.
ResultTable realisationsTable(const MonteCarloData& data);
/// The same of several runs with the same draws, each of an object, `near.contrast_intensity at 2
/// s`; provenance is that of the last.
struct NamedRealisations {
    std::string object; ///< "" of all together
    const MonteCarloData* data;
};
ResultTable realisationsTable(const std::vector<NamedRealisations>& runs);
/// Reads back what saveMonteCarlo wrote as .json, with the values of realisationsImage. What was
/// asked is not in a file: project and settings stay empty. Throws InputError for a file of another
/// form and for draws that do not fit it.
MonteCarloData loadMonteCarlo(const std::filesystem::path& file,
                              const irsg::RadianceImage& realisations);
/// Place in the ranking, kind (0 temperature, 1 emissivity), index and Sobol' indices with their
/// intervals; names in the provenance.
ResultTable rankingTable(const MonteCarloData& data);

} // namespace smat
