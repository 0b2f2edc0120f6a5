#pragma once

#include <string>
#include <vector>

#include "irsg/geometry/conversion/ModelNames.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// How warm a surface is, as one says it before anything is measured.
struct FirstTemperature {
    enum class Kind {
        air,      ///< as the air around it
        aboveAir, ///< by so many kelvin warmer than it
        recovery, ///< that of air brought to rest: air where it stands, warmer with the Mach number
        fixed     ///< so many kelvin
    };
    Kind kind = Kind::air;
    double kelvin = 0.0; ///< of aboveAir and fixed
    auto operator<=>(const FirstTemperature&) const = default;
};
/// "air + 400 K", for names of entries.
std::string nameOf(const FirstTemperature& temperature);

/// A surface of a model that has names and no codes, and what it might be.
struct FirstSurface {
    CodeRule::Of of = CodeRule::Of::material;
    std::string name; ///< in the file
    long polygons = 0;
    double area = 0.0;       ///< in squares of the file's unit
    int libraryMaterial = 0; ///< index in materialLibrary()
    FirstTemperature temperature;
    std::string because; ///< the word of the name that says so; empty where none does
    int strength = 0;    ///< of two rules for a face the stronger one counts
};

/// The surfaces of a model by what the names of its materials, objects and groups say together. A
/// face belongs to the one of its names that counts most: a word of something hot, then of what it
/// is made of, then of a colour or a part; of these a material before an object before a group.
/// What all faces have in common (the name of the whole) says nothing of a part. Faces without a
/// known word are taken by their material or, where no face has one, by object or group, if these
/// are not more than 100, or else all as one, "*". Of more than 100 surfaces by object or by group
/// those that differ in numbers alone are one, "rivet*". Each surface has a material of the library
/// and a temperature. Largest first.
std::vector<FirstSurface> suggestedSurfaces(const NamedParts& parts);

/// Codes and entries for surfaces: an index for each material and each temperature that occurs,
/// from 1, in the order of the surfaces; the rules by strength, since later ones win.
struct FirstSignature {
    ModelCodes codes;
    SignatureDatabase database;
};
FirstSignature firstSignatureOf(const std::vector<FirstSurface>& surfaces,
                                const std::string& title);

} // namespace irsg
