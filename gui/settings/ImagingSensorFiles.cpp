#include "gui/settings/ImagingSensorFiles.h"

#include <QFileInfo>

#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/simulate/ImagingSensorXml.h"

namespace smat::gui {
void importImagingSensor(Workbench& workbench, Dialogs& dialogs, QWidget* window,
                         const std::function<void(const QString&)>& say) {
    const QString file = dialogs.openFile(
        window, QObject::tr("Import an imaging sensor"),
        {QObject::tr("ImagingSensor files of KARMA (*.xml)"), QObject::tr("All files (*)")});
    if (file.isEmpty())
        return;
    try {
        const ImagingSensorFile read = readImagingSensor(file.toStdString());
        const Settings after = workbench.settings().with(read.set.settings);
        if (auto missing = read.missingIn(after, "the project, to be set first"); !missing.empty())
            throw irsg::InputError(std::move(missing));
        workbench.set(after,
                      QObject::tr("Import imaging sensor %1").arg(QFileInfo(file).fileName()));
        QStringList remarks;
        for (const std::string& remark : read.remarks)
            remarks << textOf(remark);
        if (!remarks.isEmpty())
            dialogs.tell(window, QObject::tr("Imaging sensor"), remarks);
        say(QObject::tr("The settings of %1 are those of the project now").arg(file));
    } catch (const irsg::InputError& error) {
        dialogs.tell(window, QObject::tr("This imaging sensor cannot be imported"),
                     sentencesOf(error));
    }
}

void exportImagingSensor(Workbench& workbench, Dialogs& dialogs, QWidget* window,
                         const std::function<void(const QString&)>& say) {
    const QString file = dialogs.saveFile(window, QObject::tr("Export the imaging sensor"),
                                          {QObject::tr("ImagingSensor files of KARMA (*.xml)")},
                                          "ImagingSensor.xml");
    if (file.isEmpty())
        return;
    try {
        requireOwnPlace(file.toStdString());
        writeImagingSensor(workbench.settings(), file.toStdString());
        say(QObject::tr("Wrote %1").arg(file));
    } catch (const irsg::InputError& error) {
        dialogs.tell(window, QObject::tr("The imaging sensor cannot be written"),
                     sentencesOf(error));
    }
}

} // namespace smat::gui
