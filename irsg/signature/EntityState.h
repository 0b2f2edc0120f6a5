#pragma once

namespace irsg {

/// What an entity is doing: everything eq. 7 and eq. 6 depend on beside the database.
struct EntityState {
    double time_s = 0.0;
    double power = 0.0; ///< engine power setting, 0 to 1 by custom; the lookup tables' own axis
    double mach = 0.0;
    double altitude_m = 0.0;
    double ambient_K = 288.15;
    /// Between the nose axis and the direction reference point -> sensor, 0 to pi.
    double aspectAngle_rad = 0.0;

    bool operator==(const EntityState&) const = default;
};

} // namespace irsg
