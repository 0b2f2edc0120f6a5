#include "irsg/radiometry/SpectralHead.h"

#include <gtest/gtest.h>

namespace irsg {
namespace {

TEST(SpectralHead, IsTheSameInEverySpelling) {
    const auto um = SpectralAxis::wavelength;
    const auto nm = SpectralAxis::nanometres;
    const auto angstrom = SpectralAxis::angstroms;
    const auto wavenumber = SpectralAxis::wavenumber;
    const std::pair<const char*, SpectralAxis> rows[] = {
        {"um", um},
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
        {"Wellenl\u00e4nge [\u00b5m]", um},
        {"WELLENL\u00c4NGE in \u00b5m", um},
        {"Wellenla\u0308nge (Mikrometer)", um},
        {"Wellenl\xe4nge [\xb5m]", um},
        {"Longueur d'onde (\u00b5m)", um},
        {"longueur d\u2019onde en nm", nm},
        {"\u00c5", angstrom},
        {"\u212b", angstrom},
        {"Wavelength [Angstrom]", angstrom},
        {"lambda [\u00c5ngstr\u00f6m]", angstrom},
        {"wavelength (A\u030a)", angstrom},
        {"Wellenzahl [cm-1]", wavenumber},
        {"Wellenzahl / cm\u207b\u00b9", wavenumber},
        {"Nombre d'onde [cm-1]", wavenumber},
        {"\u03bd (1/cm)", wavenumber},
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
    EXPECT_TRUE(spectralHead("Wellenl\u00e4nge in Luft [nm]")->isInAir);
    EXPECT_TRUE(spectralHead("longueur d'onde dans l'air (nm)")->isInAir);
    ASSERT_TRUE(spectralHead("wavelength"));
    EXPECT_FALSE(spectralHead("wavelength")->axis);
}

TEST(SpectralHead, IsNoneForOtherWordsAndContradictions) {
    for (const char* head :
         {"", "response", "mm", "m", "eV", "THz", "wavelength [cm-1]", "wavenumber [um]", "um nm",
          "emissivity [um]", "3", "Hz", "A", "wavelength [A]", "Wellenzahl [\u00c5]", "Frequenz"}) {
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
    EXPECT_EQ(wavelengthOn_um(SpectralAxis::angstroms, 32000.0), 3.2);
    EXPECT_EQ(wavelengthOn_um(SpectralAxis::wavenumber, 2000.0), 5.0);
}

} // namespace
} // namespace irsg
