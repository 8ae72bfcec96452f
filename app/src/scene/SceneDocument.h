// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/TapesModel.h>

#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Document of the open scene: contents of the scene file other than structures, modification state, saving, and a
/// backup copy of unsaved changes that survives a crash.
class SceneDocument : public QObject
{
    Q_OBJECT
  public:
    /// Makes an empty document. @param model  structures and undo stack; must outlive this
    explicit SceneDocument(palpate::ui::StructureModel& model, QObject* parent = nullptr);
    ~SceneDocument() override; ///< regular exit: deletes the copy of unsaved changes

    /// Takes over a scene that was just opened; the model already has the rows.
    void take(const palpate::ui::OpenedScene& scene);
    /// Adds the findings and tapes (undoable) and the unopened structures of a scene that was added to this one.
    void add(const palpate::ui::OpenedScene& scene);
    /// Scene file that was opened or last saved; empty if none.
    [[nodiscard]] const std::filesystem::path& file() const noexcept { return m_file; }
    /// Returns whether another window or program changed the file since it was read or saved.
    [[nodiscard]] bool isFileChanged() const;
    [[nodiscard]] bool isModified() const { return !m_model.undoStack().isClean(); }
    [[nodiscard]] const std::vector<palpate::core::Finding>& findings() const noexcept { return m_findings.findings(); }
    /// Model for undoable edits of the findings.
    [[nodiscard]] palpate::ui::FindingsModel& findingsModel() noexcept { return m_findings; }
    /// Model for undoable edits of the tapes.
    [[nodiscard]] palpate::ui::TapesModel& tapesModel() noexcept { return m_tapes; }
    /// Adds a finding (undoable). `marked` and `unmarked` are emitted each time that the finding appears or
    /// disappears.
    void addFinding(const palpate::core::Finding& finding);

    /// Sets findings and tapes aside, or brings them back before those made meanwhile. They are still saved. Clears the
    /// undo stack.
    void setAside(bool isAside);

    /// Volume shown in sections; empty: none.
    [[nodiscard]] const std::filesystem::path& image() const noexcept { return m_rest.image; }
    /// Sets the volume shown in sections (undoable). @param file  empty: none
    void setImage(const std::filesystem::path& file);

    /// Range of the image's numbers from black to white; empty: chosen from the image.
    [[nodiscard]] const std::optional<palpate::geometry::GreyWindow>& imageWindow() const noexcept
    {
        return m_rest.imageWindow;
    }
    /// Sets this range (undoable; consecutive changes are one step).
    void setImageWindow(const palpate::geometry::GreyWindow& window);

    /// Plane that cuts the picture; empty: none.
    [[nodiscard]] const std::optional<palpate::meshio::SceneSection>& section() const noexcept
    {
        return m_rest.section;
    }
    /// Sets this plane (undoable; consecutive moves are one step).
    void setSection(const std::optional<palpate::meshio::SceneSection>& section);

    /// Copy of the scene with other mesh axes. Structures and unopened structures get the new axes; findings and tapes
    /// rotate with their structure, a section with the first one. The camera is omitted, because its target rotates
    /// away.
    [[nodiscard]] palpate::meshio::SceneFile inFrame(palpate::core::FileFrame frame) const;

    /// Saves the scene, including unopened structures and unknown fields.
    /// @param shownMap  map by which a structure is coloured
    palpate::core::Status save(const std::filesystem::path& file, const palpate::meshio::SceneCamera& camera,
                               std::optional<palpate::meshio::ShownMap> shownMap = {});

    /// Finds a copy of unsaved changes left by a crash, if any.
    [[nodiscard]] static std::optional<std::filesystem::path> findLeftover();
    /// Locks such a copy for this window until a scene is taken. @return false if another window has or had the copy
    bool claimLeftover(const std::filesystem::path& copy);
    /// Deletes such a copy.
    static void discardLeftover(const std::filesystem::path& copy);

  Q_SIGNALS:
    void findingsChanged();
    /// Another volume is to be shown, or the meshes have new axes.
    void imageChanged();
    void imageWindowChanged();
    void sectionChanged();
    void marked(const palpate::core::Finding& finding);
    void unmarked(const palpate::core::Finding& finding);
    /// The copy of unsaved changes could not be written. Emitted once until writing succeeds again. @param line  the
    /// reason
    void copyFailed(const QString& line);

  private:
    class ImageStep;
    class ImageWindowStep;
    class SectionStep;
    [[nodiscard]] palpate::meshio::SceneFile content() const;
    [[nodiscard]] palpate::core::Transform turnOf(const std::string& structure, palpate::core::FileFrame frame) const;
    void followName(int row, const QString& before, const QString& after);
    bool writeCopy(); ///< @return false if no copy was written
    [[nodiscard]] bool beginCopy();
    void dropCopy();

    palpate::ui::StructureModel& m_model;
    std::filesystem::path m_file;
    palpate::ui::FindingsModel m_findings;
    palpate::ui::TapesModel m_tapes;
    palpate::meshio::SceneFile m_rest; ///< camera and unknown fields
    std::vector<palpate::meshio::SceneStructure> m_unopened;
    std::vector<palpate::core::Finding> m_findingsAside;
    std::vector<palpate::core::Tape> m_tapesAside;
    QTimer m_copyTimer;
    std::filesystem::path m_copy;
    bool m_hasCopyFailed = false;
    std::unique_ptr<QLockFile> m_lock;  ///< held while this window uses the copy
    std::unique_ptr<QLockFile> m_claim; ///< lock of a copy that is being opened
};
