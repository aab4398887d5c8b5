#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the picture of doc/planning.md: how a path is found in a drawn office.

usage: planning_picture.py TOOL OUT.png

TOOL is agrid_map_tool. Areas in colours, the borders between them cut into portals (bars with their middles),
turning points (dots), and a road through the portals' middles beside the path. Needs OpenCV, numpy and scipy.
"""
import csv
import os
import subprocess
import sys
import tempfile

SCALE = 6  # of the picture
START, GOAL = (60, 95), (265, 270)  # px
LEFT, TOP, RIGHT, BOTTOM = 45, 80, 285, 285  # of what is shown [px]
RADIUS = 0.2  # m
RESOLUTION = 0.05  # m a pixel, of the office
SHORTEST, LONGEST, PARTS = 3, 12, 16  # of portals, as in src/planning/portal_runs.cpp
COLOURS = [(197, 227, 246), (210, 234, 215), (243, 227, 213), (236, 217, 236), (212, 217, 243), (203, 236, 239)]  # BGR
BAR, DOT, BEFORE, AFTER = (60, 60, 220), (110, 70, 30), (130, 130, 130), (210, 100, 0)


def run(*words):
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def read(tool, folder, start, goal):
    """labels of the pixels, which are free for the robot, which are wall, and a path [px]; rows from the top"""
    import cv2
    import numpy as np
    from scipy.ndimage import distance_transform_edt
    office = os.path.join(folder, 'office')
    run(tool, 'generate', '--size', '300', '--seed', '7', '-o', office)
    yaml = os.path.join(office, 'office.yaml')
    run(tool, 'convert', yaml, '-o', os.path.join(folder, 'stages'))
    labels = cv2.imread(os.path.join(folder, 'stages', 'labels.png'), cv2.IMREAD_UNCHANGED)
    grey = cv2.imread(os.path.join(office, 'office.pgm'), cv2.IMREAD_GRAYSCALE)
    free = distance_transform_edt(grey > 250) > RADIUS / RESOLUTION
    free[[0, -1]] = free[:, [0, -1]] = False
    start, goal = (min(np.argwhere(free), key=lambda p: np.hypot(p[1] - x, p[0] - y))[::-1] for x, y in (start, goal))
    pairs = os.path.join(folder, 'pairs.csv')
    with open(pairs, 'w') as file:
        file.write('id,start_x_px,start_y_px,goal_x_px,goal_y_px\n0,%g,%g,%g,%g\n' % (*start, *goal))
    run(tool, 'plan', yaml, '--pairs', pairs, '-o', os.path.join(folder, 'out.csv'), '--robot-radius', str(RADIUS),
        '--paths', os.path.join(folder, 'paths'))
    with open(os.path.join(folder, 'paths', '0.csv')) as file:
        path = [(float(row['x_px']), float(row['y_px'])) for row in csv.DictReader(file)]
    return labels, free, grey < 100, path


def turning_points(free):
    """corners of which one of four pixels is not free, in pixels"""
    rows, columns = free.shape
    return [(x - 0.5, y - 0.5) for y in range(1, rows) for x in range(1, columns)
            if free[y - 1:y + 1, x - 1:x + 1].sum() == 3]


def portals(labels, free):
    """[(pieces of border, middle)]: runs of neighbouring free pixels of two areas, cut into parts"""
    runs = {}
    rows, columns = free.shape
    for y in range(rows - 1):
        for x in range(columns - 1):
            for dx, dy in ((1, 0), (0, 1)):
                a, b = labels[y, x], labels[y + dy, x + dx]
                if a == b or not free[y, x] or not free[y + dy, x + dx]:
                    continue
                piece = (x + dx / 2, y + dy / 2, dx)
                group = runs.setdefault((min(a, b), max(a, b)), [])
                near = [run for run in group if any(abs(p[0] - piece[0]) + abs(p[1] - piece[1]) <= 1.5 for p in run)]
                joined = [piece] + [p for run in near for p in run]
                runs[min(a, b), max(a, b)] = [run for run in group if run not in near] + [joined]
    found = []
    for run in (run for group in runs.values() for run in group):
        run.sort()
        side = min(max(-(-len(run) // PARTS), SHORTEST), LONGEST)
        for k in range(0, len(run), side):
            part = run[k:k + side]
            found.append((part, part[len(part) // 2][:2]))
    return found


def crossed(path, found):
    """the path with the middles of the portals that it crosses, in order: the road before it is pulled taut"""
    road = []
    for a, b in zip(path, path[1:]):
        road.append((0, a) if not road else (len(road), a))
        hits = []
        for part, middle in found:
            for x, y, across in part:
                d = (b[0] - a[0], b[1] - a[1])
                step, off = (d[0], x - a[0]) if across else (d[1], y - a[1])
                t = off / step if step else -1
                miss = a[1] + t * d[1] - y if across else a[0] + t * d[0] - x
                if 0 <= t <= 1 and abs(miss) <= 0.5:
                    hits.append((t, middle))
                    break
        road += sorted(hits)
    return [point for _, point in road] + [path[-1]]


def picture(labels, free, wall, path):
    import cv2
    import numpy as np
    image = np.full((*labels.shape, 3), 255, np.uint8)
    palette = np.array(COLOURS, np.uint8)
    inside = labels > 0
    image[inside] = palette[labels[inside] % len(COLOURS)]
    image[inside & ~free] = image[inside & ~free] * 0.88
    image[wall] = 50
    image = cv2.resize(image, None, fx=SCALE, fy=SCALE, interpolation=cv2.INTER_NEAREST)

    def at(point):
        return tuple(round((value + 0.5) * SCALE) for value in point)

    found = portals(labels, free)
    for part, middle in found:
        for x, y, across in part:
            ends = ((x, y - .5), (x, y + .5)) if across else ((x - .5, y), (x + .5, y))
            cv2.line(image, at(ends[0]), at(ends[1]), BAR, 2, cv2.LINE_AA)
        cv2.circle(image, at(middle), 3, BAR, -1, cv2.LINE_AA)
    for point in turning_points(free):
        cv2.circle(image, at(point), 2, DOT, -1, cv2.LINE_AA)
    for points, colour, thickness in ((crossed(path, found), BEFORE, 2), (path, AFTER, 2)):
        cv2.polylines(image, [np.array([at(point) for point in points])], False, colour, thickness, cv2.LINE_AA)
    for point in (path[0], path[-1]):
        cv2.circle(image, at(point), 7, AFTER, -1, cv2.LINE_AA)
    return image[TOP * SCALE:BOTTOM * SCALE, LEFT * SCALE:RIGHT * SCALE]


def main(tool, target):
    import cv2
    with tempfile.TemporaryDirectory() as folder:
        image = picture(*read(tool, folder, START, GOAL))
    cv2.imwrite(target, image, [cv2.IMWRITE_PNG_COMPRESSION, 9])


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
