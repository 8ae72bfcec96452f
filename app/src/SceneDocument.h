// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructureModel.h>

#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

/// The open scene as a document: what its file says beside the structures, whether it was changed, saving, and a copy
/// of unsaved changes that survives a crash.
class SceneDocument : public QObject
{
    Q_OBJECT
  public:
    /// @param model  holds the structures and the undo stack of all edits; must outlive this
    explicit SceneDocument(palpate::ui::StructureModel& model, QObject* parent = nullptr);
    ~SceneDocument() override; ///< an orderly end: the copy of unsaved changes goes

    /// Takes a scene that was just opened; the rows are the model's already.
    void take(const palpate::ui::OpenedScene& scene);
    /// Takes what a scene that is added brings besides structures: its findings, undoably, and what could not be
    /// opened.
    void add(const palpate::ui::OpenedScene& scene);
    /// The scene file that it came from or was saved to; empty when there is none.
    [[nodiscard]] const std::filesystem::path& file() const noexcept { return m_file; }
    /// True when the file is another one than when it was read or saved: another window or program wrote it since.
    [[nodiscard]] bool isFileChanged() const;
    [[nodiscard]] bool isModified() const { return !m_model.undoStack().isClean(); }
    [[nodiscard]] const std::vector<palpate::core::Finding>& findings() const noexcept { return m_findings.findings(); }
    /// The same to be edited, undoably.
    [[nodiscard]] palpate::ui::FindingsModel& findingsModel() noexcept { return m_findings; }
    /// Adds a finding, undoably; `marked` and `unmarked` tell each time that it comes or goes.
    void addFinding(const palpate::core::Finding& finding);

    /// The scene with its meshes taken to be along other axes: structures and what could not be opened say it, findings
    /// turn with the structure that they are on. The view is left out: what it looked at turns away.
    [[nodiscard]] palpate::meshio::SceneFile inFrame(palpate::core::FileFrame frame) const;

    /// Saves all of it: what could not be opened and what this version does not know is kept.
    /// @param shownMap  that a structure is coloured by
    palpate::core::Status save(const std::filesystem::path& file, const palpate::meshio::SceneCamera& camera,
                               std::optional<palpate::meshio::ShownMap> shownMap = {});

    /// @return the copy of unsaved changes that a crashed program left, if there is one.
    [[nodiscard]] static std::optional<std::filesystem::path> findLeftover();
    /// Keeps such a copy for this window, until a scene is taken. @return false when another window has it, or had
    bool claimLeftover(const std::filesystem::path& copy);
    /// Deletes such a copy.
    static void discardLeftover(const std::filesystem::path& copy);

  Q_SIGNALS:
    void findingsChanged();
    void marked(const palpate::core::Finding& finding);
    void unmarked(const palpate::core::Finding& finding);
    /// The copy of unsaved changes could not be written; told once until it can. @param line  why
    void copyFailed(const QString& line);

  private:
    [[nodiscard]] palpate::meshio::SceneFile content() const;
    void followName(int row, const QString& before, const QString& after);
    bool writeCopy(); ///< @return false when there is none
    [[nodiscard]] bool beginCopy();
    void dropCopy();

    palpate::ui::StructureModel& m_model;
    std::filesystem::path m_file;
    palpate::ui::FindingsModel m_findings;
    palpate::meshio::SceneFile m_rest; ///< camera, unknown fields
    std::vector<palpate::meshio::SceneStructure> m_unopened;
    QTimer m_copyTimer;
    std::filesystem::path m_copy;
    bool m_hasCopyFailed = false;
    std::unique_ptr<QLockFile> m_lock;  ///< held as long as the copy is ours
    std::unique_ptr<QLockFile> m_claim; ///< of a copy that is being opened
};
