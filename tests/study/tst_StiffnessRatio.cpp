// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/study/BuriedLumps.h>
#include <palpate/study/FeltFile.h>

#include <QTest>

#include <cmath>

using namespace palpate;
using meshio::AnatomyKind;
using study::RatioSource;

/// Tests the stiffness ratio of a lump to its organ with synthetic descriptions.
class StiffnessRatio : public QObject
{
    Q_OBJECT

    static meshio::SceneStructure named(const char* name)
    {
        meshio::SceneStructure one;
        one.name = name;
        return one;
    }
    static std::optional<study::StiffnessRatio> between(const meshio::SceneStructure& lump,
                                                        const meshio::SceneStructure& organ)
    {
        return study::stiffnessRatio(lump, organ);
    }

  private Q_SLOTS:
    void whatIsKnownBestCounts()
    {
        meshio::SceneStructure lump = named("tumour"), organ = named("liver");
        QCOMPARE(between(lump, organ)->typical, 4.4);
        QVERIFY(between(lump, organ)->source == RatioSource::Published && between(lump, organ)->isRange());
        QVERIFY(between(lump, organ)->citation.find("PMC2894569") != std::string_view::npos);
        lump.tissue.stiffness_N_per_mm = 0.6;
        organ.tissue.stiffness_N_per_mm = 0.2;
        QVERIFY(between(lump, organ)->source == RatioSource::Tissue);
        QCOMPARE(between(lump, organ)->typical, 0.6 / 0.2);
        organ.young_kPa = 7.0;
        QVERIFY(between(lump, organ)->source == RatioSource::Tissue); // a single modulus gives no ratio
        lump.young_kPa = 35.0;
        QVERIFY(between(lump, organ)->source == RatioSource::Moduli && between(lump, organ)->typical == 5.0);
        lump.young_ratio = 2.5;
        QVERIFY(between(lump, organ)->source == RatioSource::Typed && between(lump, organ)->typical == 2.5);
        QCOMPARE(study::stiffnessRatio(lump, organ, 7.0)->typical, 7.0);
        QVERIFY(!study::stiffnessRatio(lump, organ, 7.0)->isRange());
    }

    /// Tissue assigned by name is not a stiffness set by the user: after opening, tissue by name and saving, a pair has
    /// exactly the same ratio.
    void theTissueOfANameIsNotChosen()
    {
        for (const char* lumpName : {"tumour", "metastasis", "benign lesion", "fibrosis", "cyst"}) {
            meshio::SceneStructure lump = named(lumpName), organ = named("liver");
            const auto before = between(lump, organ);
            organ.tissue.stiffness_N_per_mm = study::namedStiffness_N_per_mm("liver").value();
            lump.tissue.stiffness_N_per_mm = study::namedStiffness_N_per_mm(lumpName, &organ.name).value();
            QVERIFY2(before && between(lump, organ) == before, lumpName);
            organ.tissue.stiffness_N_per_mm = 0.3; // a firmer liver: its lumps keep their ratio
            QVERIFY2(between(lump, organ) == before, lumpName);
        }
    }

    void anUnknownNameHasNoRatio()
    {
        QVERIFY(!between(named("thing"), named("liver")));
        QVERIFY(!between(named("tumour"), named("part")));
        QVERIFY(!between(named("tumour"), named("kidney"))); // no published value
        meshio::SceneStructure lump = named("thing"), organ = named("liver");
        organ.tissue.law.kind = lump.tissue.law.kind = core::LawKind::Exponential;
        lump.tissue.stiffness_N_per_mm = 2.0;
        QVERIFY(!between(lump, organ)); // no single value
        const std::string question = study::ratioQuestion("thing", "liver").english();
        for (const char* part : {"thing", "liver", "not known", "--ratio \"thing=R\"", "4.4 (2.2 to 5.2)", "cyst"}) {
            QVERIFY2(question.find(part) != std::string::npos, question.c_str());
        }
        QVERIFY(question.find("breast") == std::string::npos); // no text about other organs
    }

    void whatIsFilledWithFluidIsSofterThanItsOrgan()
    {
        for (const char* organ : {"liver", "kidney", "thyroid", "part"}) {
            QVERIFY2(between(named("cyst"), named(organ))->high < 1.0, organ);
            QVERIFY2(between(named("portal vein"), named(organ))->high < 1.0, organ);
        }
        const std::string liver = "liver";
        QVERIFY(study::namedStiffness_N_per_mm("cyst", &liver).value() <
                study::namedStiffness_N_per_mm("liver").value());
    }

    void eachPublishedRangeIsOneWithASource()
    {
        for (const study::PublishedRatio& one : study::publishedRatios()) {
            const study::StiffnessRatio& ratio = one.ratio;
            QVERIFY2(ratio.low > 0.0 && ratio.low <= ratio.typical && ratio.typical <= ratio.high,
                     one.name.text().data());
            QVERIFY2(!ratio.citation.empty() && ratio.source == RatioSource::Published, one.name.text().data());
            QVERIFY2(study::publishedRatio(one.lump, one.organ) == &one, one.name.text().data());
        }
        // A benign liver tumour by MR elastography: 2.7 to 2.3 kPa; a malignant one 10.1.
        QVERIFY(std::abs(study::publishedRatio(AnatomyKind::BenignLump, AnatomyKind::Liver)->ratio.typical -
                         2.7 / 2.3) < 0.05);
        QVERIFY(std::abs(study::publishedRatio(AnatomyKind::MalignantLump, AnatomyKind::Liver)->ratio.typical -
                         10.1 / 2.3) < 0.05);
    }

    void aRatioIsSaidWithItsRange()
    {
        QCOMPARE(study::ratioText(std::nullopt), std::string("stiffness ratio not known"));
        QCOMPARE(study::ratioText(between(named("metastasis"), named("liver"))),
                 std::string("4.4 (2.2 to 5.2) times as stiff, published for such lumps"));
        QCOMPARE(study::ratioText(study::StiffnessRatio::exactly(3.0, RatioSource::Typed)),
                 std::string("3 times as stiff, as typed"));
    }
};

PALPATE_TEST(StiffnessRatio)
#include "tst_StiffnessRatio.moc"
