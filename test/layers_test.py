#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads every #include of the package against the order of its layers (doc/architecture.md).

usage: layers_test.py REPOSITORY
"""
import pathlib
import re
import sys

ORDER = ['geometry', 'map', 'grid', 'tags', 'areas', 'topology', 'semantic_map']
# blind to each other, above all of ORDER
TOP = {'planning', 'pipeline', 'storage', 'identity', 'dialogue', 'evaluation', 'exchange'}
ROS = re.compile(r'^(ros|tf2|tf2_ros|tf2_geometry_msgs|nodelet|pluginlib|rviz|costmap_2d|nav_core|\w+_msgs|'
                 r'std_srvs|dynamic_reconfigure|agrid_map)/')
INCLUDE = re.compile(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]')


def room_of(path):
    """The room a file of this repository lives in, from its path below include/ or src/."""
    parts = path.split('/')
    if parts[0] == 'agrid':
        parts = parts[1:]
    return parts[0].split('.')[0]


def allowed(user, used):
    """Whether room `user` may include room `used`."""
    if user == used or used not in set(ORDER) | TOP | {'agrid_map_ros', 'ros', 'rviz', 'plugins', 'tools'}:
        return True
    if user in ORDER:
        return used in ORDER and ORDER.index(used) <= ORDER.index(user)
    if user in TOP:
        return used in ORDER
    if user == 'tools':
        return used in ORDER or used in TOP
    if user == 'rviz':
        return False
    if user in ('ros', 'plugins', 'agrid_map_ros'):
        return used in ORDER or used in TOP or used == 'agrid_map_ros'
    return False


def rviz_breach(root, user, include):
    """Whether code for RViz includes what lives in another room of src/ or include/."""
    if user != 'rviz' or '/' not in include:
        return False
    return any((root / top / include).exists() for top in ('include', 'src'))


def main():
    root = pathlib.Path(sys.argv[1])
    files = [(f, f.relative_to(root / top).as_posix()) for top in ('include', 'src')
             for f in sorted((root / top).rglob('*')) if f.suffix in ('.h', '.cpp')]
    wrong = []
    for file, relative in files:
        user = room_of(relative)
        core = user in ORDER or user in TOP or user == 'tools'
        for number, line in enumerate(file.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            include = match.group(1)
            if core and ROS.match(include):
                wrong.append('%s:%d: the core includes ROS: %s' % (file, number, include))
            elif rviz_breach(root, user, include):
                wrong.append('%s:%d: RViz sees messages only: %s' % (file, number, include))
            elif '/' in include and not ROS.match(include) and not allowed(user, room_of(include)):
                wrong.append('%s:%d: %s may not include %s' % (file, number, user, include))
    print('\n'.join(wrong))
    print('%d files, %d wrong includes' % (len(files), len(wrong)))
    return 1 if wrong or not files else 0


if __name__ == '__main__':
    sys.exit(main())
