#pragma once

#include <string>
#include <vector>

#include <pugixml.hpp>

#include "irsg/karma/KarmaXml.h"

namespace irsg::karma {

/// What a document holds. Throws InputError naming every diagnostic with its line.
struct Contents {
    std::vector<KarmaParameter> parameters;
    std::vector<KarmaComposite> composites;
};
/// Parses `text` into `document` and reads it.
Contents load(std::string text, const std::string& file, pugi::xml_document& document);

/// The text inside an element without the blanks around it.
std::string trimmedText(const pugi::xml_node& element);

} // namespace irsg::karma
