#include "gui/project/PlacingFields.h"

#include <cmath>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/project/PlacingPicture.h"
#include "gui/widgets/NumberField.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/Project.h"

namespace smat::gui {
namespace {

using Origin = irsg::ModelOrigin::At;

using irsg::modelUnits;

QComboBox* axisBox(const QString& name) {
    auto* box = new QComboBox;
    box->setObjectName(name);
    box->addItem(PlacingFields::tr("as the file says"));
    for (const std::string& axis : irsg::modelAxisNames()) {
        const QString sign = axis.front() == '-' ? QStringLiteral("−") : QStringLiteral("+");
        box->addItem(PlacingFields::tr("%1%2 of the file")
                         .arg(sign, QString::fromStdString(axis.substr(1)).toUpper()));
    }
    return box;
}

std::optional<irsg::ModelAxis> axisOf(const QComboBox* box) {
    return box->currentIndex() == 0
               ? std::nullopt
               : std::optional(static_cast<irsg::ModelAxis>(box->currentIndex() - 1));
}

void setAxis(QComboBox* box, const std::optional<irsg::ModelAxis>& axis) {
    box->setCurrentIndex(axis ? static_cast<int>(*axis) + 1 : 0);
}

} // namespace

PlacingFields::PlacingFields(const QString& prefix, QWidget* parent, Asks asks)
    : QWidget(parent), asksForOrigin_(asks == Asks::all) {
    up_ = axisBox(prefix + ".up");
    nose_ = axisBox(prefix + ".nose");
    unit_ = new QComboBox;
    unit_->setObjectName(prefix + ".unit");
    unit_->addItem(tr("as the file says"));
    for (const irsg::ModelUnit& unit : modelUnits)
        unit_->addItem(tr(unit.name));
    unit_->addItem(tr("another"));
    otherUnit_ = new NumberField(tr("m"));
    otherUnit_->setObjectName(prefix + ".unit_m");
    otherUnit_->setRange(leastModelUnit_m, mostModelUnit_m);
    otherUnit_->setValue(1.0);
    auto* unitRow = new QHBoxLayout;
    unitRow->addWidget(unit_, 1);
    unitRow->addWidget(otherUnit_);
    origin_ = new QComboBox;
    origin_->setObjectName(prefix + ".origin");
    origin_->addItems({tr("that of the file, unless it is far away"), tr("that of the file"),
                       tr("the centre of the model"), tr("below its centre, at its lowest point"),
                       tr("a point of the file")});
    pointRow_ = new QWidget;
    auto* pointLayout = new QHBoxLayout(pointRow_);
    pointLayout->setContentsMargins(0, 0, 0, 0);
    const char* const names[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        point_[i] = new NumberField(names[i]);
        point_[i]->setObjectName(prefix + ".origin." + names[i]);
        point_[i]->setRange(-1e9, 1e9);
        point_[i]->setValue(0.0);
        pointLayout->addWidget(point_[i]);
        connect(point_[i], &NumberField::edited, this, &PlacingFields::refresh);
    }
    guess_ = new QPushButton(tr("&Guess from the model"));
    guess_->setObjectName(prefix + ".guess");
    guess_->setEnabled(false);
    said_ = new QLabel;
    said_->setObjectName(prefix + ".said");
    said_->setWordWrap(true);
    said_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // Forms give no room for lines that a text takes later.
    said_->setMinimumHeight(3 * said_->fontMetrics().lineSpacing());
    said_->setForegroundRole(QPalette::PlaceholderText);
    picture_ = new PlacingPicture;

    auto* form = new QFormLayout;
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(8);
    form->addRow(tr("&Up is"), up_);
    form->addRow(tr("Nose &points to"), nose_);
    auto* unitLabel = new QLabel(tr("&One unit is"));
    unitLabel->setBuddy(unit_);
    form->addRow(unitLabel, unitRow);
    form->addRow(tr("Or&igin is"), origin_);
    form->addRow({}, pointRow_);
    form->setRowVisible(origin_, asksForOrigin_);
    form->addRow({}, guess_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(said_);
    column->addWidget(picture_, 1);

    for (QComboBox* box : {up_, nose_, unit_, origin_})
        connect(box, &QComboBox::currentIndexChanged, this, &PlacingFields::refresh);
    connect(otherUnit_, &NumberField::edited, this, &PlacingFields::refresh);
    connect(guess_, &QPushButton::clicked, this, &PlacingFields::takeGuess);
    isMade_ = true;
    refresh();
}

void PlacingFields::setFile(const std::filesystem::path& file) {
    if (file == file_)
        return;
    file_ = file;
    shape_.reset();
    guess_->setEnabled(false);
    task_.cancel();
    if (file.empty())
        return refresh();
    picture_->showWord(tr("Reading the model…"));
    using Read = std::shared_ptr<const irsg::ModelShape>;
    task_.run<Read>(
        [file] { return std::make_shared<const irsg::ModelShape>(irsg::shapeOf(file)); },
        [this](const Read& shape) {
            shape_ = shape;
            guess_->setEnabled(true);
            refresh();
            emit wasRead();
        },
        [this](const std::exception_ptr& thrown) {
            picture_->showWord(sentencesOf(thrown).join("\n"));
            emit wasRead();
        });
}

void PlacingFields::setPlacing(const irsg::ModelPlacing& placing) {
    setAxis(up_, placing.up);
    setAxis(nose_, placing.nose);
    int unit = 0;
    if (placing.unit_m) {
        unit = static_cast<int>(std::size(modelUnits)) + 1;
        for (std::size_t i = 0; i < std::size(modelUnits); ++i)
            if (modelUnits[i].unit_m == *placing.unit_m)
                unit = static_cast<int>(i) + 1;
        otherUnit_->setValue(*placing.unit_m);
    }
    unit_->setCurrentIndex(unit);
    origin_->setCurrentIndex(placing.origin ? static_cast<int>(placing.origin->at) + 1 : 0);
    if (placing.origin) {
        point_[0]->setValue(placing.origin->point.x);
        point_[1]->setValue(placing.origin->point.y);
        point_[2]->setValue(placing.origin->point.z);
    }
    refresh();
}

irsg::ModelPlacing PlacingFields::placing() const {
    irsg::ModelPlacing placing;
    placing.up = axisOf(up_);
    placing.nose = axisOf(nose_);
    const auto unit = static_cast<std::size_t>(unit_->currentIndex());
    if (unit > 0)
        placing.unit_m =
            unit <= std::size(modelUnits) ? modelUnits[unit - 1].unit_m : otherUnit_->value();
    if (asksForOrigin_ && origin_->currentIndex() > 0) {
        placing.origin = irsg::ModelOrigin{static_cast<Origin>(origin_->currentIndex() - 1), {}};
        if (placing.origin->at == Origin::point)
            placing.origin->point = {point_[0]->value(), point_[1]->value(), point_[2]->value()};
    }
    return placing;
}

irsg::BoundingBox PlacingFields::placedBox(const irsg::ModelPlacing& completed) const {
    const irsg::Matrix4 turned = irsg::turnAndScale(completed);
    irsg::BoundingBox box = irsg::BoundingBox::nowhere();
    for (const irsg::Float3& corner : shape_->corners)
        box.include(turned.place(irsg::toVec3(corner)));
    return box;
}

std::optional<irsg::BoundingBox> PlacingFields::bounds() const {
    if (!shape_ || !isRight())
        return std::nullopt;
    return placedBox(irsg::completed(placing(), shape_->axes, file_.filename().string()));
}

bool PlacingFields::isRight() const {
    try {
        irsg::completed(placing(), shape_ ? shape_->axes : irsg::FileAxes{}, "");
        return true;
    } catch (const irsg::InputError&) {
        return false;
    }
}

void PlacingFields::takeGuess() {
    if (!shape_)
        throw irsg::LogicError("a guess before the model is read");
    setPlacing(shape_->guess.placing);
    QStringList reasons;
    for (const std::string& reason : shape_->guess.reasons)
        reasons << QString::fromStdString(reason);
    said_->setText(tr("Guessed: %1.").arg(reasons.join("; ")));
    emit changed();
}

void PlacingFields::refresh() {
    if (!isMade_)
        return;
    const bool isPoint = origin_->currentIndex() == static_cast<int>(Origin::point) + 1;
    pointRow_->setVisible(isPoint && asksForOrigin_);
    otherUnit_->setVisible(unit_->currentIndex() == unit_->count() - 1);
    if (shape_) {
        try {
            const auto whole = irsg::completed(placing(), shape_->axes, file_.filename().string());
            picture_->show(shape_, whole);
            const irsg::BoundingBox box = placedBox(whole);
            const irsg::Vec3 size = box.max - box.min;
            said_->setText(tr("%1 m long, %2 m wide, %3 m high%4")
                               .arg(formattedNumber(std::abs(size.y)),
                                    formattedNumber(std::abs(size.x)),
                                    formattedNumber(std::abs(size.z)),
                                    shape_->axes.reason.empty()
                                        ? QString()
                                        : "; " + QString::fromStdString(shape_->axes.reason)));
        } catch (const irsg::InputError&) {
            picture_->showWord(
                tr("Up and nose lie along one axis: choose another for one of them."));
            said_->clear();
        }
    } else if (file_.empty()) {
        picture_->showWord(tr("No model yet"));
    }
    emit changed();
}

} // namespace smat::gui

#include "moc_PlacingFields.cpp"
