// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Recovery.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace palpate::fuzz {

namespace recording {

std::string recording(std::int64_t ticks)
{
    const InputFile file("seed.palpate");
    session::RecordingInfo info;
    info.scene = "box.stl";
    info.firstGeneration = 1;
    auto writer = session::RecordingWriter::create(file.path(), info, session::RecordingWriter::Sync::AtEnd);
    require(writer.isOk(), "a recording can be made");
    for (std::int64_t i = 0; i < ticks; ++i) {
        servo::TickRecord tick;
        tick.tick = i;
        tick.p_WH = core::Vec3(0.1 * static_cast<double>(i), 0.0, std::sin(0.01 * static_cast<double>(i)));
        tick.felt.p_WG = tick.p_WH;
        require(writer.value()->append(tick).isOk(), "a tick can be written");
    }
    require(writer.value()->finish().isOk(), "a recording can be ended");
    std::ifstream in(file.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The first page, which leads to all others, is gone.
std::string headless(std::string recording)
{
    constexpr std::size_t kPage = 4096;
    std::fill_n(recording.begin(), kPage, '\0');
    return recording;
}

/// A quote within the text of a table, which has more than one line: SQLite quotes the rest of it.
std::string openQuote(std::string recording)
{
    recording.at(recording.find("part TEXT") + 3) = '\'';
    return recording;
}

/// What comes out of a damaged recording is a sound one.
void recover(const std::filesystem::path& path)
{
    const std::filesystem::path copy = path.parent_path() / "copy.palpate";
    const auto recovered = session::recoverRecording(path, copy);
    if (!recovered.isOk()) {
        require(recovered.status().message().find('\n') == std::string::npos, "a refusal is one line");
        return;
    }
    for (const std::string& loss : recovered.value().losses) {
        require(loss.find('\n') == std::string::npos, "a loss is one line");
    }
    const auto reader = session::RecordingReader::open(copy);
    require(reader.isOk(), "a recovered copy can be opened");
    require(reader.value()->extent().ticks == recovered.value().ticks, "it holds what was said");
    require(reader.value()->verify().isOk(), "its checksums hold");
}

std::vector<std::string> seeds()
{
    return {recording(300),
            headless(recording(300)),
            recording(1),
            headless(recording(1)),
            recording(0),
            openQuote(recording(0)),
            std::string("SQLite format 3\0", 16),
            ""};
}

void tryInput(std::string_view bytes)
{
    static const InputFile file("r.palpate");
    file.set(bytes);
    recover(file.path());
    const auto reader = session::RecordingReader::open(file.path());
    if (!reader.isOk()) {
        require(reader.status().message().find('\n') == std::string::npos, "a refusal is one line");
        return;
    }
    const session::RecordingReader& r = *reader.value();
    std::int64_t last = -1;
    std::int64_t count = 0;
    const core::Status status =
        r.forEach(r.extent().firstTick, r.extent().lastTick, [&](const servo::TickRecord& tick) {
            require(count == 0 || tick.tick > last, "ticks ascend");
            last = tick.tick;
            (void)r.structureName(tick);
            return ++count < 1000;
        });
    require(status.isOk() || status.message().find('\n') == std::string::npos, "an error is one line");
    (void)r.motion();
    (void)r.verify();
    for (const std::string& hash : r.embeddedHashes()) {
        (void)r.embedded(hash);
    }
}

} // namespace recording

extern const Target kRecording{"recording", 100, recording::seeds, recording::tryInput};

} // namespace palpate::fuzz
