#pragma once

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

/// What a synthetic tape7 says about its run, in the units of MODTRAN's cards.
struct SyntheticRun {
    int model = 6;
    int path = 1;
    int kind = 1;
    double h1_km = 0.0;
    double h2_km = 0.0;
    double zenith_deg = 90.0;
    double range_km = 1.0;
    double ground_km = 0.0;
    int iparm = -99;
    double parm2_deg = -99.0;
    double temperature_K = 288.15; ///< of the air, which emits as a black body
    double sunDepth = 0.0;         ///< along the way of the sun
    std::vector<double> wavenumbers_per_cm = {2000.0, 2010.0, 2020.0, 2030.0, 2040.0};
    /// Optical depth of the path at a wavenumber.
    std::function<double(double)> depth = [](double) { return 0.1; };
};

template <typename... Values>
std::string printed(const char* format, Values... values) {
    char buffer[400];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

/// Planck's law in W cm-2 sr-1 (cm-1)-1.
inline double planckPerWavenumber(double wavenumber_per_cm, double temperature_K) {
    const double wavelength_um = wavelengthFromWavenumber_um(wavenumber_per_cm);
    return 1e-4 * perWavenumberFromPerMicrometre(
                      planckRadiance_W_m2_sr_um(wavelength_um, temperature_K), wavelength_um);
}

/// The text of one run with the layout of MODTRAN 5: absorbing air of one temperature.
inline std::string tape7(const SyntheticRun& run) {
    std::string text;
    text += printed("T F %d%5d%5d    0%5d    6    6    6    6    6    1    0    0   0.000   0.00\n",
                    run.model, run.path, run.kind, 6);
    text +=
        printed("    1    1    1    0    0    0  23.00000   0.00000   0.00000   0.00000%10.5f\n",
                run.ground_km);
    text += " -99.000 -99.000 -99.000\n";
    text += " -99.00000 -99.00000 -99.00000  1.416445  0.000736 ! H2O & O3 COLUMNS [GM/CM2]\n";
    text += "   361976 U S STANDARD\n";
    text += printed("%10.5f%10.5f%10.5f%10.5f   0.00000   0.00000    0        0.00000\n", run.h1_km,
                    run.h2_km, run.zenith_deg, run.range_km);
    text += printed("%5d  -99  -99  -99\n", run.iparm);
    text += printed(" -99.00000%10.5f -99.00000 -99.00000 -99.00000 -99.00000\n", run.parm2_deg);
    text += printed("%10.1f%10.1f%10.1f%10.1fNW\n", run.wavenumbers_per_cm.front(),
                    run.wavenumbers_per_cm.back(), 10.0, 20.0);
    text += "    0   0    0.000  0    0.000  0    1.000\n";
    if (run.kind == 0) {
        text += "    FREQ COMBIN MOLEC AER+CLD AER+CLD    -LOG\n"
                "    CM-1  TRANS  SCAT   TRANS  abTRNS  COMBIN\n";
    } else if (run.kind == 3) {
        text += "    FREQ   TRANS     SOL TR  SOLAR\n";
    } else {
        text += "    FREQ  TOT_TRANS  PTH_THRML  THRML_SCT  SURF_EMIS   SOL_SCAT  SING_SCAT  "
                "GRND_RFLT  DRCT_RFLT  TOTAL_RAD  REF_SOL  SOL@OBS   DEPTH DIR_EM    TOA_SUN "
                "BBODY_T[K]\n";
    }
    for (const double wavenumber : run.wavenumbers_per_cm) {
        const double depth = run.depth(wavenumber);
        const double tau = std::exp(-depth);
        const double emitted = (1.0 - tau) * planckPerWavenumber(wavenumber, run.temperature_K);
        if (run.kind == 0) {
            text +=
                printed("%8.2f%7.4f%6.4f%8.4f%8.4f%8.3f\n", wavenumber, tau, 1.0, tau, 1.0, depth);
        } else if (run.kind == 3) {
            const double top = 1e-6;
            text += printed("%8.2f%8.4f%9.2E%9.2E%70.3E\n", wavenumber, std::exp(-run.sunDepth),
                            top * std::exp(-run.sunDepth), top, run.sunDepth);
        } else if (run.kind == 1) {
            text +=
                printed("%8.2f%11.8f%11.4E 0.0000E+00 0.0000E+00%22s 0.0000E+00%11s%11.4E%18s"
                        "%8.3f 1.0000%22.3f\n",
                        wavenumber, tau, emitted, "", "", emitted, "", depth, run.temperature_K);
        } else {
            text += printed("%8.2f%11.8f%11.4E 0.0000E+00 0.0000E+00 0.0000E+00 0.0000E+00 "
                            "0.0000E+00 0.0000E+00%11.4E 0.00E+00 5.00E-07%8.3f 1.0000 9.0000E-07"
                            "%11.3f\n",
                            wavenumber, tau, emitted, emitted, depth, run.temperature_K);
        }
    }
    return text + " -9999.\n";
}

/// A text with its first `what` exchanged.
inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, text.npos) << what;
    return at == text.npos ? text : text.replace(at, what.size(), with);
}

} // namespace irsg
