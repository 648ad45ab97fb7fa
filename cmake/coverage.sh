#!/bin/sh
# Prints the line coverage of each folder of host/, from the counters below the working folder:
#   coverage.sh GCOVR SOURCE
set -eu

"$1" --root "$2" --object-directory . --filter "$2/host/" --csv - | awk -F, '
  NR == 1 { next }
  {
    folder = $1
    if (!sub(/\/[^\/]*$/, "", folder)) folder = "."
    if (!(folder in lines)) order[++folders] = folder
    lines[folder] += $2; run[folder] += $3
    allLines += $2; allRun += $3
  }
  function row(name, of, ran) { printf "%-18s %6d of %6d lines %6.1f %%\n", name, ran, of, 100 * ran / of }
  END {
    if (allLines == 0) { print "no counters: run the tests first"; exit 1 }
    for (i = 1; i <= folders; ++i) row(order[i], lines[order[i]], run[order[i]])
    row("all", allLines, allRun)
  }'
