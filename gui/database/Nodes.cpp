#include "gui/database/Nodes.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

QString trNodes(const char* text) {
    return QCoreApplication::translate("smat::gui::Nodes", text);
}

QString titled(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : name + " (" + unit + ")";
}

QString withUnit(double value, const QString& unit) {
    return unit.isEmpty() ? textOf(value) : textOf(value) + " " + unit;
}

std::pair<std::vector<double>, std::vector<double>> columnsOf(const Nodes& nodes) {
    std::pair<std::vector<double>, std::vector<double>> columns;
    for (const auto& node : nodes) {
        columns.first.push_back(node.x);
        columns.second.push_back(node.y);
    }
    return columns;
}

Nodes nodesOf(const std::vector<double>& x, const std::vector<double>& y) {
    Nodes nodes;
    for (std::size_t i = 0; i < x.size(); ++i)
        nodes.push_back({x[i], y[i]});
    return nodes;
}

} // namespace

Nodes nodesOf(const irsg::LookupTable& table) {
    return nodesOf(table.x(), table.y());
}

Nodes nodesOf(const irsg::Spectrum& spectrum) {
    return spectrum.isConstant() ? Nodes() : nodesOf(spectrum.wavelengths_um(), spectrum.values());
}

irsg::LookupTable tableOf(const Nodes& nodes, bool loop) {
    if (nodes.empty())
        return {};
    auto [x, y] = columnsOf(nodes);
    return {std::move(x), std::move(y), loop};
}

irsg::Spectrum spectrumOf(const Nodes& nodes, irsg::Spectrum::Outside outside) {
    auto [x, y] = columnsOf(nodes);
    return {std::move(x), std::move(y), outside};
}

QString NodeRules::xTitle() const {
    return titled(xName, xUnit);
}

QString NodeRules::yTitle() const {
    return titled(yName, yUnit);
}

double NodeRules::greatestY(double x) const {
    return yMaximumAt ? std::min(yMaximum, yMaximumAt(x)) : yMaximum;
}

QString NodeRules::problemOfX(double x) const {
    if (!std::isfinite(x))
        return trNodes("%1 has to be a finite number").arg(xName);
    if (xPositive && x <= 0.0)
        return trNodes("%1 has to be above 0").arg(xName);
    if (x < xMinimum)
        return trNodes("%1 has to be at least %2").arg(xName, withUnit(xMinimum, xUnit));
    if (x > xMaximum)
        return trNodes("%1 has to be at most %2").arg(xName, withUnit(xMaximum, xUnit));
    return {};
}

QString NodeRules::problemOfY(double x, double y) const {
    constexpr double rounding = 1e-12;
    if (!std::isfinite(y))
        return trNodes("%1 has to be a finite number").arg(yName);
    if (y < yMinimum)
        return trNodes("%1 has to be at least %2").arg(yName, withUnit(yMinimum, yUnit));
    if (y > greatestY(x) + rounding)
        return trNodes("%1 can be at most %2 here").arg(yName, withUnit(greatestY(x), yUnit));
    return {};
}

QString NodeRules::problemOf(const Nodes& nodes) const {
    if (nodes.size() < fewest)
        return trNodes("at least %1 rows have to stay").arg(fewest);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        QString problem = problemOfX(nodes[i].x);
        int column = 1;
        if (problem.isEmpty() && i > 0 && nodes[i].x <= nodes[i - 1].x)
            problem = trNodes("%1 has to be above %2, the value before: the axis ascends")
                          .arg(textOf(nodes[i].x), textOf(nodes[i - 1].x));
        if (problem.isEmpty()) {
            problem = problemOfY(nodes[i].x, nodes[i].y);
            column = 2;
        }
        if (!problem.isEmpty())
            return trNodes("row %1, column %2: %3, not %4")
                .arg(i + 1)
                .arg(column)
                .arg(problem, textOf(column == 1 ? nodes[i].x : nodes[i].y));
    }
    return {};
}

Node NodeRules::bounded(const Nodes& nodes, std::size_t index, Node wanted) const {
    // A node stays between its neighbours by a thousandth of their distance.
    double low = xPositive ? std::max(xMinimum, 1e-6) : xMinimum;
    double high = xMaximum;
    const double gap = 1e-3;
    if (index > 0) {
        const double before = nodes[index - 1].x;
        const double after = index + 1 < nodes.size() ? nodes[index + 1].x : before + 1.0;
        low = std::max(low, before + gap * (after - before));
    }
    if (index + 1 < nodes.size()) {
        const double after = nodes[index + 1].x;
        const double before = index > 0 ? nodes[index - 1].x : after - 1.0;
        high = std::min(high, after - gap * (after - before));
    }
    const double x = low <= high ? std::clamp(wanted.x, low, high) : nodes[index].x;
    return {x, std::clamp(wanted.y, std::min(yMinimum, greatestY(x)), greatestY(x))};
}

NodeRules rulesOf(const irsg::TableRules& rules, const QString& valueUnit) {
    NodeRules made;
    made.xName = QCoreApplication::translate("EntryFields", rules.axis);
    made.xUnit = formattedUnit(rules.unit);
    made.yName = QCoreApplication::translate("EntryFields", rules.value);
    made.yUnit = valueUnit;
    made.xMinimum = rules.leastPosition;
    made.xMaximum = rules.mostPosition;
    made.yMinimum = rules.leastValue;
    made.xStep = rules.step;
    made.yStart = rules.firstValue;
    return made;
}

QString spreadsheetText(const Nodes& nodes) {
    QString text;
    for (const auto& node : nodes)
        text += textOf(node.x) + "\t" + textOf(node.y) + "\n";
    return text;
}

} // namespace smat::gui
