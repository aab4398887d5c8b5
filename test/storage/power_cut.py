#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Simulates power cuts under a store that eight clients edit, and looks for what was lost.

usage: power_cut.py HAMMER [--cuts N] [--seed S] [--control]

The store lies on an ext4 image in memory, mounted through a loop device. At a cut the process is
stopped, the image is copied, page cache left out, until two copies agree, and the copy is mounted and
read: what was never synced is not in it. --control leaves out fsync: the loop must find losses then,
and fails if not. Skipped, visibly, where loop devices or mounts are not permitted.
"""
import argparse
import filecmp
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import hammer

SKIPPED = 77
IMAGE_MB = 32


def call(*command):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


class Mounted:
    """An image, mounted while this is in scope."""

    def __init__(self, image, place):
        self.image, self.place = image, place

    def __enter__(self):
        self.place.mkdir(exist_ok=True)
        answer = call('mount', '-o', 'loop', str(self.image), str(self.place))
        if answer.returncode != 0:
            raise OSError(answer.stderr.decode().strip())
        return self.place

    def __exit__(self, *_):
        for _ in range(50):  # a copy may still be read by the system
            if call('umount', str(self.place)).returncode == 0:
                return
            time.sleep(0.1)
        call('umount', '-l', str(self.place))


def copied(image, folder):
    """A copy of the image that did not change while it was made."""
    copies = [folder / 'copy-a', folder / 'copy-b']
    shutil.copyfile(image, copies[0])
    while True:
        shutil.copyfile(image, copies[1])
        if filecmp.cmp(copies[0], copies[1], shallow=False):
            return copies[0]
        copies.reverse()


def cut(program, folder, seconds, options):
    """One power cut on a fresh file system: edits acknowledged, lost ones, and damage."""
    image = folder / 'image'
    with open(image, 'wb') as file:
        file.truncate(IMAGE_MB << 20)
    made = call('mkfs.ext4', '-q', '-F', str(image))
    if made.returncode != 0:
        raise OSError(made.stderr.decode().strip())
    with Mounted(image, folder / 'mounted') as place:
        clients = hammer.Clients(program, str(place / 'store'), options)
        clients.ready.wait()
        clients.ended.wait(seconds)
        died = clients.ended.is_set()
        clients.process.send_signal(signal.SIGSTOP)
        time.sleep(0.05)  # what it wrote to the pipe before is read
        acknowledged, edits = dict(clients.acknowledged), clients.edits
        copy = copied(image, folder)
        clients.kill()
    if died:
        sys.exit('the clients ended by themselves')
    with Mounted(copy, folder / 'mounted') as place:
        lost, damage = hammer.losses(program, str(place / 'store'), acknowledged)
    return edits, lost, damage


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('hammer')
    parser.add_argument('--cuts', type=int, default=10)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--control', action='store_true')
    options = parser.parse_args()
    chance = random.Random(options.seed)
    edits = lost = torn = cuts_with_loss = 0
    began = time.monotonic()
    memory = '/dev/shm' if os.access('/dev/shm', os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as name:
        for _ in range(options.cuts):
            try:
                some, missing, damage = cut(options.hammer, pathlib.Path(name), chance.uniform(0.1, 1.0),
                                            ['--no-sync'] if options.control else [])
            except OSError as error:
                print('SKIPPED: no power cuts can be simulated here: %s' % error)
                sys.exit(SKIPPED)
            edits, lost, torn = edits + some, lost + missing, torn + (1 if damage else 0)
            cuts_with_loss += 1 if missing else 0
            if damage:
                print(damage, end='')
    print('%d cuts, %d acknowledged edits, %d lost in %d cuts, %d torn, %.0f s'
          % (options.cuts, edits, lost, cuts_with_loss, torn, time.monotonic() - began))
    if options.control:
        sys.exit(0 if lost else 'the checker found no losses where there must be some')
    sys.exit(1 if lost or torn or not edits else 0)


if __name__ == '__main__':
    main()
