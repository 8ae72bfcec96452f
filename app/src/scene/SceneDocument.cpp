// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneDocument.h"

#include "shared/Paths.h"
#include "shared/ProgramFolders.h"

#include <palpate/ui/Translated.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <QUndoCommand>
#include <QUndoStack>
#include <QUuid>

#include <algorithm>
#include <map>
#include <utility>

using namespace palpate;

namespace {

constexpr int kCopyDelay_ms = 1500; // after the latest edit
constexpr const char* kCopyOf = "copy_of";
constexpr const char* kCopyOfHash = "copy_of_sha256";

QString copyFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/unsaved");
}

QString lockOf(const std::filesystem::path& copy)
{
    return toText(copy) + QStringLiteral(".lock");
}

bool isCopy(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::equivalent(file.parent_path(), toPath(copyFolder()), error);
}

} // namespace

SceneDocument::SceneDocument(ui::StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_model(model)
    , m_findings(model.undoStack())
    , m_tapes(model.undoStack())
{
    connect(&m_findings, &ui::FindingsModel::changed, this, &SceneDocument::findingsChanged);
    connect(&m_findings, &ui::FindingsModel::marked, this, &SceneDocument::marked);
    connect(&m_findings, &ui::FindingsModel::unmarked, this, &SceneDocument::unmarked);
    m_copyTimer.setSingleShot(true);
    m_copyTimer.setInterval(kCopyDelay_ms);
    connect(&m_copyTimer, &QTimer::timeout, this, &SceneDocument::writeCopy);
    connect(&model.undoStack(), &QUndoStack::indexChanged, &m_copyTimer, qOverload<>(&QTimer::start));
    connect(&model, &ui::StructureModel::renamed, this, &SceneDocument::followName);
    connect(&model.undoStack(), &QUndoStack::cleanChanged, this, [this](bool isClean) {
        if (isClean) {
            m_copyTimer.stop();
            dropCopy();
        }
    });
}

SceneDocument::~SceneDocument()
{
    dropCopy();
}

void SceneDocument::take(const ui::OpenedScene& scene)
{
    dropCopy();
    m_rest = scene.scene;
    m_rest.structures.clear();
    m_rest.findings.clear();
    m_rest.tapes.clear();
    m_findingsAside.clear();
    m_tapesAside.clear();
    m_tapes.reset(scene.scene.tapes);
    m_findings.reset(scene.scene.findings); // before writing a copy of unsaved changes, which includes the findings
    m_unopened = scene.unopened;
    const bool isScene = scene.files.size() == 1 && meshio::isSceneFile(scene.files.front());
    // The sample has no file here, so that saving never overwrites it.
    const bool isSample = isScene && app::isSampleFile(scene.files.front());
    m_file = isScene && !isSample ? scene.files.front() : std::filesystem::path();
    if (isScene && !isSample && isCopy(m_file)) {
        // Restored changes stay unsaved changes of the original file, which is unmodified.
        QJsonObject extra = QJsonDocument::fromJson(QByteArray::fromStdString(m_rest.extra)).object();
        m_file = toPath(extra.take(QLatin1String(kCopyOf)).toString());
        m_rest.sha256 = extra.take(QLatin1String(kCopyOfHash)).toString().toStdString();
        m_rest.extra =
            extra.isEmpty() ? std::string() : QJsonDocument(extra).toJson(QJsonDocument::Compact).toStdString();
        m_model.undoStack().resetClean();
        const std::filesystem::path& leftover = scene.files.front();
        if (writeCopy()) {
            discardLeftover(leftover);
        } else { // the leftover copy is the only one
            m_copy = leftover;
            m_lock = std::move(m_claim);
        }
    } else if (scene.isReopened) {
        m_model.undoStack().resetClean();
        (void)writeCopy();
    }
    m_claim.reset();
    Q_EMIT sectionChanged();
    Q_EMIT imageChanged();
}

void SceneDocument::setAside(bool isAside)
{
    QUndoStack& undo = m_model.undoStack();
    const bool wasClean = undo.isClean();
    undo.clear(); // steps refer to rows of findings
    if (!wasClean) {
        undo.resetClean();
    }
    std::vector<core::Finding> findings = std::exchange(m_findingsAside, {});
    std::vector<core::Tape> tapes = std::exchange(m_tapesAside, {});
    findings.insert(findings.end(), m_findings.findings().begin(), m_findings.findings().end());
    tapes.insert(tapes.end(), m_tapes.tapes().begin(), m_tapes.tapes().end());
    if (isAside) {
        m_findingsAside = std::exchange(findings, {});
        m_tapesAside = std::exchange(tapes, {});
    }
    m_findings.reset(std::move(findings));
    m_tapes.reset(std::move(tapes));
}

void SceneDocument::add(const ui::OpenedScene& scene)
{
    for (const core::Finding& finding : scene.scene.findings) {
        addFinding(finding);
    }
    m_tapes.add(scene.scene.tapes);
    m_unopened.insert(m_unopened.end(), scene.unopened.begin(), scene.unopened.end());
}

/// A finding refers to its structure by name: update the name unless another structure has the old or new name.
void SceneDocument::followName(int row, const QString& before, const QString& after)
{
    for (int other = 0; other < m_model.rowCount(); ++other) {
        const QString name = ui::readableName(m_model.structure(other).name);
        if (other != row && (name == before || name == after)) {
            return;
        }
    }
    bool isAny = false;
    for (core::Finding& finding : m_rest.findings) {
        std::vector<std::string*> names{&finding.structure};
        for (core::FindingLayer& layer : finding.layers) {
            names.push_back(&layer.structure);
        }
        for (std::string* name : names) {
            if (ui::readableName(*name) == before) {
                *name = after.toStdString();
                isAny = true;
            }
        }
    }
    if (isAny) {
        Q_EMIT findingsChanged();
    }
}

/// Undo step that exchanges the image.
class SceneDocument::ImageStep : public QUndoCommand
{
  public:
    ImageStep(SceneDocument& document, std::filesystem::path image, const QString& text)
        : QUndoCommand(text)
        , m_document(document)
        , m_image(std::move(image))
    {
    }
    void redo() override
    {
        std::swap(m_document.m_rest.image, m_image);
        std::swap(m_document.m_rest.imageWindow, m_window);
        Q_EMIT m_document.imageChanged();
    }
    void undo() override { redo(); }

  private:
    SceneDocument& m_document;
    std::filesystem::path m_image;                ///< before redo the new image, after it the old one
    std::optional<geometry::GreyWindow> m_window; ///< likewise; a new image begins without one
};

void SceneDocument::setImage(const std::filesystem::path& file)
{
    const std::filesystem::path absolute = file.empty() ? file : std::filesystem::absolute(file).lexically_normal();
    if (absolute != m_rest.image) {
        m_model.undoStack().push(new ImageStep(
            *this, absolute, file.empty() ? tr("Remove the image") : tr("Show %1").arg(toText(file.filename()))));
    }
}

/// Undo step that exchanges the window of the image.
class SceneDocument::ImageWindowStep : public QUndoCommand
{
  public:
    ImageWindowStep(SceneDocument& document, const geometry::GreyWindow& window)
        : QUndoCommand(tr("Change the window of the image"))
        , m_document(document)
        , m_other(window)
    {
    }
    void redo() override
    {
        std::swap(m_document.m_rest.imageWindow, m_other);
        Q_EMIT m_document.imageWindowChanged();
    }
    void undo() override { redo(); }
    [[nodiscard]] int id() const override { return kImageWindow; }
    /// Keeps the window before the first change.
    bool mergeWith(const QUndoCommand*) override { return true; }

  private:
    static constexpr int kImageWindow = 3; // StructureModel has 1, SectionStep 2
    SceneDocument& m_document;
    std::optional<geometry::GreyWindow> m_other; ///< before redo the new window, after it the old one
};

void SceneDocument::setImageWindow(const geometry::GreyWindow& window)
{
    if (window != m_rest.imageWindow) {
        m_model.undoStack().push(new ImageWindowStep(*this, window));
    }
}

/// Undo step that exchanges the section.
class SceneDocument::SectionStep : public QUndoCommand
{
  public:
    SectionStep(SceneDocument& document, std::optional<meshio::SceneSection> section)
        : m_document(document)
        , m_other(std::move(section))
        , m_isMove(m_other && document.m_rest.section)
    {
        setText(m_isMove ? tr("Move the section") : m_other ? tr("Show a section") : tr("End the section"));
    }
    void redo() override
    {
        std::swap(m_document.m_rest.section, m_other);
        Q_EMIT m_document.sectionChanged();
    }
    void undo() override { redo(); }
    [[nodiscard]] int id() const override { return m_isMove ? kSectionMove : -1; }
    /// Keeps the section before the first move.
    bool mergeWith(const QUndoCommand*) override { return true; }

  private:
    static constexpr int kSectionMove = 2; // StructureModel has 1
    SceneDocument& m_document;
    std::optional<meshio::SceneSection> m_other; ///< before redo the new section, after it the old one
    bool m_isMove;
};

void SceneDocument::setSection(const std::optional<meshio::SceneSection>& section)
{
    if (section != m_rest.section) {
        m_model.undoStack().push(new SectionStep(*this, section));
    }
}

void SceneDocument::addFinding(const core::Finding& finding)
{
    m_findings.add({finding}, tr("Mark %1").arg(QString::fromStdString(finding.name)));
}

meshio::SceneFile SceneDocument::content() const
{
    meshio::SceneFile scene = m_model.scene().sceneFile(m_rest);
    scene.findings = m_findingsAside;
    scene.findings.insert(scene.findings.end(), m_findings.findings().begin(), m_findings.findings().end());
    scene.tapes = m_tapesAside;
    scene.tapes.insert(scene.tapes.end(), m_tapes.tapes().begin(), m_tapes.tapes().end());
    scene.structures.insert(scene.structures.end(), m_unopened.begin(), m_unopened.end());
    return scene;
}

bool SceneDocument::isFileChanged() const
{
    const std::string now = m_rest.sha256.empty() ? std::string() : meshio::fileHash(m_file);
    return !now.empty() && now != m_rest.sha256;
}

/// Rotation of places on a structure for other mesh axes. A name that no structure has rotates with the first one.
core::Transform SceneDocument::turnOf(const std::string& structure, core::FileFrame frame) const
{
    const auto& rows = m_model.rows();
    const auto named = std::find_if(rows.begin(), rows.end(), [&structure](const study::OpenStructure& row) {
        return row.loaded.description.name == structure ||
               ui::readableName(row.loaded.description.name).toStdString() == structure;
    });
    const meshio::LoadedStructure& on = (named == rows.end() ? rows.front() : *named).loaded;
    core::Transform turn = on.description.X_WM;
    turn.rotate(core::lpsRotation(frame) *
                core::lpsRotation(core::resolvedFrame(on.description.frame, on.frame)).transpose());
    return turn * on.description.X_WM.inverse();
}

meshio::SceneFile SceneDocument::inFrame(core::FileFrame frame) const
{
    meshio::SceneFile scene = content();
    scene.camera.reset();
    for (core::Finding& finding : scene.findings) {
        const core::Transform turn = turnOf(finding.structure, frame);
        finding.p_W = turn * finding.p_W;
        if (finding.camera) {
            finding.camera->position_W = turn * finding.camera->position_W;
            finding.camera->focus_W = turn * finding.camera->focus_W;
            finding.camera->up_W = turn.linear() * finding.camera->up_W;
        }
    }
    for (core::Tape& tape : scene.tapes) {
        tape.from_W = turnOf(tape.fromOn, frame) * tape.from_W;
        tape.to_W = turnOf(tape.toOn, frame) * tape.to_W;
    }
    if (scene.section) {
        const core::Transform turn = turnOf({}, frame);
        scene.section->p_W = turn * scene.section->p_W;
        scene.section->n_W = turn.linear() * scene.section->n_W;
        if (scene.section->direction != meshio::SectionDirection::Free) {
            constexpr double kRounding = 1e-9; // of a turn by right angles
            Eigen::Index axis = 0;
            const bool isPatients = scene.section->n_W.cwiseAbs().maxCoeff(&axis) > 1.0 - kRounding;
            scene.section->direction =
                isPatients ? static_cast<meshio::SectionDirection>(2 - axis) : meshio::SectionDirection::Free;
        }
    }
    for (meshio::SceneStructure& structure : scene.structures) {
        structure.frame = frame;
    }
    return scene;
}

core::Status SceneDocument::save(const std::filesystem::path& file, const meshio::SceneCamera& camera,
                                 std::optional<meshio::ShownMap> shownMap)
{
    m_rest.shownMap = std::move(shownMap);
    const std::string unknown = m_rest.camera ? m_rest.camera->extra : std::string();
    m_rest.camera = camera;
    m_rest.camera->extra = unknown;
    meshio::SceneFile scene = content();
    std::map<std::filesystem::path, std::string> hashes; // hashes of the meshes as they are on disk now
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_model.presentCount()); ++i) {
        meshio::SceneStructure& structure = scene.structures[i];
        const auto [hash, isNew] = hashes.emplace(structure.mesh, std::string());
        if (isNew) {
            hash->second = meshio::fileHash(structure.mesh);
        }
        structure.sha256 = hash->second;
    }
    const core::Status saved = meshio::writeScene(file, scene);
    if (saved.isOk()) {
        m_file = file;
        m_rest.sha256 = meshio::fileHash(file);
        m_model.undoStack().setClean();
        m_copyTimer.stop();
        dropCopy();
    }
    return saved;
}

/// Chooses a unique name. A process id is not enough: ids recur, also in containers or on machines that share the
/// folder.
bool SceneDocument::beginCopy()
{
    QDir().mkpath(copyFolder());
    const std::filesystem::path copy =
        toPath(copyFolder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces) +
               QStringLiteral(".palpate.json"));
    auto lock = std::make_unique<QLockFile>(lockOf(copy));
    lock->setStaleLockTime(0);
    if (!lock->tryLock(0)) {
        return false;
    }
    m_copy = copy;
    m_lock = std::move(lock);
    return true;
}

bool SceneDocument::writeCopy()
{
    if (!isModified() || m_model.rows().empty()) {
        return false;
    }
    core::Status status;
    if (m_copy.empty() && !beginCopy()) {
        status = {core::StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be written"), copyFolder().toStdString()};
    } else {
        meshio::SceneFile scene = content();
        QJsonObject extra = QJsonDocument::fromJson(QByteArray::fromStdString(scene.extra)).object();
        extra[QLatin1String(kCopyOf)] = toText(m_file);
        extra[QLatin1String(kCopyOfHash)] = QString::fromStdString(m_rest.sha256);
        scene.extra = QJsonDocument(extra).toJson(QJsonDocument::Compact).toStdString();
        status = meshio::writeScene(m_copy, scene);
    }
    if (!std::exchange(m_hasCopyFailed, !status.isOk()) && !status.isOk()) { // the next edit tries again
        Q_EMIT copyFailed(
            tr("Unsaved changes would be lost in a crash. Save the scene. %1").arg(ui::translated(status)));
    }
    return status.isOk();
}

void SceneDocument::dropCopy()
{
    if (!m_copy.empty()) {
        std::error_code ignored;
        std::filesystem::remove(m_copy, ignored);
        m_copy.clear();
        m_lock.reset();
    }
}

std::optional<std::filesystem::path> SceneDocument::findLeftover()
{
    const QDir folder(copyFolder());
    for (const QString& name : folder.entryList({QStringLiteral("*.palpate.json")}, QDir::Files, QDir::Time)) {
        const std::filesystem::path copy = toPath(folder.filePath(name));
        QLockFile lock(lockOf(copy));
        lock.setStaleLockTime(0);
        if (lock.tryLock(0)) { // lock is free: its process has ended
            return copy;
        }
    }
    return std::nullopt;
}

bool SceneDocument::claimLeftover(const std::filesystem::path& copy)
{
    auto lock = std::make_unique<QLockFile>(lockOf(copy));
    lock->setStaleLockTime(0);
    std::error_code error;
    if (!lock->tryLock(0) || !std::filesystem::exists(copy, error)) {
        return false;
    }
    m_claim = std::move(lock);
    return true;
}

void SceneDocument::discardLeftover(const std::filesystem::path& copy)
{
    std::error_code ignored;
    std::filesystem::remove(copy, ignored);
}

#include "moc_SceneDocument.cpp"
