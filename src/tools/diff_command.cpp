// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands.h"
#include "tools/knowledge_difference.h"
#include "tools/stored_file.h"

namespace agrid::tools {
namespace {

int diff(const Arguments& arguments) {
  const StoreContents a = readAndWarn(arguments.operand(0));
  const StoreContents b = readAndWarn(arguments.operand(1));
  const int code = printFound(differences(a, b));
  // of what is damaged nobody knows what it said
  return a.errors.empty() && b.errors.empty() ? code : kFileFailed;
}

}  // namespace

Command diffCommand() {
  Syntax syntax;
  syntax.command = "diff";
  syntax.summary = "Tells in sentences what differs between two files of stored tags.";
  syntax.operands = {"A.yaml", "B.yaml"};
  return {syntax, diff, kFileFailed};
}

}  // namespace agrid::tools
