// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/EngineTexts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <vector>

namespace palpate::ui {

namespace {

/// Allowed content of places that hold no part.
enum class Holds
{
    Numbers,
    Names, ///< also numbers or known words
};

/// Sentence or part of a sentence with places %1, %2 … for names, numbers and parts.
struct Template
{
    const char* english;
    unsigned parts; ///< bit i: place i + 1 holds a part that must be a known template
    Holds holds;
};

// General patterns come last, because the first match is used.
constexpr Template kTemplates[] = {
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1: %2: this version does not know this field; it is kept, but not used"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file is empty"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a web page (HTML), perhaps a failed download"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the content is no known mesh format"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "is %1, which Palpate does not read"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a glTF file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a ZIP archive"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a gzip file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a PNG image"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a PDF document"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an SQLite database (a recording?)"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a DICOM file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an %1 mesh"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an %1 mesh: save it as one of these"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a readable file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a mesh file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "is a folder"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "is not a regular file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "cannot be opened"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "cannot be read"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "cannot be written"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "cannot be written: %1; choose another folder"), 0b1, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "No such file or directory"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "Permission denied"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "Read-only file system"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "No space left on device"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "Is a directory"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "File too large"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "Disk quota exceeded"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "Input/output error"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "Not a directory"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "File name too long"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "not a file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP(
         "palpate::ui::Engine",
         "the touched surface goes there; found another file, expected none or an older export. Choose another name"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the disk is full"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no memory to read it"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "not enough memory to read it"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a mesh that fits"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file became shorter while it was read"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a folder without mesh files"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 files in it"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the folder cannot be read: %1"), 0b1, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a folder of meshes"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no such file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "none of %1 triangle has an area"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "none of %1 triangles has an area"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "at least one that has"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "at least one"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "0 triangles"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "0 faces"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "0 polygons and strips"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 triangle"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 triangles"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 point"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 points"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 byte"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 bytes"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 whole triangle"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 whole triangles"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 polygon"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 polygons"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 face"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 faces"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 corner"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 corners"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 to %2"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 of %2 have coordinates that are not numbers"), 0b10, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 of %2 have coordinates that are farther than 10 km from the origin"),
     0b10, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 of %2 have coordinates that are not numbers (first: triangle %3)"),
     0b10, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 of %2 have coordinates that are farther than 10 km from the origin (first: triangle %3)"),
     0b10, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "finite coordinates within 10 km"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file ends in the STL header"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file ends in the header"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "at least %1 bytes"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "at most %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the binary STL declares %1 but its %2 hold %3"), 0b11, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file ends there: %1 of %2 lost"), 0b10, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file ends after %1"), 0b1, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "what came after %1 lost"), 0b1, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file ends in a line: that line and what came after it lost"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "too many elements"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 elements declared"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 is not a number"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "three numbers"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the vertex has fewer than three coordinates"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "it uses point %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no faces with a list of vertex indices"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no vertices with x, y and z"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "one of each"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "vertex index %1 (%2 vertices so far)"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "face %1 uses vertex %2"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a zero byte"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "text"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the end of the line"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the XML is broken: %1"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "well-formed XML to the end"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "its mesh is larger than %1 MiB"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a mesh that fits its file's size"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "reading it takes more than %1 MiB of memory"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "reading it took more than %1 s"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "reading it took more than %1 s of processor time"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a mesh that can be read sooner"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the system ended the process that read it, perhaps for want of memory"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "its volume is larger than %1 MiB"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a volume that fits its file's size"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a volume that fits"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a volume that can be read sooner"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the process that read it gave up (exit code %1)"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "reading was cancelled"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a volume"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a readable volume"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "it does not end"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a header that says where the voxels are"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "it does not end with its last tag"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "`</VTKFile>` at the end"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "its compressed voxels are cut off or broken"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 bytes when unpacked"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 bytes of voxels"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 voxels declared"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "as many as its %1 bytes can hold"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an axis without a voxel"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "at least one along each axis"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 components a voxel"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no numbers"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "one number for each voxel"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "axes or distances of its voxels that say no place"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "three directions that are not in a plane, and distances that are not 0"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "directions of its axes that can't be read"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "three vectors that are not in a plane"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 twice"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "each field once"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no dimension before them"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a dimension"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "three counts of voxels"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the name of one file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no header of NIfTI"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "348 or 540 bytes of it"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "voxels of kind %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "one of NIfTI's kinds, as 16 for float"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 axes"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "1 to 7"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a byte of 0 in its text"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a header of text alone"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "what is not one number"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 dimension"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 dimensions"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "1 to 4"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "value %1 is %2"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a number that an Int32 can hold"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a number that a %1 can hold"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a blank or a new line behind it"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "voxels in another encoding"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "`raw` or `gzip`"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the process that read it crashed (%1)"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a file that can be read"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no structure %1"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "one of that name"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 open edge: the surface has holes or a rim"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 open edges: the surface has holes or a rim"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 triangle without area left out"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 triangles without area left out"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 duplicate triangle left out"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 duplicate triangles left out"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 triangle turned round to face the same way as the rest"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 triangles turned round to face the same way as the rest"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 edge shared by more than two triangles"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 edges shared by more than two triangles"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 part without a consistent front"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 parts without a consistent front"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 part without an inside, touched from both sides"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 parts without an inside, touched from both sides"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 closed part looks inside out: touched from within only, unless turned outwards"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 closed parts look inside out: touched from within only, unless turned outwards"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP(
         "palpate::ui::Engine",
         "%1 values of arrays differed by more than 10 % from another at the same vertex: the mean is used"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "staircase of about %1 × %2 × %3 mm voxels (%4 % of the area in %5 directions)"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: "
                                              "volume changed by %5 %, at most %6 mm from the voxel boundary"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP(
         "palpate::ui::Engine",
         "surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: at most %5 mm from the voxel boundary"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "surface from a label map of %1 × %2 × %3 mm voxels, with its steps"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "surface from a label map of %1 × %2 × %3 mm voxels, not smoothed: too "
                                              "small, it would lose more than half of its volume"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "not smoothed: too small, it would lose more than half of its volume"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "structures of only a few voxels, whose shape is uncertain: %1"), 0b0,
     Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no voxels of %1"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "names and colours from the ITK-SNAP label description %1"), 0b0,
     Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the file has no names: names by the numbers of %1, check them"), 0b0,
     Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "left out: %1: %2"), 0b10, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "smoothed: vertices moved by at most %1 mm, volume %2 %"), 0b0,
     Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "smoothed: vertices moved by at most %1 mm"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "surface \"smooth\": curved facets are not available in this version; "
                                              "felt and drawn as facets"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 and %2 come within %3 mm of each other at (%4, %5, %6) without touching: a point falls into "
                       "the gap, a fingertip of 0.5 mm or more rides over it"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 and %2 touch in one layer and differ %3-fold in stiffness: the force steps at the seam"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no SPACE tag: coordinates taken as LPS"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 and %2 more file"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 and %2 more files"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "tagged SPACE=RAS: x and y negated to get LPS"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "tagged SPACE=%1, but taken as %2, as was chosen"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "taken as %1, as the scene file says; not as %2"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "only %1 units wide, taken as %2; looks like %3: open with --unit %4"),
     0b110, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 units wide, taken as %2; looks like %3: open with --unit %4"), 0b110,
     Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "metres"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "millimetres"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "larger ones"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 and %2 are the same surface twice"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 lies in %2 and is felt below it"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 lies in %2, which is felt in the last of %3 layers: both are felt in that one"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "%1 seems to lie in %2, whose surface is open or inside out: it is not felt below it"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "colours not read: those of its %1"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "changed since the scene was saved: found SHA-256 %1, expected %2; opened as it is now"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "is a list of 3D Slicer marks, not a Palpate scene: open the anatomy, "
                                              "then take the marks in with File > Import findings"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "is not a Palpate scene: found neither `version` nor `structures`; "
                                              "expected a file that Palpate saved (.palpate.json)"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "version: found %1, expected at most %2: it was made by a newer Palpate"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no JSON object"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a scene as a JSON object"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an array"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an object"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a text"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a number"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "true or false"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "an array of %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 numbers"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a whole number"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "a fraction"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "nothing"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "none"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the path of a mesh file"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the path of a recording"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the name of a structure of this scene"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "one of %1"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "found none of the surfaces that it was made on"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "it holds none and names no mesh"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "no such file, neither where it was nor beside the recording"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "is another surface now than was recorded; opened as it is now"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "its recorded map is of another surface; it is not felt"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "what lumps below it made is of another surface; it is not felt"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "the recording does not say what scene it was made on"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "lumps felt through their organ: %1"), 0b1, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "left out, its surface is open: it has no volume to be felt"), 0b0,
     Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "left out, its surface is inside out"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "left out, it lies outside %1"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine",
                       "how many times as stiff as %1 it is, is not known, so no verdict is given; expected a ratio, "
                       "as --ratio \"%2=R\" or `young_ratio` in a scene file. Published: %3"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 and %2 reach into each other: where both are felt is not judged"),
     0b0, Holds::Names},
    {QT_TRANSLATE_NOOP(
         "palpate::ui::Engine",
         "its triangles are wider than a finger's contact: what the hand feels of its lumps differs by up "
         "to %1 % from what is shown; a finer mesh mends it"),
     0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 was read as %2"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 or %2"), 0b0, Holds::Names},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "line %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "byte %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "polygon %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "point %1"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "header"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "structures"), 0b0, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1; expected %2"), 0b11, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "found %1, expected %2"), 0b11, Holds::Numbers},
    {QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1: %2"), 0b10, Holds::Names},
};

QString translated(const char* english)
{
    return QCoreApplication::translate("palpate::ui::Engine", english);
}

struct Pattern
{
    const Template* sentence;
    QRegularExpression expression;
};

const std::vector<Pattern>& patterns()
{
    static const std::vector<Pattern> kAll = [] {
        std::vector<Pattern> all;
        static const QRegularExpression place(QStringLiteral("%\\d"));
        for (const Template& one : kTemplates) {
            const QStringList words = QString::fromUtf8(one.english).split(place);
            QString expression = QRegularExpression::escape(words.front());
            for (qsizetype i = 1; i < words.size(); ++i) {
                const bool isPart = (one.parts & (1U << (i - 1))) != 0;
                expression += isPart                        ? QStringLiteral("(.+?)")
                              : one.holds == Holds::Numbers ? QStringLiteral("(-?[\\d.,]+)")
                                                            : QStringLiteral("((?:(?!: |; ).)+?)");
                expression += QRegularExpression::escape(words[i]);
            }
            all.push_back({&one, QRegularExpression(QRegularExpression::anchoredPattern(expression))});
        }
        return all;
    }();
    return kAll;
}

/// Formats a number for the window's locale; other text is returned unchanged.
QString withNumber(const QString& text)
{
    static const QRegularExpression number(QStringLiteral("\\d{1,3}(,\\d{3})+|\\d+\\.\\d+"));
    if (!number.match(text, 0, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption)
             .hasMatch() ||
        text != number.match(text).captured()) {
        return text;
    }
    return text.contains(QLatin1Char('.')) ? QString(text).replace(QLatin1Char('.'), QLocale().decimalPoint())
                                           : QLocale().toString(QString(text).remove(QLatin1Char(',')).toLongLong());
}

/// True for text that needs no translation: a quoted name or a single word.
bool isName(const QString& text)
{
    return (text.startsWith(QLatin1Char('"')) && text.endsWith(QLatin1Char('"'))) || !text.contains(QLatin1Char(' '));
}

/// Translates a text by the first matching template; empty if the text or a required part is unknown.
std::optional<QString> find(const QString& text)
{
    for (const Pattern& pattern : patterns()) {
        const QRegularExpressionMatch match = pattern.expression.match(text);
        if (!match.hasMatch()) {
            continue;
        }
        QString out = translated(pattern.sentence->english);
        bool isKnown = true;
        for (int i = match.lastCapturedIndex(); i > 0 && isKnown; --i) {
            const QString held = match.captured(i);
            const std::optional<QString> part = find(held);
            isKnown = part || (pattern.sentence->parts & (1U << (i - 1))) == 0 || isName(held);
            // Not with arg(): the inserted text may contain a percent sign followed by a digit.
            out.replace(QLatin1Char('%') + QString::number(i), part.value_or(withNumber(held)));
        }
        if (isKnown) {
            return out;
        }
    }
    return std::nullopt;
}

} // namespace

QString engineText(std::string_view line)
{
    const QString text = QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size()));
    //: around a line that has no translation
    const char* const unknown = QT_TRANSLATE_NOOP("palpate::ui::Engine", "%1 (in English)");
    const QString untranslated = translated(unknown);
    if (text.isEmpty() || untranslated == QLatin1String(unknown)) {
        return text; // English window
    }
    const std::optional<QString> found = find(text);
    return found ? *found : QString(untranslated).replace(QStringLiteral("%1"), text);
}

} // namespace palpate::ui
