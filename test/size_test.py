#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every source file stays under 300 lines, every function under 40, and bears its licence.

usage: size_test.py REPOSITORY

A function is what starts in the first column and ends with a brace of its own there (.clang-format
indents everything else).
"""
import pathlib
import re
import sys

MAX_FILE_LINES = 300
MAX_FUNCTION_LINES = 40
LICENCE = 'SPDX-License-Identifier: BSD-3-Clause'
NOT_A_FUNCTION = re.compile(r'^(namespace|class|struct|enum|union|extern|using|#|//|template)\b')


def functions(lines):
    """(first line, number of lines) of each function, lines counted from 1."""
    start = None
    for number, line in enumerate(lines, 1):
        if line.startswith('}'):
            if start and not line.startswith('};') and '// namespace' not in line:
                yield start, number - start + 1
            start = None
        elif re.match(r'^[A-Za-z_~]', line) and not NOT_A_FUNCTION.match(line) and start is None:
            start = number
        elif start and line.rstrip().endswith(';') and not line.startswith(' '):
            start = None
        if start == number and line.rstrip().endswith(';'):
            start = None


def main():
    root = pathlib.Path(sys.argv[1])
    files = [f for top in ('include', 'src', 'test', 'benchmark') for f in sorted((root / top).rglob('*'))
             if f.suffix in ('.h', '.cpp')]
    wrong = []
    for file in files:
        lines = file.read_text().splitlines()
        name = file.relative_to(root)
        if LICENCE not in lines[0]:
            wrong.append('%s:1: no licence line' % name)
        if len(lines) >= MAX_FILE_LINES:
            wrong.append('%s: %d lines' % (name, len(lines)))
        if name.parts[0] in ('include', 'src'):
            wrong += ['%s:%d: a function of %d lines' % (name, start, length)
                      for start, length in functions(lines) if length >= MAX_FUNCTION_LINES]
    print('\n'.join(wrong))
    print('%d files, %d findings' % (len(files), len(wrong)))
    return 1 if wrong or not files else 0


if __name__ == '__main__':
    sys.exit(main())
