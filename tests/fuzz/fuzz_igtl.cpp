// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"
#include "WireBytes.h"

#include <palpate/igtl/Messages.h>
#include <palpate/igtl/Surface.h>

#include <algorithm>
#include <cmath>

namespace palpate::fuzz {

namespace igtlwire {

using test::WireBytes;

std::string textOf(const std::vector<std::uint8_t>& bytes)
{
    return {bytes.begin(), bytes.end()};
}

std::vector<std::string> seeds()
{
    const auto matrix = WireBytes().f32({1, 0, 0, 0, 1, 0, 0, 0, 1, 4, 5, 6}).bytes();
    const auto strip = WireBytes()
                           .u32(4)
                           .u32(0)
                           .u32(0)
                           .u32(0)
                           .u32(0)
                           .u32(0)
                           .u32(0)
                           .u32(1)
                           .u32(20)
                           .u32(0)
                           .f32({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
                           .u32(4)
                           .u32(0)
                           .u32(1)
                           .u32(2)
                           .u32(3)
                           .bytes();
    const std::vector<std::pair<const char*, std::vector<std::uint8_t>>> contents{
        {"TRANSFORM", matrix},
        {"POSITION", WireBytes().f32({1, 2, 3, 0, 0, 0, 1}).bytes()},
        {"TDATA", WireBytes().text("Stylus", 20).u8(2).u8(0).raw(matrix).bytes()},
        {"STATUS", WireBytes().u16(1).u64(0).text("none", 20).text("fine", 5).bytes()},
        {"STRING", WireBytes().u16(3).u16(4).text("lump", 4).bytes()},
        {"SENSOR", WireBytes().u8(1).u8(0).u64(0).f64(2.5).bytes()},
        {"POLYDATA", test::tetrahedron()},
        {"POLYDATA", strip},
        {"STT_TDATA", WireBytes().u32(50).text("", 32).bytes()}};
    std::vector<std::string> all;
    std::string stream;
    for (const auto& [type, content] : contents) {
        for (const unsigned version : {1U, 2U}) {
            all.push_back(textOf(test::wireMessage(type, "a", content, {.version = version, .metadata = 4})));
            stream += all.back();
        }
        all.push_back(textOf(content)); // without a header, see below
    }
    all.push_back(stream);
    return all;
}

void decodeAll(igtl::ByteView content)
{
    if (const auto transform = igtl::decodeTransform(content); transform.isOk()) {
        if (const auto pose = igtl::poseOf(transform.value())) {
            require(pose->p_mm.allFinite() && std::abs(pose->q.norm() - 1.0) < 1e-9, "a pose is finite");
        }
    }
    if (const auto pose = igtl::decodePosition(content); pose.isOk()) {
        require(pose.value().p_mm.allFinite() && std::abs(pose.value().q.norm() - 1.0) < 1e-9, "a pose is finite");
    }
    if (const auto tools = igtl::decodeTrackingData(content); tools.isOk()) {
        require(tools.value().size() * 70 == content.size(), "each tool is in the content");
    }
    if (const auto status = igtl::decodeStatus(content); status.isOk()) {
        require(status.value().text.size() <= content.size(), "a text is in the content");
    }
    if (const auto text = igtl::decodeString(content); text.isOk()) {
        require(text.value().size() <= content.size(), "a text is in the content");
    }
    if (const auto reading = igtl::decodeSensor(content); reading.isOk()) {
        require(reading.value().values.size() * 8 < content.size(), "each value is in the content");
    }
    (void)igtl::decodeTrackingRequest(content);
    const auto surface = igtl::decodeSurface(content);
    if (!surface.isOk()) {
        requireOneLine(surface.status(), "POLYDATA");
        return;
    }
    require(!surface.value().triangles.empty(), "a surface has a triangle");
    for (const auto& point : surface.value().points) {
        require(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]), "points are finite");
    }
    for (const auto& triangle : surface.value().triangles) {
        require(std::ranges::max(triangle) < surface.value().points.size(), "indices are in range");
    }
}

/// Reads the input as a stream in pieces, and decodes it as a content of every type, because a changed message is
/// stopped by its checksum.
void tryInput(std::string_view input)
{
    const igtl::ByteView bytes(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    decodeAll(bytes);
    for (const std::size_t chunk : {std::size_t{7}, input.size() + 1}) {
        igtl::MessageReader reader(true);
        for (std::size_t at = 0; at < bytes.size(); at += chunk) {
            reader.add(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
            for (auto step = reader.next(); step != igtl::MessageReader::Step::NeedsMore; step = reader.next()) {
                if (step == igtl::MessageReader::Step::Lost) {
                    require(!reader.problem().empty(), "a lost stream has a reason");
                    return;
                }
                if (step == igtl::MessageReader::Step::Complete) {
                    require(reader.message().header.name.size() <= igtl::kNameLength, "a name is bounded");
                    decodeAll(reader.message().content);
                }
            }
            require(reader.stored_bytes() <= input.size(), "only received bytes are stored");
        }
    }
}

} // namespace igtlwire

extern const Target kIgtl{"igtl", 500, igtlwire::seeds, igtlwire::tryInput};

} // namespace palpate::fuzz
