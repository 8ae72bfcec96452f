// SPDX-License-Identifier: BSD-3-Clause
#include "labels/LabelNames.h"

#include "text/FileStem.h"

#include "text/TextScan.h"

#include <palpate/core/Numbers.h>

#include <QByteArray>
#include <QString>
#include <QXmlStreamReader>

#include <algorithm>
#include <fstream>
#include <limits>
#include <system_error>

namespace palpate::meshio::internal {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestLabelName = 200; ///< [bytes]

/// @return `text` as one line of valid UTF-8; text that is no UTF-8 is taken as Latin-1
std::string cleanName(std::string_view text)
{
    const QByteArray bytes(text.data(), static_cast<qsizetype>(std::min(text.size(), kLongestLabelName)));
    QString name = QString::fromUtf8(bytes);
    if (text.size() <= kLongestLabelName && name.contains(QChar::ReplacementCharacter)) {
        name = QString::fromLatin1(bytes);
    }
    for (QChar& c : name) {
        if (!c.isPrint() && !c.isSurrogate()) {
            c = QLatin1Char(' ');
        }
    }
    return name.simplified().toStdString();
}

std::optional<std::uint32_t> labelValue(std::string_view word)
{
    const std::optional<std::int64_t> value = wordToInteger(trimmed(word));
    return value && *value >= 0 && *value <= std::numeric_limits<std::uint32_t>::max()
               ? std::optional(static_cast<std::uint32_t>(*value))
               : std::nullopt;
}

/// @param most  the value of full brightness
std::optional<std::array<double, 3>> colourOf(const std::vector<double>& numbers, double most)
{
    if (numbers.size() != 3 || !std::all_of(numbers.begin(), numbers.end(),
                                            [most](double number) { return number >= 0.0 && number <= most; })) {
        return std::nullopt;
    }
    return std::array<double, 3>{numbers[0] / most, numbers[1] / most, numbers[2] / most};
}

constexpr std::string_view kDescription = "ITK-SnAP Label Description"; // differs in case between versions

/// True if the file begins as an ITK-SNAP label description.
bool isLabelDescription(const fs::path& path)
{
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return false;
    }
    std::string start(512, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    return std::search(start.begin(), start.end(), kDescription.begin(), kDescription.end(), [](char a, char b) {
               return sameWord(std::string_view(&a, 1), std::string_view(&b, 1));
           }) != start.end();
}

} // namespace

LabelNames slicerNames(const VolumeLayout& layout)
{
    LabelNames names;
    const auto pair = [&layout](std::size_t segment, const char* field) -> std::string_view {
        const auto found = layout.pairs.find("Segment" + std::to_string(segment) + "_" + field);
        return found == layout.pairs.end() ? std::string_view() : std::string_view(found->second);
    };
    for (std::size_t i = 0; i < layout.pairs.size(); ++i) {
        const std::string_view name = pair(i, "Name").empty() ? pair(i, "ID") : pair(i, "Name");
        if (name.empty()) {
            break;
        }
        const bool isOld = pair(i, "Layer").empty() && layout.layers > 1;
        const std::optional<std::uint32_t> value = labelValue(pair(i, "LabelValue"));
        const std::optional<std::uint32_t> layer = labelValue(pair(i, "Layer"));
        names[{layer.value_or(isOld ? static_cast<std::uint32_t>(i) : 0U),
               value.value_or(isOld ? 1U : static_cast<std::uint32_t>(i + 1))}] = {
            cleanName(name), colourOf(numbersIn(pair(i, "Color"), 3), 1.0)};
    }
    return names;
}

LabelNames niftiNames(const std::string& xml)
{
    LabelNames names;
    QXmlStreamReader reader(QByteArray::fromStdString(std::string(trimmed(xml))));
    while (!reader.atEnd()) {
        const QXmlStreamReader::TokenType token = reader.readNext();
        if (token == QXmlStreamReader::DTD || token == QXmlStreamReader::EntityReference) {
            break;
        }
        if (token != QXmlStreamReader::StartElement || reader.name() != QLatin1String("Label")) {
            continue;
        }
        const auto attribute = [attributes = reader.attributes()](const char* name) {
            return attributes.value(QLatin1String(name)).toString().toStdString();
        };
        const std::optional<std::uint32_t> value = labelValue(attribute("Key"));
        const std::string colour = attribute("Red") + " " + attribute("Green") + " " + attribute("Blue");
        const std::string name = reader.readElementText(QXmlStreamReader::SkipChildElements).toStdString();
        if (value && !reader.hasError()) {
            names[{0, *value}] = {cleanName(name), colourOf(numbersIn(colour, 3), 1.0)};
        }
    }
    return names;
}

LabelNames itkSnapNames(std::string_view text)
{
    LabelNames names;
    LineReader lines(text);
    while (lines.next()) {
        std::string_view rest = trimmed(lines.line());
        const std::size_t quote = rest.find('"'), end = rest.rfind('"');
        if (rest.empty() || rest.front() == '#' || quote == std::string_view::npos || end == quote) {
            continue;
        }
        const std::string_view name = rest.substr(quote + 1, end - quote - 1);
        constexpr std::size_t kBefore = 7; // IDX R G B A VIS MSH
        const std::vector<double> numbers = numbersIn(rest.substr(0, quote), kBefore);
        const std::optional<std::uint32_t> value = labelValue(takeWord(rest));
        if (numbers.size() == kBefore && value && *value != 0) {
            names[{0, *value}] = {cleanName(name), colourOf({numbers[1], numbers[2], numbers[3]}, 255.0)};
        }
    }
    return names;
}

std::optional<fs::path> labelDescriptionBeside(const fs::path& volume)
{
    constexpr std::array<std::string_view, 2> kEndings{".txt", ".label"};
    const fs::path folder = volume.parent_path().empty() ? fs::path(".") : volume.parent_path();
    for (const std::string_view ending : kEndings) {
        fs::path named = folder / (fileStem(volume) + std::string(ending));
        if (isLabelDescription(named)) {
            return named;
        }
    }
    constexpr int kMostFiles = 10000;
    std::optional<fs::path> only;
    std::error_code error;
    int files = 0;
    for (fs::directory_iterator at(folder, error), end; !error && at != end && ++files < kMostFiles;
         at.increment(error)) {
        const std::string ending = at->path().extension().string();
        if (std::any_of(kEndings.begin(), kEndings.end(),
                        [&](std::string_view one) { return sameWord(ending, one); }) &&
            isLabelDescription(at->path())) {
            if (only) {
                return std::nullopt;
            }
            only = at->path();
        }
    }
    return only;
}

} // namespace palpate::meshio::internal
