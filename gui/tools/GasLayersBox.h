#pragma once

#include <vector>

#include <QStringList>
#include <QWidget>

#include "gui/workbench/EditedState.h"
#include "irsg/gas/GasLayer.h"

class QListWidget;
class QToolButton;

namespace smat::gui {

class NumberField;

/// Layers of gas in order from the sensor: a list to add to, remove from and order, and the numbers
/// of the one that is chosen in fields below it. There is always one. Each edit is a step of the
/// undo stack; what is typed into a field until it is left is one.
class GasLayersBox : public QWidget {
    Q_OBJECT

  public:
    explicit GasLayersBox(QUndoStack& undoStack, QWidget* parent = nullptr);

    const std::vector<irsg::GasLayer>& layers() const { return state_->layers; }
    /// The one that is chosen, from 0.
    std::size_t chosen() const;
    void choose(std::size_t layer);
    /// What is wrong with texts that are being typed and with layers as a whole, a sentence each.
    QStringList problems() const;

  signals:
    /// Layers or problems are others.
    void changed();

  private:
    struct State {
        std::vector<irsg::GasLayer> layers;
        std::size_t chosen = 0;
        bool operator==(const State&) const = default;
    };
    QWidget* makeFields();
    QToolButton* makeButton(const char* name, const char* picture, const QString& tip,
                            void (GasLayersBox::*act)());
    void add();
    void remove();
    void moveUp() { move(-1); }
    void moveDown() { move(1); }
    void move(int by);
    /// Why a number cannot stand in the chosen layer, in the library's words.
    QString problemOf(std::size_t field, double value) const;
    /// A step that leaves these layers with this one chosen.
    void edit(State after, const QString& step, int gesture = EditedState<State>::noGesture);
    void set(std::size_t field, double value);
    /// After a step, its undo or redo.
    void showState();
    void refill();
    void showChosen();
    void refreshButtons();

    EditedState<State> state_;
    int gesture_ = EditedState<State>::noGesture; ///< of the typing that goes on
    QListWidget* list_ = nullptr;
    QToolButton *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
    std::vector<NumberField*> fields_; ///< in the order of gasLayerFields()
};

} // namespace smat::gui
