#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the answers of `agrid_map_tool plan` against the image itself, sharing no code with it.

usage: check_paths.py MAP.png PAIRS.csv OUT.csv PATHS_DIR [RADIUS_PX] [FREE_GREY]

A pixel may be crossed if its centre is more than RADIUS_PX (4) from the centre of the nearest pixel
darker than FREE_GREY (250) and it does not lie on the outermost ring. Every segment is checked
against every pixel whose closed square it touches. Prints the figures; exit code 1 if an answer is false.
"""
import csv
import os
import sys

import cv2
import numpy
from scipy import ndimage

HAIR = 1e-7  # px; coordinates come as text with nine decimals


def crossable_pixels(path, radius_px, free_grey):
    image = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
    blocked = image < free_grey
    nearest = ndimage.distance_transform_edt(~blocked, return_distances=False, return_indices=True)
    rows, columns = numpy.indices(blocked.shape)
    squared = (nearest[0] - rows) ** 2 + (nearest[1] - columns) ** 2
    free = squared > radius_px ** 2
    free[[0, -1], :] = False
    free[:, [0, -1]] = False
    return free


def touched_pixels(a, b):
    """Columns and rows of all pixels whose closed squares the segment touches, each tried."""
    low = numpy.floor(numpy.minimum(a, b) - 0.5 - HAIR).astype(int)
    high = numpy.ceil(numpy.maximum(a, b) + 0.5 + HAIR).astype(int)
    xs, ys = numpy.meshgrid(numpy.arange(low[0], high[0] + 1), numpy.arange(low[1], high[1] + 1))
    enter = numpy.zeros(xs.shape)
    leave = numpy.ones(xs.shape)
    inside = numpy.ones(xs.shape, bool)
    for centre, start, step in ((xs, a[0], b[0] - a[0]), (ys, a[1], b[1] - a[1])):
        if step == 0:
            inside &= numpy.abs(centre - start) <= 0.5 + HAIR
            continue
        t = ((centre - 0.5 - HAIR - start) / step, (centre + 0.5 + HAIR - start) / step)
        enter = numpy.maximum(enter, numpy.minimum(*t))
        leave = numpy.minimum(leave, numpy.maximum(*t))
    inside &= enter <= leave
    return xs[inside], ys[inside]


def path_problem(free, corners, pair):
    ends = [[float(pair['start_x_px']), float(pair['start_y_px'])],
            [float(pair['goal_x_px']), float(pair['goal_y_px'])]]
    if numpy.abs(corners[[0, -1]] - ends).max() > 1e-3:
        return 'starts or ends elsewhere'
    for a, b in zip(corners[:-1], corners[1:]):
        xs, ys = touched_pixels(a, b)
        if not free[ys, xs].all():
            return 'touches a pixel that is not free between %s and %s' % (a, b)
    return None


def main():
    image, pairs_file, out_file, directory = sys.argv[1:5]
    radius_px = float(sys.argv[5]) if len(sys.argv) > 5 else 4.0
    free = crossable_pixels(image, radius_px, float(sys.argv[6]) if len(sys.argv) > 6 else 250)
    components, _ = ndimage.label(free)
    pairs = list(csv.DictReader(open(pairs_file)))
    rows = {row['id']: row for row in csv.DictReader(open(out_file))}
    wrong, ratios, times = [], [], []
    for pair in pairs:
        row = rows.get(pair['id'])
        s, g = (components[int(float(pair[k + '_y_px'])), int(float(pair[k + '_x_px']))]
                for k in ('start', 'goal'))
        if row is None or (row['status'] == 'SUCCESS') != bool(s and s == g):
            wrong.append((pair['id'], 'false answer', row and row['status']))
            continue
        times.append(float(row['milliseconds']))
        if row['status'] != 'SUCCESS':
            continue
        path = os.path.join(directory, pair['id'] + '.csv')
        corners = numpy.loadtxt(path, delimiter=',', skiprows=1, ndmin=2)
        length = numpy.linalg.norm(numpy.diff(corners, axis=0), axis=1).sum()
        problem = path_problem(free, corners, pair)
        if problem is None and abs(length - float(row['length_px'])) > 1e-3:
            problem = 'length %f, not %s' % (length, row['length_px'])
        if problem:
            wrong.append((pair['id'], problem))
        if float(pair.get('best_known_length_px') or 0) > 0:
            ratios.append(length / float(pair['best_known_length_px']))
    print('%s: %d pairs, %d found, %d wrong' % (os.path.basename(image), len(pairs), len(ratios),
                                                len(wrong)))
    if ratios:
        print('  length / best known: mean %.5f p95 %.5f max %.5f'
              % (numpy.mean(ratios), numpy.percentile(ratios, 95), max(ratios)))
        print('  milliseconds: median %.3f p95 %.3f max %.3f'
              % (numpy.median(times), numpy.percentile(times, 95), max(times)))
    for item in wrong[:20]:
        print('  WRONG', *item)
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
