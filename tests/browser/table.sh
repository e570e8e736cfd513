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

# Rows of one's own, with options: errors and ratios, emulated, and drawn too.
"$report" --table --kind weapon --first-view --lights 1 --size 160x120 --drawn 1 --row Optimal \
    --row "Optimal edge_weight=1" --row "Cascades-2 edge_weight=0.5 strip_light=false" >rows 2>/dev/null
for line in '^Optimal edge_weight=1 ' '^Cascades-2 edge_weight=0.5 strip_light=false '; do
    [ "$(grep -c "$line" rows)" = 4 ] || fail "no line $line: $(cat rows)"
done
# A mean over places within a texel: another error than that of one place, for the same pixels.
for shifts in 1 3; do
    "$report" --table --kind weapon --first-view --lights 1 --size 160x120 --row Optimal \
        --shifts $shifts --json "shifts$shifts.json" >/dev/null 2>&1
done
if cmp -s shifts1.json shifts3.json; then fail "places within a texel change nothing"; fi
for key in pixels_counted pixels_shadowed; do
    [ "$(grep "$key" shifts1.json)" = "$(grep "$key" shifts3.json)" ] || fail "other $key"
done
if "$report" --table --shifts 0 >/dev/null 2>&1; then fail "took no place at all"; fi
if "$report" --table --row "Optimal edge_weight=2" 2>wrong; then fail "took a bad option"; fi
grep -q 'edge_weight' wrong || fail "does not say what is wrong: $(cat wrong)"
if "$report" --table --row "Nothing" 2>wrong; then fail "took a setup that there is not"; fi

# The command of a bad case draws it as it was measured.
command=$(sed -n 's/^ *\([^ ]*lixel-browser .*\)/\1/p' table | head -1)
[ -n "$command" ] || fail "no case is worse than any other's: $(cat table)"
$command --frames 1 >drawn
grep -q 'map 1024' drawn || fail "not drawn: $(cat drawn)"
[ "$(ls ./*.png | wc -l)" = 2 ] || fail "not two pictures: $(ls)"

# Every second of three cases is drawn, and the worst are pictured, as the browser does. It draws
# later frames, in which Optimal and XPSM have searched on; other setups' are as the first.
"$report" --table --kind duel --first-view --lights 3 --size 160x120 --drawn 2 --pictures pictures \
    --json drawn.json >both 2>/dev/null
for line in '^Drawn: one case in 2, 2 of 3' '^Cascades-2 / Ogre-PSSM-3  *2 ' \
    '^Optimal > best other '; do
    grep -q "$line" both || fail "no line $line: $(cat both)"
done
[ "$(grep -c '"Uniform": ' drawn.json)" = 3 ] || fail "not three cases: $(cat drawn.json)"
drawn=$(sed -n '/"Uniform": /,/}/s/.*"drawn_error_percent": \(.*\),/\1/p' drawn.json)
[ "$(echo "$drawn" | wc -l)" = 2 ] || fail "not two drawn cases: $(cat drawn.json)"
browser=${command%% *}
"$browser" --headless --sample duel --setup Uniform --size 160x120 --frames 1 \
    --stats uniform.json >drawn
grep -qF "\"error_percent\": $(echo "$drawn" | head -1)," uniform.json ||
    fail "the browser's errors are others: $drawn, $(cat uniform.json)"
sed -n 's/^ *\([^ ]*\): emulated [0-9.]*, drawn [0-9.]*; \(.*\)$/\1 \2/p' both >pictured
[ -s pictured ] || fail "no case is pictured: $(cat both)"
while read -r setup file; do
    [ -s "$file" ] || fail "no picture $file"
    case $setup in Optimal | XPSM | Ogre-LiSPSM-1) continue ;; esac # the last is not the browser's
    light=${file#pictures/duel-into-the-sun-}
    "$browser" --headless --sample duel --light "${light%-"$setup"-errors.png}" --setup "$setup" \
        --size 160x120 --frames 1 --comparison browser.png >drawn
    cmp browser.png "$file" || fail "$file is not the browser's"
done <pictured
echo "Cases are measured by kind, told by kind, written, drawn, pictured, and drawn by the command."
