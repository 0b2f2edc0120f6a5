#include "irsg/radiometry/SpectralHead.h"

#include <gtest/gtest.h>

namespace irsg {
namespace {

TEST(SpectralHead, IsTheSameInEverySpelling) {
    const auto um = SpectralAxis::wavelength;
    const auto nm = SpectralAxis::nanometres;
    const auto wavenumber = SpectralAxis::wavenumber;
    const std::pair<const char*, SpectralAxis> rows[] = {{"um", um},
                                                         {"wavelength [um]", um},
                                                         {"Wavelength (um)", um},
                                                         {"wavelength_um", um},
                                                         {"Wavelength (micrometers)", um},
                                                         {"WAVELENGTH, MICRONS", um},
                                                         {"\u00b5m", um},
                                                         {"\u03bb [\u03bcm]", um},
                                                         {"\xb5m", um},
                                                         {"lambda/um", um},
                                                         {"wl [um]", um},
                                                         {"nm", nm},
                                                         {"wavelength [nm]", nm},
                                                         {"wavelength_nm_vac", nm},
                                                         {"NANOMETERS", nm},
                                                         {"cm-1", wavenumber},
                                                         {"cm^-1", wavenumber},
                                                         {"cm\u207b\u00b9", wavenumber},
                                                         {"1/CM", wavenumber},
                                                         {"wavenumber [cm-1]", wavenumber},
                                                         {"Wavenumber (cm-1)", wavenumber},
                                                         {"wavenumber", wavenumber},
                                                         {"Wave number (cm-1)", wavenumber}};
    for (const auto& [head, axis] : rows) {
        const auto read = spectralHead(head);
        ASSERT_TRUE(read) << head;
        EXPECT_EQ(read->axis, axis) << head;
    }
    EXPECT_TRUE(spectralHead("wavelength_nm_air")->isInAir);
    ASSERT_TRUE(spectralHead("wavelength"));
    EXPECT_FALSE(spectralHead("wavelength")->axis);
}

TEST(SpectralHead, IsNoneForOtherWordsAndContradictions) {
    for (const char* head : {"", "response", "mm", "m", "eV", "THz", "wavelength [cm-1]",
                             "wavenumber [um]", "um nm", "emissivity [um]", "3", "Hz"}) {
        EXPECT_FALSE(spectralHead(head)) << head;
    }
}

TEST(SpectralHead, TellsTheUnitOfValuesWhereTheyLeaveNoDoubt) {
    EXPECT_EQ(axisOfValues({3.0, 5.0}, false), SpectralAxis::wavelength);
    EXPECT_EQ(axisOfValues({5.0, 3.0}, true), SpectralAxis::wavelength);
    EXPECT_EQ(axisOfValues({3000.0, 5000.0}, true), SpectralAxis::nanometres);
    EXPECT_FALSE(axisOfValues({3000.0, 5000.0}, false));
    EXPECT_FALSE(axisOfValues({3.0, 5000.0}, true));
    EXPECT_FALSE(axisOfValues({}, true));
}

TEST(SpectralHead, ConvertsToMicrometres) {
    EXPECT_EQ(wavelengthOn_um(SpectralAxis::wavelength, 3.2), 3.2);
    EXPECT_EQ(wavelengthOn_um(SpectralAxis::nanometres, 3200.0), 3.2);
    EXPECT_EQ(wavelengthOn_um(SpectralAxis::wavenumber, 2000.0), 5.0);
}

} // namespace
} // namespace irsg
