#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/render/values/RenderSettings.h"

namespace smat {

/// The words of settings for choices of irsg::RenderSettings, in the order of forms. Choices and
/// defaults of the settings' rows and the values of a scene all come from here.
template <typename Choice, std::size_t count>
using ChoiceWords = std::array<std::pair<const char*, Choice>, count>;

inline constexpr ChoiceWords<irsg::EngineChoice, 3> engineWords{
    {{"opengl", irsg::EngineChoice::opengl},
     {"rays", irsg::EngineChoice::rays},
     {"auto", irsg::EngineChoice::automatic}}};
inline constexpr ChoiceWords<irsg::TileStrategy, 2> zoomWords{
    {{"aligned", irsg::TileStrategy::aligned}, {"sills", irsg::TileStrategy::published}}};
inline constexpr ChoiceWords<irsg::ReflectionMode, 3> reflectionWords{
    {{"off", irsg::ReflectionMode::off},
     {"approx", irsg::ReflectionMode::approx},
     {"smart", irsg::ReflectionMode::smart}}};
inline constexpr ChoiceWords<irsg::SunShadowMode, 3> shadowWords{
    {{"off", irsg::SunShadowMode::off},
     {"point", irsg::SunShadowMode::point},
     {"disc", irsg::SunShadowMode::disc}}};
inline constexpr ChoiceWords<irsg::FluxWeights, 2> fluxWeightWords{
    {{"viewFactor", irsg::FluxWeights::viewFactor}, {"report", irsg::FluxWeights::report}}};
inline constexpr ChoiceWords<irsg::ReferenceTransmittance, 2> referenceTransmittanceWords{
    {{"ratio", irsg::ReferenceTransmittance::ratio},
     {"segment", irsg::ReferenceTransmittance::segment}}};
/// Counts per pixel, or per axis.
inline constexpr ChoiceWords<bool, 2> supersamplingWords{{{"perAxis", false}, {"perPixel", true}}};

template <typename Words>
std::vector<std::string> wordsOf(const Words& words) {
    std::vector<std::string> all;
    for (const auto& [word, value] : words)
        all.emplace_back(word);
    return all;
}

/// LogicError for a choice without a word.
template <typename Words, typename Choice>
std::string wordOf(const Words& words, Choice choice) {
    for (const auto& [word, value] : words)
        if (value == choice)
            return word;
    throw irsg::LogicError("a choice of rendering has no word");
}

/// LogicError for a word that no choice has; the table of settings refuses those before.
template <typename Words>
auto valueOf(const Words& words, std::string_view text) {
    for (const auto& [word, value] : words)
        if (text == word)
            return value;
    throw irsg::LogicError("a word of a setting names no choice");
}

} // namespace smat
