#include "gui/start/StartPage.h"

#include <algorithm>

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/start/DataFolder.h"
#include "gui/widgets/Theme.h"
#include "irsg/image/PngView.h"

namespace smat::gui {
namespace {

constexpr QSize cardPicture(170, 112);
constexpr int cardColumns = 3, mostRecent = 6, leastCard_px = 100;
constexpr int leftMargin_px = 24, rightMargin_px = 16, cardSpacing_px = 6;

QLabel* heading(const QString& text, double scale, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setBold(true);
    label->setFont(font);
    return label;
}

/// The part of a picture inside of the frame that exported pictures have, without title and colour
/// bar; all of it where there is no frame.
QPixmap withoutLegend(const QPixmap& picture) {
    const QImage image = picture.toImage().convertToFormat(QImage::Format_RGB32);
    constexpr irsg::Rgb frame = irsg::viewFrameColor;
    const QRgb line = qRgb(frame.red, frame.green, frame.blue);
    const auto isLine = [&](int x, int y) {
        return image.valid(x, y) && image.pixel(x, y) == line;
    };
    const int middle = image.height() / 2;
    int left = 0;
    while (left < image.width() && !isLine(left, middle))
        ++left;
    int top = middle, bottom = middle, right = left;
    while (isLine(left, top - 1))
        --top;
    while (isLine(left, bottom + 1))
        ++bottom;
    while (isLine(right + 1, top))
        ++right;
    const QRect inside(QPoint(left + 1, top + 1), QPoint(right - 1, bottom - 1));
    return inside.width() > 40 && inside.height() > 40 ? picture.copy(inside) : picture;
}

QIcon cardIcon(const std::filesystem::path& file, double pixelRatio) {
    QPixmap picture(QString::fromStdString(file.string()));
    if (picture.isNull())
        return icon("model");
    const QSize wanted = cardPicture * pixelRatio;
    picture = withoutLegend(picture).scaled(wanted, Qt::KeepAspectRatioByExpanding,
                                            Qt::SmoothTransformation);
    picture = picture.copy(QRect(
        QPoint((picture.width() - wanted.width()) / 2, (picture.height() - wanted.height()) / 2),
        wanted));
    picture.setDevicePixelRatio(pixelRatio);
    return picture;
}

QToolButton* plainButton(const QString& text, const char* name, const char* drawing,
                         QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setText(text);
    button->setIcon(icon(drawing));
    button->setIconSize(QSize(20, 20));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

StartPage::StartPage(QWidget* page) : QWidget(page) {
    setObjectName("startPage");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    auto* body = new QWidget(this);
    body->setBackgroundRole(QPalette::Base);
    auto* grid = new QGridLayout(body);
    grid->setContentsMargins(leftMargin_px, 18, rightMargin_px, 18);
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(12);
    grid->addWidget(heading(tr("Infrared signatures of 3-D models"), 1.5, body), 0, 0, 1, 2);
    grid->addWidget(makeSamples(), 1, 0, 1, 2);
    grid->addWidget(makeOwn(), 2, 0, Qt::AlignTop);
    grid->addWidget(makeRecent(), 2, 1, Qt::AlignTop);
    grid->setRowStretch(3, 1);
    grid->setColumnStretch(1, 1);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setBackgroundRole(QPalette::Base);
    scroll->setWidget(body);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scroll);
    page->installEventFilter(this);
    setGeometry(page->rect());
    raise();
}

QWidget* StartPage::makeSamples() {
    auto* part = new QWidget(this);
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(cardSpacing_px);
    grid->addWidget(heading(tr("Samples"), 1.15, part), 0, 0, 1, cardColumns);
    int number = 0;
    for (const Sample& sample : samples()) {
        auto* card = new QToolButton(part);
        card->setObjectName("sample-" + QString::fromStdString(sample.project.stem().string()));
        card->setIcon(cardIcon(sample.picture, devicePixelRatioF()));
        card->setIconSize(cardPicture);
        card->setText(sample.title);
        card->setToolTip(sample.words);
        card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        card->setAutoRaise(true);
        card->setFocusPolicy(Qt::StrongFocus);
        const QString file = QString::fromStdString(sample.project.string());
        connect(card, &QToolButton::clicked, this, [this, file] { emit fileChosen(file); });
        cards_ << card;
        grid->addWidget(card, 1 + number / cardColumns, number % cardColumns, Qt::AlignLeft);
        ++number;
    }
    if (number == 0)
        grid->addWidget(new QLabel(tr("The samples are not installed. The environment variable "
                                      "SMAT_DATA names the folder that contains them."),
                                   part),
                        1, 0);
    grid->setColumnStretch(cardColumns, 1);
    grid->setRowStretch(grid->rowCount(), 1);
    return part;
}

QWidget* StartPage::makeOwn() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(2);
    column->addWidget(heading(tr("Your own model"), 1.15, part));
    auto* model = plainButton(tr("Open a model…"), "startModel", "model", part);
    auto* project = plainButton(tr("New project…"), "startProject", "new", part);
    auto* open = plainButton(tr("Open a project, result or image…"), "startOpen", "open", part);
    auto* guide =
        plainButton(tr("The guide: your first signature"), "startGuide", "question", part);
    connect(model, &QToolButton::clicked, this, &StartPage::modelWanted);
    connect(project, &QToolButton::clicked, this, &StartPage::projectWanted);
    connect(open, &QToolButton::clicked, this, &StartPage::openWanted);
    connect(guide, &QToolButton::clicked, this, &StartPage::guideWanted);
    for (QToolButton* button : {model, project, open, guide})
        column->addWidget(button);
    return part;
}

QWidget* StartPage::makeRecent() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(heading(tr("Recent"), 1.15, part));
    recent_ = new QVBoxLayout;
    recent_->setSpacing(0);
    column->addLayout(recent_);
    return part;
}

void StartPage::setRecentFiles(const QStringList& files) {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    QStringList shown, names;
    for (const QString& file : files)
        if (QFileInfo::exists(file) && shown.size() < mostRecent) {
            shown.append(file);
            names.append(QFileInfo(file).fileName());
        }
    for (const QString& file : shown) {
        // Files of one name are told apart by their folders.
        const QFileInfo info(file);
        const QString name = names.count(info.fileName()) > 1
                                 ? tr("%1 in %2").arg(info.fileName(), info.dir().dirName())
                                 : info.fileName();
        auto* button = plainButton(name, "recentFile", "recent", this);
        button->setToolTip(file);
        connect(button, &QToolButton::clicked, this, [this, file] { emit fileChosen(file); });
        recent_->addWidget(button);
    }
    if (recent_->count() == 0) {
        auto* none = new QLabel(tr("Nothing yet"), this);
        none->setForegroundRole(QPalette::PlaceholderText);
        recent_->addWidget(none);
    }
}

void StartPage::fitCards() {
    if (cards_.isEmpty())
        return;
    const int bar_px = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const int around_px = cards_.front()->sizeHint().width() - cards_.front()->iconSize().width();
    const int room_px = width() - leftMargin_px - rightMargin_px - bar_px;
    const int card_px = (room_px - (cardColumns - 1) * cardSpacing_px) / cardColumns - around_px;
    const int width_px = std::clamp(card_px, leastCard_px, cardPicture.width());
    const QSize size(width_px, width_px * cardPicture.height() / cardPicture.width());
    for (QToolButton* card : cards_) {
        card->setIconSize(size);
        // A title that is longer than its picture is read in the tip.
        card->setMaximumWidth(size.width() + around_px);
    }
}

void StartPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitCards();
}

void StartPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    letKeysBelow(false);
}

void StartPage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    // Hidden with the window it still lies above.
    if (isHidden() && parentWidget() != nullptr)
        letKeysBelow(true);
}

void StartPage::letKeysBelow(bool let) {
    for (QWidget* below :
         parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (below != this)
            below->setEnabled(let);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) {
        setGeometry(parentWidget()->rect());
        raise();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace smat::gui

#include "moc_StartPage.cpp"
