#include "gui/scenario/FramesPanel.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/image/ColoredPlane.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/ResultPlot.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ImageStatistics.h"

namespace smat::gui {
namespace {

constexpr QSize thumbnail(112, 84);
constexpr int leastBeside_px = 480, leastPlot_px = 116;
enum Role { bandRole = Qt::UserRole, frameRole };

QIcon pictureOf(const WrittenFrame& frame, const irsg::ColorMap& map,
                const irsg::DisplayLimits& limits) {
    ColoredPlane plane;
    plane.setValues(frame.width, frame.height,
                    std::make_shared<const std::vector<float>>(frame.values));
    plane.setColors(map, limits);
    const QPixmap picture = QPixmap::fromImage(
        plane.picture().scaled(thumbnail, Qt::KeepAspectRatio, Qt::FastTransformation));
    // The chosen one has the colours of the others, not a tint of the selection.
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);
    return icon;
}

} // namespace

FramesPanel::FramesPanel(Dialogs dialogs, QWidget* parent)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    setObjectName("framesPanel");
    words_ = new QLabel(this);
    words_->setObjectName("framesWords");
    words_->setWordWrap(true);
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_->setForegroundRole(QPalette::PlaceholderText);
    words_->setContentsMargins(10, 6, 10, 2);
    words_->setText(tr("Write frames to see them here."));
    strip_ = new QListWidget(this);
    strip_->setObjectName("filmStrip");
    strip_->setAccessibleName(tr("Frames"));
    strip_->setViewMode(QListView::IconMode);
    strip_->setWrapping(false);
    strip_->setMovement(QListView::Static);
    strip_->setIconSize(thumbnail);
    strip_->setSpacing(4);
    strip_->setUniformItemSizes(true);
    strip_->setFrameShape(QFrame::NoFrame);
    strip_->hide();
    quantity_ = new QComboBox(this);
    quantity_->setObjectName("framesQuantity");
    quantity_->setMinimumWidth(90);
    quantity_->setToolTip(tr("Quantity to plot"));
    plot_ = new PlotPanel(PlotKind::cartesian, dialogs_, this);
    plot_->addInFront(quantity_);
    plot_->cartesian()->setMinimumHeight(leastPlot_px);
    plot_->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    film_ = menuButton(tr("Export film…"), "exportFilm", {});
    film_->hide();
    connect(film_->menu(), &QMenu::aboutToShow, this, &FramesPanel::fillFilmMenu);
    auto* first = new QHBoxLayout;
    first->setContentsMargins(0, 0, 10, 0);
    first->addWidget(words_, 1);
    first->addWidget(film_, 0, Qt::AlignTop);
    column->addLayout(first);
    parts_ = new QBoxLayout(QBoxLayout::TopToBottom);
    parts_->setSpacing(2);
    parts_->addWidget(strip_);
    parts_->addWidget(plot_, 1);
    column->addLayout(parts_, 1);
    column->addStretch(0);
    arrange(false);
    connect(strip_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr)
            emit frameChosen(sensor_, item->data(bandRole).toULongLong(),
                             item->data(frameRole).toULongLong());
    });
    connect(quantity_, &QComboBox::activated, this, &FramesPanel::drawTable);
}

void FramesPanel::arrange(bool beside) {
    parts_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    strip_->setFlow(beside ? QListView::TopToBottom : QListView::LeftToRight);
    // setFlow forgets it.
    strip_->setWrapping(false);
    const int along = thumbnail.height() + 62, across = thumbnail.width() + 40;
    strip_->setHorizontalScrollBarPolicy(beside ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
    strip_->setVerticalScrollBarPolicy(beside ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    strip_->setMinimumSize(beside ? across : 0, beside ? 0 : along);
    strip_->setMaximumSize(beside ? across : QWIDGETSIZE_MAX, beside ? QWIDGETSIZE_MAX : along + 8);
}

void FramesPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool beside = width() >= leastBeside_px && 5 * width() > 7 * height();
    if (beside != (parts_->direction() == QBoxLayout::LeftToRight))
        arrange(beside);
}

void FramesPanel::say(const QString& sentence) {
    words_->setText(sentence);
    words_->setVisible(!sentence.isEmpty());
}

void FramesPanel::setOutcome(std::shared_ptr<const SimulationFrames> outcome,
                             const QString& colorMap) {
    outcome_ = std::move(outcome);
    colorMap_ = colorMap;
    std::size_t missing = 0;
    for (const SensorResult& sensor : outcome_->result.sensors)
        missing += sensor.framesMissing;
    QStringList words{(outcome_->result.state == AnalysisState::complete
                           ? tr("%1 frames in %2")
                           : tr("Stopped: %1 frames in %2"))
                          .arg(outcome_->frames.size())
                          .arg(textOf(outcome_->order.folder))};
    if (missing > 0)
        words
            << tr("%1 steps have no frame: the sensor or the entity that it tracks was not present")
                   .arg(missing);
    for (const std::string& note : outcome_->notes)
        words << textOf(note);
    say(words.join('\n'));
    showSensor(sensor_);
}

const SensorResult* FramesPanel::shownResult() const {
    if (!outcome_)
        return nullptr;
    const auto found = std::ranges::find(outcome_->result.sensors, sensor_, &SensorResult::sensor);
    return found == outcome_->result.sensors.end() ? nullptr : &*found;
}

void FramesPanel::showSensor(std::size_t sensor) {
    sensor_ = sensor;
    if (!outcome_)
        return;
    fillStrip();
    film_->setVisible(strip_->count() > 0);
    const bool canBe = shownFilm() != nullptr;
    film_->setEnabled(canBe && !filming_);
    film_->setToolTip(canBe ? tr("The frames of the shown sensor and band in one scale of colours")
                            : tr("A film needs frames that were written as OpenEXR"));
    const SensorResult* result = shownResult();
    const bool hasRows = result != nullptr && !result->table.empty();
    plot_->setVisible(hasRows);
    if (!hasRows)
        return;
    const QString before = quantity_->currentData().toString();
    quantity_->clear();
    for (const std::string& key : plottableQuantities(result->table))
        quantity_->addItem(quantityTitle(result->table, key), textOf(key));
    quantity_->setCurrentIndex(std::max(quantity_->findData(before), 0));
    drawTable();
}

void FramesPanel::fillStrip() {
    const QSignalBlocker quiet(strip_);
    strip_->clear();
    // One scale for all frames of a band, so that what grows brighter is seen to.
    std::vector<irsg::DisplayLimits> limits;
    for (const WrittenFrame& frame : outcome_->frames) {
        if (frame.sensor != sensor_ || frame.low > frame.high)
            continue;
        if (limits.size() <= frame.band)
            limits.resize(frame.band + 1, {.low = INFINITY, .high = -INFINITY});
        limits[frame.band].low = std::min(limits[frame.band].low, frame.low);
        limits[frame.band].high = std::max(limits[frame.band].high, frame.high);
    }
    std::vector<std::vector<std::span<const float>>> shown(limits.size());
    for (const WrittenFrame& frame : outcome_->frames)
        if (frame.sensor == sensor_ && frame.band < limits.size())
            shown[frame.band].emplace_back(frame.values);
    for (std::size_t band = 0; band < limits.size(); ++band) {
        if (!(limits[band].low < limits[band].high))
            limits[band].high = limits[band].low + 1.0;
        limits[band] = limits[band].with(irsg::ColorScale::automatic, shown[band]);
    }
    const irsg::ColorMap& map = irsg::ColorMap::named(colorMap_.toStdString());
    for (const WrittenFrame& frame : outcome_->frames) {
        if (frame.sensor != sensor_ || frame.band >= limits.size())
            continue;
        auto* item = new QListWidgetItem(pictureOf(frame, map, limits[frame.band]),
                                         tr("%1 s").arg(frame.time_s, 0, 'g', 6), strip_);
        item->setData(bandRole, static_cast<qulonglong>(frame.band));
        item->setData(frameRole, static_cast<qulonglong>(frame.number));
        item->setToolTip(tr("Frame %1").arg(frame.number, 6, 10, QChar('0')));
    }
    strip_->setVisible(strip_->count() > 0);
}

void FramesPanel::drawTable() {
    const SensorResult* result = shownResult();
    if (result == nullptr || result->table.empty())
        return;
    PlotData data = cartesianData({{textOf(result->name), &result->table, true}},
                                  quantity_->currentData().toString().toStdString());
    // The field above says what is drawn, and aspect and range are the scenario's.
    data.title.clear();
    data.conditions = warningNote(data.curves);
    plot_->cartesian()->setData(std::move(data));
    plot_->refresh();
}

const FilmStrip* FramesPanel::shownFilm() const {
    if (!outcome_)
        return nullptr;
    // Of several bands that of the chosen frame.
    const QListWidgetItem* chosen = strip_->currentItem();
    const std::size_t band = chosen == nullptr ? 0 : chosen->data(bandRole).toULongLong();
    const auto found = std::ranges::find_if(outcome_->films, [&](const FilmStrip& film) {
        return film.sensor == sensor_ && film.band == band;
    });
    return found == outcome_->films.end() ? nullptr : &*found;
}

void FramesPanel::fillFilmMenu() {
    QMenu* menu = film_->menu();
    menu->clear();
    const bool hasFfmpeg = findFfmpeg().has_value();
    const auto add = [&](const char* name, const QString& text, const QString& filter,
                         const QString& extension) {
        const bool isThere = hasFfmpeg || extension == ".png";
        QAction* action = menu->addAction(
            isThere ? text : tr("%1 (needs the program ffmpeg, which is not on PATH)").arg(text));
        action->setObjectName(name);
        action->setEnabled(isThere);
        connect(action, &QAction::triggered, this,
                [this, extension, filter] { exportFilm(extension, filter); });
    };
    add("filmMp4", tr("Film (MP4)…"), tr("Film (*.mp4)"), ".mp4");
    add("filmGif", tr("Moving picture (GIF)…"), tr("Moving picture (*.gif)"), ".gif");
    add("filmPng", tr("Numbered pictures (PNG)…"), tr("Numbered pictures (*.png)"), ".png");
}

void FramesPanel::exportFilm(const QString& extension, const QString& filter) {
    const FilmStrip* film = shownFilm();
    if (film == nullptr)
        return;
    const std::filesystem::path usual =
        outcome_->order.folder / (film->label + extension.toStdString());
    std::filesystem::path file =
        dialogs_.saveFile(this, tr("Export a film"), {filter}, textOf(usual)).toStdString();
    if (file.empty())
        return;
    if (file.extension() != extension.toStdString())
        file += extension.toStdString();
    try {
        requireOwnPlace(file);
    } catch (const irsg::InputError& error) {
        return dialogs_.tell(this, tr("This film cannot be written"), sentencesOf(error));
    }
    emit filmAsked({*film, file, outcome_->order.scenario.displayName()});
}

void FramesPanel::setFilming(bool filming) {
    filming_ = filming;
    film_->setEnabled(!filming && shownFilm() != nullptr);
}

} // namespace smat::gui

#include "moc_FramesPanel.cpp"
