#include "Support.h"

#include <cmath>

#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

UserSpectrum plume() {
    std::vector<double> axis_um;
    std::vector<double> hot;
    std::vector<double> warm;
    for (int i = 0; i <= 40; ++i) {
        axis_um.push_back(4.0 + i / 30.0);
        const double emissivity = 0.5 + 0.5 * std::sin(i / 3.0);
        hot.push_back(emissivity * planckRadiance_W_m2_sr_um(axis_um.back(), 900.0));
        warm.push_back((1.0 - emissivity) * planckRadiance_W_m2_sr_um(axis_um.back(), 600.0));
    }
    return {"plume core",
            1.0 / 3.0,
            "W cm-2 sr-1 (cm-1)-1",
            "made up, \"with quotes\" and \u00b5m",
            {{"CO2(T4)", {axis_um, hot, Spectrum::Outside::zero}},
             {"H2O", {axis_um, warm, Spectrum::Outside::zero}}}};
}

} // namespace

SignatureDatabase completeDatabase() {
    SignatureDatabase database;
    database.title = "complete";
    database.notes = "two\nlines";
    database.spectra["plume core"] = plume();

    TemperatureEntry skin;
    skin.name = "skin";
    skin.terms = {1.0 / 3.0,
                  0.9,
                  0.89,
                  2.5,
                  {{0, 10, 20}, {0, 1.0 / 7.0, 0}, true},
                  {{0, 1}, {0, 40}},
                  {{0, 11000}, {0, -1}},
                  {{0.2, 0.9}, {0, 3}}};
    skin.notes = "assumed";
    database.temperatures[0] = skin;
    database.temperatures[-7] = {"plain", {}, {300.0, 0.0, 0.0, 0.0, {}, {}, {}, {}}, "", {}, ""};

    TemperatureEntry gas;
    gas.name = "gas";
    gas.mode = EmissionMode::userSpectrum;
    gas.userSpectrum = "plume core";
    gas.factors = {{"H2O", 0.1, {}, {{0, 90, 180}, {1, 0.5, 0.25}}},
                   {"CO2(T4)", 1.0, {{0, 0.3, 1}, {1, 0.9, 1}, true}, {}}};
    database.temperatures[2147483647] = gas;

    database.materials[0] = {"paint", Spectrum::constant(0.9), Spectrum(), 0.0, "handbook"};
    database.materials[3] = {"glass",
                             {{2.0, 4.5, 5.0, 14.0}, {0.1, 0.2, 0.9, 0.88}},
                             {{2.0, 4.5, 5.0}, {0.85, 0.7, 0.0}},
                             0.25,
                             ""};
    return database;
}

} // namespace irsg
