#pragma once

#include "gui/image/ComparedPair.h"
#include "gui/widgets/FlowBar.h"

class QAction;
class QCheckBox;
class QComboBox;
class QToolButton;

namespace smat::gui {

/// The buttons and boxes over a comparison: which images, planes and colours, how they differ, and
/// what is copied and written of it.
class ComparisonBar : public FlowBar {
    Q_OBJECT

  public:
    /// `wipe` finds its place here.
    explicit ComparisonBar(QWidget* wipe, QWidget* parent = nullptr);

    /// Offers the planes of a pair, with that which was chosen before where there is one.
    void offerPlanes(const ComparedPair& pair);
    /// Name of the chosen one; empty for the usual one.
    QString plane() const;
    void setMode(irsg::DifferenceMode mode);
    bool isMarking() const;
    void toggleMarks();
    /// The map after this one, or before it.
    void changeColors(bool back);
    /// What can be done with a pair.
    void refresh(const ComparedPair& pair);
    void setHasCommand(bool has);

  signals:
    /// A file for one side.
    void openWanted(int side);
    void swapWanted();
    void planeChosen();
    void colorsChosen(const std::string& map);
    void modeChosen(irsg::DifferenceMode mode);
    void marksToggled();
    void worstWanted();
    void numbersWanted();
    void pictureWanted();
    void commandWanted();
    void exportWanted(const QString& filter);
    void fitWanted();
    void actualSizeWanted();

  private:
    void makeBoxes();
    void makeButtons();

    QComboBox* plane_ = nullptr;
    QComboBox* colors_ = nullptr;
    QComboBox* mode_ = nullptr;
    QCheckBox* mark_ = nullptr;
    QToolButton* worst_ = nullptr;
    QToolButton* swap_ = nullptr;
    QToolButton* copy_ = nullptr;
    QToolButton* export_ = nullptr;
    QAction* copyCommand_ = nullptr;
};

} // namespace smat::gui
