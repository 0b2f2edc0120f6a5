#pragma once

#include "irsg/sensor/SensorDescription.h"

namespace irsg::test {

/// A cooled staring sensor whose numbers have closed forms: constant transmission and quantum
/// efficiency, no emission of its own.
inline SensorDescription staringSensor() {
    SensorDescription sensor;
    sensor.title = "staring";
    sensor.optics.aperture_m = 0.1;
    sensor.optics.focalLength_m = 0.2;
    sensor.optics.transmission = Spectrum::constant(0.8);
    sensor.detector.pitch_um = 15.0;
    sensor.detector.columns = 48;
    sensor.detector.rows = 40;
    sensor.detector.integrationTime_s = 2e-3;
    sensor.detector.response = Spectrum::constant(0.7);
    sensor.detector.band = {3.999, 4.001};
    sensor.detector.well_e = 7e6;
    sensor.electronics.gain = 10.0;
    sensor.electronics.bits = 20;
    sensor.check();
    return sensor;
}

} // namespace irsg::test
