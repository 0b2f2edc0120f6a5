#include "gui/tools/TemperatureProfilePage.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/tools/ViewerGeometry.h"

namespace smat::gui {
TemperatureProfilePage::TemperatureProfilePage(Workbench& workbench, Dialogs dialogs,
                                               QWidget* parent)
    : AtmosphereToolPage(workbench, std::move(dialogs), parent) {
    setObjectName("temperatureProfilePage");
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    air_ = new QLabel(this);
    air_->setObjectName("air");
    air_->setWordWrap(true);
    form->addRow(tr("Air"), air_);
    const TemperatureProfileRequest usual;
    const auto field = [&](const char* name, const QString& label, double value,
                           const QString& tip) {
        auto* edit = new QLineEdit(exactNumber(value), this);
        edit->setObjectName(name);
        edit->setToolTip(tip);
        connect(edit, &QLineEdit::textChanged, this, &TemperatureProfilePage::refresh);
        auto* row = new QHBoxLayout;
        row->setSpacing(8);
        row->addWidget(edit, 1);
        auto* unit = new QLabel(tr("m"), this);
        unit->setForegroundRole(QPalette::PlaceholderText);
        row->addWidget(unit);
        form->addRow(label, row);
        return edit;
    };
    min_ = field("min", tr("Lowest altitude"), usual.min_m, tr("At least 0: the ground"));
    max_ = field("max", tr("Highest altitude"), usual.max_m, tr("At least the lowest altitude"));
    step_ = field("step", tr("Step"), usual.step_m, tr("From one altitude to the next, above 0"));
    inputs()->addLayout(form);
    connect(&this->workbench(), &Workbench::settingsChanged, this,
            &TemperatureProfilePage::refresh);
    refresh();
}

std::optional<TemperatureProfileRequest> TemperatureProfilePage::request() const {
    const auto min = numberIn(min_, "m"), max = numberIn(max_, "m"), step = numberIn(step_, "m");
    if (!min || !max || !step)
        return std::nullopt;
    return TemperatureProfileRequest{.min_m = *min, .max_m = *max, .step_m = *step};
}

void TemperatureProfilePage::refresh() {
    if (step_ == nullptr)
        return;
    air_->setText(atmosphereWords());
    QStringList problems;
    const auto asked = request();
    if (!asked)
        problems << tr("Type three numbers in metres, such as 0, 12000 and 100.");
    else if (asked->min_m < 0.0)
        problems << tr("The lowest altitude must be at least 0 m, the ground.");
    else if (asked->max_m < asked->min_m)
        problems << tr("The highest altitude must not be below the lowest.");
    else if (!(asked->step_m > 0.0))
        problems << tr("The step must be above 0 m.");
    else if ((asked->max_m - asked->min_m) / asked->step_m >= maximumProfileRows)
        problems
            << tr("There are at most %1 altitudes: choose a larger step.").arg(maximumProfileRows);
    setProblems(problems);
    if (!problems.isEmpty())
        return;
    setCommand(QString::fromStdString(
        "smat-batch temperature-profile" +
        atmosphereArguments(resolvedAtmosphere(workbench().project(), workbench().settings())) +
        " --min=" + irsg::numberText(asked->min_m) + " --max=" + irsg::numberText(asked->max_m) +
        " --step=" + irsg::numberText(asked->step_m) + " --out profile.csv"));
}

Calculation::Work TemperatureProfilePage::work() {
    const auto project = workbench().project();
    const auto settings = workbench().settings();
    const auto asked = request().value_or(TemperatureProfileRequest());
    return [this, project, settings, asked]() -> std::function<void()> {
        const auto table = temperatureProfile(environmentOf(project, settings), asked);
        return [this, table] { showTable(table, tr("Temperature profile"), {}); };
    };
}

} // namespace smat::gui

#include "moc_TemperatureProfilePage.cpp"
