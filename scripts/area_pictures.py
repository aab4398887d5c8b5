#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of doc/areas.md.

usage: area_pictures.py steps TOOL OUT.png               how one drawn office is divided
       area_pictures.py truth TOOL SEED OUT.png          areas of a drawn office beside its true rooms
       area_pictures.py reliability TOOL OUT.svg [NAME=MAPS]...   how often doors are true, by confidence

TOOL is agrid_map_tool, MAPS a folder for its command eval, NAME what the curve is called; one of twenty drawn
offices is always there. Its tables go to standard output. The first two need OpenCV and numpy (python3-opencv).
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

WALL, UNKNOWN = 100, 230  # map_saver writes 0, 205 and 254
DOOR, OPENED = (200, 60, 0), (0, 140, 255)  # BGR


def run(*words):
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def convert(tool, office, folder, *params):
    """labels of the pixels, borders as (area, area, (x1, y1, x2, y2)) in pixels"""
    import cv2
    run(tool, 'convert', os.path.join(office, 'office.yaml'), '-o', folder, *params)
    labels = cv2.imread(os.path.join(folder, 'labels.png'), cv2.IMREAD_UNCHANGED)
    with open(os.path.join(folder, 'graph.json')) as file:
        graph = json.load(file)
    number = {area['id']: k for k, area in enumerate(graph['areas'], 1)}
    doors = [door for door in graph['doors'] if 0 not in door['areas']]
    with open(os.path.join(folder, 'doors.csv')) as file:
        lines = [tuple(map(float, row)) for row in list(csv.reader(file))[1:]]
    return labels, [(number[door['areas'][0]], number[door['areas'][1]], line)
                    for door, line in zip(doors, lines)]


def colours(count):
    """colours that differ from number to number"""
    import cv2
    import numpy as np
    numbers = np.arange(count)
    hsv = np.stack([numbers * 67 % 180, 70 + numbers * 29 % 80, 225 + numbers * 17 % 30], axis=1)
    return cv2.cvtColor(hsv[None].astype('uint8'), cv2.COLOR_HSV2BGR)[0]


def paint(office, labels, palette):
    import cv2
    grey = cv2.imread(os.path.join(office, 'office.pgm'), cv2.IMREAD_GRAYSCALE)
    picture = cv2.cvtColor(grey, cv2.COLOR_GRAY2BGR)
    inside = (labels > 0) & (grey > UNKNOWN)
    picture[inside] = palette[labels[inside]]
    picture[grey < WALL] = 0
    return picture


def draw(picture, line, colour, scale):
    import cv2
    x1, y1, x2, y2 = (round((v + 0.5) * scale) for v in line)
    cv2.line(picture, (x1, y1), (x2, y2), colour, 4, cv2.LINE_AA)


def enlarged(picture, scale):
    import cv2
    return cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_NEAREST)


def beside(pictures, path):
    import cv2
    gap = 16
    framed = [cv2.copyMakeBorder(p, 0, 0, 0, gap, cv2.BORDER_CONSTANT, value=(255, 255, 255)) for p in pictures]
    cv2.imwrite(path, cv2.hconcat(framed)[:, :-gap])


def most_frequent(labels, where):
    import numpy as np
    counts = np.bincount(labels[where], minlength=1)
    counts[0] = 0
    return int(counts.argmax()) if counts.any() else 0


def steps(tool, out):
    scale = 2
    with tempfile.TemporaryDirectory() as temp:
        office = os.path.join(temp, 'office')
        run(tool, 'generate', '--size', '360', '--seed', '26', '-o', office)
        every_border = ['-p', 'min_separation=0', '-p', 'min_area_size=0', '-p', 'min_area_clearance=0']
        fragments, borders = convert(tool, office, os.path.join(temp, 'fragments'), *every_border)
        areas, doors = convert(tool, office, os.path.join(temp, 'areas'))
        area_of = [most_frequent(areas, fragments == k) for k in range(int(fragments.max()) + 1)]
        palette = colours(int(max(fragments.max(), areas.max())) + 1)
        pictures = [enlarged(paint(office, labels, palette), scale) for labels in (fragments * 0, fragments, areas)]
    for a, b, line in borders:
        draw(pictures[1], line, OPENED if area_of[a] == area_of[b] else DOOR, scale)
    for _, _, line in doors:
        draw(pictures[2], line, DOOR, scale)
    beside(pictures, out)


def truth(tool, seed, out):
    import cv2
    with tempfile.TemporaryDirectory() as temp:
        office = os.path.join(temp, 'office')
        run(tool, 'generate', '--size', '800', '--seed', seed, '-o', office)
        areas, doors = convert(tool, office, os.path.join(temp, 'areas'))
        rooms = cv2.imread(os.path.join(office, 'rooms.png'), cv2.IMREAD_UNCHANGED)
        number, taken = [0], set()  # a room has the colour of the area that has most of it
        for room in range(1, int(rooms.max()) + 1):
            area = most_frequent(areas, rooms == room)
            number.append(area if area and area not in taken else int(areas.max()) + room)
            taken.add(area)
        palette = colours(int(areas.max()) + int(rooms.max()) + 1)
        pictures = [paint(office, areas, palette), paint(office, rooms, palette[number])]
    for _, _, line in doors:
        draw(pictures[0], line, DOOR, 1)
    beside(pictures, out)


BINS = (0, 0.5, 0.7, 0.8, 0.9, 0.95, 1.000001)


def draw_offices(tool, folder):
    os.mkdir(folder)
    for seed in range(1, 21):
        run(tool, 'generate', '--size', '600', '--seed', str(seed), '-o', os.path.join(folder, str(seed)))


def curve(tool, maps):
    """(mean confidence, share that is true, number) of each bin; prints the tool's own table"""
    with tempfile.TemporaryDirectory() as temp:
        path = os.path.join(temp, 'doors.csv')
        tables = subprocess.run([tool, 'eval', maps, '--doors', path], check=True, stdout=subprocess.PIPE)
        print(tables.stdout.decode().split('\n\n')[-1])
        with open(path) as file:
            doors = [(float(row['confidence']), int(row['true'])) for row in csv.DictReader(file)]
    points = []
    for low, high in zip(BINS, BINS[1:]):
        inside = [door for door in doors if low <= door[0] < high]
        if inside:
            points.append(tuple(sum(values) / len(inside) for values in zip(*inside)) + (len(inside),))
    return points


def axes(size, place):
    """the lines of the frame, its numbers and names"""
    lines = ['<path d="M%g %gV%gH%g" fill="none" stroke="black"/>' % (*place(0, 1), place(0, 0)[1], place(1, 0)[0]),
             '<path d="M%g %gL%g %g" stroke="gray" stroke-dasharray="4"/>' % (*place(0, 0), *place(1, 1))]
    text = '<text transform="translate(%g %g) rotate(%g)" text-anchor="%s">%s</text>'
    for tick in (0, 0.2, 0.4, 0.6, 0.8, 1):
        x, y = place(tick, 0)
        lines.append(text % (x, y + 16, 0, 'middle', tick))
        x, y = place(0, tick)
        lines.append(text % (x - 6, y + 4, 0, 'end', tick))
    x, y = place(0.5, 0)
    lines.append(text % (x, y + 36, 0, 'middle', 'confidence (mean of the bin)'))
    x, y = place(0, 0.5)
    lines.append(text % (x - 34, y, -90, 'middle', 'share of doors that is true'))
    return lines


def reliability(tool, out, curves):
    size, margin = 360, 48

    def place(confidence, true):
        return margin + confidence * size, margin / 2 + (1 - true) * size
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="sans-serif" font-size="12">'
             % (size + 3 * margin, size + 2 * margin), '<rect width="100%" height="100%" fill="white"/>']
    lines += axes(size, place)
    for k, (name, colour) in enumerate(zip(curves, ('#d06000', '#0050b4', '#008040', '#802080'))):
        print(name + '\n')
        points = curve(tool, curves[name])
        lines.append('<g fill="%s"><path d="M%s" fill="none" stroke="%s" stroke-width="1.5"/>'
                     % (colour, 'L'.join('%.1f %.1f' % place(*point[:2]) for point in points), colour))
        for confidence, true, number in points:
            x, y = place(confidence, true)
            lines.append('<circle cx="%.1f" cy="%.1f" r="3"/><text x="%.1f" y="%.1f" font-size="10">%d</text>'
                         % (x, y, x + 6, y + 10 - 14 * (k % 2), number))
        x, y = place(0.05, 1)
        lines.append('<text x="%g" y="%g">%s</text></g>' % (x, y + 18 * (k + 1), name))
    with open(out, 'w') as file:
        file.write('\n'.join(lines) + '\n</svg>\n')


def main(words):
    commands = {'steps': (3, steps), 'truth': (4, truth)}
    if words and len(words) == commands.get(words[0], (0,))[0]:
        commands[words[0]][1](*words[1:])
    elif len(words) >= 3 and words[0] == 'reliability' and all('=' in word for word in words[3:]):
        with tempfile.TemporaryDirectory() as temp:
            curves = {'drawn offices': os.path.join(temp, 'offices')}
            draw_offices(words[1], curves['drawn offices'])
            curves.update(word.split('=', 1) for word in words[3:])
            reliability(words[1], words[2], curves)
    else:
        sys.exit(__doc__)


if __name__ == '__main__':
    main(sys.argv[1:])
