#include "irsg/image/ImageFormat.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/ImageFile.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using smat::test::ownFolder;
using test::bitsOf;
using test::inputErrorOf;
using test::patternImage;
using testing::HasSubstr;

TEST(ImageFormats, HaveNamesAndExtensionsOfTheirOwnAndAWriter) {
    std::set<std::string> extensions, names;
    for (const ImageFormat* format : imageFormats()) {
        EXPECT_TRUE(names.insert(format->name).second) << format->name;
        EXPECT_TRUE(names.insert(format->shortName).second) << format->shortName;
        ASSERT_FALSE(format->extensionList().empty()) << format->name;
        for (const std::string& extension : format->extensionList()) {
            EXPECT_EQ(extension.front(), '.');
            EXPECT_TRUE(extensions.insert(extension).second) << extension;
            EXPECT_EQ(imageFormatOf("a/b" + extension), format);
        }
        EXPECT_NE(format->write, nullptr) << format->name;
        EXPECT_EQ(format->read == nullptr, format->keeps == ImageFormat::Keeps::picture);
        EXPECT_EQ(format->read == nullptr, format->recognises == nullptr);
        EXPECT_EQ(readableImageFormatOf("a/b" + format->extensionList().front()),
                  format->read == nullptr ? nullptr : format);
    }
}

TEST(ImageFormats, ThatKeepValuesGiveThemBackByContent) {
    const RadianceImage image = patternImage(13, 9);
    for (const ImageFormat* format : imageFormats()) {
        if (format->read == nullptr) {
            continue;
        }
        const auto file = ownFolder() / ("image" + format->extensionList().front());
        writeImageFile(image, file);
        // Under a name that says nothing.
        const auto renamed = ownFolder() / "unnamed";
        std::filesystem::rename(file, renamed);
        EXPECT_TRUE(holdsImage(renamed)) << format->name;
        EXPECT_EQ(bitsOf(readImageFile(renamed).primary().values), bitsOf(image.primary().values))
            << format->name;
    }
}

TEST(ImageFormats, ThatAreReadAreToldByNamesOfEitherCase) {
    for (const std::string& extension : readableImageExtensions()) {
        const ImageFormat* format = readableImageFormatOf("a" + extension);
        ASSERT_NE(format, nullptr) << extension;
        EXPECT_NE(format->read, nullptr) << extension;
    }
    EXPECT_EQ(readableImageFormatOf("A.TIF"), imageFormatOf("a.tif"));
    EXPECT_TRUE(readableImageFormatOf("a.DAT")->isText);
    EXPECT_FALSE(readableImageFormatOf("a.exr")->isText);
    for (const char* name : {"a", "a.", "a.png", "tif", "a.tif.gz"}) {
        EXPECT_EQ(readableImageFormatOf(name), nullptr) << name;
    }
}

TEST(ImageFormats, RefuseAnotherExtensionNamingThoseThereAre) {
    const std::string message =
        inputErrorOf([] { writeImageFile(patternImage(2, 2), "image.jpeg"); });
    EXPECT_THAT(message, HasSubstr("image.jpeg"));
    EXPECT_THAT(message, HasSubstr(".jpeg"));
    for (const std::string& extension : imageExtensions()) {
        EXPECT_THAT(message, HasSubstr(extension));
    }
}

} // namespace
} // namespace irsg
