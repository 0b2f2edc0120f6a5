#pragma once

#include <optional>
#include <string>

#include "irsg/geometry/view/Sensor.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// The shape of the entrance pupil.
enum class PupilShape {
    circular,
    annular, ///< a circle with a central obscuration
    square   ///< its aperture is the side
};

/// The solid angle in which a pixel sees the pupil, of a circle with F = focal length / aperture.
enum class ConeConvention {
    exact,     ///< "1/(4F^2+1)": pi / (4 F^2 + 1), the projected solid angle of a flat disc
    smallAngle ///< "1/(4F^2)": pi / (4 F^2)
};

/// Optics at infinity focus.
struct SensorOptics {
    PupilShape pupil = PupilShape::circular;
    double aperture_m = 0.0; ///< diameter, of a square its side; > 0
    double focalLength_m = 0.0;
    double obscuration = 0.0; ///< of an annulus: inner through outer diameter, 0 to 1, exclusive
    Spectrum transmission = Spectrum::constant(1.0); ///< 0 to 1
    double temperature_K = 0.0;                      ///< 0: cold, without emission
    double emissivity = 0.0;                         ///< 0 to 1; with the transmission at most 1
    double coldShieldEfficiency = 1.0; ///< part of the hemisphere beside the cone that is shielded
    double housingTemperature_K = 0.0; ///< of what the detector sees past the shield
    double defocus_waves = 0.0;        ///< wavefront error at the edge of the pupil (W020)
    double defocusWavelength_um = 0.0; ///< in whose waves it is given; > 0 where there is any
    double aberrationBlur_urad = 0.0;  ///< standard deviation of a Gaussian point spread, per axis

    double fNumber() const { return focalLength_m / aperture_m; }
    /// Of the pupil, less what is obscured.
    double apertureArea_m2() const;
    /// Projected solid angle in which the detector's centre sees the pupil.
    double cone_sr(ConeConvention convention) const;
};

/// What the detector's response is a spectrum of.
enum class ResponseKind {
    quantumEfficiency, ///< electrons per photon
    responsivity_A_per_W,
    absorptance ///< of a thermal detector: absorbed per incident power
};

struct SensorDetector {
    double pitch_um = 0.0;   ///< of square pixels
    double fillFactor = 1.0; ///< part of the pixel's area, a centred square; 0 to 1
    int columns = 0, rows = 0;
    double integrationTime_s = 0.0; ///< of a scanner the dwell time
    ResponseKind responseKind = ResponseKind::quantumEfficiency;
    Spectrum response;
    SpectralRange band;                    ///< outside of it the response is 0
    std::optional<double> well_e;          ///< of photon detectors: electrons; at least 1
    double darkCurrent_e_per_s = 0.0;      ///< of photon detectors
    double timeConstant_s = 0.0;           ///< of a low-pass of first order; 0: none
    std::optional<double> thermalNetd_K;   ///< of thermal detectors: noise as a NETD
    double thermalNetdTemperature_K = 0.0; ///< of the background that it is given for

    bool isThermal() const { return responseKind == ResponseKind::absorptance; }
    double activeWidth_um() const; ///< of the square that senses
};

struct SensorMotion {
    double jitter_urad = 0.0; ///< standard deviation per axis within an integration time
    double lineOfSightRate_urad_per_s = 0.0; ///< along the rows, a drift or a scan
};

struct SensorElectronics {
    double gain = 0.0; ///< electrons, of thermal detectors absorbed watts, per count
    double offset_counts = 0.0;
    double readNoise_e = 0.0;   ///< of photon detectors, standard deviation
    int bits = 14;              ///< of the converter, 1 to 32
    double frameRate_Hz = 30.0; ///< of the frames that an observer sees, > 0
};

/// The seven components of three-dimensional noise (D'Agostino and Webb, Proc. SPIE 1488, 1991):
/// time, vertical (rows) and horizontal (columns). tvh is the temporal noise that follows from all
/// else; the others are standard deviations in parts of it at the reference background.
struct SensorNoise {
    double referenceTemperature_K = 300.0;
    double tv = 0.0;                ///< a row in a frame
    double th = 0.0;                ///< a column in a frame
    double t = 0.0;                 ///< a frame
    double vh = 0.0;                ///< a pixel: fixed pattern, what a correction leaves
    double v = 0.0;                 ///< a row
    double h = 0.0;                 ///< a column
    double deadPixelFraction = 0.0; ///< give no signal
    double hotPixelFraction = 0.0;  ///< are always full
};

/// A sensor from its pupil to its counts, as a value. `Sensor` is the pinhole camera that its image
/// is rendered with. Electrons stand for the signal of photon detectors, absorbed watts for that of
/// thermal ones.
struct SensorDescription {
    std::string title;
    std::string source; ///< where its numbers come from
    SensorOptics optics;
    SensorDetector detector;
    SensorMotion motion;
    SensorElectronics electronics;
    SensorNoise noise;

    /// Throws InputError with everything that cannot be, by its key in the file.
    void check() const;

    double pixelAngle_rad() const { return 1e-6 * detector.pitch_um / optics.focalLength_m; }
    double activeArea_m2() const;
    /// Signal per joule on the detector: electrons, or absorbed joules per second of integration.
    double signalPerJoule(double wavelength_um) const;
    /// Signal per joule in front of the optics, relative to its peak, as the response of a band.
    Band band() const;
    /// The peak: electrons per joule, or 1 for each absorbed joule.
    double peakSignalPerJoule() const;
    /// The pinhole camera of its detector: columns, rows, field of view and band.
    Sensor pinhole() const;
};

} // namespace irsg
