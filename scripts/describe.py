# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/demo shows of answers that are too long to print.

usage: describe.py areas GRAPH.yaml    a line for each area and door
       describe.py ends GRAPH.yaml     two areas far apart: START GOAL, then the anchor of START
       describe.py path PATH.yaml      the answer of plan_path, poses shortened
The files hold what `rosservice call` prints.
"""
import sys

import yaml


def areas(answer):
    graph = answer['graph']
    names = {area['id']: area['name'] for area in graph['areas']}
    names[0] = 'outside'
    for area in graph['areas']:
        print('%-8s %6.1f m2, anchor (%.2f, %.2f)' % (area['name'], area['size'], area['anchor']['x'],
                                                     area['anchor']['y']))
    for door in graph['doors']:
        print('%-8s %6.2f m wide, between %s and %s' % (door['name'], door['width'],
                                                       names[door['areas'][0]], names[door['areas'][1]]))


def ends(answer):
    rooms = [area for area in answer['graph']['areas'] if area['size'] >= 8]
    rooms.sort(key=lambda area: area['anchor']['x'] + area['anchor']['y'])
    start, goal = rooms[0], rooms[-1]
    print('%s %s %.3f %.3f' % (start['name'], goal['name'], start['anchor']['x'],
                                              start['anchor']['y']))


def path(answer):
    for key in ('status', 'route'):
        print(yaml.safe_dump({key: answer[key]}, default_flow_style=None, sort_keys=False), end='')
    for key in ('length', 'length_bound', 'clearance', 'planning_time', 'map_id'):
        print('%s: %s' % (key, answer[key]))
    points = [pose['pose']['position'] for pose in answer['path']['poses']]
    print('cells: %d' % len(answer['cells']))
    print('path: %d poses, %s' % (len(points), ' '.join('(%.2f, %.2f)' % (p['x'], p['y']) for p in points)))


if __name__ == '__main__':
    with open(sys.argv[2]) as file:
        {'areas': areas, 'ends': ends, 'path': path}[sys.argv[1]](yaml.safe_load(file))
