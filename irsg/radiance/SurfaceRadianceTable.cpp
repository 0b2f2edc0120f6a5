#include "irsg/radiance/SurfaceRadianceTable.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/NodeBlocks.h"
#include "irsg/radiometry/DotProducts.h"

namespace irsg {

namespace {

/// Pieces that kinds are divided into.
constexpr std::size_t combineParts = 8;

double sumOf(const double* a, std::size_t count) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        sum += a[i];
    return sum;
}

/// A place of a table that grows as it is asked.
template <typename Entry>
Entry& at(std::vector<std::vector<Entry>>& table, int stack, int row, std::size_t rows) {
    const auto number = static_cast<std::size_t>(stack);
    if (number >= table.size())
        table.resize(number + 1);
    if (table[number].empty())
        table[number].resize(rows);
    return table[number][static_cast<std::size_t>(row)];
}

} // namespace

SurfaceRadianceTable::SurfaceRadianceTable(const SceneRadiometry& radiometry,
                                           const OccluderStacks& occluderStacks)
    : radiometry_(radiometry),
      occluderStacks_(occluderStacks),
      outputs_(radiometry.outputs().size()),
      factorCount_(radiometry.terms().factorCount()) {
    for (const auto& [first, last] : radiometry.outputs())
        area_um_.push_back(sumOf(&radiometry.weights_um()[first], last - first));
    for (std::size_t drawn = 0; drawn < radiometry.surfaces().size(); ++drawn)
        termGroups_.push_back(termGroupsOf(static_cast<int>(drawn)));
    setBackground(
        std::make_shared<const std::vector<double>>(radiometry.wavelengths_um().size(), 0.0));
}

void SurfaceRadianceTable::setBackground(SharedValues background) {
    if (areEqual(background, background_)) {
        background_ = std::move(background);
        return;
    }
    background_ = std::move(background);
    inBand_.clear();
    for (std::size_t output = 0; output < outputs_; ++output)
        inBand_.push_back(radiometry_.integrate(*background_, output));
    for (std::vector<HiddenPlace>& ofStack : hiddenPlaces_)
        for (HiddenPlace& place : ofStack)
            place.isKnown = false;
}

void SurfaceRadianceTable::turn(const std::vector<int>& drawn) {
    for (std::vector<Place>& ofStack : places_)
        for (const int one : drawn)
            for (int row = radiometry_.rows().first(one);
                 row < radiometry_.rows().first(one + 1) && !ofStack.empty(); ++row)
                ofStack[static_cast<std::size_t>(row)].isCombined = false;
}

std::vector<SurfaceRadianceTable::TermGroup> SurfaceRadianceTable::termGroupsOf(int drawn) const {
    const SurfaceSpectra& surface = radiometry_.surfaces()[static_cast<std::size_t>(drawn)];
    const AtmosphereSamples& air = radiometry_.air(radiometry_.rows().first(drawn));
    std::vector<TermGroup> groups;
    const auto add = [&](std::size_t term, double sign, TermGroup group) {
        auto known = std::ranges::find_if(groups, [&](const TermGroup& other) {
            return other.slot == group.slot && other.part == group.part &&
                   other.passesAtmosphere == group.passesAtmosphere &&
                   other.pathLight == group.pathLight;
        });
        if (known == groups.end())
            known = groups.insert(groups.end(), std::move(group));
        known->terms.emplace_back(term, sign);
    };
    for (std::size_t k = 0; k < radiometry_.terms().terms.size(); ++k) {
        const RadianceTerm& term = radiometry_.terms().terms[k];
        if ((term.light && !air.light[k]) || surface.isWithout(term.surface))
            continue;
        const bool isEmission = term.surface == SurfaceQuantity::emission;
        TermGroup group;
        group.passesAtmosphere =
            term.passesAtmosphere || (isEmission && surface.emissionPassesAtmosphere);
        if (term.isAlongPath())
            group.pathLight = static_cast<int>(k);
        const auto parts = static_cast<int>(surface.emission.size());
        for (int part = isEmission ? 0 : -1; part < (isEmission ? parts : 0); ++part) {
            group.part = part;
            group.slot = factorCount_;
            if (term.factor.drawn < 0 || term.factor.complement)
                add(k, 1.0, group);
            group.slot = static_cast<std::size_t>(term.factor.drawn);
            if (term.factor.drawn >= 0)
                add(k, term.factor.complement ? -1.0 : 1.0, group);
        }
    }
    return groups;
}

SurfaceRadianceTable::Place& SurfaceRadianceTable::placeOf(const SurfaceStackId& kind) {
    return at(places_, kind.stack, kind.row, static_cast<std::size_t>(radiometry_.rows().size()));
}

SurfaceRadianceTable::HiddenPlace& SurfaceRadianceTable::hiddenPlaceOf(int stack, int drawn) {
    return at(hiddenPlaces_, stack, drawn, termGroups_.size());
}

std::vector<double> SurfaceRadianceTable::passed(int stack,
                                                 std::pair<std::size_t, std::size_t> nodes,
                                                 bool throughAir, int drawn) const {
    const auto& [first, last] = nodes;
    std::vector<double> product(last - first);
    radiometry_.fillPassed(occluderStacks_.materials(stack), first, product.size(), product.data(),
                           throughAir, drawn);
    return product;
}

bool SurfaceRadianceTable::hasGas(int stack) const {
    return std::ranges::any_of(occluderStacks_.materials(stack),
                               [](const OccluderMaterial& one) { return isGasColumn(one.second); });
}

SurfaceRadianceTable::Passed SurfaceRadianceTable::passedBy(int stack, int drawn) const {
    const std::pair<std::size_t, std::size_t> all{0, radiometry_.weights_um().size()};
    Passed result{passed(stack, all, false, drawn), {}};
    if (hasGas(stack))
        result.throughAir = passed(stack, all, true, drawn);
    return result;
}

std::map<std::pair<int, int>, SurfaceRadianceTable::Work>
SurfaceRadianceTable::plan(const std::vector<SurfaceStackId>& kinds) {
    std::map<std::pair<int, int>, Work> all;
    for (const SurfaceStackId& kind : kinds) {
        const int drawn = radiometry_.rows().renderedOf(kind.row);
        Place& place = placeOf(kind);
        HiddenPlace& hidden = hiddenPlaceOf(kind.stack, drawn);
        if (place.isKnown && place.path == path_ && hidden.isKnown)
            continue;
        Work& work = all[{kind.stack, drawn}];
        if (place.isKnown && place.path != path_) {
            const std::vector<TermGroup>& groups = termGroups_[static_cast<std::size_t>(drawn)];
            for (std::size_t output = 0; output < outputs_; ++output)
                for (std::size_t s = 0; s < groups.size(); ++s)
                    if (groups[s].pathLight >= 0)
                        groupSums_[place.groupSums + output * groups.size() + s] = 0.0;
            work.rowsOfPath.push_back(kind.row);
            place.isCombined = false;
        }
        if (!place.isKnown) {
            place.groupSums = groupSums_.size();
            groupSums_.resize(groupSums_.size() +
                              outputs_ * termGroups_[static_cast<std::size_t>(drawn)].size());
            place.sent = sent_.size();
            sent_.resize(sent_.size() + outputs_ * valuesOfKind());
            work.rows.push_back(kind.row);
        }
        if (!hidden.isKnown) {
            if (!hidden.hasRoom) {
                hidden.at = hidden_.size();
                hidden_.resize(hidden_.size() + 2 * outputs_);
            }
            std::fill_n(&hidden_[hidden.at], 2 * outputs_, 0.0);
            work.hidden = true;
        }
        place.isKnown = hidden.isKnown = hidden.hasRoom = true;
        place.path = path_;
    }
    return all;
}

void SurfaceRadianceTable::prepare(const std::vector<SurfaceStackId>& kinds) {
    const std::map<std::pair<int, int>, Work> wanted = plan(kinds);
    std::vector<std::pair<int, Passed>> through; // by front
    std::vector<std::pair<std::size_t, const std::pair<const std::pair<int, int>, Work>*>> all;
    for (const auto& one : wanted) {
        if (through.empty() || through.back().first != one.first.first)
            through.emplace_back(one.first.first, Passed());
        all.emplace_back(through.size() - 1, &one);
    }
    parallelFor(through.size(),
                [&](std::size_t i) { through[i].second = passedBy(through[i].first); });
    parallelFor(all.size(), [&](std::size_t i) {
        const auto& [surface, work] = *all[i].second;
        const auto& [stack, drawn] = surface;
        if (!radiometry_.isGas(drawn))
            return evaluate(stack, drawn, drawn, work, through[all[i].first].second);
        for (const int part : radiometry_.partsOf(drawn))
            evaluate(stack, drawn, part, work, passedBy(stack, part));
    });
    std::vector<SurfaceStackId> changed;
    for (const SurfaceStackId& kind : kinds)
        if (!std::exchange(placeOf(kind).isCombined, true))
            changed.push_back(kind);
    parallelFor(combineParts, [&](std::size_t part) {
        for (std::size_t i = beginOfPart(part, combineParts, changed.size());
             i < beginOfPart(part + 1, combineParts, changed.size()); ++i)
            combine(changed[i]);
    });
}

void SurfaceRadianceTable::evaluate(int stack, int kindOf, int drawn, const Work& work,
                                    const Passed& passed) {
    if (work.hidden)
        evaluateHidden(drawn, passed.plain, &hidden_[hiddenPlaceOf(stack, kindOf).at]);
    addSums(stack, drawn, work.rows, false, passed);
    addSums(stack, drawn, work.rowsOfPath, true, passed);
}

void SurfaceRadianceTable::addSums(int stack, int drawn, const std::vector<int>& rows, bool ofPath,
                                   const Passed& passed) {
    if (rows.empty())
        return;
    const std::size_t groups = termGroups_[static_cast<std::size_t>(drawn)].size();
    std::vector<SliceBetween> about(rows.size());
    std::vector<int> taken; // rows that are summed for them, ascending
    std::vector<double> sums;
    for (std::size_t output = 0; output < outputs_; ++output) {
        taken.clear();
        for (std::size_t r = 0; r < rows.size(); ++r) {
            about[r] = radiometry_.rowsAbout(rows[r], output);
            taken.push_back(about[r].below);
            taken.push_back(about[r].above);
        }
        std::ranges::sort(taken);
        taken.erase(std::ranges::unique(taken).begin(), taken.end());
        const auto& [first, last] = radiometry_.outputs()[output];
        sums.assign(taken.size() * groups, 0.0);
        for (std::size_t begin = first; begin < last; begin += nodesOfBlock)
            addBlock(drawn, taken, ofPath, passed, begin, std::min(nodesOfBlock, last - begin),
                     sums);
        const auto sumsOf = [&](int row) {
            return &sums[static_cast<std::size_t>(std::ranges::lower_bound(taken, row) -
                                                  taken.begin()) *
                         groups];
        };
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const double *below = sumsOf(about[r].below), *above = sumsOf(about[r].above);
            double* const own = &groupSums_[placeOf({stack, rows[r]}).groupSums + output * groups];
            for (std::size_t s = 0; s < groups; ++s)
                own[s] += std::lerp(below[s], above[s], about[r].part);
        }
    }
}

void SurfaceRadianceTable::addBlock(int drawn, const std::vector<int>& rows, bool ofPath,
                                    const Passed& passed, std::size_t begin, std::size_t count,
                                    std::vector<double>& sums) const {
    double values[nodesOfBlock], through[nodesOfBlock];
    const std::vector<TermGroup>& groups = termGroups_[static_cast<std::size_t>(drawn)];
    for (std::size_t s = 0; s < groups.size(); ++s) {
        const TermGroup& group = groups[s];
        if (ofPath && group.pathLight < 0)
            continue;
        fillGroup(drawn, group, &passed.of(group.passesAtmosphere)[begin], begin, count, values);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const AtmosphereSamples& air = radiometry_.air(rows[r]);
            const double* of = group.passesAtmosphere ? air.transmittance->data() + begin : nullptr;
            if (group.pathLight >= 0) {
                const double* light =
                    air.light[static_cast<std::size_t>(group.pathLight)]->data() + begin;
                if (of)
                    fillProducts(of, light, count, through);
                of = of ? through : light;
            }
            sums[r * groups.size() + s] +=
                of ? dotProduct(values, of, count) : sumOf(values, count);
        }
    }
}

void SurfaceRadianceTable::fillGroup(int drawn, const TermGroup& group, const double* passed,
                                     std::size_t begin, std::size_t count, double* values) const {
    const SurfaceSpectra& surface = radiometry_.surfaces()[static_cast<std::size_t>(drawn)];
    const AtmosphereSamples& air = radiometry_.air(radiometry_.rows().first(drawn));
    bool isFirst = true;
    const auto add = [&](const auto& make) {
        if (std::exchange(isFirst, false))
            fillBlock(values, count, make);
        else
            fillBlock(values, count, [&](std::size_t i) { return values[i] + make(i); });
    };
    for (const auto& [k, sign] : group.terms) {
        const RadianceTerm& term = radiometry_.terms().terms[k];
        const double* own =
            (group.part < 0 ? surface.quantity(term.surface)
                            : surface.emission[static_cast<std::size_t>(group.part)].radiance)
                .data() +
            begin;
        const double of = sign;
        if (term.surface == SurfaceQuantity::specular) {
            const double* mirrored = surface.lobeLight->data() + begin;
            add([=](std::size_t i) { return of * passed[i] * (own[i] * mirrored[i]); });
        } else if (term.light && group.pathLight < 0) {
            const double* light = air.light[k]->data() + begin;
            add([=](std::size_t i) { return of * passed[i] * own[i] * light[i]; });
        } else {
            add([=](std::size_t i) { return of * passed[i] * own[i]; });
        }
    }
}

void SurfaceRadianceTable::combine(const SurfaceStackId& kind) {
    const int drawn = radiometry_.rows().renderedOf(kind.row);
    const std::vector<TermGroup>& groups = termGroups_[static_cast<std::size_t>(drawn)];
    const std::vector<SurfaceSpectra::Emission>& emission =
        radiometry_.surfaces()[static_cast<std::size_t>(drawn)].emission;
    const Place& place = placeOf(kind);
    for (std::size_t output = 0; output < outputs_; ++output) {
        double* sent = &sent_[place.sent + output * valuesOfKind()];
        std::fill_n(sent, valuesOfKind(), 0.0);
        for (std::size_t s = 0; s < groups.size(); ++s)
            sent[groups[s].slot] +=
                groupSums_[place.groupSums + output * groups.size() + s] *
                (groups[s].part < 0 ? 1.0
                                    : emission[static_cast<std::size_t>(groups[s].part)].factor);
    }
}

void SurfaceRadianceTable::evaluateHidden(int drawn, const std::vector<double>& passed,
                                          double* into) const {
    const std::vector<double>& opacity =
        radiometry_.surfaces()[static_cast<std::size_t>(drawn)].opacity;
    if (opacity.empty()) // a lobe
        return;
    for (std::size_t output = 0; output < outputs_; ++output) {
        const auto& [first, last] = radiometry_.outputs()[output];
        // As radiance, and as a part of the background, or of the response where there is none.
        double hidden = 0.0, part = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            const double stopped = passed[i] * opacity[i];
            hidden += stopped * (*background_)[i];
            part += stopped;
        }
        *into++ += hidden;
        *into++ += inBand_[output] > 0.0 ? hidden / inBand_[output] : part / area_um_[output];
    }
}

bool SurfaceRadianceTable::isPrepared(const SurfaceStackId& kind) const {
    const auto stack = static_cast<std::size_t>(kind.stack);
    const auto row = static_cast<std::size_t>(kind.row);
    const auto drawn = static_cast<std::size_t>(radiometry_.rows().renderedOf(kind.row));
    return stack < places_.size() && !places_[stack].empty() && places_[stack][row].isCombined &&
           places_[stack][row].path == path_ && hiddenPlaces_[stack][drawn].isKnown;
}

SurfaceRadianceTable::InOutputs SurfaceRadianceTable::inOutputs(const SurfaceStackId& kind) const {
    if (!isPrepared(kind))
        throw LogicError("a kind of surface was evaluated that was not prepared");
    const auto stack = static_cast<std::size_t>(kind.stack);
    const auto row = static_cast<std::size_t>(kind.row);
    const auto drawn = static_cast<std::size_t>(radiometry_.rows().renderedOf(kind.row));
    InOutputs found;
    found.sent_ = &sent_[places_[stack][row].sent];
    found.hidden_ = &hidden_[hiddenPlaces_[stack][drawn].at];
    found.factorCount_ = factorCount_;
    return found;
}

std::vector<double> SurfaceRadianceTable::terms(const SurfaceStackId& kind,
                                                std::size_t output) const {
    const auto& [first, last] = radiometry_.outputs()[output];
    std::vector<double> sums(radiometry_.terms().terms.size(), 0.0);
    for (const int drawn : radiometry_.partsOf(radiometry_.rows().renderedOf(kind.row))) {
        const SurfaceSpectra& surface = radiometry_.surfaces()[static_cast<std::size_t>(drawn)];
        const std::vector<double> plain = passed(kind.stack, {first, last}, false, drawn);
        const std::vector<double> throughAir =
            hasGas(kind.stack) ? passed(kind.stack, {first, last}, true, drawn) : plain;
        for (std::size_t k = 0; k < sums.size(); ++k) {
            const RadianceTerm& term = radiometry_.terms().terms[k];
            const bool passesAtmosphere =
                term.passesAtmosphere ||
                (term.surface == SurfaceQuantity::emission && surface.emissionPassesAtmosphere);
            const std::vector<double>& through = passesAtmosphere ? throughAir : plain;
            const std::vector<double> sent =
                apparentTerm(surface, radiometry_.terms(), k, radiometry_.air(kind.row));
            if (!sent.empty())
                sums[k] += dotProduct(through.data(), &sent[first], last - first);
        }
    }
    return sums;
}

} // namespace irsg
