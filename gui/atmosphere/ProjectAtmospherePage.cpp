#include "gui/atmosphere/ProjectAtmospherePage.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>

#include "gui/atmosphere/AtmosphereDocument.h"
#include "gui/atmosphere/AtmospherePages.h"
#include "gui/widgets/FileFilters.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/workbench/Workbench.h"
#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

constexpr int wideAir_px = 760;

QString bandTitle(const irsg::SpectralRange& band) {
    return QStringLiteral("%1–%2 µm").arg(band.min_um).arg(band.max_um);
}

} // namespace

struct ProjectAtmospherePage::Answer {
    std::vector<BandProviders> bands;
    QStringList problems;
};

ProjectAtmospherePage::ProjectAtmospherePage(Workbench& workbench, Dialogs dialogs,
                                             AtmospherePages& pages, QWidget* parent)
    : QWidget(parent), workbench_(workbench), dialogs_(std::move(dialogs)), pages_(pages) {
    setObjectName("projectAirPage");
    setAutoFillBackground(true);
    halves_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
    halves_->setContentsMargins(14, 12, 14, 12);
    halves_->setSpacing(14);
    halves_->addWidget(makeList(), 2);
    halves_->addWidget(makeAnswers(), 3);
    for (const auto signal :
         {&Workbench::projectOpened, &Workbench::projectChanged, &Workbench::settingsChanged})
        connect(&workbench_, signal, this, &ProjectAtmospherePage::follow);
    follow();
}

QPushButton* ProjectAtmospherePage::addButton(QBoxLayout& row, const char* name,
                                              const QString& text, const QString& tip,
                                              void (ProjectAtmospherePage::*does)()) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, does);
    row.addWidget(button);
    return button;
}

QWidget* ProjectAtmospherePage::makeList() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    auto* words = new QLabel(tr("The first that covers the whole band is used for each quantity. "
                                "Drag, or Alt+Up and Alt+Down, to put them in order."),
                             part);
    words->setWordWrap(true);
    column->addWidget(words);
    list_ = new QListWidget(part);
    list_->setObjectName("airList");
    list_->setAccessibleName(tr("Atmospheres of the project"));
    list_->setDragDropMode(QAbstractItemView::InternalMove);
    list_->setDefaultDropAction(Qt::MoveAction);
    list_->setTextElideMode(Qt::ElideMiddle);
    list_->setMinimumHeight(90);
    list_->installEventFilter(this);
    column->addWidget(list_, 1);
    empty_ =
        new QLabel(tr("The project has no atmosphere: everything is seen through vacuum."), part);
    empty_->setObjectName("noAir");
    empty_->setWordWrap(true);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(empty_);
    auto* order = new QHBoxLayout;
    up_ = addButton(*order, "airUp", tr("Up"), tr("Move up: it is used before the next (Alt+Up)"),
                    &ProjectAtmospherePage::up);
    down_ = addButton(*order, "airDown", tr("Down"),
                      tr("Move down: it is used after the next (Alt+Down)"),
                      &ProjectAtmospherePage::down);
    order->addStretch(1);
    auto* files = new QHBoxLayout;
    addButton(*files, "airAdd", tr("Add…"), tr("Add another atmosphere; it is used last"),
              &ProjectAtmospherePage::add);
    edit_ =
        addButton(*files, "airEdit", tr("Edit"), tr("Open the parameters of this AtmosphereSmart"),
                  &ProjectAtmospherePage::edit);
    remove_ = addButton(*files, "airRemove", tr("Remove"),
                        tr("Remove it from the project (Delete); its file stays"),
                        &ProjectAtmospherePage::remove);
    files->addStretch(1);
    column->addLayout(order);
    column->addLayout(files);
    connect(list_->model(), &QAbstractItemModel::rowsMoved, this,
            [this] { take(tr("Order the atmospheres")); });
    connect(list_, &QListWidget::currentRowChanged, this, &ProjectAtmospherePage::refreshButtons);
    connect(list_, &QListWidget::itemActivated, this, &ProjectAtmospherePage::edit);
    return part;
}

QWidget* ProjectAtmospherePage::makeAnswers() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    auto* words = new QLabel(tr("The atmosphere that is used in each band of the sensor"), part);
    column->addWidget(words);
    table_ = new QTableWidget(part);
    table_->setObjectName("airAnswers");
    table_->setAccessibleName(words->text());
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->setMinimumHeight(140);
    column->addWidget(table_, 1);
    problems_ = new QLabel(part);
    problems_->setObjectName("airListProblems");
    problems_->setWordWrap(true);
    problems_->hide();
    column->addWidget(problems_);
    return part;
}

bool ProjectAtmospherePage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == list_ && event->type() == QEvent::KeyPress) {
        const auto* key = dynamic_cast<QKeyEvent*>(event);
        const bool withAlt = key->modifiers() == Qt::AltModifier;
        if (withAlt && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down)) {
            move(key->key() == Qt::Key_Up ? -1 : 1);
            return true;
        }
        if (key->matches(QKeySequence::Delete)) {
            remove();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ProjectAtmospherePage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    halves_->setDirection(width() >= wideAir_px ? QBoxLayout::LeftToRight
                                                : QBoxLayout::TopToBottom);
}

void ProjectAtmospherePage::follow() {
    const auto listed = workbench_.settings()[key::environmentAtmospheres];
    QStringList texts;
    for (const auto& one : listed)
        if (one != "none")
            texts << textOf(one);
    QStringList shown;
    for (int i = 0; i < list_->count(); ++i)
        shown << list_->item(i)->text();
    if (shown != texts) {
        const int row = list_->currentRow();
        list_->clear();
        list_->addItems(texts);
        list_->setCurrentRow(std::clamp(row, 0, std::max(list_->count() - 1, 0)));
    }
    empty_->setVisible(texts.isEmpty());
    refreshButtons();
    ask();
}

void ProjectAtmospherePage::take(const QString& step) {
    QStringList texts;
    for (int i = 0; i < list_->count(); ++i)
        texts << list_->item(i)->text();
    Settings changed = workbench_.settings();
    changed.set(key::environmentAtmospheres,
                texts.isEmpty() ? "none" : texts.join(';').toStdString());
    workbench_.set(changed, step);
}

void ProjectAtmospherePage::move(int by) {
    const int from = list_->currentRow(), to = from + by;
    if (from < 0 || to < 0 || to >= list_->count())
        return;
    const QSignalBlocker quiet(list_);
    list_->insertItem(to, list_->takeItem(from));
    list_->setCurrentRow(to);
    take(tr("Order the atmospheres"));
}

void ProjectAtmospherePage::add() {
    const QString file = dialogs_.openFile(this, tr("Add an atmosphere"), atmosphereFilters());
    if (file.isEmpty())
        return;
    list_->addItem(file);
    list_->setCurrentRow(list_->count() - 1);
    take(tr("Add an atmosphere"));
}

void ProjectAtmospherePage::remove() {
    if (list_->currentRow() < 0)
        return;
    delete list_->takeItem(list_->currentRow());
    take(tr("Remove an atmosphere"));
}

void ProjectAtmospherePage::edit() {
    if (edit_->isEnabled())
        pages_.open(workbench_.project().resolve(list_->currentItem()->text().toStdString()));
}

void ProjectAtmospherePage::refreshButtons() {
    const int row = list_->currentRow();
    const bool isOne = row >= 0 && row < list_->count();
    up_->setEnabled(isOne && row > 0);
    down_->setEnabled(isOne && row + 1 < list_->count());
    remove_->setEnabled(isOne);
    bool isAtmosphere = false;
    if (isOne && workbench_.hasProject()) {
        const std::string text = list_->item(row)->text().toStdString();
        isAtmosphere = !isNoAtmosphere(text) &&
                       AtmosphereDocument::isAtmosphere(workbench_.project().resolve(text));
    }
    edit_->setEnabled(isAtmosphere);
}

void ProjectAtmospherePage::ask() {
    if (!workbench_.hasProject())
        return;
    task_.run<Answer>(
        [project = workbench_.project(), settings = workbench_.settings()] {
            Answer answer;
            try {
                std::vector<irsg::SpectralRange> bands;
                for (const Settings& one : eachBand(settings))
                    bands.push_back(irsg::Band::fromText(one.text(key::sensorBand)).range());
                answer.bands = providersFor(environmentOf(project, settings), bands);
            } catch (const irsg::InputError& error) {
                answer.problems = sentencesOf(error);
            }
            return answer;
        },
        [this](const Answer& answer) { showAnswer(answer); });
}

void ProjectAtmospherePage::showAnswer(const Answer& answer) {
    table_->clear();
    table_->setRowCount(answer.bands.empty() ? 0
                                             : static_cast<int>(answer.bands[0].sources.size()));
    table_->setColumnCount(static_cast<int>(answer.bands.size()));
    for (int column = 0; column < table_->columnCount(); ++column) {
        const BandProviders& band = answer.bands[static_cast<std::size_t>(column)];
        table_->setHorizontalHeaderItem(column, new QTableWidgetItem(bandTitle(band.band)));
        for (int row = 0; row < table_->rowCount(); ++row) {
            const QuantityProvider& source = band.sources[static_cast<std::size_t>(row)];
            auto* cell = new QTableWidgetItem(
                source.providedBy.empty() ? tr("none") : textOf(source.providedBy));
            if (source.providedBy.empty())
                cell->setForeground(palette().brush(QPalette::PlaceholderText));
            QStringList why;
            for (const std::string& refusal : source.refusals)
                why << withFormattedUnits(textOf(refusal));
            cell->setToolTip(why.join('\n'));
            table_->setItem(row, column, cell);
            table_->setVerticalHeaderItem(row, new QTableWidgetItem(textOf(source.quantity)));
        }
    }
    problems_->setStyleSheet(QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
    problems_->setText(answer.problems.join('\n'));
    problems_->setVisible(!answer.problems.isEmpty());
}

} // namespace smat::gui

#include "moc_ProjectAtmospherePage.cpp"
