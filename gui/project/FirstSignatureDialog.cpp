#include "gui/project/FirstSignatureDialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/project/PlacingFields.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberField.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/signature/MaterialLibrary.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::gui {
namespace {

using Kind = irsg::FirstTemperature::Kind;

enum SurfaceColumn {
    surfaceNameColumn,
    surfaceKindColumn,
    surfaceFacesColumn,
    surfaceMaterialColumn,
    surfaceTemperatureColumn,
    surfaceColumnCount
};

bool needsKelvin(Kind kind) {
    return kind == Kind::aboveAir || kind == Kind::fixed;
}

QTableWidgetItem* readOnly(const QString& text, Qt::Alignment alignment = Qt::AlignLeft) {
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    item->setTextAlignment(alignment | Qt::AlignVCenter);
    return item;
}

} // namespace

FirstSignatureDialog::FirstSignatureDialog(const Project& project, std::size_t number,
                                           QWidget* parent)
    : QDialog(parent),
      project_(project),
      number_(number),
      model_(project.resolve(project.models.at(number).file)) {
    setObjectName("firstSignatureDialog");
    setWindowTitle(tr("First signature of %1").arg(textOf(model_.filename())));
    resize(820, 560);

    auto* placingPage = new QWidget;
    auto* placingColumn = new QVBoxLayout(placingPage);
    placing_ = new PlacingFields("placing");
    placingColumn->addWidget(placing_);

    auto* surfacePage = new QWidget;
    auto* surfaceColumn = new QVBoxLayout(surfacePage);
    auto* hint =
        new QLabel(tr("What each surface is made of and how warm it is, as its name in the "
                      "file suggests. All of it can be refined in the database later."));
    hint->setWordWrap(true);
    table_ = new QTableWidget(0, surfaceColumnCount);
    table_->setObjectName("surfaces");
    table_->setHorizontalHeaderLabels(
        {tr("Name in the file"), tr("Name of"), tr("Faces"), tr("Material"), tr("Temperature")});
    table_->verticalHeader()->hide();
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    // The keys go through the fields in it, and what has them is in sight.
    table_->setFocusPolicy(Qt::NoFocus);
    table_->setTabKeyNavigation(false);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now != nullptr && table_->viewport()->isAncestorOf(now))
            table_->scrollTo(table_->indexAt(now->mapTo(table_->viewport(), now->rect().center())));
    });
    surfaceColumn->addWidget(hint);
    surfaceColumn->addWidget(table_, 1);

    tabs_ = new QTabWidget;
    tabs_->addTab(surfacePage, tr("&Surfaces"));
    tabs_->addTab(placingPage, tr("&Placing"));
    said_ = new QLabel(tr("Reading the model…"));
    said_->setObjectName("said");
    said_->setWordWrap(true);
    said_->setForegroundRole(QPalette::PlaceholderText);
    auto* buttons = okAndCancel(*this, tr("Create"));
    create_ = buttons->button(QDialogButtonBox::Ok);
    create_->setObjectName("create");
    create_->setEnabled(false);
    auto* column = new QVBoxLayout(this);
    column->addWidget(tabs_, 1);
    column->addWidget(said_);
    column->addWidget(buttons);

    const irsg::ModelPlacing given = project.models.at(number).options.placing;
    placing_->setPlacing(given);
    connect(placing_, &PlacingFields::changed, this,
            [this] { create_->setEnabled(isReady_ && placing_->isRight()); });
    // What the project says of its placing is not guessed at.
    if (given == irsg::ModelPlacing{})
        connect(placing_, &PlacingFields::wasRead, this, [this] {
            if (placing_->guess() != nullptr)
                placing_->takeGuess();
        });
    placing_->setFile(model_);
    task_.run<irsg::ModelNames>(
        [model = model_] { return irsg::namesOf(model, irsg::ModelCodes()); },
        [this](const irsg::ModelNames& names) { fill(names); },
        [this](const std::exception_ptr& thrown) {
            said_->setText(sentencesOf(thrown).join("\n"));
        });
}

void FirstSignatureDialog::fill(const irsg::ModelNames& names) {
    suggested_ = irsg::suggestedSurfaces(names.parts);
    table_->setRowCount(static_cast<int>(suggested_.size()));
    for (std::size_t i = 0; i < suggested_.size(); ++i) {
        const irsg::FirstSurface& surface = suggested_[i];
        const int row = static_cast<int>(i);
        const QString number = QString::number(row);
        const QString kinds[] = {tr("material"), tr("object"), tr("group")};
        const QString kind = kinds[static_cast<std::size_t>(surface.of)];
        auto* name = readOnly(surface.name.empty() ? tr("(no name)") : textOf(surface.name));
        name->setToolTip(surface.because.empty()
                             ? tr("No known word in this name: painted skin is assumed")
                             : tr("Because of \"%1\" in its name").arg(textOf(surface.because)));
        table_->setItem(row, surfaceNameColumn, name);
        table_->setItem(row, surfaceKindColumn, readOnly(kind));
        table_->setItem(row, surfaceFacesColumn,
                        readOnly(QString::number(surface.polygons), Qt::AlignRight));
        Row widgets;
        widgets.material = new QComboBox;
        widgets.material->setObjectName("material." + number);
        for (const auto& [index, material] : irsg::materialLibrary().materials)
            widgets.material->addItem(textOf(material.name), index);
        widgets.material->setCurrentIndex(widgets.material->findData(surface.libraryMaterial));
        widgets.temperature = new QComboBox;
        widgets.temperature->setObjectName("temperature." + number);
        widgets.temperature->addItems({tr("as the air"), tr("air plus"),
                                       tr("recovery temperature of the air"), tr("fixed at")});
        widgets.kelvin = new NumberField(tr("K"));
        widgets.kelvin->setObjectName("kelvin." + number);
        const auto adapt = [widgets] {
            const auto kind = static_cast<Kind>(widgets.temperature->currentIndex());
            widgets.kelvin->setVisible(needsKelvin(kind));
            widgets.kelvin->setRange(kind == Kind::fixed ? 1.0 : -150.0, 5000.0);
            if (kind == Kind::fixed && widgets.kelvin->value() < 100.0)
                widgets.kelvin->setValue(300.0);
        };
        widgets.kelvin->setValue(surface.temperature.kelvin);
        widgets.temperature->setCurrentIndex(static_cast<int>(surface.temperature.kind));
        adapt();
        connect(widgets.temperature, &QComboBox::currentIndexChanged, this, adapt);
        auto* cell = new QWidget;
        auto* layout = new QHBoxLayout(cell);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(widgets.temperature, 1);
        layout->addWidget(widgets.kelvin);
        widgets.kelvin->setMaximumWidth(100);
        table_->setCellWidget(row, surfaceMaterialColumn, widgets.material);
        table_->setCellWidget(row, surfaceTemperatureColumn, cell);
        rows_.push_back(widgets);
    }
    table_->resizeColumnsToContents();
    table_->resizeRowsToContents();
    table_->setColumnWidth(surfaceNameColumn,
                           std::clamp(table_->columnWidth(surfaceNameColumn), 160, 260));
    table_->horizontalHeader()->setSectionResizeMode(surfaceTemperatureColumn,
                                                     QHeaderView::Stretch);
    said_->setText(
        tr("Create writes %1 and %2 beside the model.")
            .arg(textOf(irsg::codesFileOf(model_).filename()), textOf(newDatabase().filename())));
    isReady_ = true;
    create_->setEnabled(placing_->isRight());
    // While the model was read, Cancel was the only button that Enter could press.
    if (create_->isEnabled())
        create_->setFocus();
}

std::vector<irsg::FirstSurface> FirstSignatureDialog::surfaces() const {
    std::vector<irsg::FirstSurface> surfaces = suggested_;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        surfaces[i].libraryMaterial = rows_[i].material->currentData().toInt();
        const auto kind = static_cast<Kind>(rows_[i].temperature->currentIndex());
        surfaces[i].temperature = {kind, needsKelvin(kind) ? rows_[i].kelvin->value() : 0.0};
    }
    return surfaces;
}

std::filesystem::path FirstSignatureDialog::newDatabase() const {
    std::filesystem::path file = model_;
    file.replace_extension(".sigdb");
    for (int i = 2; std::filesystem::exists(file); ++i)
        file.replace_filename(model_.stem().string() + "-" + std::to_string(i) + ".sigdb");
    return file;
}

std::optional<irsg::BoundingBox> FirstSignatureDialog::bounds() const {
    return placing_->bounds();
}

Project FirstSignatureDialog::write() const {
    const auto first = irsg::firstSignatureOf(surfaces(), model_.stem().string());
    irsg::ModelCodes codes = first.codes;
    codes.painted = irsg::readModelCodes(model_).painted;
    const auto database = newDatabase();
    irsg::createSignatureFile(first.database, database);
    irsg::saveModelCodes(codes, model_);
    Project project = project_;
    ProjectModel& target = project.models.at(number_);
    target.database =
        target.file.is_absolute() ? database : target.file.parent_path() / database.filename();
    target.options.placing = placing_->placing();
    return project;
}

} // namespace smat::gui

#include "moc_FirstSignatureDialog.cpp"
