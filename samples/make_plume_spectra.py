#!/usr/bin/env python3
"""Writes the plume spectra of the samples: emission and transmission of the wall of a gas shell.

    python3 samples/make_plume_spectra.py        (standard library only)

The plumes of the sample models are closed shells, one inside the other, and a line of sight crosses
both walls of each. So each wall carries half of its zone: it is an isothermal layer of CO2 and H2O
with the column of half the zone's diameter. All zones of a plume share one material (one code in
the model), hence one transmissivity; by Kirchhoff's law the wall of a zone at temperature T emits

    L(nu) = [1 - tau_CO2 tau_H2O] B(nu, T)

split into the component CO2, (1 - tau_CO2) B, and the component H2O, tau_CO2 (1 - tau_H2O) B.

The mean transmittance of a layer at low resolution follows the statistical model of Goody,

    tau = exp(-k X / sqrt(1 + k X / beta)),   beta = pi (line width) / (line spacing),

with the mean absorption coefficient k(nu) of a band from

  (a) CO2 at 4.3 um: the P and R branches of a rigid rotor, "just overlapping lines" (Penner, 1959;
      Malkmus, 1963):  k = S (hc/kT) sum_v w_v (x_v / 4B) exp(-(hc/kT) x_v^2 / 4B),
      x_v = |nu - nu0 + 12.5 v|, where v counts quanta of the bending mode (667.4 cm-1), each of which
      moves the band by x23 = -12.5 cm-1 (Herzberg, 1945) and has the Boltzmann weight
      w_v = (v + 1) q^v (1 - q)^2, q = exp(-hc 667.4/kT). B = 0.3902 cm-1, nu0 = 2349.1 cm-1, band
      strength S = 2700 cm-2 atm-1 at 0 deg C (Penner, 1959), line width 0.07 cm-1 at 296 K and 1 atm
      with exponent 0.7, line spacing 4B;
  (b) the other bands: the exponential wide band model (Edwards, 1976; tabulated in Modest, Radiative
      Heat Transfer):  k = (alpha/omega) exp(-2 |nu - nuc| / omega), omega = omega0 sqrt(T/T0),
      beta = beta0 sqrt(T0/T), T0 = 100 K, pressure 1 atm.

Hot gas emits beyond both edges of the band that cold air absorbs: what is left behind 100 m of air is
the blue spike near 4.18 um and the red spike from 4.35 um on. The spectra of the aircraft are those
that an instrument at 100 m sees through air of 288 K with 400 ppm of CO2 and 50 % humidity, and
carry that reference distance; those of the ship are free of air.

Columns, mole fractions and temperatures of the zones are our assumptions, stated below.
"""
import math
import os

C1 = 1.191042972e-12  # 2 h c^2 in W cm-2 sr-1 (cm-1)-4
C2 = 1.438776877  # h c / k in cm K
GRAMS_PER_M2_OF_ATM_CM = {"CO2": 19.64, "H2O": 8.04}  # 1 cm of gas at 0 deg C and 1 atm


def planck(nu, temperature):
    """Black body, W cm-2 sr-1 (cm-1)-1."""
    return C1 * nu**3 / math.expm1(C2 * nu / temperature)


def co2_43(nu, temperature):
    """(a): k in m2/g and beta."""
    strength = 2700.0 / GRAMS_PER_M2_OF_ATM_CM["CO2"]
    rotation = 0.3902
    q = math.exp(-C2 * 667.4 / temperature)
    k = 0.0
    for v in range(12):
        x = abs(nu - 2349.1 + 12.5 * v)
        weight = (v + 1) * q**v * (1 - q) ** 2
        k += weight * x / (4 * rotation) * math.exp(-C2 / temperature * x * x / (4 * rotation))
    beta = math.pi * 0.07 * (296.0 / temperature) ** 0.7 / (4 * rotation)
    return strength * C2 / temperature * k, beta


# (b): centre cm-1, alpha cm-1/(g m-2), beta0, omega0 cm-1
EDWARDS = {
    "CO2": [(3660.0, 4.0, 0.13341, 23.5)],
    "H2O": [(1600.0, 41.2, 0.09427, 56.4), (3760.0, 24.89, 0.13219, 60.0),
            (5350.0, 3.0, 0.08169, 43.1)],
}


def transmittance(gas, nu, column_g_m2, temperature):
    """Of a layer, the product over its bands."""
    bands = []
    for centre, alpha, beta0, omega0 in EDWARDS[gas]:
        omega = omega0 * math.sqrt(temperature / 100.0)
        bands.append((alpha / omega * math.exp(-2 * abs(nu - centre) / omega),
                      beta0 * math.sqrt(100.0 / temperature)))
    if gas == "CO2":
        bands.append(co2_43(nu, temperature))
    depth = sum(k * column_g_m2 / math.sqrt(1 + k * column_g_m2 / beta) for k, beta in bands)
    return math.exp(-depth)


def axis():
    """Wavenumbers from 1.9 to 12.5 um, fine where the 4.3 um band is."""
    nu = 800.0
    while nu <= 5300.0:
        yield nu
        nu += 4.0 if 2140.0 <= nu < 2460.0 else 20.0 if 1200.0 <= nu < 4200.0 else 100.0


def wall(nu, gas):
    """Emissivities of both components and the transmissivity of a wall."""
    co2 = transmittance("CO2", nu, gas["CO2_g_m2"], gas["state_K"])
    h2o = transmittance("H2O", nu, gas["H2O_g_m2"], gas["state_K"])
    return 1 - co2, co2 * (1 - h2o), co2 * h2o


def air(nu, distance_m):
    """Air of 288 K: 0.745 g m-3 of CO2 (400 ppm), 6.4 g m-3 of water (50 %)."""
    return (transmittance("CO2", nu, 0.745 * distance_m, 288.0) *
            transmittance("H2O", nu, 6.4 * distance_m, 288.0))


# Columns of half a zone. Aircraft: exhaust of a lean gas turbine, 3.3 % CO2 and as much H2O at the
# nozzle, thinned on the way out so that each zone holds about as much as the other. Ship: exhaust of
# a diesel engine thinned to 2 % CO2, 1.5 m of it.
PLUMES = {
    "turboprop4": {"gas": {"CO2_g_m2": 4.0, "H2O_g_m2": 1.6, "state_K": 500.0},
                   "reference_m": 100.0,
                   "zones": {"plume core": 700.0, "plume mid": 480.0, "plume outer": 360.0}},
    "ship": {"gas": {"CO2_g_m2": 38.0, "H2O_g_m2": 16.0, "state_K": 420.0},
             "reference_m": 0.0,
             "zones": {"funnel plume": 420.0}},
}


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    for sample, plume in PLUMES.items():
        for zone, temperature in plume["zones"].items():
            with open(os.path.join(here, sample, zone + ".csv"), "w", newline="\n") as out:
                out.write("# unit: W cm-2 sr-1 (cm-1)-1\n")
                out.write("# reference_distance_m: %g\n" % plume["reference_m"])
                out.write("# wall of an isothermal shell at %g K (make_plume_spectra.py)\n"
                          % temperature)
                out.write("cm-1,CO2,H2O\n")
                for nu in axis():
                    co2, h2o, _ = wall(nu, plume["gas"])
                    black = planck(nu, temperature) * air(nu, plume["reference_m"])
                    out.write("%g,%.6g,%.6g\n" % (nu, co2 * black, h2o * black))
        with open(os.path.join(here, sample, "gas.csv"), "w", newline="\n") as out:
            out.write("# wall of a gas shell, emissivity = 1 - transmissivity"
                      " (make_plume_spectra.py)\n")
            out.write("um,transmissivity\n")
            for nu in reversed(list(axis())):
                out.write("%.8g,%.6g\n" % (1e4 / nu, wall(nu, plume["gas"])[2]))


if __name__ == "__main__":
    main()
