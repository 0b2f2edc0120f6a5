#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/atmosphere/import/PathTable.h"
#include "irsg/atmosphere/import/SightTable.h"
#include "irsg/atmosphere/import/SpectralRun.h"

namespace irsg {

/// An atmosphere made of the results of another program, so that whoever has a licence of MODTRAN
/// brings their own truth: one run, or a family of runs of the same air on the same wavenumbers
/// over range, altitude and elevation.
///
/// It supports what its runs contain: transmittance (every run of radiance or transmittance with a
/// finite path or a path to space), path radiance (IEMSCT 1 and 2: thermal and scattered), optical
/// depth of scattering (IEMSCT 0), background radiance (TOTAL_RAD of runs to space, ITYPE 3), solar
/// irradiance (IEMSCT 3, and `SOL@OBS` of IEMSCT 2 if the run states the sun's elevation). It has
/// no diffuse fluxes and no air temperature. See PathTable and SightTable for how it interpolates;
/// transmittance also answers for the same path the other way round. Runs of the same path may
/// complete each other (transmittance and radiance); where both have a transmittance, that of the
/// radiance run with its more digits is taken. Spectra have the wavenumbers of the runs as nodes.
///
/// Elevations are those of the runs' cards: apparent ones at the sensor. Runs with sun (IEMSCT 2)
/// are true for one position of the sun: where the runs state it, asking for path or background
/// radiance with a sun more than 0.5 deg lower or higher is an InputError; azimuths are not
/// compared. A path, a direction or an altitude outside the family is an InputError that names it
/// and the table's span.
class TabulatedAtmosphere : public Atmosphere, public RunFamily {
  public:
    /// Throws InputError naming every run that does not belong to the family of the first: other
    /// wavenumbers, other air (MODEL, IHAZE, ISEASN, IVULCN, ICSTL, ICLD, VIS, WSS, WHH, RAINRT,
    /// GNDALT, CO2MX), another sun, the same geometry twice, transmittances of one path that differ
    /// by more than 0.001.
    TabulatedAtmosphere(std::vector<SpectralRun> runs, std::string name);

    /// Reads results: tape7, tape7.scn, MODTRAN 6 CSV and JSON, in any mixture, and tables of our
    /// own, whose runs are added. Throws InputError with the diagnostics of all files.
    static TabulatedAtmosphere import(std::span<const std::filesystem::path> files);
    /// Reads and writes the table file `.smatatm`: JSON with `format`, `version`, `name`, the runs'
    /// wavenumbers once and each run with its source, geometry, cards, warnings and spectra in
    /// the units of SpectralRun; numbers read back equal. Throws InputError for a file of another
    /// kind or version and for every value that is wrong.
    static TabulatedAtmosphere read(const std::filesystem::path& file);
    void write(const std::filesystem::path& file) const;
    /// The text of that file.
    std::string toText() const;
    static TabulatedAtmosphere fromText(const std::string& text, const std::string& file);
    /// Whether a text is such a file; the name `.smatatm` makes a file one.
    static bool isTable(std::string_view text);
    static bool isTableFile(const std::filesystem::path& file);
    /// Whether `import` knows what to do with the file, by its content and name.
    static bool canImport(const std::filesystem::path& file);

    const std::vector<SpectralRun>& runs() const { return runs_; }
    /// Of all runs, each with its source.
    std::vector<std::string> warnings() const;
    /// Leave-one-out errors of every quantity along every axis.
    std::vector<InterpolationError> interpolationErrors() const;
    /// "transmittance: sensor 0 m, target 0 m, range up to 5000 m (1 path)", one a quantity.
    std::vector<std::string> spans() const;

    std::string name() const override { return name_; }
    SpectralRange base() const override;
    bool supports(AtmosphereProperty property) const override;
    /// Over a sphere; flat where its backgrounds hold the flat direction alone.
    TargetView targetView(const AtmosphericPath& path) const override;
    AtmosphereDescription describe() const override;
    std::string nearestRun(const AtmosphericQuery& query) const override;

    /// Quadrature points are wavenumbers of the runs, at which the table of these alone answers.
    bool isWidebandModeAvailable() const override { return true; }
    std::shared_ptr<const SensorCkData> prepareCk(const CkRequest& request) const override;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override;
    std::vector<double> valuesAtPoints(const AtmosphericQuery& query,
                                       const SensorCkData& points) const override;

  private:
    /// Paths that end at altitudes of the air and paths to space are never mixed.
    struct PropertyTables {
        PathTable finite;
        PathTable toSpace;

        bool isEmpty() const { return finite.isEmpty() && toSpace.isEmpty(); }
        PathTable& of(const AtmosphericPath& path);
        const PathTable& answering(const AtmosphericPath& path) const;
        std::string span() const;
    };

    void checkFamily() const;
    void fillPaths();
    void fillSights();
    bool holdsSight(double altitude_m, double elevation_rad) const;
    void checkSun(const SunPosition& sun) const;
    /// First node and one past the last that surround a range.
    std::pair<std::size_t, std::size_t> nodesAround(const SpectralRange& range) const;
    /// Optical depths of a path, of the path the other way round where the runs have only that.
    std::vector<double> depths(const AtmosphericPath& path, std::size_t first,
                               std::size_t last) const;
    std::vector<double> sunlight(const AtmosphericQuery& query, std::size_t first,
                                 std::size_t last) const;
    /// The answer at spectral nodes first to last - 1.
    std::vector<double> valuesAt(const AtmosphericQuery& query, std::size_t first,
                                 std::size_t last) const;
    /// Paths of the training, or those between them.
    std::vector<AtmosphericPath> ckPaths(bool heldOut) const;
    /// The table of some of its nodes, ascending in wavelength.
    std::shared_ptr<const TabulatedAtmosphere> of(const std::vector<std::uint32_t>& nodes) const;

    std::vector<SpectralRun> runs_;
    std::string name_;
    std::vector<double> wavelengths_um_; ///< ascending: the runs' wavenumbers backwards
    PropertyTables transmittances_;
    PropertyTables radiances_;
    PropertyTables scatterings_;
    SightTable backgrounds_;
    SightTable suns_;
    /// Tables of the quadrature points that were asked last; copies share them.
    struct OfPoints;
    std::shared_ptr<OfPoints> ofPoints_;
};

} // namespace irsg
