#include "smatcore/tools/GasEntries.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/tools/GasLayerText.h"
#include "tests/support/Refusal.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string full = "T_K=900,p_atm=0.5,length_m=2,CO2=0.1,H2O=0.11,CO=0.01,CH4=0.002,O2=0.05,"
                         "soot_ppmv=0.3";

TEST(GasEntries, PutALayerIntoADatabaseAsAZoneThatHoldsIt) {
    const irsg::GasLayer layer = gasLayerFromText(full, "layer");
    irsg::SignatureDatabase database;
    addGasZone(database, layer, {"plume", 4, 7});
    ASSERT_EQ(database.materials.size(), 1U);
    ASSERT_EQ(database.temperatures.size(), 1U);
    const irsg::Material& gas = database.materials.at(4);
    EXPECT_TRUE(gas.isGas());
    EXPECT_EQ(gas.name, "plume");
    EXPECT_EQ(gas.gasPressure_atm, 0.5);
    EXPECT_EQ(gas.gasCO2, 0.1);
    EXPECT_EQ(gas.gasH2O, 0.11);
    EXPECT_EQ(gas.gasCO, 0.01);
    EXPECT_EQ(gas.gasCH4, 0.002);
    EXPECT_EQ(gas.gasO2, 0.05);
    EXPECT_EQ(gas.gasSoot_ppmv, 0.3);
    EXPECT_THAT(gas.notes, HasSubstr(full));
    const irsg::TemperatureEntry& temperature = database.temperatures.at(7);
    EXPECT_EQ(temperature.name, "plume");
    EXPECT_EQ(temperature.mode, irsg::EmissionMode::temperature);
    EXPECT_EQ(temperature.terms.base_K, 900.0);
    EXPECT_EQ(temperature.terms.ambientFactor, 0.0) << "whatever the air around it";
    EXPECT_TRUE(irsg::lint(database).empty());
    EXPECT_TRUE(irsg::signatureFromJson(irsg::signatureToJson(database)) == database);
}

TEST(GasEntries, PutTheSpectrumOfALayerIntoADatabaseWithWhatItLetsThrough) {
    irsg::GasRequest request;
    request.layers = {gasLayerFromText(full, "layer")};
    request.background_K = 1500.0; // what is behind the gas is no part of it
    const GasSurface surface = gasSurface(request);
    irsg::SignatureDatabase database;
    addGasSurface(database, surface, {"plume", 4, 7});
    EXPECT_EQ(database.temperatures.at(7).mode, irsg::EmissionMode::userSpectrum);
    EXPECT_EQ(database.temperatures.at(7).userSpectrum, "plume");
    const irsg::Spectrum& radiance = database.spectra.at("plume").components.at(0).radiance;
    const irsg::Material& material = database.materials.at(4);
    EXPECT_FALSE(material.isGas());

    // The numbers of the band.
    request.background_K.reset();
    const irsg::GasSpectrum gas = irsg::gasSpectrum(request);
    const irsg::Spectrum* const emitted[] = {&radiance};
    EXPECT_NEAR(irsg::integrateProduct(emitted, request.band), gas.bandRadiance_W_m2_sr(),
                1e-3 * gas.bandRadiance_W_m2_sr());
    const irsg::Spectrum* const passed[] = {&material.transmissivity};
    EXPECT_NEAR(irsg::integrateProduct(passed, request.band) / request.band.width_um(),
                gas.bandTransmittance(), 1e-3);
    // All of the band, and nothing beyond.
    EXPECT_TRUE(radiance.covers(request.band));
    EXPECT_EQ(radiance.at(2.9), 0.0);
    EXPECT_EQ(radiance.at(5.1), 0.0);
    // A uniform layer emits what it absorbs (Kirchhoff), and reflects nothing. Cells that are cut
    // at the ends of the band are means about another place than their node.
    const std::vector<double>& nodes_um = radiance.wavelengths_um();
    for (std::size_t i = 2; i + 2 < nodes_um.size(); ++i) {
        const double tau = material.transmissivity.at(nodes_um[i]);
        EXPECT_NEAR(material.emissivity.at(nodes_um[i]) + tau, 1.0, 1e-15);
        const double black = irsg::planckRadiance_W_m2_sr_um(nodes_um[i], 900.0);
        EXPECT_NEAR(radiance.values()[i], (1.0 - tau) * black, 1e-6 * black) << nodes_um[i];
    }
    EXPECT_TRUE(irsg::lint(database).empty()) << irsg::lint(database).front().value;
    EXPECT_TRUE(irsg::signatureFromJson(irsg::signatureToJson(database)) == database);
}

TEST(GasEntries, SeeALayerBehindAnother) {
    irsg::GasRequest request;
    request.layers = {gasLayerFromText("T_K=300,p_atm=1,length_m=1,CO2=0.2", "layer 1"),
                      gasLayerFromText("T_K=1200,p_atm=1,length_m=1,CO2=0.1", "layer 2")};
    const GasSurface both = gasSurface(request);
    EXPECT_EQ(both.temperature.terms.base_K, 1200.0);
    request.layers.erase(request.layers.begin());
    const GasSurface one = gasSurface(request);
    EXPECT_LT(both.spectrum.components[0].radiance.at(4.26),
              0.1 * one.spectrum.components[0].radiance.at(4.26));
}

TEST(GasEntries, RefuseIndicesAndNamesThatAreTaken) {
    irsg::GasRequest request;
    request.layers = {gasLayerFromText(gasLayerExample, "layer")};
    irsg::SignatureDatabase database;
    const GasSurface surface = gasSurface(request);
    addGasSurface(database, surface, {"plume", 4, 7});
    const irsg::SignatureDatabase before = database;
    const std::string message = refusalOf([&] {
        addGasSurface(database, surface, {"plume", 4, 7});
    });
    for (const char* part : {"material index", "temperature index", "name", "plume", "7"}) {
        EXPECT_THAT(message, HasSubstr(part));
    }
    EXPECT_THAT(refusalOf([&] {
                    addGasZone(database, request.layers[0], {"another", 5, 7});
                }),
                HasSubstr("temperature index"));
    EXPECT_TRUE(database == before);
    // A zone may be called as a spectrum is.
    addGasZone(database, request.layers[0], {"plume", 5, 8});
    EXPECT_EQ(database.materials.size(), 2U);
}

} // namespace
} // namespace smat::test
