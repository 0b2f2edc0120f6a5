#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "gui/view/InfraredRequest.h"
#include "irsg/image/SampledTiles.h"

namespace smat::gui {

class InfraredDisplay;

/// A frustum as it is drawn: from the eye to a rectangle before the target.
struct ViewFrustum {
    enum class Of {
        frame,  ///< all that the sensor sees
        window, ///< what the antialiasing samples by itself
        point   ///< an object that is drawn as a point
    };
    Of of = Of::frame;
    irsg::Vec3 eye_m;
    std::array<irsg::Vec3, 4> corners_m; ///< from the top left one clockwise
    bool operator==(const ViewFrustum&) const = default;
};

/// The frusta of the sensor's zoom windows (F21), of what was sampled: the picture of the sensor is
/// drawn as an analysis draws it, in a thread of its own, and says itself which windows it took.
class SensorFrusta : public QObject {
    Q_OBJECT

  public:
    /// `sensor` is asked for the picture of the sensor, all of it; nothing while there is none.
    explicit SensorFrusta(std::function<std::optional<InfraredRequest>()> sensor,
                          QObject* parent = nullptr);
    ~SensorFrusta() override;

    /// Off at first.
    void setOn(bool on);
    bool isOn() const { return display_ != nullptr; }
    /// What they are of has changed.
    void outdate();
    /// Every question is answered.
    bool isUpToDate() const;

    /// Of the last picture; empty before it.
    const std::vector<irsg::SampledTile>& windows() const { return windows_; }
    /// To a plane through `target_m` that the sensor looks at; the frame's first.
    std::vector<ViewFrustum> frusta(const irsg::Vec3& target_m) const;

  signals:
    void changed();

  private:
    void ask();

    std::function<std::optional<InfraredRequest>()> sensor_;
    InfraredDisplay* display_ = nullptr;
    std::optional<InfraredRequest> asked_;
    long revision_ = 0;
    std::vector<irsg::SampledTile> windows_;
    std::optional<InfraredPicture> picture_; ///< without its values
};

} // namespace smat::gui
