#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Follows doc/tutorial.md as a reader would: every command of it, one after the other, in one shell.

usage: tutorial_test.py PROJECT DEVEL_SPACE

A block marked ```sh is run. One marked ```text tells what the block before it prints: each of its
lines must come, in this order; '...' in a line stands for anything. A block marked ```sh move_base is
left out, and named, where there is no move_base. Fails at the first command that fails.
"""
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

LONGEST = 120  # [s] that a block may take
DONE = '-- the block ends here --'


def blocks(text):
    """(language, lines) of each fenced block."""
    return [(match[1].strip(), match[2].splitlines())
            for match in re.finditer(r'^```([^\n]*)\n(.*?)^```$', text, re.S | re.M)]


def missing(expected, printed):
    """The first line that does not come; none: all come in this order."""
    rest = iter(printed)
    for line in expected:
        pattern = '.*'.join(re.escape(part) for part in line.strip().split('...'))
        if not any(re.fullmatch(pattern, got.strip()) for got in rest):
            return line
    return None


class Reader:
    """A shell in a folder that looks like the package's, with a master of its own."""

    def __init__(self, project, devel, folder):
        for name in ('scripts', 'launch', 'test', 'doc', 'config'):
            (folder / name).symlink_to(project / name)
        (folder / 'build').mkdir()
        (folder / 'build' / 'devel').symlink_to(devel)
        with socket.socket() as free:
            free.bind(('127.0.0.1', 0))
            port = free.getsockname()[1]
        environment = dict(os.environ, ROS_MASTER_URI='http://localhost:%d' % port, ROS_HOSTNAME='localhost',
                           ROS_HOME=str(folder / 'ros_home'), PATH='/usr/sbin:/usr/bin:/sbin:/bin')
        self.shell = subprocess.Popen(['bash', '-e'], cwd=folder, env=environment, stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                      start_new_session=True)

    def run(self, lines):
        """What the commands print; None if one failed."""
        signal.alarm(LONGEST)
        try:
            self.shell.stdin.write('\n'.join(lines) + '\necho; echo "%s"\n' % DONE)
            self.shell.stdin.flush()
            printed = []
            for line in self.shell.stdout:
                if line.strip() == DONE:
                    return printed
                print(line, end='')
                printed.append(line)
            return None
        except BrokenPipeError:
            return None
        finally:
            signal.alarm(0)

    def leave(self):
        """Ends all that was started: roslaunch stops its nodes, which are in groups of their own."""
        for attempt in range(LONGEST):
            try:
                os.killpg(self.shell.pid, 0 if attempt else signal.SIGINT)
            except ProcessLookupError:
                return
            self.shell.poll()
            time.sleep(0.5)
        os.killpg(self.shell.pid, signal.SIGKILL)


def has_move_base():
    return subprocess.run(['/usr/bin/env', 'rospack', 'find', 'move_base'], capture_output=True,
                          check=False).returncode == 0


def follow(reader, steps):
    printed = []
    for kind, lines in steps:
        if kind == 'sh move_base' and not has_move_base():
            print('-- left out, there is no move_base:', *lines, sep='\n   ')
        elif kind.startswith('sh'):
            print('\n$ ' + '\n$ '.join(lines))
            printed = reader.run(lines)
            if printed is None:
                sys.exit('this failed: ' + '; '.join(lines))
        elif kind == 'text':
            line = missing(lines, printed)
            if line is not None:
                sys.exit('this was to be printed: ' + line)


def main():
    project, devel = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])

    def late(*_):
        raise TimeoutError('a block took longer than %d s' % LONGEST)
    signal.signal(signal.SIGALRM, late)
    with tempfile.TemporaryDirectory() as folder:
        reader = Reader(project, devel, pathlib.Path(folder))
        try:
            follow(reader, blocks((project / 'doc' / 'tutorial.md').read_text(encoding='utf-8')))
        finally:
            reader.leave()


if __name__ == '__main__':
    main()
