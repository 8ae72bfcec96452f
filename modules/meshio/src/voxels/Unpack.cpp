// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/Unpack.h"

#include <vtk_zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace palpate::meshio::internal {

struct ByteStream::Inflater
{
    Inflater()
    {
        constexpr int kZlibOrGzip = 15 + 32; // window size, and detection of the header
        if (inflateInit2(&stream, kZlibOrGzip) != Z_OK) {
            throw std::bad_alloc();
        }
    }
    ~Inflater() { (void)inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    z_stream stream{};
    bool isAtEnd = false; ///< of a member
};

ByteStream::ByteStream(std::function<std::string_view()> next, bool isPacked)
    : m_next(std::move(next))
    , m_inflater(isPacked ? std::make_unique<Inflater>() : nullptr)
{
}

ByteStream::~ByteStream() = default;

std::size_t ByteStream::read(std::span<char> to)
{
    std::size_t done = 0;
    while (done < to.size() && !m_isDamaged) {
        const bool isAtEnd = m_rest.empty() && (m_rest = m_next()).empty();
        const std::span<char> free = to.subspan(done);
        if (m_inflater != nullptr) {
            const std::size_t written = inflateInto(free);
            done += written;
            m_isDamaged = m_isDamaged || (isAtEnd && written == 0 && !m_inflater->isAtEnd);
            if (isAtEnd && written == 0) {
                break;
            }
        } else if (isAtEnd) {
            break;
        } else {
            const std::size_t take = std::min(m_rest.size(), free.size());
            std::copy_n(m_rest.begin(), take, free.begin());
            m_rest.remove_prefix(take);
            done += take;
        }
    }
    return done;
}

/// @return the number of bytes written; 0 if there is no input, or at damaged data
std::size_t ByteStream::inflateInto(std::span<char> to)
{
    z_stream& z = m_inflater->stream;
    if (m_inflater->isAtEnd) {
        // Zeros behind the last member fill a block, as gzip accepts.
        m_rest.remove_prefix(std::min(m_rest.find_first_not_of('\0'), m_rest.size()));
        if (m_rest.empty()) {
            return 0;
        }
        (void)inflateReset(&z); // a further member
        m_inflater->isAtEnd = false;
    }
    constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
    const std::size_t in = std::min(m_rest.size(), kMost), out = std::min(to.size(), kMost);
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(m_rest.data()));
    z.avail_in = static_cast<uInt>(in);
    z.next_out = reinterpret_cast<Bytef*>(to.data());
    z.avail_out = static_cast<uInt>(out);
    const int result = inflate(&z, Z_NO_FLUSH);
    m_rest.remove_prefix(in - z.avail_in);
    m_inflater->isAtEnd = result == Z_STREAM_END;
    m_isDamaged = result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR;
    return out - z.avail_out;
}

} // namespace palpate::meshio::internal
