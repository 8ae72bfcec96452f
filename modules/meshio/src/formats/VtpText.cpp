// SPDX-License-Identifier: BSD-3-Clause
#include "formats/VtpText.h"

#include "text/TextScan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;

/// The part of the file that is XML.
std::string_view xmlOf(std::string_view bytes)
{
    return bytes.substr(0, bytes.find("<AppendedData"));
}

/// @param exponent  of a number of `size` characters @return true if the number is certainly within the range of
/// Float32
bool isSmall(std::string_view exponent, std::size_t size)
{
    exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
    const std::optional<std::int64_t> value = wordToInteger(exponent);
    return value && *value + static_cast<std::int64_t>(size) < std::numeric_limits<float>::max_exponent10;
}

/// Finds the numbers that VTK does not read in an array of floating-point text.
class ArrayText
{
  public:
    /// @param xml  the text from the begin of the file
    ArrayText(FileImage& image, std::string_view xml)
        : m_image(image)
        , m_xml(xml)
    {
    }
    /// Overwrites these numbers in the text of the array whose tag ends at `close`.
    void run(std::string_view tag, std::size_t close, bool isOfPoints);
    /// Positions at which a blank is missing, in ascending order.
    [[nodiscard]] const std::vector<std::size_t>& missingBlanks() const noexcept { return m_missingBlanks; }

  private:
    FileImage& m_image;
    std::string_view m_xml;
    std::vector<std::size_t> m_missingBlanks;
};

void ArrayText::run(std::string_view tag, std::size_t close, bool isOfPoints)
{
    const bool isFloat = tag.find("Float32") != std::string_view::npos;
    const double most = isFloat ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
    const std::string_view text = m_xml.substr(close + 1, m_xml.find('<', close) - close - 1);
    constexpr std::string_view kBlanks = " \t\r\n\v\f";
    for (std::size_t at = 0; at < text.size(); ++at) {
        // Finite numbers within the range have neither of these letters, or a small exponent.
        const char c = text[at];
        const bool isExponent = isOfPoints && (c == 'e' || c == 'E');
        if (c != 'n' && c != 'N' && c != '#' && !isExponent) {
            continue;
        }
        const std::size_t first = text.find_last_of(kBlanks, at) + 1,
                          end = std::min(text.find_first_of(kBlanks, at), text.size());
        const std::string_view word = text.substr(first, end - first);
        if (isExponent && isSmall(text.substr(at + 1, end - at - 1), word.size())) {
            at = end;
            continue;
        }
        at = end;
        const std::optional<double> value = wordToNumber(word);
        const bool isWord = word.find_first_of("nN#") != std::string_view::npos;
        if (!value || (!isWord && !(isOfPoints && std::abs(*value) > most))) {
            continue;
        }
        const std::string_view plain = std::isnan(*value) ? "nan" : *value > 0.0 ? "inf" : "-inf";
        const std::size_t begin = static_cast<std::size_t>(word.data() - m_xml.data());
        if (word.size() > plain.size()) {
            const auto to = m_image.writable().subspan(begin, word.size());
            std::fill(std::copy(plain.begin(), plain.end(), to.begin()), to.end(), ' ');
        } else if (end == text.size()) {
            m_missingBlanks.push_back(begin + word.size());
        }
    }
}

} // namespace

Status removePadding(FileImage& image, const ScanContext& context)
{
    const std::string_view bytes = image.bytes();
    const std::size_t end = std::min(bytes.rfind('>'), bytes.size() - 1) + 1;
    if (trimmed(bytes.substr(end)).empty() || !withoutPadding(bytes.substr(end)).empty()) {
        return {};
    }
    Result<FileImage> document = FileImage::copy(bytes.substr(0, end), context.file);
    if (document.isOk()) {
        image = std::move(document).value();
    }
    return document.status();
}

void removeEmptyPieces(FileImage& image, const VtpHeader& header)
{
    constexpr std::string_view kBegin = "<Piece", kEnd = "</Piece>";
    const std::string_view bytes = image.bytes();
    const std::string_view xml = xmlOf(bytes);
    std::vector<std::size_t> begins;
    for (std::size_t at = xml.find(kBegin); at != std::string_view::npos; at = xml.find(kBegin, at + 1)) {
        begins.push_back(at);
    }
    if (begins.size() != header.pieces.size() || xml.find("<!--") != std::string_view::npos) {
        return;
    }
    for (std::size_t i = 0; i < begins.size(); ++i) {
        const VtpPiece& piece = header.pieces[i];
        if (piece.points + piece.verts.count + piece.lines.count + piece.strips.count + piece.polys.count > 0) {
            continue;
        }
        const std::size_t tagEnd = xml.find('>', begins[i]);
        const bool isWhole = tagEnd != std::string_view::npos && xml[tagEnd - 1] == '/';
        const std::size_t close = isWhole ? tagEnd + 1 : xml.find(kEnd, begins[i]) + kEnd.size();
        const std::size_t next = i + 1 < begins.size() ? begins[i + 1] : xml.size();
        if (tagEnd == std::string_view::npos || close <= tagEnd || close > next) {
            return;
        }
        for (char& c : image.writable().subspan(begins[i], close - begins[i])) {
            c = c == '\n' ? c : ' ';
        }
    }
}

Status makeNumbersReadable(FileImage& image, const ScanContext& context)
{
    const std::string_view bytes = image.bytes(), xml = xmlOf(bytes);
    ArrayText arrays(image, xml);
    bool isOfPoints = false;
    std::size_t close = 0;
    for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', close)) {
        close = xml.find('>', at);
        if (close == std::string_view::npos) {
            break;
        }
        const std::string_view tag = xml.substr(at, close - at);
        if (tag.starts_with("<Points") || tag.starts_with("</Points")) {
            isOfPoints = tag[1] != '/';
        }
        const auto has = [tag](std::string_view word) { return tag.find(word) != std::string_view::npos; };
        if (tag.starts_with("<DataArray") && has("Float") && !has("binary") && !has("appended")) {
            arrays.run(tag, close, isOfPoints);
        }
    }
    if (arrays.missingBlanks().empty()) {
        return {};
    }
    std::string text;
    text.reserve(bytes.size() + arrays.missingBlanks().size());
    std::size_t done = 0;
    for (const std::size_t at : arrays.missingBlanks()) {
        text.append(bytes.substr(done, at - done)).append(" ");
        done = at;
    }
    text.append(bytes.substr(done));
    Result<FileImage> whole = FileImage::copy(text, context.file);
    if (whole.isOk()) {
        image = std::move(whole).value();
    }
    return whole.status();
}

} // namespace palpate::meshio::internal
