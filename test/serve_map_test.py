#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/serve_map starts, and what it says where it cannot.

usage: serve_map_test.py REPOSITORY
"""
import os
import pathlib
import subprocess
import sys
import tempfile


def serve(script, folder, installed, *arguments):
    """Exit code and output, with `rospack` and `rosrun` that only tell what they are asked for."""
    for name, line in (('rospack', 'exit %d' % (0 if installed else 1)), ('rosrun', 'echo "$@"')):
        stand_in = folder / name
        stand_in.write_text('#!/bin/bash\n%s\n' % line)
        stand_in.chmod(0o755)
    run = subprocess.run(['bash', str(script), *arguments], cwd=folder, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, env={'PATH': '%s:%s' % (folder, os.environ['PATH'])})
    return run.returncode, run.stdout.decode()


def main():
    script = pathlib.Path(sys.argv[1]).resolve() / 'scripts' / 'serve_map'
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / 'here.yaml').write_text('')
        expected = [
            (True, ('auto', '/m.yaml', '__name:=a'), 0, 'map_server map_server /m.yaml __name:=a'),
            (False, ('auto', '/m.yaml', '__name:=a'), 0, 'agrid_map/MapServerNodelet __name:=a'),
            (True, ('false', '/m.yaml'), 0, 'agrid_map/MapServerNodelet'),
            (True, ('true', 'here.yaml'), 0, 'map_server map_server here.yaml'),
            (False, ('true', '/m.yaml'), 69, 'map_server is not installed'),
            (True, ('auto', 'maps/m.yaml'), 66, 'give the whole path'),
            (True, ('yes', '/m.yaml'), 64, 'allowed are auto, true, false'),
        ]
        for installed, arguments, code, text in expected:
            answer = serve(script, folder, installed, *arguments)
            if answer[0] != code or text not in answer[1]:
                sys.exit('serve_map %s: %s, expected %d and: %s' % (' '.join(arguments), answer, code, text))


if __name__ == '__main__':
    main()
