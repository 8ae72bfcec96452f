// SPDX-License-Identifier: BSD-3-Clause
#include "MeshWire.h"

#include "Fault.h"
#include "PreScan.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;
using geometry::Triangle;

// Layout: head size, head, then for each structure its vertices, its triangles and its arrays' values as they lie in
// memory. Both ends are one build on one machine.
constexpr std::size_t kMostHead = std::size_t{1} << 28;
constexpr std::size_t kMostMessage = 4000;
constexpr std::size_t kPart = std::size_t{1} << 22;
static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

class Head
{
  public:
    template<class T>
    void put(T value)
    {
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    void put(const std::string& text)
    {
        put(std::uint64_t{text.size()});
        m_bytes.append(text);
    }
    [[nodiscard]] const std::string& bytes() const noexcept { return m_bytes; }

  private:
    std::string m_bytes;
};

/// Takes values off a head; after the first that is not there all are zero and `isGood` is false.
class HeadReader
{
  public:
    explicit HeadReader(std::string_view bytes)
        : m_rest(bytes)
    {
    }
    template<class T>
    T take()
    {
        T value{};
        if (m_rest.size() < sizeof(value)) {
            m_isGood = false;
            return value;
        }
        std::memcpy(&value, m_rest.data(), sizeof(value));
        m_rest.remove_prefix(sizeof(value));
        return value;
    }
    std::string text()
    {
        const auto size = take<std::uint64_t>();
        if (!m_isGood || size > m_rest.size()) {
            m_isGood = false;
            return {};
        }
        std::string out(m_rest.substr(0, size));
        m_rest.remove_prefix(size);
        return out;
    }
    [[nodiscard]] bool isGood() const noexcept { return m_isGood; }
    [[nodiscard]] bool isAtEnd() const noexcept { return m_isGood && m_rest.empty(); }

  private:
    std::string_view m_rest;
    bool m_isGood = true;
};

bool writeAll(int descriptor, const void* data, std::size_t size)
{
    const auto* from = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t done = ::write(descriptor, from, std::min(size, std::size_t{1} << 30));
        if (done < 0 && errno != EINTR) {
            return false;
        }
        from += std::max<ssize_t>(done, 0);
        size -= static_cast<std::size_t>(std::max<ssize_t>(done, 0));
    }
    return true;
}

bool readAll(int descriptor, void* data, std::size_t size, std::uint64_t at)
{
    auto* to = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t done = ::pread(descriptor, to, size, static_cast<off_t>(at));
        if (done == 0 || (done < 0 && errno != EINTR)) {
            return false;
        }
        to += std::max<ssize_t>(done, 0);
        at += static_cast<std::uint64_t>(std::max<ssize_t>(done, 0));
        size -= static_cast<std::size_t>(std::max<ssize_t>(done, 0));
    }
    return true;
}

/// Moves `count` items from the memory file into `out`, a part at a time, each checked while it is near.
template<class T, class Check>
bool moveItems(int descriptor, std::uint64_t& at, std::uint64_t count, std::vector<T>& out, Check&& isGood)
{
    constexpr std::size_t kItems = kPart / sizeof(T);
    out.reserve(count);
    while (out.size() < count) {
        const std::size_t begin = out.size();
        const std::size_t items = std::min<std::size_t>(kItems, count - begin);
        out.resize(begin + items);
        if (!readAll(descriptor, &out[begin], items * sizeof(T), at)) {
            return false;
        }
        (void)::fallocate(descriptor, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(at),
                          static_cast<off_t>(items * sizeof(T))); // without it only memory is lost
        at += items * sizeof(T);
        if (!std::all_of(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(), isGood)) {
            return false;
        }
    }
    return true;
}

Head headOf(const Result<MeshFile>& outcome)
{
    Head head;
    head.put(static_cast<std::uint8_t>(outcome.status().code()));
    if (!outcome.isOk()) {
        head.put(outcome.status().message());
        return head;
    }
    const MeshFile& file = outcome.value();
    head.put(file.format);
    head.put(file.loss);
    head.put(static_cast<std::uint8_t>(file.frame));
    head.put(file.unit_mm);
    head.put(std::uint64_t{file.notes.size()});
    for (const std::string& note : file.notes) {
        head.put(note);
    }
    head.put(std::uint64_t{file.structures.size()});
    for (const MeshStructure& structure : file.structures) {
        head.put(structure.name);
        head.put(std::uint8_t{structure.colour.has_value()});
        head.put(structure.colour.value_or(std::array<double, 3>{}));
        head.put(std::uint64_t{structure.mesh.vertices.size()});
        head.put(std::uint64_t{structure.mesh.triangles.size()});
        head.put(std::uint64_t{structure.mesh.arrays.size()});
        for (const geometry::MeshArray& array : structure.mesh.arrays) {
            head.put(array.name);
            head.put(std::uint8_t{array.isPerTriangle});
        }
    }
    return head;
}

/// A message of the child, as one line that names the file.
Status statusOf(std::uint8_t code, std::string message, const std::string& file)
{
    message.resize(std::min(message.size(), kMostMessage));
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    if (!message.starts_with(file + ": ")) {
        message.insert(0, file + ": ");
    }
    return {code <= static_cast<std::uint8_t>(StatusCode::Internal) ? static_cast<StatusCode>(code)
                                                                    : StatusCode::Internal,
            std::move(message)};
}

} // namespace

bool writeOutcome(int descriptor, Result<MeshFile> outcome)
{
    const Head head = headOf(outcome);
    const std::uint64_t size = head.bytes().size();
    if (!writeAll(descriptor, &size, sizeof(size)) || !writeAll(descriptor, head.bytes().data(), size)) {
        return false;
    }
    if (!outcome.isOk()) {
        return true;
    }
    for (MeshStructure& structure : outcome.value().structures) {
        const geometry::TriangleMesh mesh = std::move(structure.mesh);
        if (!writeAll(descriptor, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3)) ||
            !writeAll(descriptor, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle))) {
            return false;
        }
        for (const geometry::MeshArray& array : mesh.arrays) {
            if (!writeAll(descriptor, array.values.data(), array.values.size() * sizeof(float))) {
                return false;
            }
        }
    }
    return true;
}

namespace {

struct MeshCounts
{
    std::uint64_t vertices, triangles;
};

/// Gets the structures' meshes, which stand one after the other. @param at  where the first begins
/// @return what is wrong with them; null when nothing is
const char* moveMeshes(int descriptor, std::uint64_t at, const std::vector<MeshCounts>& counts, MeshFile& file)
{
    for (std::size_t i = 0; i < counts.size(); ++i) {
        geometry::TriangleMesh& mesh = file.structures[i].mesh;
        if (!moveItems(descriptor, at, counts[i].vertices, mesh.vertices,
                       [](const Vec3& p) { return p.cwiseAbs().maxCoeff() <= kMostMm && p.allFinite(); })) {
            return "an impossible coordinate";
        }
        const std::uint64_t vertices = counts[i].vertices;
        if (!moveItems(descriptor, at, counts[i].triangles, mesh.triangles, [vertices](const Triangle& t) {
                return t[0] < vertices && t[1] < vertices && t[2] < vertices;
            })) {
            return "an index out of range";
        }
        for (geometry::MeshArray& array : mesh.arrays) {
            if (!moveItems(descriptor, at, array.isPerTriangle ? counts[i].triangles : counts[i].vertices, array.values,
                           [](float) { return true; })) {
                return "half an array";
            }
        }
    }
    return nullptr;
}

} // namespace

Result<MeshFile> readOutcome(int descriptor, const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    const auto nonsense = [&name](const char* what) {
        return fault(StatusCode::Internal, name, "", std::string("the import process handed back ") + what,
                     "a checked mesh");
    };
    struct stat info = {};
    std::uint64_t headSize = 0;
    if (::fstat(descriptor, &info) != 0 || !readAll(descriptor, &headSize, sizeof(headSize), 0)) {
        return nonsense("nothing");
    }
    const auto size = static_cast<std::uint64_t>(info.st_size);
    if (headSize > std::min<std::uint64_t>(size - sizeof(headSize), kMostHead)) {
        return nonsense("a head without an end");
    }
    std::string bytes(headSize, '\0');
    if (!readAll(descriptor, bytes.data(), bytes.size(), sizeof(headSize))) {
        return nonsense("half a head");
    }
    HeadReader head(bytes);
    if (const auto code = head.take<std::uint8_t>(); code != 0) {
        std::string message = head.text();
        return head.isAtEnd() ? statusOf(code, std::move(message), name) : nonsense("an error without its text");
    }

    MeshFile file;
    file.path = path;
    file.format = head.text();
    file.loss = head.text();
    const auto frame = head.take<std::uint8_t>();
    if (frame > static_cast<std::uint8_t>(FileFrame::Ras)) {
        return nonsense("an unknown frame");
    }
    file.frame = static_cast<FileFrame>(frame);
    file.unit_mm = head.take<double>();
    if (!(file.unit_mm > 0.0) || !std::isfinite(file.unit_mm)) {
        return nonsense("an impossible unit");
    }
    for (auto notes = head.take<std::uint64_t>(); notes > 0 && head.isGood(); --notes) {
        file.notes.push_back(head.text());
    }
    std::vector<MeshCounts> counts;
    std::uint64_t end = sizeof(headSize) + headSize;
    for (auto structures = head.take<std::uint64_t>(); structures > 0 && head.isGood(); --structures) {
        MeshStructure& structure = file.structures.emplace_back();
        structure.name = head.text();
        const bool hasColour = head.take<std::uint8_t>() != 0;
        const auto colour = head.take<std::array<double, 3>>();
        if (hasColour) {
            if (!std::all_of(colour.begin(), colour.end(), [](double c) { return c >= 0.0 && c <= 1.0; })) {
                return nonsense("an impossible colour");
            }
            structure.colour = colour;
        }
        MeshCounts& c = counts.emplace_back();
        c.vertices = head.take<std::uint64_t>();
        c.triangles = head.take<std::uint64_t>();
        std::uint64_t ofVertex = sizeof(Vec3), ofTriangle = sizeof(Triangle); // bytes of one
        for (auto arrays = head.take<std::uint64_t>(); arrays > 0 && head.isGood(); --arrays) {
            geometry::MeshArray& array = structure.mesh.arrays.emplace_back();
            array.name = head.text();
            array.isPerTriangle = head.take<std::uint8_t>() != 0;
            (array.isPerTriangle ? ofTriangle : ofVertex) += sizeof(float);
        }
        if (structure.mesh.arrays.size() > 2 * kMostArrays || c.vertices > size || c.triangles > size ||
            c.triangles == 0 || c.vertices * ofVertex + c.triangles * ofTriangle > size - end) {
            return nonsense("an impossible count");
        }
        end += c.vertices * ofVertex + c.triangles * ofTriangle;
    }
    if (!head.isAtEnd() || file.structures.empty() || end != size) {
        return nonsense("counts that do not fit its size");
    }
    if (const char* wrong = moveMeshes(descriptor, sizeof(headSize) + headSize, counts, file)) {
        return nonsense(wrong);
    }
    return file;
}

} // namespace palpate::meshio::internal
