#include "gui/image/ChosenImage.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include "irsg/core/Errors.h"
#include "irsg/image/ImageFile.h"

namespace smat::gui {

irsg::ImageReading chosenImage(const Dialogs& dialogs, QWidget* window, const QString& file) {
    constexpr std::size_t mostAnswers = 12; // more buttons are no help: the default is read
    std::vector<irsg::ImagePart> parts;
    try {
        parts = irsg::imageParts(file.toStdString());
    } catch (const irsg::InputError&) {
        return {};
    }
    if (parts.empty() || parts.size() > mostAnswers || !dialogs.ask)
        return {};
    QStringList answers;
    for (const irsg::ImagePart& part : parts)
        answers << QString::fromStdString(part.words);
    const int answer = dialogs.ask(
        window, QCoreApplication::translate("ChosenImage", "Several images in one file"),
        QCoreApplication::translate("ChosenImage", "%1 holds several images. Which one is meant?")
            .arg(QFileInfo(file).fileName()),
        answers);
    return answer >= 0 && static_cast<std::size_t>(answer) < parts.size()
               ? parts[static_cast<std::size_t>(answer)].reading
               : irsg::ImageReading();
}

} // namespace smat::gui
