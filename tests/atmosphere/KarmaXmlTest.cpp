#include <cstdlib>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/karma/KarmaXml.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string everything =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\r\n"
    "<!-- by hand -->\r\n"
    "<data xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" version=\"2\">\r\n"
    "  <fileType>Parameters</fileType>\r\n"
    "  <type>/Thing/Root/Thing</type>\r\n"
    "  <Object_Model_Identification_Table><Name>A &amp; B</Name><Version/>"
    "</Object_Model_Identification_Table>\r\n"
    "  <documentation>What it is.</documentation>\r\n"
    "  <parameter name=\"One\" unit=\"m\">\r\n"
    "    <double> 5.0 </double><documentation>A \xC3\xA9 number.</documentation>\r\n"
    "  </parameter>\r\n"
    "  <parameter name=\"Many\"><vector><double>1e-3</double><double>+2</double></vector>"
    "</parameter>\r\n"
    "  <parameter name=\"Three\"><vector3><double>1</double><double>2</double><double>3</double>"
    "</vector3></parameter>\r\n"
    "  <parameter name=\"Kind\"><entityType>SORT</entityType></parameter>\r\n"
    "  <parameter name=\"Words\"><string>a b</string></parameter>\r\n"
    "  <parameter name=\"None\"><vector/></parameter>\r\n"
    "  <extension depth=\"1\"><deep><!-- inside --></deep></extension>\r\n"
    "  <composition><composite name=\"C\"><component>Air</component>"
    "<parameters>$(KARMA_ROOT)\\a\\b.xml</parameters><composition>none</composition>"
    "<priority>-2</priority><colour>red</colour><documentation>First.</documentation>"
    "</composite></composition>\r\n"
    "</data>\r\n";

TEST(KarmaXml, ReadsEveryKindOfParameterWithItsLine) {
    const KarmaXml document = KarmaXml::parse(everything, "thing.xml");
    EXPECT_EQ(document.type(), "/Thing/Root/Thing");
    EXPECT_EQ(document.typeName(), "Thing");
    EXPECT_EQ(document.documentation(), "What it is.");
    ASSERT_EQ(document.parameters().size(), 6u);
    EXPECT_EQ(*document.find("One"),
              (KarmaParameter{"One", KarmaKind::number, {5.0}, "", "A \xC3\xA9 number.", 0}));
    EXPECT_EQ(document.find("One")->line, 8);
    EXPECT_THAT(document.find("Many")->numbers, testing::ElementsAre(1e-3, 2.0));
    EXPECT_EQ(document.find("Three")->kind, KarmaKind::vector3);
    EXPECT_EQ(document.find("Kind")->text, "SORT");
    EXPECT_EQ(document.find("Words")->text, "a b");
    EXPECT_TRUE(document.find("None")->numbers.empty());
    EXPECT_EQ(document.find("Other"), nullptr);
    ASSERT_EQ(document.composites().size(), 1u);
    EXPECT_EQ(document.composites().front(),
              (KarmaComposite{"C", "Air", "$(KARMA_ROOT)\\a\\b.xml", "none", -2, "First.", 0}));
    EXPECT_EQ(document.composites().front().line, 17);
}

TEST(KarmaXml, WritesBackEverythingThatItRead) {
    const KarmaXml document = KarmaXml::parse(everything, "thing.xml");
    EXPECT_EQ(significant(document.text()), significant(everything));
    EXPECT_EQ(KarmaXml::parse(document.text(), "again").text(), document.text());
}

TEST(KarmaXml, SettingTheSameValuesChangesNothing) {
    KarmaXml document = KarmaXml::parse(everything, "thing.xml");
    for (const KarmaParameter& parameter : std::vector(document.parameters())) {
        document.set(parameter);
    }
    document.setComposites(std::vector(document.composites()));
    EXPECT_EQ(significant(document.text()), significant(everything));
}

TEST(KarmaXml, ANewValueKeepsWhatStandsAroundIt) {
    KarmaXml document = KarmaXml::parse(everything, "thing.xml");
    document.set({"One", KarmaKind::number, {0.1}, "", "", 0});
    document.set({"Words", KarmaKind::vector, {1.0, 2.5}, "", "now numbers", 0});
    document.set({"New", KarmaKind::string, {}, "<&>", "escaped", 0});
    document.remove("Many");
    KarmaComposite composite = document.composites().front();
    composite.parameters = "c.xml";
    document.setComposites({{"B", "Air", "b.xml", "none", 3, "", 0}, composite});

    const KarmaXml again = KarmaXml::parse(document.text(), "again");
    EXPECT_EQ(again.parameters(), document.parameters());
    EXPECT_EQ(again.composites(), document.composites());
    EXPECT_EQ(again.find("New")->text, "<&>");
    EXPECT_EQ(again.find("Many"), nullptr);
    EXPECT_THAT(document.text(), HasSubstr("unit=\"m\""));
    EXPECT_THAT(document.text(), HasSubstr("A \xC3\xA9 number."));
    EXPECT_THAT(document.text(), HasSubstr("<colour>red</colour>"));
    EXPECT_THAT(document.text(), HasSubstr("<!-- inside -->"));
    EXPECT_EQ(again.composites().front().name, "B");
}

TEST(KarmaXml, ACopyIsItsOwnDocument) {
    const KarmaXml original = KarmaXml::parse(everything, "thing.xml");
    KarmaXml copy = original;
    copy.remove("One");
    EXPECT_NE(original.find("One"), nullptr);
    EXPECT_THAT(original.text(), HasSubstr("name=\"One\""));
    EXPECT_THAT(copy.text(), testing::Not(HasSubstr("name=\"One\"")));
}

TEST(KarmaXml, ANewDocumentIsReadBack) {
    KarmaXml document("/Thing/Root/Thing", "A thing of two < three.");
    document.set({"V", KarmaKind::vector3, {1.0, 0.1, -3e300}, "", "three", 0});
    const auto file = ownFolder() / "new.xml";
    document.write(file);
    const KarmaXml again = KarmaXml::read(file);
    EXPECT_EQ(again.parameters(), document.parameters());
    EXPECT_EQ(again.documentation(), "A thing of two < three.");
    EXPECT_EQ(again.text(), document.text());
    EXPECT_THAT(refusalOf([&] { document.write(ownFolder() / "no" / "where.xml"); }),
                HasSubstr("where.xml"));
}

TEST(KarmaXml, ParametersThatCannotBeAreOurOwnFault) {
    KarmaXml document("/T", "");
    EXPECT_THROW(document.set({"", KarmaKind::number, {1.0}, "", "", 0}), LogicError);
    EXPECT_THROW(document.set({"A", KarmaKind::number, {}, "", "", 0}), LogicError);
    EXPECT_THROW(document.set({"A", KarmaKind::vector3, {1.0}, "", "", 0}), LogicError);
    EXPECT_THROW(document.set({"A", KarmaKind::number, {std::nan("")}, "", "", 0}), LogicError);
}

TEST(KarmaXml, LatinTextBecomesUtf8AndKeepsItsLines) {
    std::string text = smartXml("<documentation>temp\xE9rature \xE9\xE9\xE9\n</documentation>\n" +
                                numberXml("A", "1"));
    text.replace(text.find("UTF-8"), 5, "ISO-8859-1");
    const KarmaXml document = KarmaXml::parse(text, "latin.xml");
    EXPECT_THAT(document.documentation(), HasSubstr("temp\xC3\xA9rature"));
    EXPECT_EQ(document.find("A")->line, 7);
    EXPECT_THAT(document.text(), HasSubstr("encoding=\"UTF-8\""));
    EXPECT_EQ(KarmaXml::parse(document.text(), "again").documentation(), document.documentation());
}

TEST(KarmaXml, TheFilesOfTheReportComeBackEqual) {
    const auto folder = smat::test::sharedMaterial("data/karma");
    if (folder.empty()) {
        GTEST_SKIP() << "the KARMA files of the shared material are not here";
    }
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".xml") {
            continue;
        }
        EXPECT_EQ(significant(KarmaXml::read(entry.path()).text()),
                  significant(contentOf(entry.path())))
            << entry.path();
        ++files;
    }
    EXPECT_EQ(files, 5);
}

struct BadFile {
    const char* name;
    std::string text;
    std::vector<const char*> says;
};
void PrintTo(const BadFile& row, std::ostream* stream) {
    *stream << row.name;
}

class BadKarmaXml : public testing::TestWithParam<BadFile> {};

TEST_P(BadKarmaXml, IsRefusedByName) {
    const std::string message = refusalOf([] { KarmaXml::parse(GetParam().text, "bad.xml"); });
    EXPECT_THAT(message, HasSubstr("bad.xml"));
    for (const char* words : GetParam().says) {
        EXPECT_THAT(message, HasSubstr(words));
    }
}

const std::string good = numberXml("A", "1");

INSTANTIATE_TEST_SUITE_P(
    Files, BadKarmaXml,
    testing::Values(
        BadFile{"anEmptyFile", "", {"well-formed"}},
        BadFile{"noXml", "Dear reader,", {"well-formed"}},
        BadFile{"aFileCutShort",
                smartXml(good).substr(0, smartXml(good).find("</double>")),
                {"line 5", "well-formed"}},
        BadFile{"aTagThatIsNotClosed", "<data>\n<fileType>\n</data>", {"line 3", "well-formed"}},
        BadFile{"aByteOfZero", std::string("<data>\0</data>", 14), {"UTF-8"}},
        BadFile{"textInUtf16", "\xFF\xFE<", {"UTF-8"}},
        BadFile{"anEncodingThatIsNotKnown",
                "<?xml version=\"1.0\" encoding=\"EBCDIC\"?><data/>",
                {"line 1", "ebcdic", "UTF-8"}},
        BadFile{"anotherRoot", "\n<html/>", {"line 2", "'html'", "'data'"}},
        BadFile{"twoRoots",
                "<data><fileType>Parameters</fileType></data>\n<data/>",
                {"line 2", "a second root"}},
        BadFile{"noFileType", "<data/>", {"no fileType", "Parameters"}},
        BadFile{"anotherFileType",
                "<data>\n<fileType>Model</fileType></data>",
                {"line 2", "'Model'", "Parameters"}},
        BadFile{"twoTypes", smartXml("<type>/B</type>"), {"line 5", "a second one"}},
        BadFile{"aParameterWithoutName",
                smartXml("<parameter><double>1</double></parameter>"),
                {"line 5, parameter", "no name"}},
        BadFile{"aParameterWithABlankName", smartXml(numberXml(" ", "1")), {"no name"}},
        BadFile{"aParameterTwice",
                smartXml(good + good),
                {"line 6, parameter A", "not again after line 5"}},
        BadFile{"aParameterWithoutValue",
                smartXml("<parameter name=\"A\"></parameter>"),
                {"parameter A", "no value"}},
        BadFile{"aParameterWithTwoValues",
                smartXml("<parameter name=\"A\"><double>1</double><string>a</string></parameter>"),
                {"parameter A", "2 values"}},
        BadFile{"aValueOfUnknownKind",
                smartXml("<parameter name=\"A\"><integer>1</integer></parameter>"),
                {"parameter A", "'integer'", "vector3"}},
        BadFile{"aNumberWithAUnit", smartXml(numberXml("A", "5 m")), {"'5 m'", "a finite number"}},
        BadFile{"aNumberWithAComma", smartXml(numberXml("A", "5,5")), {"'5,5'"}},
        BadFile{"aNumberThatIsNone", smartXml(numberXml("A", "nan")), {"'nan'", "finite"}},
        BadFile{"aNumberWithoutEnd", smartXml(numberXml("A", "-inf")), {"'-inf'", "finite"}},
        BadFile{"aNumberThatIsTooLarge", smartXml(numberXml("A", "1e999")), {"'1e999'"}},
        BadFile{"aNumberThatIsEmpty", smartXml(numberXml("A", "")), {"nothing"}},
        BadFile{"aVectorWithAWord", smartXml(vectorXml("A", "1 x 3")), {"parameter A", "'x'"}},
        BadFile{"aVectorWithTextInIt",
                smartXml("<parameter name=\"A\"><vector>1 2 3</vector></parameter>"),
                {"'1 2 3'", "<double>"}},
        BadFile{"aVector3OfTwo",
                smartXml("<parameter name=\"A\"><vector3><double>1</double><double>2</double>"
                         "</vector3></parameter>"),
                {"2 numbers", "three"}},
        BadFile{"aCompositeWithoutName",
                smartXml("<composition><composite/></composition>"),
                {"composite", "no name"}},
        BadFile{"aCompositeWithoutComponentAndParameters",
                smartXml("<composition><composite name=\"C\"/></composition>"),
                {"composite C", "no component", "no parameters"}},
        BadFile{"aPriorityThatIsNoInteger",
                smartXml("<composition><composite name=\"C\"><component>A</component>"
                         "<parameters>a</parameters><priority>1.5</priority></composite>"
                         "</composition>"),
                {"composite C, priority", "'1.5'", "integer"}},
        BadFile{"aCompositeTwice",
                smartXml("<composition><composite name=\"C\"><component>A</component>"
                         "<parameters>a</parameters></composite><composite name=\"C\"/>"
                         "</composition>"),
                {"composite C", "the same name again"}},
        BadFile{"aCompositionOfSomethingElse",
                smartXml("<composition><thing/></composition>"),
                {"composition", "'thing'", "<composite>"}},
        BadFile{"severalFaultsAtOnce",
                smartXml(numberXml("A", "x") + numberXml("A", "1") + numberXml("B", "y")),
                {"line 5, parameter A", "line 6, parameter A", "line 7, parameter B"}}),
    [](const auto& row) { return row.param.name; });

TEST(KarmaXml, FilesThatCannotBeReadAreRefused) {
    EXPECT_THAT(refusalOf([] { KarmaXml::read("no/such.xml"); }), HasSubstr("no/such.xml"));
    EXPECT_THAT(refusalOf([] { KarmaXml::read(ownFolder()); }), HasSubstr("a folder"));
}

/// KARMA_ROOT for the time of a test.
class Root {
  public:
    explicit Root(const char* value) {
        if (const char* old = std::getenv("KARMA_ROOT")) {
            old_ = old;
        }
        value ? setenv("KARMA_ROOT", value, 1) : unsetenv("KARMA_ROOT");
    }
    ~Root() { old_ ? setenv("KARMA_ROOT", old_->c_str(), 1) : unsetenv("KARMA_ROOT"); }

  private:
    std::optional<std::string> old_;
};

TEST(KarmaPath, TheRootComesFromTheEnvironment) {
    const auto folder = ownFolder();
    const auto target = writtenFile(folder / "root" / "sub" / "a.xml", "a");
    const auto file = folder / "here" / "env.xml";
    const Root root((folder / "root").c_str());
    for (const char* path : {"$(KARMA_ROOT)\\sub\\a.xml", "%KARMA_ROOT%\\sub\\a.xml",
                             "$(KARMA_ROOT)/sub/a.xml", "$(KARMA_ROOT)sub/a.xml"}) {
        EXPECT_EQ(resolveKarmaPath(path, file), target) << path;
    }
    EXPECT_EQ(resolveKarmaPath(target.string(), file), target);
}

TEST(KarmaPath, WithoutARootTheFolderOfTheFileTakesItsPlace) {
    const auto folder = ownFolder();
    const auto target = writtenFile(folder / "sub" / "a.xml", "a");
    for (const char* unset : {static_cast<const char*>(nullptr), ""}) {
        const Root root(unset);
        EXPECT_EQ(resolveKarmaPath("$(KARMA_ROOT)\\sub\\a.xml", folder / "env.xml"), target);
    }
    EXPECT_EQ(resolveKarmaPath("sub\\a.xml", folder / "env.xml"), target);
}

TEST(KarmaPath, AFileOfTheSameNameBesideIsTakenWhereThePathLeadsNowhere) {
    const auto folder = ownFolder();
    const auto target = writtenFile(folder / "a.xml", "a");
    const Root root("/no/such/root");
    EXPECT_EQ(resolveKarmaPath("$(KARMA_ROOT)\\sub\\a.xml", folder / "env.xml"), target);
    EXPECT_EQ(resolveKarmaPath("C:\\data\\a.xml", folder / "env.xml"), target);
}

TEST(KarmaPath, AFileThatIsNowhereIsRefusedWithThePlaces) {
    const auto folder = ownFolder();
    const auto ask = [&] {
        resolveKarmaPath("$(KARMA_ROOT)\\sub\\a.xml", folder / "env.xml", "composite C");
    };
    {
        const Root root("/no/such/root");
        EXPECT_THAT(refusalOf(ask),
                    AllOf(HasSubstr("env.xml: composite C"), HasSubstr("$(KARMA_ROOT)\\sub"),
                          HasSubstr("/no/such/root/sub/a.xml"),
                          HasSubstr((folder / "a.xml").string()),
                          testing::Not(HasSubstr("not set"))));
    }
    const Root root(nullptr);
    EXPECT_THAT(refusalOf(ask), HasSubstr("KARMA_ROOT is not set"));
    EXPECT_THAT(refusalOf([&] { resolveKarmaPath("", folder / "env.xml"); }),
                HasSubstr("a file that is there"));
}

} // namespace
} // namespace irsg
