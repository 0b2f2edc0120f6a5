#include "irsg/scene/radiance/KindRadiances.h"

#include <algorithm>
#include <map>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/ParallelFor.h"

namespace irsg {

namespace {

/// Sum of a[i] b[i] in four strands, which do not wait for each other.
double sumOfProducts(const double* a, const double* b, std::size_t count) {
    double strands[4] = {0.0, 0.0, 0.0, 0.0};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (std::size_t strand = 0; strand < 4; ++strand)
            strands[strand] += a[i + strand] * b[i + strand];
    for (; i < count; ++i)
        strands[0] += a[i] * b[i];
    return (strands[0] + strands[1]) + (strands[2] + strands[3]);
}

void addTo(std::vector<double>& sum, const std::vector<double>& values, double sign) {
    sum.resize(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
        sum[i] += sign * values[i];
}

} // namespace

KindRadiances::KindRadiances(const SceneRadiometry& radiometry, const Fronts& fronts)
    : radiometry_(radiometry),
      fronts_(fronts),
      outputs_(radiometry.outputs().size()),
      factorCount_(radiometry.terms().factorCount()),
      rows_(radiometry.surfaces().size()) {
    for (const auto& [first, last] : radiometry.outputs()) {
        double area_um = 0.0;
        for (std::size_t i = first; i < last; ++i)
            area_um += radiometry.weights_um()[i];
        area_um_.push_back(area_um);
    }
    setBackground(std::vector<double>(radiometry.wavelengths_um().size(), 0.0));
}

void KindRadiances::setBackground(std::vector<double> background) {
    if (background == background_)
        return;
    background_ = std::move(background);
    inBand_.clear();
    for (std::size_t output = 0; output < outputs_; ++output)
        inBand_.push_back(radiometry_.integrate(background_, output));
    hidden_.clear();
    for (std::vector<Place>& ofFront : places_)
        for (Place& place : ofFront)
            place.hasHidden = false;
}

void KindRadiances::forget(const std::vector<int>& rows) {
    for (const int row : rows) {
        for (std::vector<Place>& ofFront : places_)
            if (!ofFront.empty())
                ofFront[static_cast<std::size_t>(row)].isKnown = false;
    }
}

KindRadiances::Place& KindRadiances::placeOf(const FactorKind& kind) {
    const auto front = static_cast<std::size_t>(kind.front);
    if (front >= places_.size())
        places_.resize(front + 1);
    if (places_[front].empty())
        places_[front].resize(rows_.size());
    return places_[front][static_cast<std::size_t>(kind.row)];
}

void KindRadiances::fillRow(Row& made, int row) const {
    const SurfaceSpectra& surface = radiometry_.surfaces()[static_cast<std::size_t>(row)];
    const std::size_t count = radiometry_.wavelengths_um().size();
    made.perFactor.resize(factorCount_);
    made.constant.assign(count, 0.0);
    for (std::size_t k = 0; k < surface.terms.size(); ++k) {
        const TermFactor& factor = radiometry_.terms().terms[k].factor;
        const std::vector<double>& sent = surface.terms[k];
        if (sent.empty())
            continue;
        if (factor.drawn < 0 || factor.complement)
            addTo(made.constant, sent, 1.0);
        if (factor.drawn >= 0)
            addTo(made.perFactor[static_cast<std::size_t>(factor.drawn)], sent,
                  factor.complement ? -1.0 : 1.0);
    }
}

std::vector<double> KindRadiances::passed(int front) const {
    std::vector<double> product = radiometry_.weights_um();
    for (const auto& [entity, material] : fronts_.materials(front)) {
        const std::vector<double>& t = radiometry_.transmissivity(entity, material);
        for (std::size_t i = 0; i < product.size(); ++i)
            product[i] *= t[i];
    }
    return product;
}

void KindRadiances::prepare(const std::vector<FactorKind>& kinds) {
    // What is new, front by front.
    struct Wanted {
        FactorKind kind;
        Place place;
        bool sent, hidden;
    };
    std::map<int, std::vector<Wanted>> wanted;
    std::vector<int> newRows;
    for (const FactorKind& kind : kinds) {
        Place& place = placeOf(kind);
        if (place.isKnown && place.hasHidden)
            continue;
        const bool sent = !place.isKnown, hidden = !place.hasHidden;
        if (sent) {
            if (!place.hasRoom) {
                place.sent = sent_.size();
                sent_.resize(sent_.size() + outputs_ * valuesOfKind());
                place.hasRoom = true;
            }
            newRows.push_back(kind.row);
        }
        if (hidden) {
            place.hidden = hidden_.size();
            hidden_.resize(hidden_.size() + 2 * outputs_);
        }
        place.isKnown = place.hasHidden = true;
        wanted[kind.front].push_back({kind, place, sent, hidden});
    }
    std::ranges::sort(newRows);
    newRows.erase(std::ranges::unique(newRows).begin(), newRows.end());
    parallelFor(newRows.size(), [&](std::size_t i) {
        fillRow(rows_[static_cast<std::size_t>(newRows[i])], newRows[i]);
    });

    std::vector<const std::pair<const int, std::vector<Wanted>>*> all;
    for (const auto& ofFront : wanted)
        all.push_back(&ofFront);
    parallelFor(all.size(), [&](std::size_t i) {
        const std::vector<double> through = passed(all[i]->first);
        for (const Wanted& one : all[i]->second) {
            if (one.sent)
                evaluateSent(one.kind, through, &sent_[one.place.sent]);
            if (one.hidden)
                evaluateHidden(one.kind, through, &hidden_[one.place.hidden]);
        }
    });
    for (const int row : newRows)
        rows_[static_cast<std::size_t>(row)] = {};
}

void KindRadiances::evaluateSent(const FactorKind& kind, const std::vector<double>& passed,
                                 double* into) const {
    const Row& row = rows_[static_cast<std::size_t>(kind.row)];
    for (const auto& [first, last] : radiometry_.outputs()) {
        const auto sum = [&, from = first,
                          count = last - first](const std::vector<double>& values) {
            return values.empty() ? 0.0 : sumOfProducts(&passed[from], &values[from], count);
        };
        for (const std::vector<double>& factor : row.perFactor)
            *into++ = sum(factor);
        *into++ = sum(row.constant);
    }
}

void KindRadiances::evaluateHidden(const FactorKind& kind, const std::vector<double>& passed,
                                   double* into) const {
    const std::vector<double>& t =
        radiometry_.surfaces()[static_cast<std::size_t>(kind.row)].transmissivity;
    for (std::size_t output = 0; output < outputs_; ++output) {
        const auto& [first, last] = radiometry_.outputs()[output];
        // As radiance, and as a part of the background, or of the response where there is none.
        double hidden = 0.0, part = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            const double stopped = passed[i] * (1.0 - t[i]);
            hidden += stopped * background_[i];
            part += stopped;
        }
        *into++ = hidden;
        *into++ = inBand_[output] > 0.0 ? hidden / inBand_[output] : part / area_um_[output];
    }
}

KindRadiance KindRadiances::of(const FactorKind& kind, std::size_t output) const {
    const auto front = static_cast<std::size_t>(kind.front);
    const auto row = static_cast<std::size_t>(kind.row);
    if (front >= places_.size() || places_[front].empty() || !places_[front][row].isKnown ||
        !places_[front][row].hasHidden)
        throw LogicError("a kind of surface was evaluated that was not prepared");
    const Place& place = places_[front][row];
    const double* sent = &sent_[place.sent + output * valuesOfKind()];
    const double* hidden = &hidden_[place.hidden + 2 * output];
    return {{sent, factorCount_}, sent[factorCount_], hidden[0], hidden[1]};
}

std::vector<double> KindRadiances::terms(const FactorKind& kind, std::size_t output) const {
    const std::vector<double> through = passed(kind.front);
    const auto& [first, last] = radiometry_.outputs()[output];
    std::vector<double> sums;
    for (const std::vector<double>& sent :
         radiometry_.surfaces()[static_cast<std::size_t>(kind.row)].terms)
        sums.push_back(sent.empty() ? 0.0
                                    : sumOfProducts(&through[first], &sent[first], last - first));
    return sums;
}

} // namespace irsg
