#include "benchmarks/atmosphere/Table.h"

#include <cstdio>
#include <fstream>
#include <iostream>

#include "irsg/core/Errors.h"

namespace irsg::accuracy {

std::string text(const char* format, double value) {
    char characters[64];
    std::snprintf(characters, sizeof characters, format, value);
    return characters;
}

Table::Table(std::string title, std::vector<std::string> columns)
    : title_(std::move(title)), columns_(std::move(columns)) {}

void Table::add(std::vector<std::string> cells) {
    rows_.push_back(std::move(cells));
}

void Table::print() const {
    auto row = [](const std::vector<std::string>& cells) {
        std::cout << "|";
        for (const std::string& cell : cells)
            std::cout << " " << cell << " |";
        std::cout << "\n";
    };
    std::cout << "### " << title_ << "\n\n";
    row(columns_);
    row(std::vector<std::string>(columns_.size(), "---"));
    for (const auto& cells : rows_)
        row(cells);
    std::cout << std::endl;
}

void writeCurves(const Output& output, const std::string& name, const std::string& title,
                 const std::vector<Curve>& curves) {
    if (output.folder.empty())
        return;
    const auto file = output.folder / (name + ".csv");
    std::ofstream out(file);
    out << "# title: " << title << "\n";
    for (std::size_t i = 0; i < curves.size(); ++i)
        out << (i ? "," : "") << curves[i].column;
    out << "\n";
    for (std::size_t row = 0; row < curves.front().values.size(); ++row) {
        for (std::size_t i = 0; i < curves.size(); ++i)
            out << (i ? "," : "") << text("%.6g", curves[i].values[row]);
        out << "\n";
    }
    if (!out.flush())
        throw InputError(Diagnostic{file.string(), "", "cannot be written", "a writable folder"});
}

} // namespace irsg::accuracy
