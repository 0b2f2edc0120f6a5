#include <set>

#include "irsg/core/CsvTable.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"
#include "irsg/signature/SurfaceTemperature.h"

#include "Support.h"
#include "tests/support/WithoutProgram.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;

const fs::path samples = fs::path(SMAT_SOURCE_DIR) / "samples";

SignatureDatabase readJson(const std::string& sample) {
    const fs::path file = samples / sample / "signature.json";
    return signatureFromJson(readBytes(file), file.string());
}

class Sample : public testing::TestWithParam<const char*> {};

TEST_P(Sample, HasADatabaseFileEqualToItsJson) {
    const fs::path file = samples / GetParam() / (std::string(GetParam()) + ".sigdb");
    EXPECT_TRUE(loadSignatureFile(file).database == readJson(GetParam()))
        << "made anew by: smat-batch db import signature.json " << file.filename();
}

TEST_P(Sample, HasItsJsonInTheFormOfAnExport) {
    EXPECT_EQ(smat::test::withoutProgram(signatureToJson(readJson(GetParam()))),
              readBytes(samples / GetParam() / "signature.json"));
}

TEST_P(Sample, HasNothingToFindFault) {
    for (const SpectralRange band : {SpectralRange{2.0, 5.0}, SpectralRange{8.0, 12.0}}) {
        for (const Finding& finding : lint(readJson(GetParam()), band)) {
            ADD_FAILURE() << finding.place << ": " << finding.value << ": " << finding.reason;
        }
    }
}

TEST_P(Sample, SaysWhereEachNumberComesFrom) {
    const SignatureDatabase database = readJson(GetParam());
    EXPECT_FALSE(database.notes.empty());
    for (const auto& [index, entry] : database.temperatures) {
        EXPECT_FALSE(entry.notes.empty()) << entry.name;
    }
    for (const auto& [index, material] : database.materials) {
        EXPECT_FALSE(material.notes.empty()) << material.name;
    }
    for (const auto& [name, spectrum] : database.spectra) {
        EXPECT_FALSE(spectrum.notes.empty()) << name;
    }
}

int bigEndian(const std::string& bytes, std::size_t at, std::size_t count) {
    unsigned value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return static_cast<int>(value);
}

TEST_P(Sample, HasAnEntryForEveryCodeOfItsModel) {
    std::set<int> colours;
    std::set<int> materials;
    bool isFlight = false;
    for (const fs::directory_entry& file : fs::directory_iterator(samples / GetParam())) {
        if (file.path().extension() != ".flt") {
            continue;
        }
        isFlight = true;
        // The face (opcode 5) and mesh (84) records with their colour and material code.
        const std::string bytes = readBytes(file.path());
        for (std::size_t at = 0; at + 4 <= bytes.size() && bigEndian(bytes, at + 2, 2) >= 4;
             at += static_cast<std::size_t>(bigEndian(bytes, at + 2, 2))) {
            const int opcode = bigEndian(bytes, at, 2);
            if (opcode == 5 || opcode == 84) {
                const std::size_t shift = opcode == 84 ? 4 : 0;
                colours.insert(bigEndian(bytes, at + 12 + shift, 4));
                materials.insert(bigEndian(bytes, at + 36 + shift, 4));
            }
        }
    }
    if (!isFlight) {
        GTEST_SKIP() << "the model of this sample is no OpenFlight file";
    }
    EXPECT_FALSE(colours.empty());
    const SignatureDatabase database = readJson(GetParam());
    for (const int colour : colours) {
        EXPECT_TRUE(database.temperatures.contains(colour)) << "temperature " << colour;
    }
    for (const int material : materials) {
        EXPECT_TRUE(database.materials.contains(material)) << "material " << material;
    }
}

TEST_P(Sample, HasTheSpectraOfItsCsvFiles) {
    for (const auto& [name, spectrum] : readJson(GetParam()).spectra) {
        UserSpectrum imported = readSpectrumCsv(samples / GetParam() / (name + ".csv"));
        imported.notes = spectrum.notes;
        EXPECT_TRUE(imported == spectrum) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, Sample,
                         testing::Values("sphere", "chessboard", "ship", "turboprop4", "box",
                                         "heron", "corvette", "tern"),
                         [](const auto& row) { return row.param; });

/// A wall of a plume: its material, and the files of its gas and of its emission.
struct Wall {
    const char *name, *sample, *gas, *emission;
    int material;
    double temperature_K;
};
void PrintTo(const Wall& row, std::ostream* out) {
    *out << row.name;
}

class PlumeWall : public testing::TestWithParam<Wall> {};

TEST_P(PlumeWall, HasTheGasOfItsCsvFile) {
    const CsvTable table =
        CsvTable::read(samples / GetParam().sample / (std::string(GetParam().gas) + ".csv"));
    const Spectrum transmissivity =
        readJson(GetParam().sample).materials.at(GetParam().material).transmissivity;
    ASSERT_EQ(transmissivity.size() + 1, table.rows().size());
    for (std::size_t i = 0; i < transmissivity.size(); ++i) {
        const auto& cells = table.rows()[i + 1].cells;
        EXPECT_EQ(transmissivity.wavelengths_um()[i], parseNumber(cells[0].text));
        EXPECT_EQ(transmissivity.values()[i], parseNumber(cells[1].text));
    }
}

/// What a wall emits over the band, of its emissivity alone.
double emitted_W_m2_sr(const Wall& wall, double from_um, double to_um) {
    const SignatureDatabase database = readJson(wall.sample);
    const Spectrum& emissivity = database.materials.at(wall.material).emissivity;
    double sum = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double at_um = from_um + (to_um - from_um) * (i + 0.5) / steps;
        sum += emissivity.at(at_um) * planckRadiance_W_m2_sr_um(at_um, wall.temperature_K) *
               (to_um - from_um) / steps;
    }
    return sum;
}

TEST_P(PlumeWall, ObeysKirchhoffsLaw) {
    const SignatureDatabase database = readJson(GetParam().sample);
    const Material& gas = database.materials.at(GetParam().material);
    const UserSpectrum& plume = database.spectra.at(GetParam().emission);
    for (const double wavelength_um : plume.components[0].radiance.wavelengths_um()) {
        double emitted = 0.0;
        for (const SpectrumComponent& component : plume.components) {
            emitted += component.radiance.at(wavelength_um);
        }
        const double black = planckRadiance_W_m2_sr_um(wavelength_um, GetParam().temperature_K);
        const double emissivity = gas.emissivity.at(wavelength_um);
        if (plume.referenceDistance_m > 0.0) {
            EXPECT_LT(emitted / black, emissivity + 2e-5) << "air only takes, " << wavelength_um;
        } else {
            EXPECT_NEAR(emitted / black, emissivity, 2e-5) << wavelength_um;
        }
        EXPECT_NEAR(gas.reflectivityAt(wavelength_um), 0.0, 1e-12) << wavelength_um;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Samples, PlumeWall,
    testing::Values(Wall{"Core", "turboprop4", "gas core", "plume core", 5, 700.0},
                    Wall{"Middle", "turboprop4", "gas mid", "plume mid", 6, 480.0},
                    Wall{"Outer", "turboprop4", "gas outer", "plume outer", 7, 360.0},
                    Wall{"Ship", "ship", "gas", "funnel plume", 5, 420.0}),
    [](const auto& row) { return row.param.name; });

TEST(Samples, CoreOfThePlumeEmitsAsANarrowBandCodeSays) {
    const Wall core{"Core", "turboprop4", "gas core", "plume core", 5, 700.0};
    EXPECT_NEAR(emitted_W_m2_sr(core, 3.0, 5.0), 142.0, 0.02 * 142.0);
}

TEST(Samples, PlumeOfTheAircraftEmitsBesideWhatColdAirAbsorbs) {
    const UserSpectrum core = readJson("turboprop4").spectra.at("plume core");
    const Spectrum& co2 = core.find("CO2")->radiance;
    EXPECT_EQ(core.referenceDistance_m, 100.0);
    EXPECT_GT(co2.at(4.181), 10.0 * co2.at(4.24)) << "blue spike";
    EXPECT_GT(co2.at(4.35), 10.0 * co2.at(4.24)) << "red spike";
    EXPECT_LT(co2.at(4.7), 0.05 * co2.at(4.35)) << "hot bands alone";
    EXPECT_LT(co2.at(3.8), 1e-3 * co2.at(4.35)) << "outside the band";
    EXPECT_GT(core.find("H2O")->radiance.at(2.55), 0.0);
}

TEST(Samples, AircraftWarmsWithSpeedAndPower) {
    const auto temperatures = readJson("turboprop4").temperatures;
    EntityState cruise;
    cruise.ambient_K = 252.0;
    cruise.mach = 0.45;
    cruise.power = 1.0;
    const auto at_K = [&](int index, const EntityState& state) {
        return surfaceTemperature_K(temperatures.at(index).terms, state);
    };
    EXPECT_NEAR(at_K(1, cruise), 252.0 * (1.0 + 0.2 * 0.89 * 0.45 * 0.45), 1e-9);
    EXPECT_GT(at_K(2, cruise), at_K(1, cruise)) << "leading edges";
    EXPECT_GT(at_K(4, cruise), at_K(2, cruise)) << "cowls";
    EntityState parked;
    EXPECT_NEAR(at_K(5, parked), 288.15, 1e-9) << "cold exhaust";
    double last_K = 288.2;
    for (const double power : {0.15, 0.5, 1.0}) {
        parked.power = power;
        EXPECT_GT(at_K(5, parked), last_K + 50.0) << power;
        last_K = at_K(5, parked);
    }
    EXPECT_LT(last_K, 760.0);
}

} // namespace
} // namespace irsg
