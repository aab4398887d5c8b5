#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the picture of doc/navigation.md from what benchmark/navigation/drive.py --trace has written.

usage: navigation_picture.py MAP.yaml TRACE.csv OUT.png

Grey: the lead that the robot set out on; red: the door that was closed meanwhile; blue: what it drove.
Needs OpenCV, numpy and PyYAML.
"""
import csv
import os
import sys

SCALE = 2  # of the picture
MARGIN = 20  # around what is shown [px of the map]
COLOURS = {'lead': (150, 150, 150), 'driven': (200, 90, 0), 'door': (40, 40, 220)}  # BGR
WIDTHS = {'lead': 2, 'driven': 3, 'door': 6}


def main():
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 64
    import cv2
    import numpy
    import yaml
    with open(sys.argv[1]) as file:
        info = yaml.safe_load(file)
    image = cv2.imread(os.path.join(os.path.dirname(sys.argv[1]), info['image']), cv2.IMREAD_GRAYSCALE)
    lines = {name: [] for name in ('lead', 'driven', 'door')}  # in the order they are drawn
    with open(sys.argv[2]) as file:
        for name, x, y in csv.reader(file):
            lines[name].append(((float(x) - info['origin'][0]) / info['resolution'],
                                image.shape[0] - (float(y) - info['origin'][1]) / info['resolution']))
    picture = cv2.cvtColor(image, cv2.COLOR_GRAY2BGR)
    picture = cv2.resize(picture, None, fx=SCALE, fy=SCALE, interpolation=cv2.INTER_NEAREST)
    for name, points in lines.items():
        line = numpy.round(numpy.array(points) * SCALE).astype(numpy.int32)
        cv2.polylines(picture, [line], False, COLOURS[name], WIDTHS[name], cv2.LINE_AA)
    start = tuple(int(SCALE * value) for value in lines['driven'][0])
    cv2.circle(picture, start, 7, COLOURS['driven'], -1, cv2.LINE_AA)
    everything = numpy.array(sum(lines.values(), []))
    low = numpy.maximum(everything.min(axis=0) - MARGIN, 0).astype(int) * SCALE
    high = (everything.max(axis=0) + MARGIN).astype(int) * SCALE
    return 0 if cv2.imwrite(sys.argv[3], picture[low[1]:high[1], low[0]:high[0]]) else 1


if __name__ == '__main__':
    sys.exit(main())
