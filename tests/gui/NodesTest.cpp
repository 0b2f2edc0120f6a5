#include "gui/database/Nodes.h"

#include <limits>

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QTest>
#include <QwtInterval>
#include <gtest/gtest.h>

#include "gui/database/NodeEditor.h"
#include "gui/database/NodePlot.h"
#include "gui/database/NodeTable.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

using Rows = std::vector<std::vector<double>>;

struct Paste {
    const char* name;
    const char* text;
    Rows rows;
    const char* problem = "";
};
void PrintTo(const Paste& row, std::ostream* out) {
    *out << row.name;
}

class PasteTest : public ::testing::TestWithParam<Paste> {};

TEST_P(PasteTest, ReadsOrRefusesWithRowColumnAndValue) {
    const auto& param = GetParam();
    const PastedRows pasted = rowsOf(QString::fromUtf8(param.text));
    EXPECT_EQ(pasted.problem.toStdString(), param.problem);
    if (pasted.problem.isEmpty()) {
        EXPECT_EQ(pasted.rows, param.rows);
    }
}

const Rows two = {{3.0, 0.5}, {4.2, 0.75}};
INSTANTIATE_TEST_SUITE_P(
    All, PasteTest,
    ::testing::Values(
        Paste{"tabs", "3\t0.5\n4.2\t0.75\n", two},
        Paste{"tabsWithDecimalCommas", "3\t0,5\r\n4,2\t0,75\r\n", two},
        Paste{"semicolonsWithDecimalCommas", "3;0,5\n4,2;0,75", two},
        Paste{"commas", "3,0.5\n4.2,0.75\n", two},
        Paste{"commasAndBlanks", "3, 0.5\n4.2, 0.75\n", two},
        Paste{"blanks", "  3   0.5\n4.2 0.75  ", two},
        Paste{"blanksWithDecimalCommas", "3 0,5\n4,2 0,75\n", two},
        Paste{"heading", "wavelength [um]\temissivity\n3\t0.5\n4.2\t0.75\n", two},
        Paste{"commentsAndEmptyLines", "# from a lab\n\n3\t0.5\n\n4.2\t0.75\n\n", two},
        Paste{"trailingTab", "3\t0.5\t\n4.2\t0.75\t\n", two},
        Paste{"oldMacintoshLines", "3\t0.5\r4.2\t0.75", two},
        Paste{"oneColumn", "3\n4.2", {{3.0}, {4.2}}},
        Paste{"exponents", "3e0\t5E-1\n4.2\t7.5e-1", two},
        Paste{"unicodeMinus", "\u22123\t1\n", {{-3.0, 1.0}}},
        Paste{"noNumber", "3\t0.5\n4.2\tn/a", {}, "row 2, column 2: 'n/a' is not a number"},
        Paste{"notFinite", "3\tnan\n", {}, "row 1, column 2: 'nan' is not a number"},
        Paste{"thousands", "3\t1,234.5\n", {}, "row 1, column 2: '1,234.5' is not a number"},
        Paste{"ragged", "3\t0.5\n4.2", {}, "row 2: 1 columns, but 2 in the rows before"},
        Paste{"emptyCell", "3\t0.5\n\t0.75", {}, "row 2, column 1: '' is not a number"},
        Paste{"nothing", " \n", {}, "the clipboard holds no numbers"}),
    [](const auto& tested) { return tested.param.name; });

NodeRules emissivityRules() {
    NodeRules rules;
    rules.xName = "wavelength";
    rules.xUnit = "um";
    rules.yName = "emissivity";
    rules.xPositive = true;
    rules.yMinimum = 0.0;
    rules.yMaximum = 1.0;
    rules.yMaximumAt = [](double x) { return x > 4.0 ? 0.8 : 1.0; };
    rules.fewest = 2;
    return rules;
}

TEST(NodeRulesTest, SayRowColumnAndValueOfTheFirstDiagnostic) {
    const NodeRules rules = emissivityRules();
    EXPECT_EQ(rules.problemOf({{3, 0.5}, {5, 0.8}}), "");
    EXPECT_EQ(rules.problemOf({{3, 0.5}}), "at least 2 rows have to stay");
    EXPECT_EQ(rules.problemOf({{3, 0.5}, {3, 0.8}}),
              "row 2, column 1: 3 has to be above 3, the value before: the axis ascends, not 3");
    EXPECT_EQ(rules.problemOf({{3, 0.5}, {5, 0.9}}),
              "row 2, column 2: emissivity can be at most 0.8 here, not 0.9");
    EXPECT_EQ(rules.problemOf({{-3, 0.5}, {5, 0.5}}),
              "row 1, column 1: wavelength has to be above 0, not -3");
}

/// The real table and plot, shown.
class NodeEditorTest : public ::testing::Test {
  protected:
    NodeEditorTest() {
        editor.setRules(emissivityRules());
        editor.setNodes({{3, 0.5}, {3.5, 0.6}, {5, 0.7}});
        QObject::connect(&editor, &NodeEditor::edited,
                         [this](const Nodes& nodes, const QString& what) {
                             taken = nodes;
                             words << what;
                         });
        QObject::connect(&editor, &NodeEditor::gestureEnded, [this] { ++gestures; });
        QObject::connect(editor.table(), &NodeTable::problem,
                         [this](const QString& sentence) { problem = sentence; });
        editor.resize(640, 300);
        editor.show();
        QTest::qWait(30);
    }
    void paste(const char* text) {
        test::keepClipboard();
        const QString wanted = QString::fromUtf8(text);
        ASSERT_TRUE(test::waitUntil([&] {
            QApplication::clipboard()->setText(wanted);
            return QApplication::clipboard()->text() == wanted;
        }));
    }
    QPoint canvasPoint(double x, double y) {
        return {qRound(editor.plot()->transform(QwtPlot::xBottom, x)),
                qRound(editor.plot()->transform(QwtPlot::yLeft, y))};
    }

    NodeEditor editor;
    Nodes taken;
    QStringList words;
    QString problem;
    int gestures = 0;
};

TEST_F(NodeEditorTest, TypingChecksTheAxisBeforeItIsTaken) {
    auto* table = editor.table();
    table->setCurrentIndex(table->model()->index(1, 0));
    QTest::keyClicks(table, "2");
    auto* cell = table->findChild<QLineEdit*>("nodeCell");
    ASSERT_NE(cell, nullptr);
    EXPECT_EQ(problem, "wavelength has to be above 3, the row before");
    QTest::keyClick(cell, Qt::Key_Return);
    QTest::qWait(10);
    EXPECT_TRUE(words.isEmpty());
    EXPECT_EQ(editor.nodes()[1].x, 3.5);

    table->edit(table->model()->index(1, 0));
    cell = table->findChild<QLineEdit*>("nodeCell");
    ASSERT_NE(cell, nullptr);
    cell->selectAll();
    QTest::keyClicks(cell, "4,2");
    EXPECT_EQ(problem, "");
    QTest::keyClick(cell, Qt::Key_Return);
    QTest::qWait(10); // a cell is taken after its key was handled
    ASSERT_EQ(words, QStringList{"at 4.2 um"});
    EXPECT_EQ(taken[1], (Node{4.2, 0.6}));
}

TEST_F(NodeEditorTest, PastesInPlaceOfAllRowsAndTurnsADescendingAxis) {
    paste("12\t0.2\n8\t0.3\n3\t0.4\n");
    editor.table()->pasteAll();
    EXPECT_EQ(taken, (Nodes{{3, 0.4}, {8, 0.3}, {12, 0.2}}));
    EXPECT_EQ(editor.plot()->nodes(), taken);
}

TEST_F(NodeEditorTest, PastesFromTheCurrentCellDown) {
    paste("0.1\n0.2");
    editor.table()->setCurrentIndex(editor.table()->model()->index(1, 1));
    QTest::keySequence(editor.table(), QKeySequence::Paste);
    EXPECT_EQ(taken, (Nodes{{3, 0.5}, {3.5, 0.1}, {5, 0.2}}));
    paste("6\t0.3\n7\t0.4");
    editor.table()->setCurrentIndex(editor.table()->model()->index(3, 0));
    editor.table()->paste();
    EXPECT_EQ(taken.size(), 5U);
    EXPECT_EQ(taken.back(), (Node{7, 0.4}));
}

TEST_F(NodeEditorTest, ABadPasteChangesNothingAndSaysWhere) {
    for (const auto& [text, sentence] :
         {std::pair{"3\t0.5\n4\t1.5", "row 2, column 2: emissivity can be at most 1 here, not 1.5"},
          std::pair{"3\t0.5\n4\tx", "row 2, column 2: 'x' is not a number"},
          std::pair{"3\t0.5\n5\t0.6\n4\t0.6",
                    "row 3, column 1: 4 has to be above 5, the value before: the axis ascends, "
                    "not 4"},
          std::pair{"3\t0.5\t1\n4\t0.5\t1", "two columns are needed, wavelength and "
                                            "emissivity; these rows have 3"}}) {
        paste(text);
        editor.table()->pasteAll();
        EXPECT_EQ(problem.toStdString(), sentence);
    }
    EXPECT_TRUE(words.isEmpty());
    EXPECT_EQ(editor.nodes().size(), 3U);
}

TEST_F(NodeEditorTest, InsertsAndRemovesRowsAndCopiesThemForASpreadsheet) {
    test::keepClipboard();
    auto* table = editor.table();
    table->setCurrentIndex(table->model()->index(2, 0));
    QTest::keyClick(table, Qt::Key_Insert);
    EXPECT_EQ(taken, (Nodes{{3, 0.5}, {3.5, 0.6}, {4.25, 0.65}, {5, 0.7}}));
    table->setCurrentIndex(table->model()->index(1, 0));
    QTest::keyClick(table, Qt::Key_Delete);
    EXPECT_EQ(taken, (Nodes{{3, 0.5}, {4.25, 0.65}, {5, 0.7}}));
    table->copy();
    EXPECT_EQ(QApplication::clipboard()->text(), "3\t0.5\n4.25\t0.65\n5\t0.7\n");
    table->selectAll();
    QTest::keyClick(table, Qt::Key_Delete);
    EXPECT_EQ(problem, "at least 2 rows have to stay");
    EXPECT_EQ(editor.nodes().size(), 3U);
}

TEST_F(NodeEditorTest, ADragMovesANodeWithinItsLimitsAsOneGesture) {
    auto* canvas = editor.plot()->canvas();
    const QPoint from = editor.plot()->positionOf(1).toPoint();
    QTest::mousePress(canvas, Qt::LeftButton, {}, from);
    QTest::mouseMove(canvas, from + QPoint(4, -10));
    QTest::mouseMove(canvas, QPoint(canvas->width() - 1, 0));
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, QPoint(canvas->width() - 1, 0));
    EXPECT_GE(words.size(), 2);
    EXPECT_EQ(gestures, 1);
    EXPECT_LT(taken[1].x, 5.0) << "it stays before its neighbour";
    EXPECT_GT(taken[1].x, 3.5);
    EXPECT_GT(taken[1].y, 0.7);
    EXPECT_LE(taken[1].y, 0.8) << "what is left of 1 beyond 4 um";
    EXPECT_EQ(editor.table()->model()->index(1, 0).data().toString(), textOf(taken[1].x));
}

TEST_F(NodeEditorTest, TheAxisGrowsWithANodeThatIsDraggedPastIt) {
    NodeRules rules = emissivityRules();
    rules.yMaximum = std::numeric_limits<double>::infinity();
    rules.yMaximumAt = nullptr;
    editor.setRules(rules);
    auto* plot = editor.plot();
    const double top = plot->axisInterval(QwtPlot::yLeft).maxValue();
    const QPoint from = plot->positionOf(1).toPoint();
    QTest::mousePress(plot->canvas(), Qt::LeftButton, {}, from);
    double before = editor.nodes()[1].y;
    for (const int above : {20, 60, 120}) {
        QTest::mouseMove(plot->canvas(), QPoint(from.x(), -above));
        EXPECT_GT(taken[1].y, before) << "it goes on with the mouse";
        before = taken[1].y;
        EXPECT_GT(plot->axisInterval(QwtPlot::yLeft).maxValue(), before) << "and stays in sight";
        EXPECT_GT(plot->positionOf(1).y(), 0.0);
        EXPECT_LT(plot->positionOf(1).y(), plot->canvas()->height());
    }
    EXPECT_GT(before, top);
    // A mouse that rests does not pull it further.
    QTest::mouseMove(plot->canvas(), QPoint(from.x(), -121));
    QTest::mouseMove(plot->canvas(), QPoint(from.x(), -120));
    EXPECT_EQ(taken[1].y, before);
    QTest::mouseRelease(plot->canvas(), Qt::LeftButton, {}, QPoint(from.x(), -120));
    EXPECT_EQ(gestures, 1);
}

TEST_F(NodeEditorTest, ADoubleClickAddsANodeAndDeleteRemovesIt) {
    auto* canvas = editor.plot()->canvas();
    QTest::mouseDClick(canvas, Qt::LeftButton, {}, canvasPoint(4.5, 0.2));
    ASSERT_EQ(taken.size(), 4U);
    EXPECT_NEAR(taken[2].x, 4.5, 0.05);
    EXPECT_NEAR(taken[2].y, 0.2, 0.05);
    EXPECT_EQ(editor.plot()->selectedNode(), 2);
    QTest::keyClick(editor.plot(), Qt::Key_Delete);
    EXPECT_EQ(taken, (Nodes{{3, 0.5}, {3.5, 0.6}, {5, 0.7}}));
    QTest::keyClick(editor.plot(), Qt::Key_Delete);
    QTest::keyClick(editor.plot(), Qt::Key_Delete);
    EXPECT_EQ(taken.size(), 2U) << "two have to stay";
}

TEST_F(NodeEditorTest, ArrowKeysStepBetweenNodesAndMoveThem) {
    editor.plot()->selectNode(0);
    QTest::keyClick(editor.plot(), Qt::Key_Right);
    EXPECT_EQ(editor.plot()->selectedNode(), 1);
    QTest::keyClick(editor.plot(), Qt::Key_Up);
    EXPECT_GT(taken[1].y, 0.6);
    EXPECT_EQ(gestures, 1);
}

} // namespace
} // namespace smat::gui
