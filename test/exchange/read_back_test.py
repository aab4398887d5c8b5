#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads what `agrid_map_tool export` writes with other people's libraries.

usage: read_back_test.py AGRID_MAP_TOOL FORMAT

FORMAT: geojson, nav2, graphml, dot, svg, labels or facts. Exit code 77: the library is not there.
"""
import importlib
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
from xml.etree import ElementTree

SKIPPED = 77
# all that XML, JSON, DOT and Prolog give a meaning to, and text beyond ASCII
NAME = 'R&D <lab> "Ä" \\N \'x\' &amp; \\" ]]> 日本 {a|b}'
TAGS = '''format_version: 1
frame_id: "floor"
areas:
  - {name: %s, seed: [4.0, -4.0], properties: {"cost": "3", "<a & b>": "]]>"}}
objects:
  - {name: "fridge & co", pose: [4.0, -4.0, 0.3], size: [0.6, 0.7], height: 1.8, category: "fridge"}
  - {name: "plug", pose: [4.5, -4.0, 0]}
end_of_file: true
'''


def need(module):
    try:
        return importlib.import_module(module)
    except ImportError:
        print('skipped: no %s' % module)
        sys.exit(SKIPPED)


def need_program(name):
    if not shutil.which(name):
        print('skipped: no %s' % name)
        sys.exit(SKIPPED)
    return name


class Office:
    """A drawn office whose files are there; truth from `graph.json` of convert."""

    def __init__(self, tool, folder, form):
        def run(*words):
            subprocess.run([tool, *words], check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

        self.folder = folder
        map_yaml = str(folder / 'o/office.yaml')
        tags = folder / 'tags.yaml'
        tags.write_text(TAGS % json.dumps(NAME, ensure_ascii=False), encoding='utf-8')
        run('generate', '--size', '400', '--seed', '3', '-o', str(folder / 'o'))
        run('convert', map_yaml, '--tags', str(tags), '-o', str(folder / 'convert'))
        run('export', map_yaml, '--tags', str(tags), '-f', form, '-o', str(folder / 'out'))
        self.graph = json.loads((folder / 'convert/graph.json').read_text())
        self.areas = {area['id']: area for area in self.graph['areas']}
        assert any(area['name'] == NAME for area in self.graph['areas']), 'the name is not on the map'

    def file(self, ending):
        return self.folder / ('out/office' + ending)


def check_geojson(office):
    geometry = need('shapely.geometry')
    from shapely.validation import explain_validity
    path = office.file('.geojson')
    collection = json.loads(path.read_text(encoding='utf-8'))
    assert collection['frame_id'] == 'floor'
    shapes = {}
    for feature in collection['features']:
        shape = geometry.shape(feature['geometry'])
        assert shape.is_valid, (feature['id'], explain_validity(shape))
        shapes[feature['id']] = shape
    areas = {key: shape for key, shape in shapes.items() if key.startswith('area/')}
    assert len(areas) == len(office.areas)
    for key, shape in areas.items():
        area = office.areas[int(key[5:])]
        assert abs(shape.area - area['size']) < 1e-3 * area['size'], (key, shape.area, area['size'])
        assert shape.contains(geometry.Point(area['anchor'])), key
    union = sum(shape.area for shape in areas.values())
    from shapely.ops import unary_union
    assert abs(unary_union(list(areas.values())).area - union) < 1e-3 * union, 'areas overlap'
    assert any(len(part.interiors) for shape in areas.values()
               for part in getattr(shape, 'geoms', [shape])), 'no holes'
    for door in office.graph['doors']:
        line = shapes['door/%d' % door['id']]
        assert abs(line.length - geometry.LineString(door['jambs']).length) < 1e-3
    assert [f['properties']['name'] for f in collection['features']].count(NAME) == 1
    ogr = need('osgeo.ogr')
    source = ogr.Open(str(path))
    layer = source.GetLayer()
    assert layer.GetFeatureCount() == len(collection['features'])
    assert layer.GetSpatialRef().IsLocal(), 'metres would be taken for degrees'


def clear_of(office):
    """Says whether a straight line keeps 0.15 m from everything that is not free."""
    numpy = need('numpy')
    cv2 = need('cv2')
    image = cv2.imread(str(office.folder / 'o/office.pgm'), cv2.IMREAD_GRAYSCALE)
    free = (image >= 250).astype(numpy.uint8)
    distance = cv2.distanceTransform(free, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    about = office.graph['map']
    origin = about['map_from_image']
    assert origin['yaw'] == 0

    def clear(a, b):
        steps = max(2, int(numpy.hypot(b[0] - a[0], b[1] - a[1]) / 0.01))
        x = numpy.linspace(a[0], b[0], steps)
        y = numpy.linspace(a[1], b[1], steps)
        columns = ((x - origin['x']) / about['resolution']).astype(int)
        rows = about['height'] - 1 - ((y - origin['y']) / about['resolution']).astype(int)
        return distance[rows, columns].min() * about['resolution'] > 0.15

    return clear


def check_nav2(office):
    """As nav2_route's GeoJsonGraphFileLoader reads it: what it takes without asking must be there."""
    networkx = need('networkx')
    collection = json.loads(office.file('.nav2.geojson').read_text(encoding='utf-8'))
    clear = clear_of(office)
    nodes, ids, graph = {}, set(), networkx.DiGraph()
    for feature in collection['features']:
        properties = feature['properties']
        assert isinstance(properties['id'], int) and properties['id'] >= 0
        assert properties['id'] not in ids, 'ids are unique among nodes and edges'
        ids.add(properties['id'])
        for value in properties['metadata'].values():
            assert isinstance(value, (str, int, float, list)), 'the loader takes no null'
        if feature['geometry']['type'] == 'Point':
            assert properties['frame'] == 'floor'
            nodes[properties['id']] = feature
            continue
        assert feature['geometry']['type'] == 'MultiLineString'
        ends = [nodes[properties[key]]['geometry']['coordinates'] for key in ('startid', 'endid')]
        assert feature['geometry']['coordinates'] == [ends]
        assert clear(*ends), properties
        assert properties['cost'] >= 0 and isinstance(properties['overridable'], bool)
        graph.add_edge(properties['startid'], properties['endid'], weight=properties['cost'])
    anchors = {n['properties']['metadata']['area']: key for key, n in nodes.items()
               if n['properties']['metadata']['kind'] == 'area'}
    topology = networkx.Graph()
    for door in office.graph['doors']:
        topology.add_edge(*door['areas'])
    for part in networkx.connected_components(topology):
        part = [area for area in part if area in anchors]
        for area in part[1:]:
            networkx.dijkstra_path_length(graph, anchors[part[0]], anchors[area])
    assert len(anchors) >= len(office.areas) - 1


def check_graphml(office):
    networkx = need('networkx')
    graph = networkx.read_graphml(str(office.file('.graphml')))
    assert graph.graph['frame_id'] == 'floor'
    areas = {data['agrid_id']: data for _, data in graph.nodes(data=True) if data['kind'] == 'area'}
    assert set(areas) == set(office.areas)
    for key, area in office.areas.items():
        assert areas[key]['name'] == area['name']
        assert abs(areas[key]['x'] - area['anchor'][0]) < 1e-3
    assert areas[[k for k, a in areas.items() if a['name'] == NAME][0]]['property:<a & b>'] == ']]>'
    doors = {data['agrid_id']: (source, target) for source, target, data in graph.edges(data=True)
             if data['kind'] in ('door', 'passage')}
    for door in office.graph['doors']:
        assert {'area_%d' % area for area in door['areas']} == set(doors[door['id']])
    assert len(doors) == len(office.graph['doors'])
    assert [data['kind'] for _, _, data in graph.edges(data=True)].count('in') == 2


def check_dot(office):
    dot = need_program('dot')
    drawn = subprocess.run([dot, '-Tsvg', str(office.file('.dot'))], check=True, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE)
    assert not drawn.stderr, drawn.stderr
    texts = [text.text for text in ElementTree.fromstring(drawn.stdout).iter(
        '{http://www.w3.org/2000/svg}text')]
    for area in office.graph['areas'] + office.graph['doors']:
        assert area['name'] in texts, (area['name'], texts)
    read = json.loads(subprocess.run([dot, '-Tdot_json', str(office.file('.dot'))], check=True,
                                     stdout=subprocess.PIPE).stdout)
    assert len(read['objects']) == len(office.areas) + 2
    assert len(read['edges']) == len(office.graph['doors']) + 2


def check_svg(office):
    etree = need('lxml.etree')
    space = '{http://www.w3.org/2000/svg}'
    root = etree.parse(str(office.file('.svg'))).getroot()
    layers = [group.get('id') for group in root.findall(space + 'g')]
    assert layers == ['areas', 'cells', 'walls', 'doors', 'objects', 'names']
    titles = [title.text for title in root.iter(space + 'title')]
    texts = [text.text for text in root.iter(space + 'text')]
    assert NAME in titles and NAME in texts
    need_program('rsvg-convert')
    cv2 = need('cv2')
    picture = office.folder / 'drawn.png'
    subprocess.run(['rsvg-convert', '-w', '800', '-h', '800', str(office.file('.svg')), '-o', str(picture)],
                   check=True)
    image = cv2.imread(str(picture))
    about = office.graph['map']
    for area in office.graph['areas']:  # beside the anchor, as the name is on it
        fill = root.find(".//*[@id='area_%d']" % area['id']).get('fill')
        x, y = area['anchor']
        step = 0.8 * area['anchor_clearance']
        scale = 800 / (about['width'] * about['resolution'])
        column = int((x - about['map_from_image']['x']) * scale)
        row = int(800 - (y - step - about['map_from_image']['y']) * scale)
        expected = [int(fill[i:i + 2], 16) for i in (5, 3, 1)]
        near = image[row - 3:row + 4, column - 3:column + 4].reshape(-1, 3).astype(int)
        assert (abs(near - expected).max(axis=1) < 12).any(), (area['id'], fill, near.mean(axis=0))


def check_labels(office):
    cv2 = need('cv2')
    one = cv2.imread(str(office.file('.labels.png')), cv2.IMREAD_UNCHANGED)
    other = cv2.imread(str(office.folder / 'convert/labels.png'), cv2.IMREAD_UNCHANGED)
    assert one.dtype == 'uint16' and (one == other).all() and one.max() == len(office.areas)


def check_facts(office):
    swipl = need_program('swipl')
    goal = ("forall(area(I, N), (write(I), nl, write(N), nl)), "
            "forall(connects(D, A, B), (area(A, _), area(B, _), door(D, _), state(D, _))), "
            "forall(in(O, A), (object(O, _), area(A, _))), halt.")
    lines = subprocess.run([swipl, '-q', '-g', goal, str(office.file('.pl'))], check=True,
                           stdout=subprocess.PIPE).stdout.decode('utf-8').splitlines()
    assert dict(zip(lines[::2], lines[1::2])) == {str(k): a['name'] for k, a in office.areas.items()}


def main():
    check = globals()['check_' + sys.argv[2]]
    with tempfile.TemporaryDirectory() as folder:
        check(Office(sys.argv[1], pathlib.Path(folder), sys.argv[2]))
    print('read back: %s' % sys.argv[2])


if __name__ == '__main__':
    main()
