// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FeltOverlay.h"

#include "palpate/ui/FeltWords.h"
#include "palpate/ui/Translated.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/view/FeltColours.h>

#include <Eigen/Geometry>

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::ui {

using core::Vec3;

namespace {

/// Relative change of stiffness against the organ without a lump, in either direction. [%]
float changeOf(float ratio)
{
    return 100.0F * std::expm1(std::abs(std::log(ratio)));
}

Vec3 normalAt(const geometry::TriangleMesh& mesh, std::size_t vertex)
{
    Vec3 sum = Vec3::Zero();
    for (const geometry::Triangle& t : mesh.triangles) {
        if (std::find(t.begin(), t.end(), vertex) != t.end()) {
            const Vec3& a = mesh.vertices[t[0]];
            sum += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        }
    }
    return sum.norm() > 0.0 ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

} // namespace

FeltOverlay::FeltOverlay(VtkViewport& viewport, StructureModel& model, LumpMaps& lumps, MapDisplay& maps,
                         QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
    , m_lumps(lumps)
    , m_maps(maps)
    , m_flight(viewport)
{
    connect(&lumps, &LumpMaps::outdated, this, [this](bool isReset) {
        if (isReset) {
            m_drawn.clear(); // the view has new pictures
            m_maps.setCovered(false);
        } else {
            undraw();
        }
        Q_EMIT changed();
    });
    connect(&lumps, &LumpMaps::changed, this, &FeltOverlay::take);
}

void FeltOverlay::setShown(bool isShown)
{
    if (isShown == m_isShown) {
        return;
    }
    m_isShown = isShown;
    undraw();
    m_lumps.setWanted(m_isShown || m_isTabled);
    draw();
}

void FeltOverlay::setTabled(bool isTabled)
{
    m_isTabled = isTabled;
    m_lumps.setWanted(m_isShown || m_isTabled);
}

void FeltOverlay::setPress(std::size_t press)
{
    m_press = std::min(press, kPress_mm.size() - 1);
    m_viewport.view().placeRing().hide(); // the best place depends on the penetration depth
    draw();
    Q_EMIT changed();
}

void FeltOverlay::take()
{
    if (m_drawn.empty()) {
        draw();
    }
    Q_EMIT changed();
}

void FeltOverlay::draw()
{
    if (!m_isShown || !isUpToDate() || organs().empty()) {
        return;
    }
    m_maps.setCovered(true);
    m_drawn.clear();
    double greatest = buried::kDetectableChange_percent.back();
    bool isHatched = false;
    std::vector<std::vector<float>> changes;
    for (const auto& one : organs()) {
        const buried::FeltSurface& felt = one->organ.felt;
        std::vector<float>& change = changes.emplace_back(felt.press[m_press].ratio);
        for (std::size_t v = 0; v < change.size(); ++v) {
            change[v] = changeOf(change[v]);
            isHatched = isHatched || felt.notJudged[v] != 0;
            greatest = felt.notJudged[v] == 0 ? std::max(greatest, double{change[v]}) : greatest;
        }
    }
    for (std::size_t i = 0; i < organs().size(); ++i) {
        const DisplayedOrgan& one = *organs()[i];
        const buried::FeltSurface& felt = one.organ.felt;
        m_drawn.push_back(static_cast<int>(one.organ.organ.organ));
        m_viewport.view().setPicture(
            one.organ.organ.organ,
            view::palpabilityColoured(*one.picture, felt.surface, {changes[i], felt.notJudged, greatest}));
    }
    drawLegend(greatest, isHatched);
    m_viewport.update();
}

void FeltOverlay::drawLegend(double greatest_percent, bool isHatched)
{
    view::ColourLegend::Content content;
    const double press_mm = kPress_mm[m_press];
    const QString how = press_mm > 0.0 ? tr("pressed %1 mm").arg(numberText(press_mm)) : tr("touched lightly");
    content.title = tr("Palpability, %1\n"
                       "(estimate)")
                        .arg(how)
                        .toStdString();
    content.briefTitle = tr("Palpability").toStdString();
    content.unknown = tr("not judged").toStdString();
    content.briefUnknown = verdictSign(buried::Verdict::NotJudged).toStdString();
    content.range.high = greatest_percent;
    content.range.hasUnknown = isHatched;
    content.marks = {{0.0, tr("0 %: no lump").toStdString(), {}},
                     {buried::kDetectableChange_percent[0], tr("7 %: not noticed").toStdString(), {}},
                     {buried::kDetectableChange_percent[1], tr("14 %: by a trained hand").toStdString(), {}},
                     {buried::kDetectableChange_percent[2], tr("28 %: plainly felt").toStdString(), {}}};
    if (greatest_percent > 1.15 * buried::kDetectableChange_percent[2]) {
        content.marks.push_back(
            {greatest_percent,
             tr("%1 %: maximum here").arg(QLocale().toString(greatest_percent, 'f', 0)).toStdString(),
             {}});
    }
    for (view::ColourLegend::Mark& mark : content.marks) {
        mark.brief = tr("%1 %").arg(QLocale().toString(mark.value, 'f', 0)).toStdString();
    }
    m_viewport.view().legend().show(content);
}

void FeltOverlay::undraw()
{
    for (const int row : m_drawn) {
        const auto i = static_cast<std::size_t>(row);
        m_viewport.view().setPicture(i, m_model.picture(static_cast<int>(i)));
    }
    if (!m_drawn.empty()) {
        m_viewport.view().legend().hide();
        m_viewport.update();
    }
    m_viewport.view().placeRing().hide();
    m_drawn.clear();
    m_maps.setCovered(false);
}

QString FeltOverlay::textAt(int row, const Vec3& p_W) const
{
    if (std::find(m_drawn.begin(), m_drawn.end(), row) == m_drawn.end()) {
        return {};
    }
    for (const auto& one : organs()) {
        if (one->organ.organ.organ == static_cast<std::size_t>(row)) {
            const vtkIdType vertex = one->vertices->FindClosestPoint(p_W.data());
            return vertex < 0 ? QString() : palpabilityText(one->organ.felt, static_cast<std::size_t>(vertex), m_press);
        }
    }
    return {};
}

bool FeltOverlay::showBestPlace(std::size_t organ, std::size_t lump)
{
    // Maximum camera distance, and offset of the ring from the surface.
    constexpr double kFarthest_mm = 250.0, kOff_mm = 0.3;
    if (organ >= organs().size() || lump >= organs()[organ]->organ.felt.lumps.size()) {
        return false;
    }
    const buried::FeltSurface& felt = organs()[organ]->organ.felt;
    const std::optional<std::size_t> best = felt.lumps[lump].press[m_press].best;
    if (!best) {
        return false;
    }
    const Vec3& p_W = felt.surface.vertices[*best];
    const Vec3 n_W = normalAt(felt.surface, *best);
    core::ViewPose pose = viewPose(m_viewport);
    const double distance_mm = std::min((pose.position_W - pose.focus_W).norm(), kFarthest_mm);
    pose.focus_W = p_W;
    pose.position_W = p_W + distance_mm * n_W;
    // Screen up: towards the head, else the patient's front.
    const Vec3 usual = std::abs(n_W.z()) < 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(-Vec3::UnitY());
    pose.up_W = (usual - usual.dot(n_W) * n_W).normalized();
    m_flight.flyTo(pose);
    m_viewport.view().placeRing().show(p_W + kOff_mm * n_W, n_W, felt.radius_mm, organs()[organ]->organ.organ.organ);
    m_viewport.update();
    return true;
}

} // namespace palpate::ui

#include "palpate/ui/moc_FeltOverlay.cpp"
