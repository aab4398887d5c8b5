#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Kills a process that eight clients edit a store through, again and again, and looks for what was lost.

usage: kill_loop.py HAMMER [--kills N] [--seed S] [--control]

--control acknowledges edits before they are stored: the loop must find losses then, and fails if not.
"""
import argparse
import random
import sys
import tempfile
import time

import hammer


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('hammer')
    parser.add_argument('--kills', type=int, default=20)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--control', action='store_true')
    options = parser.parse_args()
    chance = random.Random(options.seed)
    edits = lost = torn = 0
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as directory:
        for _ in range(options.kills):
            clients = hammer.Clients(options.hammer, directory, ['--early'] if options.control else [])
            clients.ready.wait()
            clients.ended.wait(chance.uniform(0.02, 0.5))
            died = clients.ended.is_set()
            clients.kill()
            if died:
                sys.exit('the clients ended by themselves')
            edits += clients.edits
            missing, damage = hammer.losses(options.hammer, directory, clients.acknowledged)
            lost += missing
            if damage:
                torn += 1
                print(damage, end='')
    print('%d kills, %d acknowledged edits, %d lost, %d torn, %.0f s'
          % (options.kills, edits, lost, torn, time.monotonic() - began))
    if options.control:
        sys.exit(0 if lost else 'the checker found no losses where there must be some')
    sys.exit(1 if lost or torn or not edits else 0)


if __name__ == '__main__':
    main()
