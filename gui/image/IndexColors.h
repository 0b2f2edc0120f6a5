#pragma once

#include <cstddef>
#include <vector>

#include <QColor>
#include <QString>

#include "gui/image/ColoredPlane.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

/// Whether the values of a plane are numbers of entries or objects: temperature_index,
/// material_index, object_index.
bool isIndexPlane(const irsg::ImageChannel& plane);

/// An index that a plane has.
struct SeenIndex {
    int index = 0;
    QString name; ///< what the image calls it (irsg::nameIndices); empty where it does not
    QColor color;
    std::size_t pixels = 0;

    /// "5  exhaust".
    QString words() const;
};

/// Those of a plane, ascending. Colours follow from the place in this list: neighbours differ.
std::vector<SeenIndex> seenIndices(const irsg::RadianceImage& image,
                                   const irsg::ImageChannel& plane);

/// A plane in these colours, black where it has no index.
LightPlanes lightOf(const irsg::ImageChannel& plane, const std::vector<SeenIndex>& seen);

/// A value of a plane in words: "301.2", of an index "5 exhaust".
QString valueWords(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                   std::size_t offset);

} // namespace smat::gui
