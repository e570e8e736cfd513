#!/bin/sh
# The browser's command line, headless: commands.sh BROWSER FOLDER README.
set -eu
browser=$1
folder=$2
readme=$3
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
unset DISPLAY

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    exit 1
}

# refuses STATUS TEXT OPTIONS…: the browser must end with that status and say that text.
refuses() {
    status=$1 text=$2
    shift 2
    actual=0
    "$browser" "$@" >out 2>&1 || actual=$?
    [ "$actual" = "$status" ] || fail "status $actual instead of $status for: $*: $(cat out)"
    grep -q -- "$text" out || fail "no '$text' for: $*: $(cat out)"
}

"$browser" --list >list
for name in Samples: '  field' '  duel' '  miners-lamp' '  street' '  meadow' '  telephoto' Setups: '  Uniform' '  XPSM' \
    '  LiSPSM' '  Trapezoidal' '  PSM' '  PlaneOptimal' \
    '  Ogre-Default' '  Ogre-Focused' '  Ogre-LiSPSM' '  Ogre-PSSM' '  Ogre-PlaneOptimal'; do
    grep -qxF -- "$name" list || fail "--list lacks '$name'"
done

for setup in $(sed -n '/^Setups:/,$s/^  //p' list); do
    "$browser" --headless --sample duel --setup "$setup" --map 128 --size 160x120 --frames 2 \
        --light 170,30 --view 2 --output "$setup.png" --stats "$setup.json" >/dev/null
    [ -s "$setup.png" ] || fail "no picture with $setup"
    for key in sample setup map width height error_percent acne_percent leak_percent survey_us \
        fit_us caster_ms receiver_ms frame_ms still_frame_ms maps_drawn maps_drawn_moving maps_reused \
        maps_skipped reason feedback programs programs_compiled programs_used gl_renderer; do
        grep -q "\"$key\": " "$setup.json" || fail "no $key in the statistics of $setup"
    done
done

# The README's tables are what the browser prints.
"$browser" --options >options
{
    sed -n '/^| setup | option | values |/,/^$/p' "$readme"
    sed -n '/^| keyword | values |/,/^$/{/^|/p}' "$readme"
} | cmp - options || fail "the README's tables of options are not what --options prints"

"$browser" --headless --sample field --set feedback=on --map 128 --size 160x120 --frames 2 \
    --stats feedback.json >/dev/null
grep -q '"feedback": "used"' feedback.json || fail "feedback: $(cat feedback.json)"

# A still picture's map is kept, in Lixel's scene manager too, and is what would be drawn.
"$browser" --headless --sample field --manager LixelSceneManager --proof --map 128 --size 160x120 \
    --frames 4 --stats still.json >proof
grep -q '"maps_reused": 1' still.json || fail "the map of a still picture is drawn again"
grep -Eq '^proof: [1-9][0-9]* maps .*, 0 were different$' proof || fail "proof: $(cat proof)"
refuses 105 "--budget" --headless --budget 0
refuses 1 "NoSuchManager" --headless --manager NoSuchManager

# Where Lixel is built with OGRE's shader system. Without --setup its lights have presets.
if grep -qxF '  garden' list; then
    "$browser" --headless --sample garden --map 128 --size 160x120 --frames 2 --output garden.png \
        --stats garden.json >/dev/null
    grep -q '"setup": "Garden/Sun"' garden.json || fail "the garden is not drawn with its preset"
    [ -s garden.png ] || fail "no picture of the garden"
fi

"$browser" --headless --sample duel --setup XPSM --set strength=0 --set guarded=false --map 128 \
    --size 160x120 --output flat.png --comparison flat-comparison.png --stats flat.json >/dev/null
"$browser" --headless --sample duel --setup Uniform --map 128 --size 160x120 --output uniform.png \
    --stats uniform.json >/dev/null
cmp -s flat.png uniform.png || fail "a warp of strength 0 is not the uniform map"
refuses 2 "strength: '-1' is not a number, at least 0" --headless --setup XPSM --set strength=-1
refuses 2 "no option 'color'" --headless --setup XPSM --set color=red
refuses 2 "guarded: true or false" --headless --setup XPSM --set color=red
refuses 2 "KEYWORD=VALUE" --headless --setup XPSM --set strength
refuses 2 "no options that can be set" --headless --setup Ogre-Default --set strength=1

refuses 2 "there are: field" --headless --sample nowhere
refuses 2 "there are: Uniform" --headless --setup Magic
refuses 2 "no view 99" --headless --sample duel --view 99
refuses 105 "800x600" --headless --size wide
refuses 105 "120,30" --headless --light 120,steep
refuses 2 "there are: afternoon" --headless --light sideways
# A light by its name is the sun that stands there.
for light in nearly-against 168,9; do
    "$browser" --headless --sample duel --light $light --map 128 --size 160x120 --frames 1 \
        --output "$light.png" >/dev/null
done
cmp -s nearly-against.png 168,9.png || fail "the light named nearly-against is another one"
refuses 1 "no window can be opened" --sample duel
printf 'this is no model' >broken.gltf
refuses 1 "broken.gltf" --headless --scene broken.gltf
refuses 1 "missing.obj" --headless --scene missing.obj
printf 'newmtl a\nmap_Kd missing.png\n' >plain.mtl
printf 'mtllib plain.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n' >plain.obj
printf 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >>plain.obj
"$browser" --headless --scene plain.obj --map 64 --size 32x32 --frames 1 >out 2>&1
grep -q "texture 'missing.png' cannot be read" out || fail "an unreadable texture goes unsaid"
refuses 1 "could not be written" --headless --sample duel --map 64 --size 32x32 --frames 1 \
    --output no/such/folder.png
echo "All setups draw; wrong names, sizes, lights, views and files are refused with a reason."
