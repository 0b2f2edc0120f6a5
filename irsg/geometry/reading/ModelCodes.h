#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/core/FileStamp.h"
#include "irsg/geometry/reading/ModelValues.h"

namespace irsg {

/// Indices that a rule or a brush gives; what is not set stays as it was.
struct GivenCodes {
    std::optional<int> temperature = {}, material = {};
    IrCodes over(const IrCodes& before) const {
        return {temperature.value_or(before.temperature), material.value_or(before.material)};
    }
    bool operator==(const GivenCodes&) const = default;
};

/// Gives indices to all faces that carry a name.
struct CodeRule {
    enum class Of {
        material, ///< the name of the face's material
        object,   ///< the nearest name above the face: of its mesh or its node
        group     ///< any name above the face
    };
    Of of = Of::material;
    std::string pattern; ///< * stands for any text and ? for any one byte; the case counts
    GivenCodes codes;
    bool operator==(const CodeRule&) const = default;
};
/// "material", "object" and "group", in the order of CodeRule::Of.
const std::vector<std::string>& codeRuleNames();
bool fitsPattern(const std::string& name, const std::string& pattern);

/// A piece of surface that was painted by hand: triangles, counter-clockwise from their front, in
/// the axes and the unit of the model's file.
struct PaintedSurface {
    GivenCodes codes;
    std::vector<std::array<double, 9>> triangles; ///< x, y, z of three corners
    bool operator==(const PaintedSurface&) const = default;
};

/// Codes for a model beside the model: `MODEL.codes.json`. They win over codes in the model itself,
/// and come in this order, later ones winning: rules, then painted surfaces. A face takes the codes
/// of the painted triangle it lies on (its centre, within 1e-4 of the diagonal, on the same side),
/// so that they survive a new export of the model that cuts its faces otherwise.
struct ModelCodes {
    std::vector<CodeRule> rules;
    std::vector<PaintedSurface> painted;
    bool empty() const { return rules.empty() && painted.empty(); }
    bool operator==(const ModelCodes&) const = default;
};

/// `heli.codes.json` for `heli.glb`.
std::filesystem::path codesFileOf(const std::filesystem::path& model);

/// Throws InputError that lists everything that is wrong, each with its key path and line.
ModelCodes modelCodesFromJson(const std::string& text, const std::string& fileName);
std::string modelCodesToJson(const ModelCodes& codes);
/// Those beside a model; none where there is no such file. Throws InputError.
ModelCodes readModelCodes(const std::filesystem::path& model);
/// In one step, or not at all (InputError). Without any codes the file goes.
void saveModelCodes(const ModelCodes& codes, const std::filesystem::path& model);

/// What tells whether a model has changed since it was read: its file, and the one with its codes.
struct ModelStamp {
    std::optional<FileStamp> model, codes;
    bool operator==(const ModelStamp&) const = default;
};
ModelStamp modelStampOf(const std::filesystem::path& model);

} // namespace irsg
