# SPDX-License-Identifier: BSD-3-Clause
"""The home of scripts/demo_tags, and what it shows of long answers.

usage: tags_story.py draw DIR         a home as DIR/home.yaml; DIR/changed.yaml: after the builders left
       tags_story.py tags LIST.yaml   a line for each tag that somebody gave: kind, id, name, category
       tags_story.py doors GRAPH.yaml a line for each door of the kitchen
       tags_story.py route PLAN.yaml  the names on the first route
       tags_story.py pid NODE         the process that a node runs in
The files hold what `rosservice call` prints.
"""
import pathlib
import sys
import xmlrpc.client

import yaml

RESOLUTION = 0.05
SIZE = 12.0, 8.0
ROOMS = {'hall': (0.2, 3.3, 11.8, 4.7), 'kitchen': (0.2, 4.9, 4.0, 7.8), 'living room': (4.2, 4.9, 11.8, 7.8),
         'bedroom': (0.2, 0.2, 5.0, 3.1), 'bath': (5.2, 0.2, 7.5, 3.1), 'office': (7.7, 0.2, 11.8, 3.1)}
DOORS = {'kitchen-hall': (1.5, 4.7, 2.4, 4.9), 'kitchen-living room': (4.0, 6.0, 4.2, 6.9),
         'living room-hall': (7.0, 4.7, 7.9, 4.9), 'bedroom-hall': (2.5, 3.1, 3.4, 3.3),
         'bath-hall': (6.0, 3.1, 6.9, 3.3), 'office-hall': (9.0, 3.1, 9.9, 3.3)}
# the kitchen's wall is half a metre further, the bath has its door to the bedroom
CHANGED_ROOMS = dict(ROOMS, **{'kitchen': (0.2, 4.9, 4.5, 7.8), 'living room': (4.7, 4.9, 11.8, 7.8)})
CHANGED_DOORS = dict(DOORS, **{'kitchen-living room': (4.5, 6.0, 4.7, 6.9), 'bath-hall': (5.0, 1.2, 5.2, 2.1)})


def save(stem, rectangles):
    columns, rows = (round(side / RESOLUTION) for side in SIZE)
    image = [bytearray(columns) for _ in range(rows)]
    for box in rectangles:
        left, low, right, high = (round(value / RESOLUTION) for value in box)
        for row in range(low, high):
            image[rows - 1 - row][left:right] = b'\xfe' * (right - left)
    stem.with_suffix('.pgm').write_bytes(b'P5 %d %d 255\n' % (columns, rows) + b''.join(image))
    stem.with_suffix('.yaml').write_text(
        'image: %s.pgm\nresolution: %g\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n'
        % (stem.name, RESOLUTION))


def draw(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    save(folder / 'home', [*ROOMS.values(), *DOORS.values()])
    save(folder / 'changed', [*CHANGED_ROOMS.values(), *CHANGED_DOORS.values()])


def load(path):
    with open(path) as file:
        return yaml.safe_load(file)


def tags(path):
    for tag in load(path)['tags']:
        if tag['source'] != 0:
            print(' '.join(['area', 'door', 'object'][tag['type'] - 1:tag['type']]
                           + [str(tag['id']), tag['name'], tag['category']]).rstrip())


def doors(path):
    graph = load(path)['graph']
    names = {area['id']: area['name'] for area in graph['areas']}
    for door in graph['doors']:
        between = sorted(names.get(area, 'outside') for area in door['areas'])
        if 'kitchen' in between:
            print('door %d between %s and %s: %s' % (door['id'], *between,
                                                    ['unknown', 'open', 'closed'][door['state']]))


def route(path):
    answer = load(path)
    routes = answer['routes']
    print(' - '.join(routes[0]['names']) if routes else answer['status']['message'])


def pid(node):
    import rosgraph
    uri = rosgraph.Master('/tags_story').lookupNode(node)
    print(xmlrpc.client.ServerProxy(uri).getPid('/tags_story')[2])


if __name__ == '__main__':
    {'draw': draw, 'tags': tags, 'doors': doors, 'route': route, 'pid': pid}[sys.argv[1]](sys.argv[2])
