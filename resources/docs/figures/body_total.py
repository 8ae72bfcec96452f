#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""body_total.py FILE.nii.gz   writes a schematic body as a label map with the 117 numbers of TotalSegmentator 2.

For the picture of opening-files.md, and to try the list of structures. Every structure is a chain of balls; nothing is
of a person. x to the right of the patient, y to the back, z to the head, in mm, as voxels of 2 mm.
"""
import gzip
import math
import struct
import sys

STEP = 2.0
LOW, SIZE = (-210.0, -120.0, -180.0), (210, 120, 440)


def both(name, right, radius):
    """The structure of the right side, and its mirror image on the left."""
    left = [(-x, y, z) for x, y, z in right]
    return {name + "_right": (right, radius), name + "_left": (left, radius)}


def rib(number, side):
    z = 470.0 - 22.0 * number
    width, depth = 95.0 + 5.0 * min(number, 8), 70.0
    end = 200 if number <= 7 else 290 - 10 * number
    angles = [math.radians(a) for a in range(0, max(end, 60), 2)]
    return [(side * width * math.sin(a * 0.9), 60.0 - depth + depth * math.cos(a * 0.9), z - 25.0 * a) for a in angles]


def structures():
    spine = ["S1"] + ["L%d" % i for i in range(5, 0, -1)] + ["T%d" % i for i in range(12, 0, -1)] + ["C%d" % i for i in range(7, 0, -1)]
    s = {}
    for i, name in enumerate(spine):
        small = name[0] == "C"
        z = 12.0 + 25.0 * i if not small else 12.0 + 25.0 * 17 + 14.0 * (i - 17)
        s["vertebrae_" + name] = ([(0, 62 if not small else 50, z)], 11 if not small else 6.5)
    s["sacrum"] = ([(0, 70, z) for z in (-50, -35, -20)], 16)
    s["spinal_cord"] = ([(0, 82 if z < 440 else 66, z) for z in range(20, 530, 6)], 5)
    for number in range(1, 13):
        s["rib_right_%d" % number] = (rib(number, 1), 5)
        s["rib_left_%d" % number] = (rib(number, -1), 5)
    s["sternum"] = ([(0, -78, z) for z in range(290, 420, 8)], 9)
    s["costal_cartilages"] = ([(side * (15 + 1.5 * i), -78 + 0.6 * i, 300 + 12 * k - i) for side in (1, -1) for k in range(9) for i in range(0, 30, 2)], 4)
    s.update(both("clavicula", [(20 + 5 * i, -60 + 2 * i, 430 + 0.5 * i) for i in range(24)], 6))
    s.update(both("scapula", [(105 - 0.5 * i, 70, 330 + 5 * i) for i in range(18)], 9))
    s.update(both("humerus", [(158, 30, 200 + 5 * i) for i in range(42)], 11))
    s.update(both("hip", [(45 + 60 * math.sin(a / 10), 30 + 25 * math.cos(a / 10), -70 + 8 * a) for a in range(14)], 15))
    s.update(both("femur", [(105 - 0.6 * i, 20, -90 - 5 * i) for i in range(17)] + [(85, 20, -72)], 14))
    s["skull"] = ([(70 * math.cos(a) * math.cos(b), 20 + 82 * math.sin(a) * math.cos(b), 615 + 72 * math.sin(b)) for b in [i * 0.05 - 0.7 for i in range(43)] for a in [j * 0.05 for j in range(126)]], 5)
    s["brain"] = ([(18 * x, 20 + 22 * y, 610 + 14 * z) for x in (-1, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)], 33)
    s["lung_upper_lobe_right"] = ([(60, 0, 350 + 10 * i) for i in range(6)], 36)
    s["lung_middle_lobe_right"] = ([(66, -30, 300)], 30)
    s["lung_lower_lobe_right"] = ([(66, 30, 250 + 10 * i) for i in range(7)], 34)
    s["lung_upper_lobe_left"] = ([(-62, -8, 320 + 10 * i) for i in range(9)], 36)
    s["lung_lower_lobe_left"] = ([(-66, 30, 250 + 10 * i) for i in range(6)], 34)
    s["heart"] = ([(-12 - 4 * i, -38, 300 - 6 * i) for i in range(7)], 33)
    s["atrial_appendage_left"] = ([(-34, -32, 336)], 8)
    s["liver"] = ([(70 - 16 * i, -8 - 3 * i, 190 + 3 * i) for i in range(7)], 44)
    s["gallbladder"] = ([(38, -58, 148 + 4 * i) for i in range(5)], 11)
    s["spleen"] = ([(-86, 30, 180 + 6 * i) for i in range(7)], 22)
    s["stomach"] = ([(-30 - 30 * math.sin(i / 4), -40, 150 + 9 * i) for i in range(9)], 22)
    s["pancreas"] = ([(24 - 9 * i, -5 + 2 * i, 138 + 2 * i) for i in range(10)], 10)
    s["duodenum"] = ([(34 + 10 * math.cos(a), -12, 122 + 22 * math.sin(a)) for a in [i / 4 for i in range(14)]], 9)
    s["small_bowel"] = ([(30 * math.sin(i / 3), -40 + 14 * math.cos(i / 5), 20 + 1.6 * i) for i in range(55)], 13)
    s["colon"] = ([(88, -10, -10 + 8 * i) for i in range(16)] + [(88 - 8 * i, -52, 122) for i in range(22)] + [(-88, -4, 120 - 8 * i) for i in range(18)], 14)
    s.update(both("kidney", [(52, 45, 90 + 6 * i) for i in range(9)], 20))
    s.update(both("kidney_cyst", [(76, 50, 112)], 9))
    s.update(both("adrenal_gland", [(38, 42, 166 + 3 * i) for i in range(4)], 6))
    s["urinary_bladder"] = ([(0, -35, -70)], 30)
    s["prostate"] = ([(0, -22, -112)], 16)
    s["esophagus"] = ([(-6, 38, 200 + 5 * i) for i in range(50)], 7)
    s["trachea"] = ([(0, 12, 350 + 5 * i) for i in range(24)], 9)
    s["thyroid_gland"] = ([(x, -6, 462) for x in (-14, -7, 7, 14)], 8)
    s["aorta"] = ([(-8, 44 - 2, 5 + 6 * i) for i in range(57)] + [(-8 + 8 * math.sin(a), 2 + 38 * math.cos(a), 346 + 28 * math.sin(a)) for a in [i / 8 for i in range(25)]], 10)
    s["inferior_vena_cava"] = ([(16, 40, 5 + 6 * i) for i in range(42)], 9)
    s["superior_vena_cava"] = ([(22, -8, 320 + 6 * i) for i in range(12)], 8)
    s["portal_vein_and_splenic_vein"] = ([(30 - 9 * i, 12 + 2 * i, 152 + 3 * i) for i in range(12)], 6)
    s["pulmonary_vein"] = ([(x, 4, 322) for x in range(-50, 56, 6)], 7)
    s["brachiocephalic_trunk"] = ([(4 + i, -20, 380 + 4 * i) for i in range(9)], 6)
    s["brachiocephalic_vein_right"] = ([(22 + i, -24, 392 + 4 * i) for i in range(8)], 6)
    s["brachiocephalic_vein_left"] = ([(16 - 5 * i, -30, 392 + 2 * i) for i in range(12)], 6)
    s.update(both("subclavian_artery", [(18 + 5 * i, -14, 416 + 4 * math.sin(i / 6)) for i in range(20)], 5))
    s.update(both("common_carotid_artery", [(17, -6, 424 + 5 * i) for i in range(17)], 5))
    s.update(both("iliac_artery", [(6 + 3 * i, 30 - 2 * i, 2 - 6 * i) for i in range(14)], 6))
    s.update(both("iliac_vena", [(16 + 3 * i, 42 - 2 * i, 2 - 6 * i) for i in range(14)], 6))
    s.update(both("iliopsoas", [(40 + 2 * i, 42 - 2 * i, 90 - 9 * i) for i in range(21)], 12))
    s.update(both("autochthon", [(24, 88, 0 + 9 * i) for i in range(48)], 14))
    s.update(both("gluteus_maximus", [(60 + 2 * i, 88, -20 - 8 * i) for i in range(10)], 22))
    s.update(both("gluteus_medius", [(108, 46, -50 + 7 * i) for i in range(10)], 14))
    s.update(both("gluteus_minimus", [(124, 20, -52 + 7 * i) for i in range(7)], 9))
    return s


NAMES = """spleen kidney_right kidney_left gallbladder liver stomach pancreas adrenal_gland_right adrenal_gland_left
lung_upper_lobe_left lung_lower_lobe_left lung_upper_lobe_right lung_middle_lobe_right lung_lower_lobe_right esophagus
trachea thyroid_gland small_bowel duodenum colon urinary_bladder prostate kidney_cyst_left kidney_cyst_right sacrum
vertebrae_S1 {L} {T} {C} heart aorta pulmonary_vein brachiocephalic_trunk subclavian_artery_right subclavian_artery_left
common_carotid_artery_right common_carotid_artery_left brachiocephalic_vein_left brachiocephalic_vein_right
atrial_appendage_left superior_vena_cava inferior_vena_cava portal_vein_and_splenic_vein iliac_artery_left
iliac_artery_right iliac_vena_left iliac_vena_right humerus_left humerus_right scapula_left scapula_right clavicula_left
clavicula_right femur_left femur_right hip_left hip_right spinal_cord gluteus_maximus_left gluteus_maximus_right
gluteus_medius_left gluteus_medius_right gluteus_minimus_left gluteus_minimus_right autochthon_left autochthon_right
iliopsoas_left iliopsoas_right brain skull {l} {r} sternum costal_cartilages""".format(
    L=" ".join("vertebrae_L%d" % i for i in range(5, 0, -1)),
    T=" ".join("vertebrae_T%d" % i for i in range(12, 0, -1)),
    C=" ".join("vertebrae_C%d" % i for i in range(7, 0, -1)),
    l=" ".join("rib_left_%d" % i for i in range(1, 13)),
    r=" ".join("rib_right_%d" % i for i in range(1, 13))).split()


def paint(voxels, balls, radius, label):
    for centre in balls:
        low = [max(0, math.ceil((c - radius - o) / STEP)) for c, o in zip(centre, LOW)]
        high = [min(n - 1, math.floor((c + radius - o) / STEP)) for c, o, n in zip(centre, LOW, SIZE)]
        for k in range(low[2], high[2] + 1):
            for j in range(low[1], high[1] + 1):
                left = radius ** 2 - (LOW[2] + STEP * k - centre[2]) ** 2 - (LOW[1] + STEP * j - centre[1]) ** 2
                if left > 0:
                    half = math.sqrt(left)
                    first = max(0, math.ceil((centre[0] - half - LOW[0]) / STEP))
                    last = min(SIZE[0] - 1, math.floor((centre[0] + half - LOW[0]) / STEP))
                    if last >= first:
                        at = first + SIZE[0] * (j + SIZE[1] * k)
                        voxels[at:at + last - first + 1] = bytes([label]) * (last - first + 1)


def header():
    h = bytearray(352)
    struct.pack_into("<i", h, 0, 348)
    struct.pack_into("<8h", h, 40, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<hh", h, 70, 2, 8)  # bytes
    struct.pack_into("<8f", h, 76, 1, STEP, STEP, STEP, 1, 1, 1, 1)
    struct.pack_into("<f", h, 108, 352)
    struct.pack_into("<h", h, 254, 1)  # coordinates of the scanner: x to the right, y to the front
    struct.pack_into("<12f", h, 280, STEP, 0, 0, LOW[0], 0, -STEP, 0, -LOW[1], 0, 0, STEP, LOW[2])
    h[344:348] = b"n+1\0"
    return h


def main():
    drawn = structures()
    assert len(NAMES) == 117 and set(NAMES) == set(drawn), set(NAMES) ^ set(drawn)
    voxels = bytearray(SIZE[0] * SIZE[1] * SIZE[2])
    # Bones and small structures last, so that they stay whole.
    for name in sorted(NAMES, key=lambda n: -drawn[n][1]):
        paint(voxels, *drawn[name], NAMES.index(name) + 1)
    assert set(voxels) == set(range(118)), "a structure is covered by others"
    with gzip.GzipFile(sys.argv[1], "wb", 6, mtime=0) as out:
        out.write(header())
        out.write(voxels)


if __name__ == "__main__":
    main()
