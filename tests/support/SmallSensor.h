#pragma once

#include "irsg/sensor/SensorDescription.h"

namespace smat::test {

/// A small sensor of a narrow band, without noise but photons and readout.
inline irsg::SensorDescription smallSensor() {
    irsg::SensorDescription sensor;
    sensor.title = "small";
    sensor.optics.aperture_m = 0.05;
    sensor.optics.focalLength_m = 0.2;
    sensor.optics.transmission = irsg::Spectrum::constant(0.8);
    sensor.detector.pitch_um = 20.0;
    sensor.detector.columns = 24;
    sensor.detector.rows = 20;
    sensor.detector.integrationTime_s = 1e-3;
    sensor.detector.response = irsg::Spectrum::constant(0.7);
    sensor.detector.band = {4.0, 4.1};
    sensor.detector.well_e = 5e6;
    sensor.electronics.gain = 50.0;
    sensor.electronics.readNoise_e = 100.0;
    sensor.electronics.bits = 18;
    return sensor;
}

} // namespace smat::test
