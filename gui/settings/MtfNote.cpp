#include "gui/settings/MtfNote.h"

#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace smat::gui {

MtfNote::MtfNote(QWidget* parent) : QLabel(parent) {
    setObjectName("mtfNote");
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setWordWrap(true);
    setContentsMargins(12, 4, 12, 8);
}

void MtfNote::tell(const std::filesystem::path& file) {
    QStringList lines;
    if (!file.empty()) {
        try {
            for (const std::string& line : irsg::describeMtf(file).lines)
                lines.push_back(QString::fromStdString(line));
        } catch (const irsg::InputError& error) {
            lines = sentencesOf(error);
        }
    }
    setText(lines.join('\n'));
    // Forms give a label that wraps a line alone.
    setMinimumHeight(fontMetrics().lineSpacing() * (static_cast<int>(lines.size()) + 1));
    setVisible(!lines.isEmpty());
}

} // namespace smat::gui

#include "moc_MtfNote.cpp"
