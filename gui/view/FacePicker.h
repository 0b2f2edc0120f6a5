#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QString>

#include "gui/view/DisplayScene.h"
#include "gui/view/ViewProjection.h"

namespace smat::gui {

/// What of a scene stands under a point of its view, nearest first.
std::vector<FaceHit> facesUnder(const DisplayScene& scene, const ViewProjection& through,
                                const QPointF& point);
/// "temperature 3 (wing)     material 2 (grey paint)", and the model where there are several.
QString indexWords(const DisplayScene& scene, const FaceHit& hit);

/// Which face a click is for: the nearest one, and at the same place again the next one behind it
/// with other indices.
class FacePicker {
  public:
    /// The one that is picked of those under a point, nearest first; null where there are none.
    /// Another camera begins with the nearest again.
    const FaceHit* pick(const std::vector<FaceHit>& hits, const QPointF& point,
                        const OrbitCamera& camera);
    /// The next click begins with the nearest.
    void forget() { last_.reset(); }

  private:
    struct Pick {
        QPointF at;
        std::size_t number = 0;
        OrbitCamera camera;
    };
    std::optional<Pick> last_;
};

} // namespace smat::gui
