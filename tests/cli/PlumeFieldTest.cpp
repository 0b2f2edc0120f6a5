#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/geometry/model/Model.h"
#include "irsg/radiance/GasCrossing.h"
#include "irsg/radiance/GasZones.h"
#include "tests/cli/PlainScene.h"
#include "tests/cli/Program.h"
#include "tests/cli/SeenPlume.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// Exhaust about the x axis, and about two of them where `apart_m` is above 0.
double jetPart(double x_m, double y_m, double z_m, double apart_m) {
    const double width_m = 0.2 + 0.09 * x_m;
    const auto one = [&](double from_m) {
        return std::exp(-((y_m - from_m) * (y_m - from_m) + z_m * z_m) / (width_m * width_m));
    };
    return std::min(1.0, 0.2 / width_m * (apart_m > 0.0 ? one(-apart_m) + one(apart_m) : one(0.0)));
}

class SmatBatchPlumeField : public testing::Test {
  protected:
    static std::string rowOf(double part) {
        std::ostringstream row;
        row << 288.0 + 600.0 * part << "," << 0.04 * part << "," << 0.04 * part << "\n";
        return row.str();
    }
    /// Up to 1.2 m, closer about the axis.
    static double across_m(int number) {
        const double t = number / 24.0;
        return 1.2 * t * std::lerp(0.3, 1.0, std::abs(t));
    }
    void writeTable() const {
        std::ofstream out(folder / "table.csv");
        out << "x [m],r [m],T [K],CO2,H2O\n";
        for (int i = 0; i < 31; ++i) {
            for (int j = 0; j < 25; ++j) {
                const double x_m = 0.1 * i, r_m = across_m(j);
                out << x_m << "," << r_m << "," << rowOf(jetPart(x_m, r_m, 0.0, 0.0));
            }
        }
    }
    /// Nodes of a grid, in a random order.
    void writeGrid(double apart_m) const {
        std::vector<std::string> rows;
        for (int i = 0; i < 31; ++i) {
            for (int j = -24; j <= 24; ++j) {
                for (int k = -24; k <= 24; ++k) {
                    std::ostringstream row;
                    const double x_m = 0.1 * i, y_m = across_m(j), z_m = across_m(k);
                    row << x_m << "," << y_m << "," << z_m << ","
                        << rowOf(jetPart(x_m, y_m, z_m, apart_m));
                    rows.push_back(row.str());
                }
            }
        }
        std::ranges::shuffle(rows, std::mt19937(4));
        std::ofstream out(folder / "points.csv");
        out << "x [m],y [m],z [m],T [K],CO2,H2O\n";
        for (const std::string& row : rows) {
            out << row;
        }
    }
    void writeScattered(int count) const {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> even(0.0, 1.0), across(-1.2, 1.2);
        std::ofstream out(folder / "points.csv");
        out << "x [m],y [m],z [m],T [K],CO2,H2O\n";
        for (int i = 0; i < count; ++i) {
            const double x_m = 3.0 * even(random), nearer = std::sqrt(even(random));
            const double y_m = nearer * across(random), z_m = nearer * across(random);
            out << x_m << "," << y_m << "," << z_m << "," << rowOf(jetPart(x_m, y_m, z_m, 0.0));
        }
    }

    nlohmann::json made(std::vector<std::string> arguments,
                        const std::string& name = "plume") const {
        arguments.insert(arguments.begin(), "plume");
        arguments.insert(arguments.end(), {"--band", "4.4-4.6", "--json", "--out", name + ".obj"});
        const Ran ran = smatBatch(arguments, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ran.exitCode == 0 ? nlohmann::json::parse(ran.out) : nlohmann::json();
    }
    static double of(const nlohmann::json& made, const std::string& view, const char* key) {
        for (const auto& one : made["views"]) {
            if (one["view"] == view) {
                return one[key];
            }
        }
        ADD_FAILURE() << "no view " << view;
        return 0.0;
    }
    std::string refusalOf(const std::vector<std::string>& arguments) const {
        const Ran ran = smatBatch(with({"plume", "--out", "none.obj"}, arguments), folder.path());
        EXPECT_EQ(ran.exitCode, 2) << ran.out;
        EXPECT_FALSE(std::filesystem::exists(folder / "none.obj"));
        return ran.err;
    }
    /// Zones of a model are closed, and none goes through another.
    void expectGoodZones(std::size_t zones, const std::string& name = "plume") const {
        const auto mesh = irsg::Model::load(folder / (name + ".obj"))->mesh();
        std::vector<irsg::IrCodes> codes;
        for (std::size_t i = 1; i <= zones; ++i) {
            codes.push_back({static_cast<int>(i), static_cast<int>(i)});
        }
        double before_m3 = 1e30;
        for (const irsg::IrCodes& one : codes) {
            const irsg::GasZoneShape shape = irsg::gasZoneShape(mesh, one);
            EXPECT_EQ(shape.openEdges, 0) << one.material;
            EXPECT_GT(shape.volume_m3, 0.0) << one.material;
            EXPECT_LT(shape.volume_m3, before_m3) << one.material;
            before_m3 = shape.volume_m3;
            for (const irsg::IrCodes& other : codes) {
                EXPECT_FALSE(irsg::doGasZonesCross(mesh, one, other))
                    << one.material << " " << other.material;
            }
        }
    }
    /// What a sensor far away sees.
    double seenFromBeside_W_sr(const std::string& name = "plume") const {
        const std::vector<double> seen = seenPlume_W_sr(folder, name, "90", "91", "1");
        return seen.empty() ? 0.0 : seen.front();
    }

    const TemporaryFolder folder;
    const std::string funnel = "D_m=0.5,T_K=600,velocity_m_s=20,fuel_air=0.02,ends_at=0.3";
};

TEST_F(SmatBatchPlumeField, SendsAsTheTableOfItsAxis) {
    writeTable();
    writeGrid(0.0);
    const auto table = made({"table.csv", "--bound", "0.05"}, "table");
    const auto points = made({"points.csv", "--bound", "0.03"});
    for (const char* view : {"side", "quarter", "tail"}) {
        EXPECT_NEAR(of(points, view, "intensity_table_W_sr") /
                        of(table, view, "intensity_table_W_sr"),
                    1.0, 0.03)
            << view;
        EXPECT_LT(std::abs(of(points, view, "error")), 0.03) << view;
    }
    expectGoodZones(points["zones"]);
    EXPECT_NEAR(seenFromBeside_W_sr() / of(table, "side", "intensity_table_W_sr"), 1.0, 0.05);
}

TEST_F(SmatBatchPlumeField, TakesPointsAnywhere) {
    writeTable();
    writeScattered(40000);
    const auto table = made({"table.csv", "--bound", "0.05"}, "table");
    const auto points = made({"points.csv", "--bound", "0.05"});
    for (const char* view : {"side", "quarter", "tail"}) {
        EXPECT_NEAR(of(points, view, "intensity_table_W_sr") /
                        of(table, view, "intensity_table_W_sr"),
                    1.0, 0.06)
            << view;
    }
    expectGoodZones(points["zones"]);
}

TEST_F(SmatBatchPlumeField, MakesOneOfTwoPlumesThatMeet) {
    writeGrid(0.4);
    const auto points = made({"points.csv", "--bound", "0.04"});
    expectGoodZones(points["zones"]);
    EXPECT_GT(of(points, "above", "intensity_W_sr"), 1.2 * of(points, "side", "intensity_W_sr"));
    // One hides the other from beside.
    EXPECT_NEAR(seenFromBeside_W_sr() / of(points, "side", "intensity_table_W_sr"), 1.0, 0.04);
}

TEST_F(SmatBatchPlumeField, IsRefusedWhereTheBoundIsNotReached) {
    writeGrid(0.4);
    EXPECT_THAT(refusalOf({"points.csv", "--most-zones", "2", "--bound", "0.001"}),
                HasSubstr("the best of 1 to 2"));
}

TEST_F(SmatBatchPlumeField, NamesWrongPointsByLineAndColumn) {
    write(folder / "bad.csv", "x [m],y [m],z [m],T [K],CO2\n0,0,0,800,0.1\n0,0,1,hot,0.1\n");
    EXPECT_THAT(refusalOf({"bad.csv"}), HasSubstr("bad.csv: line 3, column 4: found 'hot'"));
}

TEST_F(SmatBatchPlumeField, BendsAJetInWind) {
    const auto bent = made({"--jet", funnel + ",up_deg=90,wind_m_s=6", "--bound", "0.2"}, "bent");
    const auto sideways =
        made({"--jet", funnel + ",up_deg=90,wind_m_s=6,wind_from_deg=90", "--bound", "0.15"},
             "sideways");
    struct Box {
        double least[3] = {1e9, 1e9, 1e9}, most[3] = {-1e9, -1e9, -1e9};
    };
    const auto boxOf = [&](const std::string& name) { // starboard, up, aft
        Box box;
        std::istringstream lines(contentOf(folder / (name + ".obj")));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string kind;
            double place_m[3];
            if (words >> kind >> place_m[0] >> place_m[1] >> place_m[2] && kind == "v") {
                for (int axis = 0; axis < 3; ++axis) {
                    box.least[axis] = std::min(box.least[axis], place_m[axis]);
                    box.most[axis] = std::max(box.most[axis], place_m[axis]);
                }
            }
        }
        return box;
    };
    const Box aft = boxOf("bent"), port = boxOf("sideways");
    EXPECT_GT(aft.most[1], 0.8) << "it does not go up";
    EXPECT_GT(aft.least[1], -0.3) << "more than the lee side is below the mouth";
    EXPECT_GT(aft.most[2], 0.7) << "the wind from ahead does not blow it to the tail";
    EXPECT_NEAR(aft.most[0] + aft.least[0], 0.0, 0.05);
    EXPECT_LT(port.least[0], -0.7) << "the wind from starboard does not blow it to port";
    EXPECT_NEAR(-port.least[0], aft.most[2], 0.1 * aft.most[2]);
    for (const auto& [name, zones] : std::vector<std::pair<std::string, std::size_t>>{
             {"bent", bent["zones"]}, {"sideways", sideways["zones"]}}) {
        expectGoodZones(zones, name);
    }
    // Turned with the wind, it is seen from the tail as it was from the side.
    EXPECT_NEAR(of(sideways, "above", "intensity_table_W_sr") /
                    of(bent, "above", "intensity_table_W_sr"),
                1.0, 0.01);
    EXPECT_NEAR(seenFromBeside_W_sr("bent") / of(bent, "side", "intensity_W_sr"), 1.0, 0.03);
}

TEST_F(SmatBatchPlumeField, LiftsAJetByItsHeat) {
    const std::string weak = "D_m=1,T_K=700,velocity_m_s=4,fuel_air=0.02,ends_at=0.3";
    made({"--jet", weak + ",up_deg=0", "--bound", "0.3"});
    std::istringstream lines(contentOf(folder / "plume.obj"));
    double highest_m = 0.0, lowest_m = 0.0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        double starboard_m = 0.0, up_m = 0.0;
        if (words >> kind >> starboard_m >> up_m && kind == "v") {
            highest_m = std::max(highest_m, up_m);
            lowest_m = std::min(lowest_m, up_m);
        }
    }
    EXPECT_GT(highest_m, -2.0 * lowest_m);
}

TEST_F(SmatBatchPlumeField, NamesWhatNoJetCanBe) {
    for (const auto& [more, named] : std::vector<std::pair<std::string, std::string>>{
             {",up_deg=100", "up_deg: found 100"},
             {",wind_m_s=-1", "wind_m_s: found -1"},
             {",wind_from_deg=90", "no wind_m_s beside it"},
             {",wind_m_s=3,coflow_m_s=2", "coflow_m_s: found 2"},
             {",up_deg=0,wind_m_s=200,wind_from_deg=90", "within its own width"},
             {",up_deg=0,wind_m_s=19,wind_from_deg=180", "wind_m_s"},
             {",wind=3", "wind"}}) {
        EXPECT_THAT(refusalOf({"--jet", funnel + more}), HasSubstr(named)) << more;
    }
}

} // namespace
} // namespace smat::test
