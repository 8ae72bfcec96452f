// SPDX-License-Identifier: BSD-3-Clause
#include "PreScan.h"

#include "Fault.h"
#include "TextScan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::size_t kHeader = 80;
constexpr std::size_t kFirstFacet = 84;
constexpr std::size_t kFacet = 50;
constexpr std::size_t kProgressStep = std::size_t{1} << 16;

Status cancelled(const ScanContext& context)
{
    return {StatusCode::Cancelled, context.file + ": reading was cancelled"};
}

/// Cuts the image to its first `size` bytes, and puts `end` behind them.
Status keepWhole(FileImage& image, std::size_t size, std::string_view end, const ScanContext& context)
{
    std::string bytes(image.bytes().substr(0, size));
    Result<FileImage> whole = FileImage::copy(bytes.append(end), context.file);
    if (whole.isOk()) {
        image = std::move(whole).value();
    }
    return whole.status();
}

Result<PreScan> scanAsciiStl(FileImage& image, const ScanContext& context);

} // namespace

Result<PreScan> preScanBinaryStl(FileImage& image, const ScanContext& context)
{
    std::string_view bytes = image.bytes();
    if (bytes.size() < kFirstFacet) {
        return fault(StatusCode::BadFormat, context.file, atByte(bytes.size()), "the file ends in the STL header",
                     "at least 134 bytes");
    }
    std::uint32_t declared = 0;
    std::memcpy(&declared, bytes.data() + kHeader, sizeof(declared));
    const std::uint64_t held = (bytes.size() - kFirstFacet) / kFacet;
    PreScan scan;
    if (context.isPartial && held > 0 && held < declared) {
        scan.loss = atByte(bytes.size()) + ": the file ends there: " + grouped(declared - held) + " of " +
                    counted(declared, "triangle") + " lost";
        declared = static_cast<std::uint32_t>(held);
        if (Status status = keepWhole(image, kFirstFacet + held * kFacet, "", context); !status.isOk()) {
            return status;
        }
        std::memcpy(image.writable().data() + kHeader, &declared, sizeof(declared));
        bytes = image.bytes();
    }
    if (kFirstFacet + std::uint64_t{declared} * kFacet != bytes.size()) {
        return fault(StatusCode::BadFormat, context.file, atByte(kHeader),
                     "the binary STL declares " + counted(declared, "triangle") + " but its " +
                         counted(bytes.size(), "byte") + " hold " + grouped(held),
                     grouped(kFirstFacet + std::uint64_t{declared} * kFacet) + " bytes");
    }
    if (declared == 0) {
        return fault(StatusCode::Empty, context.file, atByte(kHeader), "0 triangles", "at least one");
    }

    scan.format = "STL binary";
    scan.cells = declared;
    scan.points = std::uint64_t{declared} * 3;
    noteSpaceTag(bytes.substr(0, kHeader), scan);

    std::uint64_t notNumbers = 0;
    std::uint64_t tooFar = 0;
    std::uint64_t firstBad = declared;
    for (std::uint64_t i = 0; i < declared; ++i) {
        std::array<float, 12> facet; // normal, then three corners
        std::memcpy(facet.data(), bytes.data() + kFirstFacet + i * kFacet, sizeof(facet));
        float most = 0.0F;
        float sum = 0.0F; // x - x is zero only for a number
        for (std::size_t k = 3; k < facet.size(); ++k) {
            most = std::max(most, std::abs(facet[k]));
            sum += facet[k] - facet[k];
        }
        const bool isFinite = sum == 0.0F;
        if (!isFinite || static_cast<double>(most) * context.unit_mm > kMostMm) {
            ++(isFinite ? tooFar : notNumbers);
            firstBad = std::min(firstBad, i);
        }
        if (i % kProgressStep == 0 && context.progress && !context.progress(double(i) / double(declared))) {
            return cancelled(context);
        }
    }
    if (firstBad < declared) {
        return fault(StatusCode::NonFinite, context.file, atByte(kFirstFacet + firstBad * kFacet),
                     grouped(notNumbers + tooFar) + " of " + counted(declared, "triangle") +
                         " have coordinates that are " +
                         (tooFar == 0       ? "not numbers"
                          : notNumbers == 0 ? "farther than 10 km from the origin"
                                            : "not numbers, or farther than 10 km from the origin") +
                         " (first: triangle " + std::to_string(firstBad) + ")",
                     "finite coordinates within 10 km");
    }
    // VTK tells binary from ASCII by the share of printable characters among the first bytes: leave no doubt.
    std::fill_n(image.writable().begin(), kHeader, '\x80');
    return scan;
}

Result<PreScan> preScanAsciiStl(FileImage& image, const ScanContext& context)
{
    Result<PreScan> whole = scanAsciiStl(image, context);
    if (whole.isOk() || !context.isPartial || whole.status().code() == StatusCode::Cancelled) {
        return whole;
    }
    // Up to the last facet that has an end.
    LineReader reader(image.bytes());
    std::size_t end = 0;
    std::uint64_t lastLine = 0;
    while (reader.next()) {
        std::string_view rest = reader.line();
        if (sameWord(takeWord(rest), "endfacet")) {
            end = reader.end();
            lastLine = reader.number();
        }
    }
    if (end == 0) {
        return whole;
    }
    if (Status status = keepWhole(image, end, "\nendsolid\n", context); !status.isOk()) {
        return status;
    }
    Result<PreScan> part = scanAsciiStl(image, context);
    if (!part.isOk()) { // it was damaged elsewhere
        return whole;
    }
    part.value().loss =
        atLine(lastLine) + ": what came after " + counted(part.value().cells, "whole triangle") + " lost";
    return part;
}

namespace {

Result<PreScan> scanAsciiStl(FileImage& image, const ScanContext& context)
{
    // VTK reads lines of up to 254 characters, and takes what follows for the next line.
    constexpr std::size_t kLongest = 254;
    enum class Expect : std::uint8_t
    {
        Solid,
        Facet,
        Loop,
        Vertex,
        EndLoop,
        EndFacet
    };

    const std::span<char> writable = image.writable();
    if (image.bytes().starts_with("\xef\xbb\xbf")) { // byte order mark
        std::fill_n(writable.begin(), 3, ' ');
    }
    PreScan scan;
    scan.format = "STL ASCII";
    std::map<std::string, std::uint32_t, std::less<>> parts;
    std::uint32_t part = 0;
    Expect expect = Expect::Solid;
    unsigned corners = 0;
    LineReader reader(image.bytes());

    const auto wrong = [&](std::string_view found, std::string_view expected) {
        return fault(StatusCode::BadFormat, context.file, atLine(reader.number()), found, expected);
    };
    while (reader.next()) {
        if (const std::size_t nul = reader.line().find('\0'); nul != std::string_view::npos) {
            return fault(StatusCode::BadFormat, context.file, atByte(reader.begin() + nul), "a zero byte", "text");
        }
        std::string_view rest = reader.line();
        const std::string_view word = takeWord(rest);
        const std::span<char> line = writable.subspan(reader.begin(), reader.line().size());
        if (word.empty()) {
            std::ranges::fill(line, ' ');
            continue;
        }
        const bool isName = sameWord(word, "solid") || sameWord(word, "endsolid");
        if (!isName && reader.line().size() > kLongest) {
            return wrong("a line of " + counted(reader.line().size(), "character"), "at most 254");
        }
        switch (expect) {
        case Expect::Solid: {
            if (!sameWord(word, "solid")) {
                return wrong(inQuotes(word), "\"solid\"");
            }
            noteSpaceTag(rest, scan);
            const auto [found, isNew] =
                parts.emplace(trimmed(rest.substr(0, 256)), static_cast<std::uint32_t>(parts.size()));
            if (isNew) {
                scan.partNames.push_back(found->first);
            }
            part = found->second;
            expect = Expect::Facet;
            break;
        }
        case Expect::Facet:
            if (sameWord(word, "color")) {
                break;
            }
            if (sameWord(word, "endsolid")) {
                expect = Expect::Solid;
            } else if (sameWord(word, "facet")) {
                expect = Expect::Loop;
            } else {
                return wrong(inQuotes(word), "\"facet\" or \"endsolid\"");
            }
            break;
        case Expect::Loop:
            if (!sameWord(word, "outer") || !sameWord(trimmed(rest), "loop")) {
                return wrong(inQuotes(trimmed(reader.line())), "\"outer loop\"");
            }
            expect = Expect::Vertex;
            corners = 0;
            break;
        case Expect::Vertex: {
            if (!sameWord(word, "vertex")) {
                return wrong(inQuotes(word) + " after " + counted(corners, "corner"),
                             "\"vertex\", three times a facet");
            }
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view text = takeWord(rest);
                const std::optional<double> value = wordToNumber(text);
                if (!value) {
                    return wrong(text.empty() ? "the vertex has fewer than three coordinates"
                                              : inQuotes(text) + " is not a number",
                                 "three numbers");
                }
                if (const std::string bad = coordinateFault(*value, context.unit_mm); !bad.empty()) {
                    return fault(StatusCode::NonFinite, context.file, atLine(reader.number()),
                                 bad + " (" + inQuotes(text) + ")", "finite coordinates within 10 km");
                }
            }
            if (!trimmed(rest).empty()) {
                return wrong(inQuotes(trimmed(rest)) + " after the third coordinate", "the end of the line");
            }
            if (++corners == 3) {
                expect = Expect::EndLoop;
                scan.partOfCell.push_back(part);
            }
            break;
        }
        case Expect::EndLoop:
            if (!sameWord(word, "endloop")) {
                return wrong(inQuotes(word) + " after three corners", "\"endloop\"");
            }
            expect = Expect::EndFacet;
            break;
        case Expect::EndFacet:
            if (!sameWord(word, "endfacet")) {
                return wrong(inQuotes(word), "\"endfacet\"");
            }
            expect = Expect::Facet;
            if (scan.partOfCell.size() % kProgressStep == 0 && context.progress &&
                !context.progress(double(reader.begin()) / double(image.bytes().size()))) {
                return cancelled(context);
            }
            break;
        }
        // A few characters that are no text (in a blank line, too) and VTK takes the file for a binary one, and its
        // text for a count. A name may have any, and any length: all of it is kept from VTK.
        const std::size_t textEnd =
            isName ? static_cast<std::size_t>(word.data() + word.size() - line.data()) : line.size();
        for (char& c : line.first(textEnd)) {
            const bool isText = (c >= ' ' && c < '\x7f') || c == '\t' || c == '\r';
            c = isText ? c : c == '\v' || c == '\f' ? ' ' : '?';
        }
        std::ranges::fill(line.subspan(textEnd), ' ');
    }
    if (expect != Expect::Solid) {
        return fault(StatusCode::BadFormat, context.file, atLine(reader.number()),
                     "the file ends after " + counted(scan.partOfCell.size(), "whole triangle"),
                     expect == Expect::Facet ? "\"facet\" or \"endsolid\"" : "the rest of a facet, then \"endsolid\"");
    }
    if (scan.partOfCell.empty()) {
        return fault(StatusCode::Empty, context.file, atLine(reader.number()), "0 triangles", "at least one");
    }
    scan.cells = scan.partOfCell.size();
    scan.points = scan.cells * 3;
    return scan;
}

} // namespace

} // namespace palpate::meshio::internal
