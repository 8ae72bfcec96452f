// SPDX-License-Identifier: BSD-3-Clause
#include "scene/AnatomyWords.h"

#include <algorithm>
#include <string>
#include <vector>

namespace palpate::meshio {

namespace {

using internal::AnatomyWords;

// The words are those of TotalSegmentator's classes (all tasks of version 2), FreeSurfer's colour table, and the
// Visible Human organs of HuBMAP's reference object library (version 1.2); lumps as radiology reports name them.
// Colours follow 3D Slicer's table of generic anatomy colours where it has the structure, except for the portal vein,
// which has the colour of the hepatic veins there. The second colour is for colour-blind people: lumps, vessels and
// ducts have the hues of Okabe and Ito's palette, organs are dull.
constexpr std::array kWords = std::to_array<AnatomyWords>({
    // Adjectives of position relative to another organ: they do not identify the structure.
    {AnatomyKind::Other,
     {128, 128, 128},
     {128, 128, 128},
     "renal surface,renal impression,suprarenal impression,gastric surface,gastric impression,colic surface,"
     "colic impression,duodenal impression,esophageal impression,oesophageal impression,diaphragmatic surface"},

    {AnatomyKind::Cyst,
     {144, 238, 144},
     {250, 250, 250},
     "cyst,cystic lesion,cystic tumor,cystic tumour,cystic mass,pseudocyst"},
    {AnatomyKind::BenignLump,
     {144, 238, 144},
     {240, 228, 66},
     "benign,adenoma,fibroadenoma,hemangioma,haemangioma,angioma,lipoma,myoma,leiomyoma,fibroid,polyp,"
     "focal nodular hyperplasia,fnh"},
    {AnatomyKind::MalignantLump,
     {144, 238, 144},
     {240, 228, 66},
     "malignant,malignancy,malignancie,cancer,carcinoma,adenocarcinoma,cholangiocarcinoma,sarcoma,lymphoma,melanoma,"
     "metastasis,metastase,metastatic,met,hcc,ccc,pdac,hepatoblastoma"},
    {AnatomyKind::FibroticArea,
     {178, 190, 140},
     {205, 195, 100},
     "fibrosis,fibrotic,fibrotic area,cirrhosis,cirrhotic,scar"},
    {AnatomyKind::Lump,
     {144, 238, 144},
     {240, 228, 66},
     "tumor,tumour,lump,lesion,nodule,nodular,mass,neoplasm,neoplasia,gtv,induration"},

    {AnatomyKind::Vessel,
     {216, 101, 79},
     {213, 94, 0},
     "artery,arterie,arterial,arteriole,aorta,aortic arch,carotid,aneurysm,brachiocephalic trunk,celiac trunk,"
     "coeliac trunk,pulmonary trunk,marginal branch,ventricular branch,iliac a,sacral a,obturator a,pudendal a,"
     "umbilical a,rectal a,lad"},
    {AnatomyKind::Vessel,
     {110, 64, 170},
     {0, 114, 178},
     "portal,portal vein,portal vena,portal venous,vena porta,vena portae,splenic vein,mesenteric vein"},
    {AnatomyKind::Vessel,
     {0, 151, 206},
     {86, 180, 233},
     "vein,vena,venae,venous,cava,jugular,azygos,coronary sinus,vessel,vascular,vasculature,iliac v,obturator v,"
     "pudendal v"},
    {AnatomyKind::Nerve, {244, 214, 49}, {250, 240, 200}, "nerve,optic chiasm,plexus brachialis,brachial plexus"},
    {AnatomyKind::Duct,
     {139, 150, 98},
     {0, 158, 115},
     "duct,bile,biliary,hepatopancreatic ampulla,heptopancreatic ampulla,ampulla of vater,ureter,ureteral orifice,"
     "urethra,calyx,calyce,renal pelvis"},
    {AnatomyKind::LymphNode, {68, 172, 100}, {0, 120, 90}, "lymph,lymph node,lymphnode,lymphatic"},
    {AnatomyKind::Tendon, {183, 214, 211}, {200, 215, 220}, "ligament,ligamentum,tendon,aponeurosis,fascia,enthesis"},
    {AnatomyKind::Cartilage,
     {111, 184, 210},
     {150, 190, 210},
     "cartilage,costal cartilage,meniscus,menisci,menisc,intervertebral disc,intervertebral disk,intervertebral,"
     "trachea,bronchus,bronchi,bronchia,larynx,epiglottis,cricoid"},
    {AnatomyKind::Muscle,
     {192, 104, 88},
     {150, 90, 80},
     "muscle,musculus,myocardial muscle,femoris,gluteus,glutei,gluteal,autochthon,iliopsoas,psoas,masseter,temporalis,"
     "pterygoid,digastric,deltoid,trapezius,supraspinatus,infraspinatus,subscapularis,coracobrachial,pectoralis,"
     "serratus,teres,triceps,biceps,quadriceps,sartorius,sternocleidomastoid,platysma,scalene,levator,constrictor,"
     "sterno thyroid,sternothyroid,thyrohyoid,prevertebral,sphincter,diaphragm,compartment,tongue,gastrocnemius,soleus,"
     "adductor,iliacus,rectus abdominis,oblique muscle"},
    {AnatomyKind::Bone,
     {241, 214, 145},
     {235, 225, 200},
     "bone,femur,tibia,fibula,patella,scapula,humerus,humeri,ulna,radius,spine,vertebra,vertebrae,vertebral,sacrum,"
     "coccyx,rib,skull,cranium,diploe,pelvis,pelvic bone,mandible,mandibula,maxilla,condyle,condylar,epicondylar,"
     "perichondular,intercondylar fossa,trochlear groove,clavicle,clavicula,sternum,hip,hip implant,tarsal,metatarsal,"
     "carpal,metacarpal,phalanx,phalange,hyoid,tooth,teeth,zygomatic,styloid process,hard palate,pubis,ilium,ischium,"
     "outer table,inner table,calcaneus,talus"},
    {AnatomyKind::Fat, {230, 220, 70}, {245, 235, 170}, "fat,adipose,lipid"},
    {AnatomyKind::Kidney,
     {185, 102, 83},
     {140, 80, 70},
     "kidney,renal,renal cortex,renal pyramid,renal column,renal papilla"},
    {AnatomyKind::Spleen, {157, 108, 162}, {204, 121, 167}, "spleen,splenic"},
    {AnatomyKind::Pancreas, {249, 180, 111}, {230, 159, 0}, "pancreas,pancreatic,uncinate process"},
    {AnatomyKind::Prostate, {230, 158, 140}, {190, 130, 120}, "prostate,prostatic"},
    {AnatomyKind::Breast, {221, 160, 145}, {215, 170, 160}, "breast,mamma,mammae,mammary,fibroglandular"},
    {AnatomyKind::Thyroid, {62, 162, 114}, {120, 110, 160}, "thyroid,thyroid gland"},
    {AnatomyKind::SalivaryGland, {200, 150, 120}, {190, 150, 125}, "parotid,submandibular,sublingual gland,salivary"},
    {AnatomyKind::Liver,
     {221, 130, 101},
     {225, 185, 175},
     "liver,hepatic,hepar,porta hepatis,caudate lobe,quadrate lobe,anterolateral segment,superomedial segment,"
     "inferomedial segment,anterosuperior segment,posteroinferior segment,posterosuperior segment,"
     "anteroinferior segment"},
    {AnatomyKind::Lung, {197, 165, 145}, {205, 180, 170}, "lung,pulmonary"},
    {AnatomyKind::Brain,
     {250, 250, 225},
     {250, 250, 225},
     "brain,brain stem,brainstem,cerebral,cerebrum,cerebellum,cerebellar,cortex,cortical,ctx,gyrus,gyri,sulcus,sulci,"
     "caudate,caudate nucleus,putamen,pallidum,thalamus,hippocampus,hippocampal,amygdala,accumbens,insula,insular,"
     "operculum,substancia nigra,substantia nigra,ventral dc,vdc,claustrum,lentiform,white matter,wm,gray matter,"
     "grey matter,hypointensitie,lateral ventricle,ventricle,inf lat vent,lat vent,choroid plexus,corpus callosum,"
     "cc posterior,cc mid,cc central,cc anterior,fornix,fimbria,subiculum,presubiculum,parasubiculum,entorhinal,"
     "perirhinal,int capsule,internal capsule,septum pellucidum,frontal lobe,parietal lobe,occipital lobe,temporal "
     "lobe,"
     "subarachnoid,csf,dura,pons,medulla oblongata,midbrain,hypothalamus,spinal cord"},
    {AnatomyKind::Organ,
     {206, 110, 84},
     {150, 70, 60},
     "heart,heart ventricle,cardiac,myocardium,pericardium,left ventricle,right ventricle,atrium,"
     "atria,atrial,atrial appendage,interventricular septum,valve,pulmonary valve,mitral,"
     "tricuspid"},
    {AnatomyKind::Organ, {139, 150, 98}, {0, 110, 80}, "gallbladder,gall bladder"},
    {AnatomyKind::Organ, {222, 154, 132}, {210, 165, 150}, "bladder,urinary bladder,trigone"},
    {AnatomyKind::Organ,
     {216, 132, 105},
     {200, 140, 120},
     "stomach,gastric,duodenum,duodenal,jejunum,jejenum,ileum,colon,colonic,bowel,intestine,intestinal,caecum,cecum,"
     "rectum,sigmoid,vermiform appendix,appendix,hepatic flexure,splenic flexure,esophagus,oesophagus,pharynx,"
     "nasopharynx,oropharynx,hypopharynx,soft palate"},
    {AnatomyKind::Organ,
     {220, 150, 150},
     {215, 160, 165},
     "adrenal,adrenal gland,suprarenal,suprarenal gland,thymus,testis,testicle,ovary,ovarie,uterus,uterine,"
     "uterine tube,fallopian,cervix,cervical os,cervicovaginal,cornua,vagina,eye,eyeball,globe,lens,cornea,iris,"
     "vitreous,pituitary"},
    {AnatomyKind::Skin,
     {177, 122, 101},
     {177, 122, 101},
     "skin,epidermis,face,body trunc,body trunk,body extremity,body extremitie,"
     "body surface"},
});

/// One phrase of the table, in words.
struct Phrase
{
    std::vector<std::string_view> words;
    const AnatomyWords* group;
};

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(separator, from), text.size());
        parts.push_back(text.substr(from, to - from));
        from = to + 1;
    }
    return parts;
}

/// All phrases, sorted by descending number of words, then of letters.
std::vector<Phrase> makePhrases()
{
    std::vector<Phrase> phrases;
    for (const AnatomyWords& group : kWords) {
        for (const std::string_view phrase : split(group.phrases, ',')) {
            phrases.push_back({split(phrase, ' '), &group});
        }
    }
    const auto letters = [](const Phrase& phrase) {
        std::size_t sum = 0;
        for (const std::string_view word : phrase.words) {
            sum += word.size();
        }
        return sum;
    };
    std::stable_sort(phrases.begin(), phrases.end(), [&](const Phrase& a, const Phrase& b) {
        return a.words.size() != b.words.size() ? a.words.size() > b.words.size() : letters(a) > letters(b);
    });
    return phrases;
}

/// The words of a name in lower case.
std::vector<std::string> wordsOf(std::string_view name)
{
    std::vector<std::string> words(1);
    bool wasSmall = false;
    for (const char c : name) {
        const bool isCapital = c >= 'A' && c <= 'Z', isSmall = c >= 'a' && c <= 'z';
        const bool isOther = (static_cast<unsigned char>(c) & 0x80U) != 0; // non-ASCII letter
        if (!words.back().empty() && ((isCapital && wasSmall) || (!isCapital && !isSmall && !isOther))) {
            words.emplace_back();
        }
        if (isCapital || isSmall || isOther) {
            words.back() += isCapital ? static_cast<char>(c - 'A' + 'a') : c;
        }
        wasSmall = isSmall;
    }
    return words;
}

/// @param word  of a name, which may be the plural; @param singular  of the table
bool isWord(std::string_view word, std::string_view singular)
{
    return word.starts_with(singular) && (word.size() == singular.size() || word.substr(singular.size()) == "s" ||
                                          word.substr(singular.size()) == "es");
}

} // namespace

const AnatomyWords* internal::anatomyWords(std::string_view name)
{
    static const std::vector<Phrase> phrases = makePhrases();
    std::vector<std::string> words = wordsOf(name);
    const AnatomyWords* best = nullptr;
    for (const Phrase& phrase : phrases) {
        const std::size_t length = phrase.words.size();
        for (std::size_t at = 0; at + length <= words.size(); ++at) {
            const auto first = words.begin() + static_cast<std::ptrdiff_t>(at);
            if (!std::equal(phrase.words.begin(), phrase.words.end(), first,
                            [](std::string_view singular, std::string_view word) { return isWord(word, singular); })) {
                continue;
            }
            std::for_each_n(first, length, [](std::string& word) { word.clear(); }); // each word counts once
            const AnatomyKind kind = phrase.group->kind;
            if (kind != AnatomyKind::Other && (best == nullptr || kind < best->kind)) {
                best = phrase.group;
            }
        }
    }
    return best;
}

AnatomyKind anatomyKind(std::string_view name)
{
    const AnatomyWords* words = internal::anatomyWords(name);
    return words != nullptr ? words->kind : AnatomyKind::Other;
}

} // namespace palpate::meshio
