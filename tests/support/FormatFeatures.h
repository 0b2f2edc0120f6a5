#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace irsg::test {

/// What becomes of a feature of a format.
enum class Outcome {
    followed, ///< the surfaces are as the file says
    remarked, ///< the model is read without it, and a remark says so
    refused,  ///< the file is refused, and the refusal says why
    looksOnly ///< it changes no surface: how one looks in visible light, or words beside it
};

/// A small file with a feature, and what is read of it.
struct FormatFeature {
    std::string format;  ///< the heading of its table
    std::string feature; ///< its words in the table
    std::string name;    ///< of the file
    std::string bytes;
    Outcome outcome;
    /// Of the remark or of the refusal.
    std::string says = "";
    double area_m2 = 2.0;                       ///< of what is read
    double diagonal_m = 2.23606797749978969641; ///< of its box
    std::map<std::string, std::string> beside = {};
};

/// A plate of 2 m by 1 m in each format, with one feature more in each file.
std::vector<FormatFeature> gltfFeatures();
std::vector<FormatFeature> colladaFeatures();
std::vector<FormatFeature> fbxFeatures();
std::vector<FormatFeature> textFeatures();    ///< OBJ, STL, PLY
std::vector<FormatFeature> drawingFeatures(); ///< DXF, .x
std::vector<FormatFeature> sceneFeatures();   ///< .ac, 3DS

inline std::vector<FormatFeature> allFeatures() {
    std::vector<FormatFeature> all;
    for (const auto& list : {gltfFeatures(), colladaFeatures(), fbxFeatures(), textFeatures(),
                             drawingFeatures(), sceneFeatures()}) {
        all.insert(all.end(), list.begin(), list.end());
    }
    return all;
}

/// The text with another in the place of the first `from`, which it must have.
std::string with(std::string text, std::string_view from, std::string_view to);
/// The same, behind the first `from`.
std::string withBehind(std::string text, std::string_view from, std::string_view more);

} // namespace irsg::test
