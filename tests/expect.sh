#!/bin/sh
# expect.sh STATUS REGEX COMMAND...: the command ends with this exit code and prints a line of this form.
wanted=$1 form=$2
shift 2
text=$("$@" 2>&1)
status=$?
printf '%s\n' "$text"
[ $status -eq "$wanted" ] || { echo "FAILED: exit $status, not $wanted"; exit 1; }
printf '%s\n' "$text" | grep -qE -- "$form" || { echo "FAILED: no line has the form $form"; exit 1; }
