// Signature tables as they are handed on, and images that say what they were asked for.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/tables/TableFormats.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"
#ifdef SMAT_HAS_NETCDF
#include <netcdf.h>
#endif

namespace smat {
namespace {

using test::refusalOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// What a cell says, which tells its place.
double valueAt(double azimuth, double elevation, double range, double mach, int band) {
    return azimuth + 0.01 * elevation - 170.0 + 1e-4 * range + 10.0 * mach + 1000.0 * band;
}

/// Azimuths 0 to 270, elevations -30, 0, 30, two ranges, three Mach numbers, two bands; the rows in
/// any order.
ResultTable table(bool shuffled = false) {
    ResultTable made;
    made.add(irsg::Quantity::azimuth);
    made.add(irsg::Quantity::elevation);
    made.add(irsg::Quantity::range);
    made.add(irsg::Quantity::time);
    made.add(irsg::Quantity::mach);
    made.add("contrast_intensity@3-5um", "W sr-1");
    made.add("contrast_intensity@8-12um", "W sr-1");
    made.add("irradiance@3-5um", "W m-2");
    std::vector<std::vector<double>> rows;
    for (const double elevation : {-30.0, 0.0, 30.0}) {
        for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
            for (const double range : {3000.0, 1000.0}) {
                for (const double mach : {0.2, 0.4, 0.6}) {
                    rows.push_back({azimuth, elevation, range, 5.0, mach,
                                    valueAt(azimuth, elevation, range, mach, 0),
                                    valueAt(azimuth, elevation, range, mach, 1), 1e-6 * azimuth});
                }
            }
        }
    }
    if (shuffled) {
        std::mt19937 random(3);
        std::ranges::shuffle(rows, random);
    }
    for (const auto& row : rows) {
        made.addRow(row);
    }
    made.provenance.add("analysis", "table");
    made.provenance.add("program", "smat test");
    return made;
}

TEST(SignatureTable, FindsAxesDirectionsAndCellsInAnyOrderOfRows) {
    for (const bool shuffled : {false, true}) {
        const ResultTable from = table(shuffled);
        ASSERT_TRUE(SignatureTable::isOne(from));
        const SignatureTable one(from);
        EXPECT_THAT(one.azimuths_deg(), ElementsAre(0, 90, 180, 270));
        EXPECT_THAT(one.elevations_deg(), ElementsAre(-30, 0, 30));
        ASSERT_TRUE(one.isGrid());
        ASSERT_EQ(one.axes().size(), 2U) << "the time is one";
        EXPECT_EQ(one.axes()[0].key, "range");
        EXPECT_THAT(one.axes()[0].values, ElementsAre(1000, 3000));
        EXPECT_THAT(one.axes()[1].values, ElementsAre(0.2, 0.4, 0.6));
        EXPECT_EQ(one.choices(), 6U);
        for (std::size_t i = 0; i < one.choices(); ++i) {
            for (std::size_t elevation = 0; elevation < 3; ++elevation) {
                for (std::size_t azimuth = 0; azimuth < 4; ++azimuth) {
                    const auto choice = one.choice(i);
                    const std::size_t row = one.row(one.direction(elevation, azimuth), choice);
                    EXPECT_EQ(one.column("contrast_intensity@8-12um")->values[row],
                              valueAt(one.azimuths_deg()[azimuth], one.elevations_deg()[elevation],
                                      one.axes()[0].values[choice[0]],
                                      one.axes()[1].values[choice[1]], 1));
                }
            }
        }
    }
}

TEST(SignatureTable, RefusesWhatIsNoWholeTable) {
    ResultTable twice = table();
    std::vector<double> row;
    for (const ResultColumn& column : twice.columns()) {
        row.push_back(column.values.front());
    }
    twice.addRow(row);
    EXPECT_THAT(refusalOf([&] { SignatureTable one(twice); }), HasSubstr("a second time"));
    ResultTable part = table();
    row[1] = 60.0;
    part.addRow(row);
    EXPECT_THAT(refusalOf([&] { SignatureTable one(part); }), HasSubstr("a whole table"));
    ResultTable other;
    other.add(irsg::Quantity::range);
    other.add(irsg::Quantity::irradiance);
    other.addRow({1, 2});
    EXPECT_FALSE(SignatureTable::isOne(other));
    EXPECT_THAT(refusalOf([&] { SignatureTable one(other); }), HasSubstr("azimuth"));
}

TEST(SignatureTable, CountsDecibelsOfTheSizeDownToAFloor) {
    EXPECT_EQ(decibelOf(100.0, -200), 20.0);
    EXPECT_EQ(decibelOf(-0.1, -200), -10.0);
    EXPECT_EQ(decibelOf(0.0, -200), -200.0);
    EXPECT_EQ(decibelOf(1e-30, -200), -200.0);
}

/// A reader of MATLAB's level 5 of its own: real arrays and texts, little endian, as its
/// documentation has them.
struct MatArray {
    std::vector<std::int32_t> sizes;
    std::vector<double> numbers;
    std::string text;

    double at(std::vector<std::size_t> place) const {
        std::size_t number = 0, step = 1;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            number += (i < place.size() ? place[i] : 0) * step;
            step *= static_cast<std::size_t>(sizes[i]);
        }
        return numbers.at(number);
    }
};
class MatReader {
  public:
    explicit MatReader(std::string bytes) : bytes_(std::move(bytes)) {}
    std::map<std::string, MatArray> read() {
        std::map<std::string, MatArray> arrays;
        for (std::size_t at = 128; at < bytes_.size();) {
            EXPECT_EQ(word(at), 14U) << "a matrix";
            std::size_t end = at + 8 + word(at + 4);
            at += 8;
            const auto flags = element(at);
            MatArray array;
            const auto sizes = element(at);
            array.sizes.resize(sizes.size() / 4);
            std::memcpy(array.sizes.data(), sizes.data(), sizes.size());
            const std::string name = element(at);
            const std::string data = element(at);
            if (static_cast<unsigned char>(flags[0]) == 6) {
                array.numbers.resize(data.size() / 8);
                std::memcpy(array.numbers.data(), data.data(), data.size());
            } else {
                array.text = data;
            }
            arrays[name] = array;
            at = end;
        }
        return arrays;
    }

  private:
    std::uint32_t word(std::size_t at) const {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes_.data() + at, 4);
        return value;
    }
    std::string element(std::size_t& at) const {
        if (word(at) >> 16 != 0) { // a short one, with its number of bytes beside the kind
            const std::string small = bytes_.substr(at + 4, word(at) >> 16);
            at += 8;
            return small;
        }
        const std::size_t size = word(at + 4);
        const std::string all = bytes_.substr(at + 8, size);
        at += 8 + (size + 7) / 8 * 8;
        return all;
    }
    std::string bytes_;
};

TEST(SignatureTable, IsReadBackFromMatlabsLayout) {
    const TableFormat& format = *tableFormatOf("a.mat");
    if (!format.isBuilt) {
        GTEST_SKIP() << "this build has no " << format.library;
    }
    const ResultTable from = table(true);
    const std::string bytes = format.bytes(SignatureTable(from));
    EXPECT_EQ(bytes, format.bytes(SignatureTable(table(true)))) << "equal tables, equal files";
    auto arrays = MatReader(bytes).read();
    EXPECT_THAT(arrays["Azimuth"].numbers, ElementsAre(-180, -90, 0, 90, 180));
    EXPECT_THAT(arrays["Elevation"].numbers, ElementsAre(-30, 0, 30));
    const MatArray& pattern = arrays["Pattern"];
    EXPECT_THAT(pattern.sizes, ElementsAre(3, 5, 2, 3, 2)) << "with ranges, Mach numbers, bands";
    double negative = 0;
    const double turned[] = {180, 270, 0, 90, 180}, ranges[] = {1000, 3000}, machs[] = {.2, .4, .6};
    for (std::size_t e = 0; e < 3; ++e) {
        for (std::size_t a = 0; a < 5; ++a) {
            for (std::size_t r = 0; r < 2; ++r) {
                for (std::size_t m = 0; m < 3; ++m) {
                    for (std::size_t b = 0; b < 2; ++b) {
                        const double value = valueAt(turned[a], arrays["Elevation"].numbers[e],
                                                     ranges[r], machs[m], static_cast<int>(b));
                        EXPECT_EQ(arrays["contrast_intensity"].at({e, a, r, m, b}), value);
                        EXPECT_NEAR(arrays["Sign"].at({e, a, r, m, b}) *
                                        std::pow(10.0, pattern.at({e, a, r, m, b}) / 10.0),
                                    value, 1e-12 * std::abs(value));
                        negative += value < 0.0;
                    }
                }
            }
        }
    }
    ASSERT_GT(negative, 0);
    EXPECT_EQ(arrays["NegativeCells"].numbers.front(), negative);
    EXPECT_TRUE(std::isnan(arrays["irradiance"].at({0, 0, 0, 0, 1}))) << "not in that band";
    EXPECT_THAT(arrays["Note"].text, HasSubstr("cells are negative"));
    EXPECT_EQ(arrays["band_2"].text, "8-12um");
    EXPECT_EQ(arrays["Layout"].text, "elevation x azimuth x range x mach x band");
}

TEST(SignatureTable, IsReadBackFromNetCdf) {
    const TableFormat& format = *tableFormatOf("a.nc");
    if (!format.isBuilt) {
        GTEST_SKIP() << "this build has no " << format.library;
    }
    const ResultTable from = table(true);
    const std::string bytes = format.bytes(SignatureTable(from));
    EXPECT_EQ(bytes.substr(0, 4), "\x89HDF");
    EXPECT_EQ(bytes, format.bytes(SignatureTable(table(true)))) << "equal tables, equal files";
#ifdef SMAT_HAS_NETCDF
    const test::TemporaryFolder folder;
    saveTable(from, folder / "a.nc");
    int file = -1, variable = -1;
    ASSERT_EQ(nc_open((folder / "a.nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
    ASSERT_EQ(nc_inq_varid(file, "contrast_intensity", &variable), NC_NOERR);
    // Band, range, Mach number, elevation, azimuth.
    const std::size_t place[] = {1, 0, 2, 2, 3};
    double value = 0.0;
    ASSERT_EQ(nc_get_var1_double(file, variable, place, &value), NC_NOERR);
    EXPECT_EQ(value, valueAt(270, 30, 1000, 0.6, 1));
    char unit[16] = {};
    ASSERT_EQ(nc_get_att_text(file, variable, "units", unit), NC_NOERR);
    EXPECT_STREQ(unit, "W sr-1");
    nc_close(file);
#endif
}

TEST(SignatureTable, OfAnIcosphereIsNoMatrix) {
    ResultTable scattered;
    scattered.add(irsg::Quantity::azimuth);
    scattered.add(irsg::Quantity::elevation);
    scattered.add(irsg::Quantity::contrastIntensity);
    for (const auto& [azimuth, elevation] : {std::pair{0.0, 10.0}, {50.0, 20.0}, {90.0, -7.0}}) {
        scattered.addRow({azimuth, elevation, 1.0});
    }
    const SignatureTable one(scattered);
    EXPECT_FALSE(one.isGrid());
    for (const char* extension : {".mat", ".nc"}) {
        const TableFormat& format = *tableFormatOf(std::string("a") + extension);
        if (!format.isBuilt) {
            continue;
        }
        const std::string refusal = refusalOf([&] { format.bytes(one); });
        if (std::string(extension) == ".mat") {
            EXPECT_THAT(refusal, HasSubstr("no grid"));
        } else {
            EXPECT_EQ(format.bytes(one).substr(0, 4), "\x89HDF");
        }
    }
}

TEST(SignatureTable, IsOfferedForTablesAlone) {
    const auto hasMat = [](AnalysisKind kind) {
        const auto all = resultExtensions(kind);
        return std::ranges::find(all, ".mat") != all.end();
    };
    EXPECT_EQ(hasMat(AnalysisKind::table), tableFormatOf("a.mat")->isBuilt);
    EXPECT_FALSE(hasMat(AnalysisKind::polar));
    EXPECT_THAT(usualResultExtensions(AnalysisKind::table), ElementsAre(".csv", ".json"));
    EXPECT_THAT(refusalOf([] { checkResultFile(AnalysisKind::polar, "a.mat"); }),
                HasSubstr(".csv"));
}

} // namespace
} // namespace smat
