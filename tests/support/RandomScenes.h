#pragma once

#include <array>
#include <string>

#include "irsg/scene/InteractiveRenderer.h"

namespace irsg::test {

/// Where a random scene is from.
enum class RandomAtmosphere {
    none,     ///< constant air and background
    spectral, ///< computed air, 5 cm-1
    wideband
};

/// A scene as a user may have it: a sample or some boxes, balls, plates and wires of random places,
/// temperatures and emissivities, seen from anywhere, near or far, in any mode of antialiasing.
struct RandomScene {
    std::string name;
    Scene scene;
    SensorView view;
    bool alongRange = false;
};

/// Equal numbers give equal scenes on every machine.
RandomScene randomScene(unsigned number, RandomAtmosphere air);

/// A measured number with its error, and the truth.
struct JudgedNumber {
    double value = 0.0, truth = 0.0;
    ErrorParts error;

    double wrong() const { return value > truth ? value - truth : truth - value; }
    bool isCovered() const { return wrong() <= error.sum(); }
};

/// Intensity and contrast intensity of all of a scene, against windows of 2048 samples, air in bins
/// of 1 cm-1 with thin slices, and a dense background.
std::array<JudgedNumber, 2> judged(Renderer& renderer, const RandomScene& random);

} // namespace irsg::test
