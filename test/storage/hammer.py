# SPDX-License-Identifier: BSD-3-Clause
"""What kill_loop.py and power_cut.py share: clients that are watched, and what they were promised."""
import subprocess
import threading


class Clients:
    """Runs `agrid_store_hammer run` and keeps what it acknowledges."""

    def __init__(self, program, directory, options):
        self.process = subprocess.Popen([program, 'run', directory, *options], stdout=subprocess.PIPE)
        self.acknowledged = {}  # client: number of its last edit
        self.edits = 0
        self.ready = threading.Event()
        self.ended = threading.Event()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def _read(self):
        for line in self.process.stdout:
            if not line.endswith(b'\n'):
                break  # cut by the kill
            if line == b'ready\n':
                self.ready.set()
                continue
            client, count = map(int, line.split())
            self.acknowledged[client] = max(count, self.acknowledged.get(client, 0))
            self.edits += 1
        self.ended.set()
        self.ready.set()

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.reader.join()


def losses(program, directory, acknowledged):
    """How many acknowledged edits a store lacks, and what is wrong with it otherwise."""
    check = subprocess.run([program, 'check', directory], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    stored = dict(map(int, line.split()) for line in check.stdout.decode().splitlines())
    lost = sum(max(0, count - stored.get(client, 0)) for client, count in acknowledged.items())
    return lost, check.stderr.decode() if check.returncode != 0 else ''
