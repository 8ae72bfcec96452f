// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>

#include <sys/resource.h>
#include <unistd.h>

namespace palpate::test {

/// While the object lives, this process can allocate only so much more address space. Linux only.
class MemoryLimit
{
  public:
    explicit MemoryLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_AS, &m_before);
        unsigned long pages = 0;
        if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
            if (std::fscanf(file, "%lu", &pages) == 1) {
                const rlimit limit{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes, m_before.rlim_max};
                m_isSet = ::setrlimit(RLIMIT_AS, &limit) == 0;
            }
            (void)std::fclose(file);
        }
    }
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &m_before); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    [[nodiscard]] bool isSet() const { return m_isSet; }

  private:
    rlimit m_before{};
    bool m_isSet = false;
};

} // namespace palpate::test
