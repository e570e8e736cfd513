#!/bin/sh
# The browser in a window, used through the keyboard: window.sh BROWSER FOLDER [garden], under an X
# server. With garden, where there is that sample.
#
# The window opens, a picture taken with F12 is the headless one to the byte, number keys switch
# setups, W flies, every mouse button looks around, and Esc ends the program. What the command line
# asks for holds when setups and views change, and a picture that cannot be written ends nothing.
set -eu
browser=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    cat log >&2
    exit 1
}

# Waits until the browser has printed a line that matches, at most 60 s.
expect() {
    for _ in $(seq 600); do
        grep -q "$1" log && return
        kill -0 "$pid" 2>/dev/null || fail "the browser ended before it said '$1'"
        sleep 0.1
    done
    fail "the browser did not say '$1'"
}

# Opens the browser with these options and keeps its window.
open_browser() {
    : >log
    "$browser" "$@" >log 2>&1 &
    pid=$!
    trap 'kill $pid 2>/dev/null || true' EXIT
    expect "F12 picture"
    window=$(xdotool search --sync --onlyvisible --name "Lixel" | head -1)
    xdotool windowfocus "$window"
}

# Writes the file that F12 writes again.
take_picture() {
    rm -f "$1"
    xdotool key F12
    for _ in $(seq 100); do [ -s "$1" ] && break; sleep 0.1; done
    sleep 0.5
    [ -s "$1" ] || fail "F12 took no picture"
}

close_browser() {
    xdotool key Escape
    for _ in $(seq 600); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    if kill -0 "$pid" 2>/dev/null; then fail "Esc did not end the browser"; fi
    wait "$pid" || fail "the browser ended with status $?"
    trap - EXIT
}

options="--sample field --setup XPSM --size 320x240 --map 512"
"$browser" --headless $options --frames 1 --output headless.png
open_browser $options --output window.png

xdotool key F12
expect "picture: .*window.png"
cmp headless.png window.png || fail "the window's picture is not the headless one"

xdotool key 1
expect "^Uniform: "
xdotool key 9
expect "^Ogre-Focused: "
xdotool key 2
expect "^XPSM: "

take_picture window.png
mv window.png before.png
xdotool keydown w
sleep 1
xdotool keyup w
take_picture window.png
if cmp -s before.png window.png; then fail "W did not move the viewer"; fi

mv window.png before.png
xdotool mousemove --window "$window" 100 100
sleep 0.5
xdotool mousedown 2
xdotool mousemove --window "$window" 140 100
sleep 0.5
xdotool mouseup 2
take_picture window.png
if cmp -s before.png window.png; then fail "the middle mouse button does not look around"; fi
close_browser

# Of Uniform, whose map is the same from the first frame on.
options="--sample miners-lamp --setup Uniform --light 30,60 --size 320x240 --map 512"
"$browser" --headless $options --view 2 --frames 1 --output headless.png
open_browser $options --output window.png
xdotool key v
xdotool key 1
expect "^Uniform: "
sleep 1
take_picture window.png
cmp headless.png window.png || fail "V lost the light that was asked for"
close_browser

options="--sample duel --setup XPSM --set strength=0 --set guarded=false --size 320x240 --map 128"
"$browser" --headless $options --frames 1 --output headless.png
open_browser $options --output window.png
xdotool key 1
expect "^Uniform: "
xdotool key 2
expect "^XPSM: "
sleep 1
take_picture window.png
cmp headless.png window.png || fail "2 lost the options that were asked for"
close_browser

open_browser --sample duel --size 320x240 --map 64 --output no/such/folder.png
xdotool key F12
expect "could not be written"
xdotool key 1
expect "^Uniform: "
close_browser

if [ "${3:-}" = garden ]; then
    open_browser --sample garden --size 320x240 --map 256 --output window.png
    xdotool key 1
    expect "^Uniform: "
    take_picture window.png
    mv window.png before.png
    xdotool key 0
    expect "^Garden/Sun: "
    take_picture window.png
    if cmp -s before.png window.png; then fail "0 did not bring the scene's own setup back"; fi
    xdotool key v v v 0
    expect "^Lixel/Point: "
    close_browser
fi
echo "Pictures equal the headless ones; 1, 2, 9, V, W, F12, Esc and mouse buttons work."
