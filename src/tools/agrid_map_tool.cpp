// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands.h"

int main(int argc, char** argv) { return agrid::tools::run({argv, argv + argc}); }
