#!/bin/sh
# The report's table of one view of two kinds of scenes, in few pixels: table.sh REPORT FOLDER.
set -eu
report=$1
folder=$2
unset DISPLAY
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    exit 1
}

"$report" --table --kind weapon --kind lamp-room --first-view --lights 2 --size 160x120 \
    --json cases.json >table 2>progress
for line in '^Optimal ' '^all  *4 ' '^suns  *2 ' '^lamps  *2 ' '^by seed  *4 ' '^weapon  *2 ' '^lamp-room  *2 '; do
    grep -q "$line" table || fail "no line $line: $(cat table)"
done
grep -q '^lamp-room, view 1 of 1' progress || fail "no progress is told"
if grep -q '^meadow' table; then fail "another kind was measured"; fi
[ "$(grep -c '"scene": ' cases.json)" = 4 ] || fail "not four cases: $(cat cases.json)"
for key in view view_number light sun pixels_counted XPSM error_percent reason; do
    grep -q "\"$key\": " cases.json || fail "no $key in the cases"
done

# The command of a bad case draws it as it was measured.
command=$(sed -n 's/^ *\([^ ]*lixel-browser .*\)/\1/p' table | head -1)
[ -n "$command" ] || fail "no case is worse than any other's: $(cat table)"
$command --frames 1 >drawn
grep -q 'map 1024' drawn || fail "not drawn: $(cat drawn)"
[ "$(ls ./*.png | wc -l)" = 2 ] || fail "not two pictures: $(ls)"
echo "Cases are measured by kind, told by kind, written, and drawn by the command that is named."
