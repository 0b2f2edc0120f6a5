#include "tests/fuzz/SeedTexts.h"

#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "smatcore/data/ResultTable.h"

namespace smat::test {

std::string tape7Text() {
    return "T F 6    1    0    0    6    6    6    6    6    6    1    0    0   0.000   0.00\n"
           "    1    1    1    0    0    0  23.00000   0.00000   0.00000   0.00000   0.00000\n"
           " -99.000 -99.000 -99.000\n"
           " -99.00000 -99.00000 -99.00000  1.416445  0.000736 ! H2O & O3 COLUMNS [GM/CM2]\n"
           "   361976 U S STANDARD\n"
           "   2.00000   2.00000  90.00000   1.00000   0.00000   0.00000    0        0.00000\n"
           "  -99  -99  -99  -99\n"
           " -99.00000 -99.00000 -99.00000 -99.00000 -99.00000 -99.00000\n"
           "    2000.0    2020.0      10.0      20.0NW\n"
           "    0   0    0.000  0    0.000  0    1.000\n"
           "    FREQ COMBIN MOLEC AER+CLD AER+CLD    -LOG\n"
           "    CM-1  TRANS  SCAT   TRANS  abTRNS  COMBIN\n"
           " 2000.00 0.90481.0000  0.9048  1.0000   0.100\n"
           " 2010.00 0.90481.0000  0.9048  1.0000   0.100\n"
           " 2020.00 0.90481.0000  0.9048  1.0000   0.100\n"
           " -9999.\n";
}

std::string modtranCsvText() {
    return "# ITYPE: 1\n# IEMSCT: 1\n# H1: 2\n# RANGE: 3\n"
           "freq,tot_trans,pth_thrml,thrml_sct,surf_emis,sol_scat,sing_scat,grnd_rflt,drct_rflt,"
           "total_rad,ref_sol,sol@obs,depth,dir_em,toa_sun,bbody_t\n"
           "2000,0.5,3e-7,1e-8,1e-7,2e-9,3e-9,0,0,4.15e-7,0,9e-7,0.693,1,1e-6,290\n"
           "2010,0.25,3e-7,1e-8,1e-7,2e-9,3e-9,0,0,4.15e-7,0,8e-7,1.386,1,1e-6,290\n";
}

std::string modtranJsonText() {
    return R"({"MODTRAN":[{"MODTRANINPUT":{"NAME":"a","CASE":0,)"
           R"("RTOPTIONS":{"IEMSCT":"RT_TRANSMITTANCE"},"ATMOSPHERE":{"MODEL":"ATM_TROPICAL"},)"
           R"("GEOMETRY":{"ITYPE":2,"H1ALT":0.5,"H2ALT":2.5,"OBSZEN":60.0},)"
           R"("SURFACE":{"GNDALT":0.25},"SPECTRAL":{"V1":2000,"V2":2020,"DV":10,"FWHM":20,)"
           R"("XFLAG":"W"}},"MODTRANOUTPUT":{"SPECTRA":{"TRANSMITTANCE":{"FREQ":[2000,2010],)"
           R"("TOT_TRANS":[0.5,0.25],"COMBIN_TRANS":[0.5,0.25]},"RADIANCE":{"FREQ":[2000,2010],)"
           R"("TOT_TRANS":[0.5,0.25],"THRML_EM":[3e-7,3e-7],"TOTAL_RAD":[3e-7,3e-7]}}}}]})";
}

std::string tabulatedAtmosphereText() {
    const std::string level =
        R"("kind":"transmittance","path":"horizontal","sensor_altitude [m]":2000,)"
        R"("target_altitude [m]":2000,"elevation [rad]":0,"cards":{},)";
    return R"({"format":"irsg tabulated atmosphere","version":1,"name":"a",)"
           R"("wavenumbers [cm-1]":[2050,2051,2052],"runs":[{"source":"s",)" +
           level + R"("range [m]":2000,"transmittance":[0.9,0.8,0.7],)" +
           R"("scattering_depth":[0.01,0.01,0.01]},{"source":"t",)" + level +
           R"("range [m]":4000,"transmittance":[0.8,0.7,0.6],)" +
           R"("scattering_depth":[0.02,0.02,0.02]}]})";
}

std::string environmentText() {
    irsg::EnvironmentParameters parameters;
    parameters.sun = {1.25, -0.5};
    parameters.background =
        irsg::Spectrum({3.0, 4.1, 5.0}, {0.05, 0.3, 1.2}, irsg::Spectrum::Outside::zero);
    parameters.composition = {{"A", "AtmosphereSmart", "a\\b.xml", "none", -1, "asked first", 0},
                              {"B", "BeerLambert", "b.csv", "none", 7, "", 0}};
    return irsg::toKarma(parameters).text();
}

std::string radiativeText() {
    return "# analysis: radiative\n# atmosphere: haze\n# sensor_altitude [m]: 500\n"
           "# target_altitude [m]: 100\n# range [m]: 1000\n# los_elevation [deg]: -23.5\n"
           "# sun_azimuth [deg]: 180\n# sun_elevation [deg]: 45\n"
           "wavenumber [cm-1],wavelength [um],transmittance\n"
           "2000,5,0.5\n2500,4,0.6\n";
}

std::string resultJsonText() {
    ResultTable table;
    table.add(irsg::Quantity::range);
    table.addRow({1.0});
    table.addRow({2.0});
    table.provenance.add("program", "smat 1");
    return table.toJson();
}

} // namespace smat::test
