// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/igtl/ShareServer.h>

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace palpate::app {

/// Stores surfaces that a peer sends as mesh files, which are then opened with all checks of a file. A saved scene
/// refers to its meshes by file, too. Writing takes a worker thread.
class ReceivedSurfaces : public QObject
{
    Q_OBJECT
  public:
    static constexpr int kMaxWaiting = 4;  ///< surfaces in memory; further ones are dropped
    static constexpr int kMaxStored = 200; ///< files of one run of the program, so that no peer fills the disk

    explicit ReceivedSurfaces(QObject* parent);
    ~ReceivedSurfaces() override; ///< waits for the file that is being written

    /// Takes a surface. Any thread; returns at once.
    void take(igtl::ReceivedSurface surface);
    /// Folder of the files.
    [[nodiscard]] static QString folder();

  Q_SIGNALS:
    /// A new or changed surface is stored. @param name  of the structure
    void stored(const std::filesystem::path& file, const QString& name);
    void failed(const QString& line);

  private:
    void store(const igtl::ReceivedSurface& surface);

    std::atomic<int> m_waiting{0};
    std::atomic<bool> m_isDropping{false}; ///< a surface was dropped since the last one that was stored
    QThreadPool m_writer;                  ///< one thread

    // Thread of the writer only.
    int m_storedCount = 0;
    bool m_isFull = false;
    std::map<std::string, std::uint64_t> m_checksums; ///< of the last surface of each name
};

} // namespace palpate::app
