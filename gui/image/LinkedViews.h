#pragma once

#include <optional>
#include <vector>

#include <QObject>
#include <QPoint>

namespace smat::gui {

class ImageView;

/// The image pages of the window, which show the same part of their images and read the same pixel
/// while they are linked: those of equal size, whatever part of which analysis they are.
class LinkedViews : public QObject {
    Q_OBJECT

  public:
    static LinkedViews& instance();

    void add(ImageView* view);
    bool isOn() const { return isOn_; }
    /// The others take what the first visible one shows.
    void setOn(bool on);
    /// A view was zoomed or moved.
    void follow(const ImageView& view);
    /// A pixel of a view is read; none.
    void point(const ImageView& view, const std::optional<QPoint>& pixel);

  private:
    LinkedViews() = default;
    std::vector<ImageView*> othersLike(const ImageView& view) const;

    std::vector<ImageView*> views_;
    bool isOn_ = false, isFollowing_ = false;
};

} // namespace smat::gui
