#include "gui/image/LinkedViews.h"

#include <algorithm>

#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageView.h"

namespace smat::gui {

LinkedViews& LinkedViews::instance() {
    static LinkedViews views;
    return views;
}

void LinkedViews::add(ImageView* view) {
    views_.push_back(view);
    connect(view, &QObject::destroyed, this, [this, view] { std::erase(views_, view); });
    connect(view->canvas(), &ImageCanvas::viewChanged, this, [this, view] { follow(*view); });
    connect(view->canvas(), &ImageCanvas::hovered, this,
            [this, view](std::optional<QPoint> pixel) { point(*view, pixel); });
}

std::vector<ImageView*> LinkedViews::othersLike(const ImageView& view) const {
    std::vector<ImageView*> others;
    for (ImageView* other : views_)
        if (other != &view && view.hasImage() && other->hasImage() &&
            other->image().width() == view.image().width() &&
            other->image().height() == view.image().height())
            others.push_back(other);
    return others;
}

void LinkedViews::setOn(bool on) {
    isOn_ = on;
    const auto visible =
        std::ranges::find_if(views_, [](const ImageView* view) { return view->isVisible(); });
    if (on && visible != views_.end())
        follow(**visible);
}

void LinkedViews::follow(const ImageView& view) {
    if (!isOn_ || isFollowing_)
        return;
    isFollowing_ = true;
    for (ImageView* other : othersLike(view))
        other->canvas()->setView(view.canvas()->view());
    isFollowing_ = false;
}

void LinkedViews::point(const ImageView& view, const std::optional<QPoint>& pixel) {
    if (!isOn_)
        return;
    for (ImageView* other : othersLike(view))
        other->readPixel(pixel);
}

} // namespace smat::gui

#include "moc_LinkedViews.cpp"
