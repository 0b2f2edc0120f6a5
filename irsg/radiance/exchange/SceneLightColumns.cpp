#include <algorithm>

#include "irsg/radiance/MirrorReflectivity.h"
#include "irsg/radiance/exchange/SceneLight.h"

namespace irsg {

namespace {

LightPattern patternOf(LightOrigin origin) {
    switch (origin) {
    case LightOrigin::sun:
        return LightPattern::sun;
    case LightOrigin::sky:
        return LightPattern::sky;
    default:
        return LightPattern::ground;
    }
}

} // namespace

void SceneLight::findColumns() {
    const std::vector<RadianceTerm>& terms = radiometry_.terms().terms;
    std::vector<bool> sending(exchange_->rows());
    for (std::size_t s = 0; s < exchange_->senders(); ++s)
        if (exchange_->isSeen(s))
            sending[static_cast<std::size_t>(exchange_->rowOfSender(s))] = true;
    for (int row = 0; row < static_cast<int>(exchange_->rows()); ++row) {
        if (exchange_->ofRow(row).empty())
            continue;
        const bool sends = sending[static_cast<std::size_t>(row)];
        const SurfaceSpectra& surface = radiometry_.surfaces()[static_cast<std::size_t>(row)];
        const AtmosphereSamples& air = radiometry_.air(radiometry_.rows().first(row));
        for (std::size_t t = 0; t < terms.size(); ++t) {
            if (terms[t].surface == SurfaceQuantity::emission && sends)
                columns_.push_back({row, t, LightPattern::emission});
            if (terms[t].origin == LightOrigin::none || !terms[t].light || !air.light[t])
                continue;
            if (terms[t].origin == LightOrigin::sky)
                skyTerm_ = static_cast<int>(t);
            if (terms[t].origin == LightOrigin::ground)
                groundTerm_ = static_cast<int>(t);
            if (terms[t].origin == LightOrigin::sun)
                sunTerm_ = static_cast<int>(t);
            const bool reflects = std::ranges::any_of(
                surface.reflectance, [](double value) { return value > leastReflectance_per_sr; });
            if (sends && reflects)
                addReflected(row, t, patternOf(terms[t].origin));
        }
    }
    for (const LightExchange::GasSender& gas : exchange_->gasSenders())
        for (std::size_t t = 0; t < terms.size(); ++t)
            if (terms[t].surface == SurfaceQuantity::emission)
                columns_.push_back({gas.row, t, LightPattern::emission});
    addPassedColumns();
    if (exchange_->areMirrorsFollowed())
        addComponentColumns();
}

/// Rows of one material that reflect alike, whatever their temperatures, share a column.
void SceneLight::addReflected(int row, std::size_t term, LightPattern pattern) {
    const SurfaceRows& rows = radiometry_.rows();
    const auto isAlike = [&](const LightColumn& column) {
        const auto &own = rows.keyOf(row), &other = rows.keyOf(column.row);
        return column.term == term && column.pattern == pattern && own.first == other.first &&
               own.second.material == other.second.material &&
               radiometry_.surfaces()[static_cast<std::size_t>(row)].reflectance ==
                   radiometry_.surfaces()[static_cast<std::size_t>(column.row)].reflectance &&
               &lightOn(row, static_cast<int>(term)) ==
                   &lightOn(column.row, static_cast<int>(term));
    };
    const auto known = std::ranges::find_if(columns_, isAlike);
    if (known != columns_.end())
        known->alike.push_back(row);
    else
        columns_.push_back({row, term, pattern});
}

/// The emission that each component of a mirror takes away.
void SceneLight::addComponentColumns() {
    const std::vector<RadianceTerm>& terms = radiometry_.terms().terms;
    const SurfaceRows& rows = radiometry_.rows();
    const MirrorReflectivity mirrors(radiometry_, bounces_);
    for (int row = 0; row < static_cast<int>(exchange_->rows()); ++row) {
        const int first = exchange_->firstComponentOf(row);
        if (first < 0 || exchange_->ofRow(row).empty())
            continue;
        const SurfaceModel& model = *radiometry_.models()[static_cast<std::size_t>(row)];
        for (int k = 0; k < static_cast<int>(model.components()); ++k)
            for (std::size_t t = 0; t < terms.size(); ++t)
                if (terms[t].surface == SurfaceQuantity::emission &&
                    mirrors.isComponentFollowed(row, static_cast<std::size_t>(k)))
                    columns_.push_back(
                        {rows.firstLobe(row) + k, t, LightPattern::emission, first + k});
    }
}

/// Sky and ground through transparent surfaces, and what shadows on the ground take: in the air of
/// each body that sees any. And all of them and the sun, as mirrors receive them.
void SceneLight::addPassedColumns() {
    if (exchange_->through().empty() && exchange_->throughGas().empty() &&
        !exchange_->areMirrorsFollowed())
        return;
    std::vector<bool> isKnown(exchange_->bodies().size());
    for (int row = 0; row < static_cast<int>(exchange_->rows()); ++row) {
        if (exchange_->ofRow(row).empty() || isKnown[exchange_->bodyOfRow(row)])
            continue;
        isKnown[exchange_->bodyOfRow(row)] = true;
        for (const auto& [term, pattern] : {std::pair{skyTerm_, LightPattern::passedSky},
                                            std::pair{groundTerm_, LightPattern::passedGround},
                                            std::pair{sunTerm_, LightPattern::passedSun}})
            if (term >= 0 && (pattern != LightPattern::passedSun ||
                              exchange_->groundReflectivity() || exchange_->areMirrorsFollowed()))
                columns_.push_back({row, static_cast<std::size_t>(term), pattern});
    }
}

} // namespace irsg
