#include "gui/plot/PlotData.h"

#include <algorithm>
#include <cmath>

#include <QStringList>

#include "gui/widgets/Readable.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {

void Curve::check() const {
    if (x.size() != y.size() || (!error.empty() && error.size() != y.size()))
        throw irsg::LogicError("curve " + name.toStdString() + ": its columns differ in length");
}

std::optional<double> Curve::valueAt(double at) const {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double x0 = x[i];
        const double x1 = x[i + 1];
        const bool inside = (at - x0) * (at - x1) <= 0.0;
        if (!inside || !std::isfinite(y[i]) || !std::isfinite(y[i + 1]))
            continue;
        const double part = x1 == x0 ? 0.0 : (at - x0) / (x1 - x0);
        return y[i] + part * (y[i + 1] - y[i]);
    }
    if (x.size() == 1 && x[0] == at && std::isfinite(y[0]))
        return y[0];
    return std::nullopt;
}

std::optional<double> Curve::valueAt(double at, double period) const {
    if (x.empty())
        return std::nullopt;
    const double first = *std::min_element(x.begin(), x.end());
    double wrapped = std::fmod(at - first, period);
    if (wrapped < 0.0)
        wrapped += period;
    if (const auto value = valueAt(first + wrapped))
        return value;

    // Between the last sample and the first one of the next turn.
    const std::size_t last = x.size() - 1;
    Curve seam;
    seam.x = {x[last], x[0] + period};
    seam.y = {y[last], y[0]};
    const bool closes = seam.x[1] > seam.x[0] && seam.x[1] - seam.x[0] < 0.25 * period;
    return closes ? seam.valueAt(first + wrapped) : std::nullopt;
}

QString Curve::readoutAt(double at, double period) const {
    const auto read = [&](const Curve& curve) {
        return period > 0.0 ? curve.valueAt(at, period) : curve.valueAt(at);
    };
    const auto value = read(*this);
    if (!value)
        return QStringLiteral("no value");
    QString text = readableNumber(*value);
    if (error.empty())
        return text;
    if (const auto half = read({name, x, error}))
        text += QStringLiteral(" ± ") + QString::number(*half, 'g', 3);
    return text;
}

std::optional<Interval> rangeOf(const std::vector<Curve>& curves,
                                std::vector<double> Curve::*values, bool positiveOnly) {
    std::optional<Interval> range;
    for (const auto& curve : curves) {
        for (const double value : curve.*values) {
            if (!std::isfinite(value) || (positiveOnly && value <= 0.0))
                continue;
            if (!range)
                range = Interval{value, value};
            range->minimum = std::min(range->minimum, value);
            range->maximum = std::max(range->maximum, value);
        }
    }
    return range;
}

std::optional<Interval> rangeWithErrors(const std::vector<Curve>& curves, bool positiveOnly) {
    std::vector<Curve> edges = curves;
    for (const auto& curve : curves) {
        if (curve.error.empty())
            continue;
        Curve low = curve, high = curve;
        for (std::size_t i = 0; i < curve.error.size(); ++i) {
            low.y[i] -= curve.error[i];
            high.y[i] += curve.error[i];
        }
        edges.push_back(std::move(low));
        edges.push_back(std::move(high));
    }
    return rangeOf(edges, &Curve::y, positiveOnly);
}

namespace {

QString quoted(QString text) {
    if (!text.contains(',') && !text.contains('\t') && !text.contains('"') && !text.contains('\n'))
        return text;
    text.replace('"', "\"\"");
    return '"' + text + '"';
}

} // namespace

QString toCsv(const std::vector<Curve>& curves, const QString& xTitle, const QString& yTitle,
              std::optional<Interval> within, QChar separator) {
    if (curves.empty())
        return {};
    const bool sharedAxis = std::all_of(curves.begin(), curves.end(),
                                        [&](const Curve& c) { return c.x == curves[0].x; });

    QStringList header;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (i == 0 || !sharedAxis)
            header << quoted(xTitle);
        const QString title = curves[i].name.isEmpty() ? yTitle : yTitle + ": " + curves[i].name;
        header << quoted(title);
        if (!curves[i].error.empty())
            header << quoted(QStringLiteral("Error of ") + title);
        rows = std::max(rows, curves[i].x.size());
    }

    QStringList lines{header.join(separator)};
    for (std::size_t row = 0; row < rows; ++row) {
        QStringList cells;
        bool any = false;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const Curve& curve = curves[i];
            const bool there =
                row < curve.x.size() &&
                (!within || (curve.x[row] >= within->minimum && curve.x[row] <= within->maximum));
            any = any || there;
            if (i == 0 || !sharedAxis)
                cells << (there ? exactNumber(curve.x[row]) : QString());
            cells << (there ? exactNumber(curve.y[row]) : QString());
            if (!curve.error.empty())
                cells << (there ? exactNumber(curve.error[row]) : QString());
        }
        if (any)
            lines << cells.join(separator);
    }
    return lines.join('\n') + '\n';
}

} // namespace smat::gui
