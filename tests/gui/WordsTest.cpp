#include <filesystem>
#include <map>
#include <regex>

#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"

namespace smat::gui {
namespace {

/// The sources of the window, each as one text in which adjacent literals are joined.
std::map<std::string, std::string> sources() {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(SMAT_SOURCE_DIR) / "gui")) {
        if (entry.path().extension() == ".cpp") {
            all[entry.path().filename().string()] =
                std::regex_replace(irsg::readFile(entry.path()), std::regex("\"\\s*\n\\s*\""), "");
        }
    }
    return all;
}

void expectNowhere(const std::string& pattern, const std::string& why) {
    const std::regex wrong(pattern);
    for (const auto& [file, text] : sources()) {
        for (std::sregex_iterator it(text.begin(), text.end(), wrong), end; it != end; ++it) {
            ADD_FAILURE() << file << ": " << it->str() << "\n" << why;
        }
    }
}

TEST(Words, NoSentenceOfTheWindowIsInTheFormOfTheTerminal) {
    ASSERT_GT(sources().size(), 80U);
    const std::string why = "a person is told \"%1 is needed instead of %2\", see Sentences.h";
    expectNowhere("\"[^\"\n]*([Ff]ound [\"“'%]|, found |, expected |expected %)[^\"\n]*\"", why);
    expectNowhere("\"[^\"\n]*, where %\\d is needed[^\"\n]*\"", why);
    expectNowhere("InputError& (\\w+)\\) \\{(?![^}]*LogicError)[^}]*\\b\\1\\.what\\(\\)[^}]*\\}",
                  why);
}

TEST(Words, AnEngineerSaysIt) {
    for (const char* odd : {"none over",
                            "over the failure\"",
                            "Compute shows the answer",
                            "smart, per pixel",
                            "Drawings of",
                            "no number\"",
                            "find fault",
                            "physics closes",
                            "has no answer",
                            "sampled by themselves",
                            "Come nearer",
                            "the drawing ends",
                            "light between surfaces",
                            "this air\\b",
                            "This model lacks",
                            "Takes what others hide",
                            "they then answer",
                            "Say first which",
                            "Which one answers",
                            "The same from a terminal",
                            "edits that count",
                            "Likely ones",
                            "Cases of a time",
                            "rest beside",
                            "model of costs",
                            "difference of what was drawn",
                            "less that\"",
                            "\"Figure\"",
                            "Ask for the ranking",
                            "\"New &?air\"",
                            "Air of the &?project",
                            "is asked for in the whole band answers",
                            "stands here",
                            "All docks away",
                            "Of projects that are begun",
                            "Least altitude",
                            "waits in line",
                            "\"above %1",
                            "\"below %1",
                            "Unsaved air",
                            "its tab has a dot",
                            "\"Stbd\"",
                            "all that is known of it",
                            "\\bdock\\b",
                            "(same|[Ii]mported|[Tt]ables of) air\\b",
                            "[Ww]aiting in line",
                            "[Tt]his is no\\b",
                            "not asked for",
                            "looked for",
                            "being worked out",
                            "(what is there\\b|not there any more)",
                            "follows? in a moment",
                            "the clock goes",
                            "\\bit was calculated",
                            "(table leaves|other property leaves)",
                            "what they have\\b",
                            "whole light",
                            "Draws at most"}) {
        expectNowhere("\"[^\"\n]*" + std::string(odd) + "[^\"\n]*\"?", "odd words");
    }
}

TEST(Words, AQuestionHasOneWayOut) {
    // Dialogs::ask adds Cancel to every question.
    expectNowhere("\\{(?:[^{}]*, )?tr\\(\"(&?Cancel|&?Stay)\"\\)[^{}]*\\}", "see Dialogs.h");
}

} // namespace
} // namespace smat::gui
