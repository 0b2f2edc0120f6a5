#include <cmath>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/core/Errors.h"

namespace irsg::particles {

namespace {

class Diagnostics {
  public:
    void add(const char* parameter, std::string value, std::string expected) {
        all_.push_back({"particles", parameter, std::move(value), std::move(expected)});
    }
    bool finite(const char* parameter, double value) {
        if (std::isfinite(value))
            return true;
        add(parameter, numberText(value), "a finite number");
        return false;
    }
    bool within(const char* parameter, double value, double lowest, double highest,
                const std::string& words) {
        if (!finite(parameter, value))
            return false;
        if (value >= lowest && value <= highest)
            return true;
        add(parameter, numberText(value), words);
        return false;
    }
    void raise() {
        if (!all_.empty())
            throw InputError(std::move(all_));
    }

  private:
    std::vector<Diagnostic> all_;
};

void checkAerosol(const ParticleSettings& s, Diagnostics& diagnostics) {
    if (s.aerosol && (static_cast<int>(*s.aerosol) < 0 || static_cast<int>(*s.aerosol) > 7))
        diagnostics.add("AerosolModel", std::to_string(static_cast<int>(*s.aerosol)), "0 to 7");

    if (diagnostics.finite("Visibility", s.visibility_m) && s.visibility_m != 0.0) {
        if (s.visibility_m < 10.0 || s.visibility_m > 300e3)
            diagnostics.add("Visibility", numberText(s.visibility_m) + " m",
                            "0 for the model's own, or 10 to 300000 m");
        else if (!s.aerosol)
            diagnostics.add("Visibility", numberText(s.visibility_m) + " m",
                            "0 m in an atmosphere without aerosol");
    }

    if (s.airMass < 1 || s.airMass > 10)
        diagnostics.add("AirMass", std::to_string(s.airMass), "1 (open ocean) to 10 (continental)");
    diagnostics.within("GroundAltitude", s.ground_m, 0.0, 5000.0, "0 to 5000 m");
    diagnostics.within("WindSpeed", s.windSpeed_m_s, 0.1, 30.0, "0.1 to 30 m/s");
    diagnostics.within("WindSpeedAverage24", s.windSpeed24h_m_s, 0.1, 30.0, "0.1 to 30 m/s");
    diagnostics.within("WindSpeedMeasurementHeight", s.windHeight_m, 2.0, 40.0, "2 to 40 m");
}

void checkCloud(const ParticleSettings& s, Diagnostics& diagnostics) {
    const bool known =
        (s.cloudModel >= 0 && s.cloudModel <= 10) || s.cloudModel == 18 || s.cloudModel == 19;
    if (!known)
        diagnostics.add("CloudModel", std::to_string(s.cloudModel), "0 to 10, 18 or 19");
    if (s.atmosphere &&
        (static_cast<int>(*s.atmosphere) < 1 || static_cast<int>(*s.atmosphere) > 6))
        diagnostics.add("AtmosphereModel", std::to_string(static_cast<int>(*s.atmosphere)),
                        "1 to 6");

    // Below 0 all three stand for the model's own.
    const bool base = diagnostics.within("CloudBaseAltitude", s.cloudBase_m, -1e9, 20e3,
                                         "negative for the model's own, or 0 to 20000 m");
    bool thickness = diagnostics.finite("CloudThickness", s.cloudThickness_m);
    if (thickness && s.cloudThickness_m > 0.0)
        thickness = diagnostics.within("CloudThickness", s.cloudThickness_m, 1.0, 20e3,
                                       "0 or less for the model's own, or 1 to 20000 m");
    diagnostics.within("CloudExtinction", s.cloudExtinction_per_m, -1e9, 1.0,
                       "0 or less for the model's own, or up to 1 m-1 (1000 km-1)");

    // Nothing is to be moved, stretched or scaled where there is no cloud.
    if (s.cloudModel == 0) {
        const char* expected = "the model's own: there is no cloud (CloudModel 0)";
        if (s.cloudBase_m >= 0.0)
            diagnostics.add("CloudBaseAltitude", numberText(s.cloudBase_m) + " m", expected);
        if (s.cloudThickness_m > 0.0)
            diagnostics.add("CloudThickness", numberText(s.cloudThickness_m) + " m", expected);
        if (s.cloudExtinction_per_m > 0.0)
            diagnostics.add("CloudExtinction", numberText(s.cloudExtinction_per_m) + " m-1",
                            expected);
    } else if (known && base && thickness) {
        const CloudPlace place = cloudPlace(s);
        if (place.base_m + place.thickness_m > 20e3)
            diagnostics.add("CloudThickness",
                            "a top at " + numberText(place.base_m + place.thickness_m) + " m",
                            "base and thickness together up to 20000 m");
    }
}

} // namespace

void check(const ParticleSettings& settings) {
    Diagnostics diagnostics;
    checkAerosol(settings, diagnostics);
    checkCloud(settings, diagnostics);
    diagnostics.raise();
}

} // namespace irsg::particles
