#include "tests/cli/BadInput.h"

namespace smat::test {
namespace {

/// A radiative output of a haze from 3.5 to 6 um.
BadRow radiativeRow(const char* name, const Words& more, const Words& named) {
    return {name, file("a.csv", atmosphereHead + "3.5,0.1\n6,0.1\n"),
            with({"radiative", "a.csv", "--out", "o.csv"}, more), named};
}

Words slantWith(const Words& more) {
    return with({"--quantity", "transmittance", "--band", "4-5"}, more);
}

INSTANTIATE_TEST_SUITE_P(
    RadiativeOutputs, BadInput,
    testing::Values(
        radiativeRow("NoQuantity", {"--range", "5"}, {"--quantity", "found nothing", "scattering"}),
        radiativeRow("UnknownQuantity", {"--quantity", "fog"}, {"--quantity", "fog", "all"}),
        radiativeRow("MistypedQuantity", {"--quantity", "transmitance"},
                     {"did you mean 'transmittance'?"}),
        radiativeRow("NoGeometry", slantWith({}), {"transmittance", "a sensor altitude"}),
        radiativeRow("NoRange", slantWith({"--sensor-altitude", "9", "--los-elevation", "5"}),
                     {"transmittance", "with a range"}),
        radiativeRow("SensorBelowGround",
                     slantWith({"--sensor-altitude", "-9", "--los-elevation", "5"}),
                     {"sensor altitude", "-9"}),
        radiativeRow("WordForANumber", slantWith({"--range", "far"}), {"--range", "far"}),
        radiativeRow("InfiniteRange", slantWith({"--range", "inf"}), {"--range", "inf"}),
        radiativeRow("Contradiction",
                     slantWith({"--sensor-altitude", "9", "--los-elevation", "5", "--altitude", "9",
                                "--range", "500"}),
                     {"elevation of the line of sight", "5 deg", "target altitude of 9 m"}),
        radiativeRow("IntoTheGround",
                     slantWith({"--sensor-altitude", "9", "--los-elevation=-30", "--range", "50"}),
                     {"range", "50 m", "at most 18"}),
        radiativeRow("SpaceWithARange",
                     slantWith({"--sensor-altitude", "9", "--los-elevation", "5", "--range", "50",
                                "--to-space"}),
                     {"range", "path to space"}),
        radiativeRow("BandOutsideTheAir",
                     {"--quantity", "transmittance", "--sensor-altitude", "9", "--los-elevation",
                      "5", "--range", "50"},
                     {"3-5 um", "3.5-6 um"}),
        radiativeRow("AllOfABandOutsideTheAir",
                     {"--quantity", "all", "--band", "8-12", "--altitude", "9"},
                     {"solar irradiance over 8-12 um", "3.5-6 um"}),
        radiativeRow("AllOfNowhere", {"--quantity", "all", "--band", "4-5"},
                     {"geometry", "a sensor altitude"}),
        radiativeRow("ReversedBand", {"--quantity", "sun", "--band", "5-3"}, {"5-3"}),
        radiativeRow("UnknownResolution", slantWith({"--resolution", "2"}),
                     {"--resolution", "found 2", "1, 5 or 15"}),
        radiativeRow("ResolutionOfAirWithoutBins",
                     slantWith({"--sensor-altitude", "9", "--los-elevation", "5", "--range", "50",
                                "--resolution", "5"}),
                     {"Beer-Lambert (a.csv): resolution: found 5", "AtmosphereSmart"}),
        radiativeRow("SunBeyondTheZenith", slantWith({"--sun-elevation", "91"}),
                     {"--sun-elevation", "91"}),
        BadRow{"SeveralAtOnce",
               nothing,
               {"radiative", "none", "--quantity", "fog", "--band", "x", "--sun-azimuth", "-1",
                "--out", "o.csv"},
               {"fog", "found 'x'", "--sun-azimuth"}},
        BadRow{"AtmosphereMissing",
               nothing,
               {"radiative", "b.csv", "--quantity", "sun", "--altitude", "0", "--out", "o.csv"},
               {"b.csv"}},
        BadRow{"AtmosphereThatIsNoFile",
               nothing,
               {"radiative", "b.txt", "--quantity", "sun", "--altitude", "0", "--out", "o.csv"},
               {"b.txt", "no such file"}},
        BadRow{"NoOutput", nothing, {"radiative", "none", "--quantity", "sun"}, {"--out"}},
        BadRow{"OutputOfUnknownForm",
               nothing,
               {"radiative", "none", "--quantity", "sun", "--out", "o.exr"},
               {"o.exr", ".csv or .json"}}),
    nameOf);

BadRow profileRow(const char* name, const Words& more, const Words& named) {
    return {name, file("a.csv", atmosphereHead + "3.5,0.1\n6,0.1\n"),
            with({"temperature-profile", "a.csv", "--out", "o.csv"}, more), named};
}

INSTANTIATE_TEST_SUITE_P(
    TemperatureProfiles, BadInput,
    testing::Values(
        profileRow("Nothing", {}, {"--min", "--max", "--step"}),
        profileRow("Reversed", {"--min", "9", "--max", "5", "--step", "1"}, {"max", "5 m", "9 m"}),
        profileRow("BelowGround", {"--min", "-9", "--max", "5", "--step", "1"}, {"min", "-9 m"}),
        profileRow("NoStep", {"--min", "0", "--max", "5", "--step", "0"}, {"step", "0 m"}),
        profileRow("TooFine", {"--min", "0", "--max", "1e5", "--step", "1e-3"}, {"step", "0.001"}),
        profileRow("WordForANumber", {"--min", "low"}, {"--min", "low"}),
        BadRow{"OfVacuum",
               nothing,
               {"temperature-profile", "none", "--min", "0", "--max", "5", "--step", "1", "--out",
                "o.csv"},
               {"vacuum", "ambient temperature"}}),
    nameOf);

} // namespace
} // namespace smat::test
