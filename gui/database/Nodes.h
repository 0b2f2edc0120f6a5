#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <QString>

#include "gui/widgets/NumberText.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/LookupTable.h"

namespace smat::gui {

/// One node of a table: a place on its axis and the value there.
struct Node {
    double x = 0.0, y = 0.0;
    bool operator==(const Node&) const = default;
};
using Nodes = std::vector<Node>;

Nodes nodesOf(const irsg::LookupTable& table);
Nodes nodesOf(const irsg::Spectrum& spectrum);
/// No nodes give the empty table. Throw irsg::InputError for nodes that the type refuses.
irsg::LookupTable tableOf(const Nodes& nodes, bool loop);
irsg::Spectrum spectrumOf(const Nodes& nodes, irsg::Spectrum::Outside outside);

/// What the nodes of one table may be, and how a person reads them.
struct NodeRules {
    QString xName, xUnit; ///< "wavelength", "um"
    QString ySymbol;      ///< in the legend; yName where it is empty
    QString yName, yUnit; ///< "emissivity", ""
    double xMinimum = -std::numeric_limits<double>::infinity();
    double xMaximum = std::numeric_limits<double>::infinity();
    double yMinimum = -std::numeric_limits<double>::infinity();
    double yMaximum = std::numeric_limits<double>::infinity();
    /// Bounds y further, by x: what transmissivity leaves to emissivity. May be absent.
    std::function<double(double x)> yMaximumAt = {};
    bool xPositive = false; ///< above 0, not at it
    std::size_t fewest = 0; ///< nodes that have to stay
    double xStep = 1.0;     ///< to the first node, and between new ones at the end
    double yStart = 0.0;    ///< value of the first node

    /// "wavelength [um]".
    QString xTitle() const;
    QString yTitle() const;
    double greatestY(double x) const;
    /// Why x or y cannot be; empty where they can.
    QString problemOfX(double x) const;
    QString problemOfY(double x, double y) const;
    /// Why these nodes cannot be a table: the first diagnostic, with its row counted from 1.
    QString problemOf(const Nodes& nodes) const;
    /// The node moved to where the rules and its neighbours allow.
    Node bounded(const Nodes& nodes, std::size_t index, Node wanted) const;
};

/// Those of a lookup table of a signature database.
NodeRules rulesOf(const irsg::TableRules& rules, const QString& valueUnit);

/// Tabs between columns, as spreadsheets take it.
QString spreadsheetText(const Nodes& nodes);

} // namespace smat::gui
