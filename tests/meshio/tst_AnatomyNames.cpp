// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include <palpate/meshio/AnatomyKind.h>
#include <palpate/meshio/AnatomyPalette.h>
#include <palpate/meshio/LoadScene.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

using namespace palpate;
using meshio::AnatomyKind;

/// Tests the classification of structure names: from segmentation programs, and names of lumps.
class AnatomyNames : public QObject
{
    Q_OBJECT

    static void rows(AnatomyKind kind, std::initializer_list<const char*> names)
    {
        for (const char* name : names) {
            QTest::newRow(name) << static_cast<int>(kind);
        }
    }
    static void numbered(AnatomyKind kind, const char* before, int from, int to, const char* after = "")
    {
        for (int i = from; i <= to; ++i) {
            const std::string name = before + std::to_string(i) + after;
            QTest::newRow(name.c_str()) << static_cast<int>(kind);
        }
    }
    static void check()
    {
        QFETCH(int, kind);
        QCOMPARE(static_cast<int>(meshio::anatomyKind(QTest::currentDataTag())), kind);
    }

    /// Simulates full deuteranopia: Machado, Oliveira and Fernandes 2009 (doi:10.1109/TVCG.2009.113), table 1.
    static std::array<double, 3> asSeenByDeuteranopes(const std::array<double, 3>& rgb)
    {
        constexpr double kMatrix[3][3] = {
            {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
        std::array<double, 3> seen{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                seen[i] += kMatrix[i][k] * linear(rgb[k]);
            }
        }
        return seen;
    }
    static double linear(double value)
    {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    /// Returns the CIE 1976 colour difference of two linear sRGB colours, white D65.
    static double difference(const std::array<double, 3>& a, const std::array<double, 3>& b)
    {
        const auto lab = [](const std::array<double, 3>& c) {
            const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
            const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
            const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
            const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
            return std::array<double, 3>{116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
        };
        const auto p = lab(a), q = lab(b);
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }

  private Q_SLOTS:
    /// What a liver surgeon must tell apart stays apart for a deuteranope; with the usual colours, artery and bile duct
    /// do not.
    void colourBlindPeopleCanTellTheLiverApart()
    {
        constexpr double kApart = 20.0; // clearly different hues or shades
        const char* names[] = {"hepatic_artery", "portal_vein", "hepatic_veins", "bile_duct", "tumour", "liver"};
        for (const char* a : names) {
            for (const char* b : names) {
                if (std::string(a) < b) {
                    const double apart = difference(asSeenByDeuteranopes(meshio::safeColour(a, 0)),
                                                    asSeenByDeuteranopes(meshio::safeColour(b, 0)));
                    QVERIFY2(apart > kApart, qPrintable(QStringLiteral("%1 %2 %3").arg(a).arg(b).arg(apart)));
                }
            }
        }
        QVERIFY(difference(asSeenByDeuteranopes(meshio::defaultColour("hepatic_artery", 0)),
                           asSeenByDeuteranopes(meshio::defaultColour("bile_duct", 0))) < kApart);
    }

    /// The 117 classes of TotalSegmentator's task "total", version 2.
    void totalSegmentator_data()
    {
        QTest::addColumn<int>("kind");
        rows(AnatomyKind::Spleen, {"spleen"});
        rows(AnatomyKind::Kidney, {"kidney_right", "kidney_left"});
        rows(AnatomyKind::Liver, {"liver"});
        rows(AnatomyKind::Pancreas, {"pancreas"});
        rows(AnatomyKind::Prostate, {"prostate"});
        rows(AnatomyKind::Thyroid, {"thyroid_gland"});
        rows(AnatomyKind::Cyst, {"kidney_cyst_left", "kidney_cyst_right"});
        rows(AnatomyKind::Organ,
             {"gallbladder", "stomach", "adrenal_gland_right", "adrenal_gland_left", "esophagus", "small_bowel",
              "duodenum", "colon", "urinary_bladder", "heart", "atrial_appendage_left"});
        rows(AnatomyKind::Lung, {"lung_upper_lobe_left", "lung_lower_lobe_left", "lung_upper_lobe_right",
                                 "lung_middle_lobe_right", "lung_lower_lobe_right"});
        rows(AnatomyKind::Cartilage, {"trachea", "costal_cartilages"});
        rows(AnatomyKind::Vessel,
             {"aorta", "pulmonary_vein", "brachiocephalic_trunk", "subclavian_artery_right", "subclavian_artery_left",
              "common_carotid_artery_right", "common_carotid_artery_left", "brachiocephalic_vein_left",
              "brachiocephalic_vein_right", "superior_vena_cava", "inferior_vena_cava", "portal_vein_and_splenic_vein",
              "iliac_artery_left", "iliac_artery_right", "iliac_vena_left", "iliac_vena_right"});
        rows(AnatomyKind::Bone, {"sacrum", "vertebrae_S1", "humerus_left", "humerus_right", "scapula_left",
                                 "scapula_right", "clavicula_left", "clavicula_right", "femur_left", "femur_right",
                                 "hip_left", "hip_right", "skull", "sternum"});
        numbered(AnatomyKind::Bone, "vertebrae_L", 1, 5);
        numbered(AnatomyKind::Bone, "vertebrae_T", 1, 12);
        numbered(AnatomyKind::Bone, "vertebrae_C", 1, 7);
        numbered(AnatomyKind::Bone, "rib_left_", 1, 12);
        numbered(AnatomyKind::Bone, "rib_right_", 1, 12);
        rows(AnatomyKind::Brain, {"spinal_cord", "brain"});
        rows(AnatomyKind::Muscle, {"gluteus_maximus_left", "gluteus_maximus_right", "gluteus_medius_left",
                                   "gluteus_medius_right", "gluteus_minimus_left", "gluteus_minimus_right",
                                   "autochthon_left", "autochthon_right", "iliopsoas_left", "iliopsoas_right"});
    }
    void totalSegmentator() { check(); }

    /// Classes of the other TotalSegmentator tasks.
    void otherTasks_data()
    {
        QTest::addColumn<int>("kind");
        rows(AnatomyKind::Vessel, {"liver_vessels", "lung_vessels", "hepatic_vessel", "coronary_arteries",
                                   "venous_sinuses", "internal_jugular_vein_left", "internal_carotid_artery_right"});
        rows(AnatomyKind::Lump, {"liver_tumor", "lung_nodules", "kidney_tumor"});
        rows(AnatomyKind::Bone, {"tarsal", "metatarsal", "carpal", "metacarpal", "phalanges_hand", "phalanges_feet",
                                 "hyoid", "teeth_lower", "zygomatic_arch_left", "hard_palate", "vertebrae_body"});
        rows(AnatomyKind::Brain, {"caudate_nucleus", "lentiform_nucleus", "thalamus", "insular_cortex", "frontal_lobe",
                                  "brainstem", "ventricle", "central_sulcus", "internal_capsule"});
        rows(AnatomyKind::Muscle, {"masseter_left", "deltoid", "trapezius_left", "skeletal_muscle", "tongue",
                                   "sterno_thyroid_left", "quadriceps_femoris_left", "levator_scapulae_right",
                                   "lateral_rectus_muscle_left", "thigh_medial_compartment_left"});
        rows(AnatomyKind::Fat, {"subcutaneous_fat", "torso_fat", "intermuscular_fat"});
        rows(AnatomyKind::Breast, {"breast"});
        rows(AnatomyKind::SalivaryGland, {"parotid_gland_left", "submandibular_gland_right"});
        rows(AnatomyKind::Organ, {"heart_atrium_left", "heart_ventricle_left", "heart_myocardium", "eye_left"});
        rows(AnatomyKind::Cartilage, {"thyroid_cartilage", "intervertebral_discs"});
        rows(AnatomyKind::Nerve, {"optic_nerve_left"});
        rows(AnatomyKind::Skin, {"face", "body_trunc"});
    }
    void otherTasks() { check(); }

    /// FreeSurfer's labels of a whole brain and its surrounding tissues.
    void freeSurfer_data()
    {
        QTest::addColumn<int>("kind");
        rows(AnatomyKind::Brain, {"Left-Cerebral-White-Matter",
                                  "Left-Cerebral-Cortex",
                                  "Left-Lateral-Ventricle",
                                  "Left-Inf-Lat-Vent",
                                  "Left-Cerebellum-White-Matter",
                                  "Left-Cerebellum-Cortex",
                                  "Left-Thalamus",
                                  "Left-Thalamus-Proper",
                                  "Left-Caudate",
                                  "Right-Caudate",
                                  "Left-Putamen",
                                  "Left-Pallidum",
                                  "3rd-Ventricle",
                                  "4th-Ventricle",
                                  "Brain-Stem",
                                  "Left-Hippocampus",
                                  "Left-Amygdala",
                                  "CSF",
                                  "Left-Accumbens-area",
                                  "Left-VentralDC",
                                  "Left-choroid-plexus",
                                  "5th-Ventricle",
                                  "WM-hypointensities",
                                  "non-WM-hypointensities",
                                  "CC_Posterior",
                                  "CC_Mid_Posterior",
                                  "CC_Central",
                                  "CC_Mid_Anterior",
                                  "CC_Anterior",
                                  "ctx-lh-superiorfrontal",
                                  "ctx-rh-bankssts",
                                  "Left-Insula",
                                  "Left-Operculum",
                                  "Left-Substancia-Nigra",
                                  "Corpus_Callosum",
                                  "Fornix",
                                  "Left-caudate-intensity-abnormality",
                                  "entorhinal_cortex",
                                  "Spinal-Cord",
                                  "Dura"});
        rows(AnatomyKind::Vessel,
             {"Left-vessel", "Right-vessel", "Aorta", "Left-Common-IliacA", "Right-Common-IliacV"});
        rows(AnatomyKind::Lump, {"Left-Lesion", "Right-Lesion"});
        rows(AnatomyKind::Nerve, {"Optic-Chiasm", "Nerve"});
        rows(AnatomyKind::Bone, {"Cranium", "Bone", "Teeth", "Diploe"});
        rows(AnatomyKind::Fat, {"Adipose", "Orbital-Fat"});
        rows(AnatomyKind::Muscle, {"Muscle", "SC-Fat/Muscle", "Tongue"});
        rows(AnatomyKind::Skin, {"Epidermis"});
        rows(AnatomyKind::LymphNode, {"Pos-Lymph", "Neg-Lymph"});
        rows(AnatomyKind::Other, {"Unknown", "Left-undetermined", "Line-1", "Air"});
    }
    void freeSurfer() { check(); }

    /// Organs of the Visible Human in HuBMAP's reference object library: one example per kind of name.
    void visibleHuman_data()
    {
        QTest::addColumn<int>("kind");
        rows(AnatomyKind::Liver, {"capsule_of_the_liver", "caudate_lobe", "quadrate_lobe", "renal_impression_of_liver",
                                  "gastric_impression_of_liver", "suprarenal_impression_of_liver", "porta_hepatis",
                                  "right_posteroinferior_segment", "left_superomedial_segment1"});
        rows(AnatomyKind::Tendon, {"falciform_ligament", "round_ligament_of_liver", "tendon_of_quadriceps_femoris_L",
                                   "patellar_ligament_L", "anterior_cruciate_enthesis_L"});
        rows(AnatomyKind::Organ,
             {"hepatic_flexure_of_colon", "splenic_flexure_of_colon", "vermiform_appendix", "left_ventricle",
              "pulmonary_valve", "ileum_terminal", "jejenum", "thymus_lobe_L", "left_ovary", "body_of_uterus",
              "ampulla_of_uterine_tube_L", "external_cervical_os", "duodenal_ampulla", "ileocecal_valve",
              "trigone_of_urinary_bladder", "interventricular_septum"});
        rows(AnatomyKind::Duct, {"cystic_duct", "common_bile_duct", "hepatopancreatic_ampulla", "renal_pelvis_L",
                                 "minor_calyx_L_a", "left_ureter", "ureteral_orifice_R"});
        rows(AnatomyKind::Vessel, {"cystic_artery", "cystic_vein", "proper_hepatic_artery", "celiac_trunk",
                                   "left_marginal_branch", "posterior_left_ventricular_branch", "coronary_sinus",
                                   "right_branch_of_portal_vein", "aortic_arch", "pulmonary_trunk"});
        rows(AnatomyKind::Kidney, {"outer_cortex_of_kidney_L", "renal_pyramid_L_a", "kidney_capsule_R"});
        rows(AnatomyKind::Spleen, {"renal_surface_of_spleen", "colic_surface_of_spleen", "hilum_of_spleen"});
        rows(AnatomyKind::Pancreas, {"tail_of_pancreas", "uncinate_process"});
        rows(AnatomyKind::Bone, {"pubis_spongy_bone_L", "ilium_compact_bone_R", "coccyx", "sacrum",
                                 "medial_condyle_of_left_femur_inf", "trochlear_groove_L"});
        rows(AnatomyKind::Cartilage, {"meniscus_L", "articular_cartilage_of_knee_L"});
        rows(AnatomyKind::Muscle,
             {"papillary_muscle_of_heart_ant", "rectus_femoris_L", "levator_palpebrae_superioris_L"});
        rows(AnatomyKind::Skin, {"skin"});
    }
    void visibleHuman() { check(); }

    /// All names in the anatomy folder: every name outside this list is classified.
    void everyVisibleHumanNameIsKnown()
    {
        PALPATE_SHARED_OR_SKIP(folder, "anatomy");
        const auto scene = meshio::loadScene(folder / "vh_f_body_large.vtp");
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        std::string unknown;
        for (const meshio::LoadedStructure& one : scene.value().structures) {
            if (meshio::anatomyKind(one.description.name) == AnatomyKind::Other) {
                unknown += one.description.name + "; ";
            }
        }
        QCOMPARE(unknown, std::string());
    }

    void lumpsAsReportsNameThem_data()
    {
        QTest::addColumn<int>("kind");
        rows(AnatomyKind::Lump, {"lump 20 mm", "Tumour_segment_IV", "tumor2", "liver tumours", "mass", "Masses",
                                 "LiverLesion", "nodule-right-thyroid", "GTV"});
        rows(AnatomyKind::MalignantLump, {"hepatocellular carcinoma", "metastasis 3", "liver_metastases", "HCC",
                                          "malignant tumour", "breast cancer"});
        rows(AnatomyKind::BenignLump, {"haemangioma", "benign lump", "fibroadenoma_left", "Focal Nodular Hyperplasia"});
        rows(AnatomyKind::Cyst, {"cyst", "liver cysts", "Cyst-1", "pancreatic pseudocyst"});
        rows(AnatomyKind::FibroticArea, {"fibrosis", "fibrotic_area"});
        // Whole words only: these names are no lump, rib, hip or radius.
        rows(AnatomyKind::Other, {"massif", "tribe", "hipster", "outradius", "part", "segment 4", "thing"});
        rows(AnatomyKind::Vessel, {"cystic artery"});
    }
    void lumpsAsReportsNameThem() { check(); }
};

PALPATE_TEST(AnatomyNames)
#include "tst_AnatomyNames.moc"
