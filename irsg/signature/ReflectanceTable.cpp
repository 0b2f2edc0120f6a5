#include "irsg/signature/ReflectanceTable.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

std::vector<double> axisOf(const std::vector<ReflectanceTable::Row>& rows,
                           double ReflectanceTable::Row::*angle) {
    std::vector<double> axis;
    for (const ReflectanceTable::Row& row : rows)
        axis.push_back(row.*angle);
    std::ranges::sort(axis);
    axis.erase(std::ranges::unique(axis).begin(), axis.end());
    return axis;
}

auto directionsOf(const ReflectanceTable::Row& row) {
    return std::tuple(row.incidence_deg, row.reflection_deg, row.azimuth_deg);
}

std::string nameOf(const ReflectanceTable::Row& row, bool isBrdf) {
    std::string name = "incidence " + numberText(row.incidence_deg);
    if (isBrdf)
        name += ", reflection " + numberText(row.reflection_deg) + ", azimuth " +
                numberText(row.azimuth_deg);
    return name + " deg";
}

void check(const ReflectanceTable::Row& row, bool isBrdf, std::size_t wavelengths,
           std::vector<Diagnostic>& diagnostics) {
    const auto refuse = [&](std::string value, const char* expected) {
        diagnostics.push_back({"", nameOf(row, isBrdf), std::move(value), expected});
    };
    for (const double angle_deg : {row.incidence_deg, row.reflection_deg})
        if (!(angle_deg >= 0.0 && angle_deg <= 90.0))
            refuse(numberText(angle_deg), "an angle from 0 to 90 deg");
    if (!(row.azimuth_deg >= 0.0 && row.azimuth_deg <= 180.0))
        refuse(numberText(row.azimuth_deg), "an azimuth from 0 to 180 deg");
    if (row.values.size() != wavelengths)
        refuse(std::to_string(row.values.size()) + " values", "one for each wavelength");
    for (const double value : row.values)
        if (!(value >= 0.0 && (isBrdf ? std::isfinite(value) : value <= 1.0)))
            refuse(numberText(value),
                   isBrdf ? "a BRDF of at least 0 sr-1" : "a reflectance from 0 to 1");
}

} // namespace

ReflectanceTable::ReflectanceTable(bool isBrdf, std::vector<double> wavelengths_um,
                                   std::vector<Row> rows) {
    std::vector<Diagnostic> diagnostics;
    if (wavelengths_um.empty() || wavelengths_um.size() > mostWavelengths)
        diagnostics.push_back(
            {"", "wavelengths", std::to_string(wavelengths_um.size()), "1 to 8 of them"});
    for (std::size_t i = 0; i < wavelengths_um.size(); ++i)
        if (!(wavelengths_um[i] > 0.0 && std::isfinite(wavelengths_um[i])) ||
            (i > 0 && !(wavelengths_um[i] > wavelengths_um[i - 1])))
            diagnostics.push_back({"", "wavelengths", numberText(wavelengths_um[i]),
                                   "positive wavelengths in um that ascend"});
    if (rows.empty() || rows.size() * std::max<std::size_t>(wavelengths_um.size(), 1) > mostValues)
        diagnostics.push_back(
            {"", "rows", std::to_string(rows.size()), "at least one row, at most 2000000 values"});
    for (const Row& row : rows)
        check(row, isBrdf, wavelengths_um.size(), diagnostics);
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    Data data;
    data.isBrdf = isBrdf;
    data.wavelengths_um = std::move(wavelengths_um);
    data.rows = std::move(rows);
    std::ranges::stable_sort(data.rows, {}, directionsOf);
    data.incidences_deg = axisOf(data.rows, &Row::incidence_deg);
    data.reflections_deg = axisOf(data.rows, &Row::reflection_deg);
    data.azimuths_deg = axisOf(data.rows, &Row::azimuth_deg);
    // As sorted, row by row what the axes make.
    std::size_t next = 0;
    for (const double incidence_deg : data.incidences_deg)
        for (const double reflection_deg : data.reflections_deg)
            for (const double azimuth_deg : data.azimuths_deg) {
                const Row expected{incidence_deg, reflection_deg, azimuth_deg, {}};
                const bool isThere = next < data.rows.size() &&
                                     directionsOf(data.rows[next]) == directionsOf(expected);
                if (!isThere)
                    throw InputError(Diagnostic{"", nameOf(expected, isBrdf),
                                                next > 0 && next < data.rows.size() &&
                                                        directionsOf(data.rows[next]) ==
                                                            directionsOf(data.rows[next - 1])
                                                    ? "the row before it twice"
                                                    : "no row",
                                                "every direction of the table once"});
                ++next;
            }
    if (next != data.rows.size())
        throw InputError(Diagnostic{"", nameOf(data.rows[next], isBrdf), "a row twice",
                                    "every direction of the table once"});

    const std::size_t count = data.wavelengths_um.size();
    for (std::size_t w = 0; w < count; ++w) {
        std::vector<double> share(count, 0.0);
        share[w] = 1.0;
        data.shares.push_back(count == 1 ? Spectrum::constant(1.0)
                                         : Spectrum(data.wavelengths_um, std::move(share)));
    }

    // FNV-1a over all numbers, in two halves that doubles hold.
    std::uint64_t hash = 14695981039346656037u;
    const auto take = [&hash](double number) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211u;
        hash ^= hash >> 29;
    };
    take(isBrdf ? 1.0 : 0.0);
    std::ranges::for_each(data.wavelengths_um, take);
    for (const Row& row : data.rows) {
        take(row.incidence_deg);
        take(row.reflection_deg);
        take(row.azimuth_deg);
        std::ranges::for_each(row.values, take);
    }
    data.hashHigh = static_cast<double>(hash >> 32);
    data.hashLow = static_cast<double>(hash & 0xffffffffu);
    data_ = std::make_shared<const Data>(std::move(data));
}

const ReflectanceTable::Data& ReflectanceTable::data() const {
    static const Data none;
    return data_ ? *data_ : none;
}

double ReflectanceTable::at(std::size_t w, double incidence_deg, double reflection_deg,
                            double azimuth_deg) const {
    const Data& d = data();
    const Bracket i = bracket(d.incidences_deg, incidence_deg);
    const Bracket r = bracket(d.reflections_deg, reflection_deg);
    const Bracket a = bracket(d.azimuths_deg, azimuth_deg);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const bool nextI = corner & 1, nextR = corner & 2, nextA = corner & 4;
        const double weight = (nextI ? i.fraction : 1.0 - i.fraction) *
                              (nextR ? r.fraction : 1.0 - r.fraction) *
                              (nextA ? a.fraction : 1.0 - a.fraction);
        if (weight > 0.0)
            sum += weight * d.rows[((nextI ? i.above : i.below) * d.reflections_deg.size() +
                                    (nextR ? r.above : r.below)) *
                                       d.azimuths_deg.size() +
                                   (nextA ? a.above : a.below)]
                                .values[w];
    }
    return sum;
}

std::vector<double> ReflectanceTable::key() const {
    return {data().hashHigh, data().hashLow};
}

bool ReflectanceTable::operator==(const ReflectanceTable& other) const {
    return data_ == other.data_ ||
           (data_ && other.data_ && isBrdf() == other.isBrdf() &&
            wavelengths_um() == other.wavelengths_um() && rows() == other.rows());
}

} // namespace irsg
