#pragma once

#include <QTableWidget>

#include "gui/scenario/ScenarioPictures.h"

namespace smat::gui {

/// Where the entities of a scenario are at the time that is shown, and what the sensor sees of
/// them: a row each.
class PresentTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit PresentTable(QWidget* parent = nullptr);

    void showMoment(const Scenario& scenario, const ScenarioPicture& picture);
};

} // namespace smat::gui
