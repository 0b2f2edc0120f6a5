#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "gui/view/InfraredRequest.h"

namespace smat::gui {

class InfraredDisplay;

/// The infrared pictures of a view: how they are to look, when the next one is asked for, coarser
/// while something moves, and which of them is seen. Off at first.
class InfraredPictures : public QObject {
    Q_OBJECT

  public:
    /// `view` is asked for what there is to be drawn, sharp and in pixels of the screen: project,
    /// models, camera and size; nothing while there is nothing to draw.
    explicit InfraredPictures(std::function<std::optional<InfraredRequest>()> view,
                              QObject* parent = nullptr);
    ~InfraredPictures() override;

    /// Switched off it forgets what was asked and what was seen.
    void setOn(bool on);
    bool isOn() const { return isOn_; }
    void setQuantity(InfraredQuantity quantity);
    InfraredQuantity quantity() const { return quantity_; }
    /// Throws irsg::InputError for a map that does not exist.
    void setColorMap(const std::string& name);
    const irsg::ColorMap& colorMap() const { return *map_; }
    /// What comes to be locked stays as it is seen.
    void setColorRule(const ColorRule& rule);
    const ColorRule& colorRule() const { return rule_; }
    /// Locks limits at these.
    void setLimits(const irsg::DisplayLimits& limits);
    /// Those at which they were locked last.
    const irsg::DisplayLimits& lockedLimits() const { return lockedLimits_; }
    /// Colours and limits of a project count where they are others than before, until others are
    /// chosen. The limits are of radiance.
    void followColors(const Settings& settings);

    /// What is drawn is another thing than before: no picture that there is shows it.
    void outdate() { ++revision_; }
    /// Asks for a coarse picture where something moves, and for a sharp one when it rests.
    void ask(bool isDragging);
    void askSharp();
    /// Another scene: forgets what is seen and what was asked until now, and takes the colours of
    /// the project that comes.
    void beginAnew();

    /// The picture that is seen; null where there is none, and while it is awaited for long.
    const InfraredPicture* shown() const;
    /// "Radiance 1.234 W·m⁻²·sr⁻¹" of what is seen at parts of its width and height; else empty.
    QString readoutAt(double right, double down) const;
    /// Why there is none.
    const QStringList& problem() const { return problem_; }
    /// Whether the picture that is shown is of the scene before its last edit.
    bool isOfEarlierState() const { return picture_.image && picture_.revision != revision_; }
    /// Every question is answered, with a picture or with why there is none.
    bool isUpToDate() const;
    /// How long an answer is being waited for, s; 0 where none is.
    double waiting_s() const;
    /// "inter-reflection: pairs, 43 %" of the one under way; empty between stages.
    QString stage() const;

  signals:
    /// Quantity or colours.
    void lookChanged();
    void drawn(const smat::gui::InfraredPicture& picture);
    void failed(const QStringList& sentences);
    /// From time to time while an answer is awaited: shown() may be something else by then.
    void waited();

  private:
    void send(bool coarse);
    void take(const InfraredPicture& picture);
    void refuse(const QStringList& sentences, bool ourFault);
    void stopWaiting();
    void drop();

    std::function<std::optional<InfraredRequest>()> view_;
    InfraredDisplay* display_ = nullptr;
    bool isOn_ = false;
    InfraredQuantity quantity_ = InfraredQuantity::radiance;
    const irsg::ColorMap* map_ = nullptr;
    ColorRule rule_;
    irsg::DisplayLimits lockedLimits_;
    Settings followed_;        ///< whose colours were taken
    bool hasFollowed_ = false; ///< since the scene began
    InfraredPicture picture_;
    QStringList problem_;
    long revision_ = 0, droppedAt_ = 0;
    long sharpRevision_ = -1; ///< of the last picture with light
    double ofEdit_s_ = 0.0;   ///< what that took
    int coarseness_ = 2;      ///< pixels of the view to one of a picture that moves
    QElapsedTimer lastChange_;
    QTimer rest_, waiting_;
};

} // namespace smat::gui
