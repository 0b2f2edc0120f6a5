#pragma once

#include <vector>

#include "tools/samples/FlightWriter.h"

namespace smat {

/// One section of a lifting surface: its nose, its chord backwards, and where its back is.
struct Section {
    irsg::Vec3 nose;
    double chord;
    double thickness; ///< of the chord
    double camber;
    irsg::Vec3 up;
};

/// A control surface along the span, behind a gap.
struct Flap {
    double from, to;
};

/// A wing or a part of the tail, of sections of NACA's four digits.
struct LiftingSurface {
    double root, tip; ///< of the parameter along the span
    Section (*section)(double span);
    double hinge; ///< part of the chord that is fixed
    std::vector<Flap> flaps;
    /// The kinds of surface by place along span and chord, above and below.
    const FlightSurface* (*surfaceAt)(double span, double chord, bool above);
    double step;
    bool mirrored;            ///< drawn for the port side: turns what is in front
    const FlightSurface* gap; ///< walls of the gaps before control surfaces
};

/// Writes a lifting surface: what is fixed, the gaps, and the control surfaces behind them.
void addLiftingSurface(FlightWriter& writer, const LiftingSurface& surface);

/// Towards the end of a surface its chord goes round: the part of it that is left.
double endRound(double span, double tip, double over);

} // namespace smat
