#pragma once

#include <memory>
#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Measured reflectance over directions: a table of directional-hemispherical reflectance over the
/// angle of incidence, or of a BRDF over incidence, reflection and the azimuth between the two (180
/// deg: the side of the mirror direction), each at one wavelength or several. Linear between nodes
/// of each axis, clamped beyond their ends. A value, cheap to copy.
class ReflectanceTable {
  public:
    /// The directions of a row and a value a wavelength. Of directional-hemispherical reflectance
    /// reflection and azimuth are 0.
    struct Row {
        double incidence_deg = 0.0, reflection_deg = 0.0, azimuth_deg = 0.0;
        std::vector<double> values;
        bool operator==(const Row&) const = default;
    };
    static constexpr std::size_t mostWavelengths = 8;
    static constexpr std::size_t mostValues = 2'000'000;

    ReflectanceTable() = default; ///< none
    /// Rows in any order, each pair of directions once, all that their axes make. Values are
    /// reflectances of 0 to 1, or sr-1 of a BRDF, at least 0; angles 0 to 90 deg, azimuths 0 to
    /// 180; wavelengths ascending, at most 8; one counts everywhere. Throws InputError naming the
    /// row.
    ReflectanceTable(bool isBrdf, std::vector<double> wavelengths_um, std::vector<Row> rows);

    bool empty() const { return !data_; }
    bool isBrdf() const { return data_ && data_->isBrdf; }
    const std::vector<double>& wavelengths_um() const { return data().wavelengths_um; }
    const std::vector<double>& incidences_deg() const { return data().incidences_deg; }
    const std::vector<double>& reflections_deg() const { return data().reflections_deg; }
    const std::vector<double>& azimuths_deg() const { return data().azimuths_deg; }
    /// By incidence, then reflection, then azimuth.
    const std::vector<Row>& rows() const { return data().rows; }
    /// At wavelength number w.
    double at(std::size_t w, double incidence_deg, double reflection_deg = 0.0,
              double azimuth_deg = 0.0) const;
    /// How much each of its wavelengths counts at others.
    const std::vector<Spectrum>& shares() const { return data().shares; }
    /// Two numbers that other tables do not have.
    std::vector<double> key() const;

    bool operator==(const ReflectanceTable& other) const;

  private:
    struct Data {
        bool isBrdf = false;
        std::vector<double> wavelengths_um, incidences_deg, reflections_deg, azimuths_deg;
        std::vector<Row> rows;
        std::vector<Spectrum> shares;
        double hashHigh = 0.0, hashLow = 0.0;
    };
    const Data& data() const;

    std::shared_ptr<const Data> data_;
};

} // namespace irsg
