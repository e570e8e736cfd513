#!/bin/sh
# The browser in a window, used through the keyboard: window.sh BROWSER FOLDER, under an X server.
#
# The window opens, a picture taken with F12 is the headless one to the byte, number keys switch
# setups, W flies, and Esc ends the program.
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

options="--sample field --setup XPSM --size 320x240 --map 512"
"$browser" --headless $options --frames 1 --output headless.png

: >log
"$browser" $options --output window.png >log 2>&1 &
pid=$!
trap 'kill $pid 2>/dev/null || true' EXIT
expect "F12 picture"
window=$(xdotool search --sync --onlyvisible --name "Lixel" | head -1)
xdotool windowfocus "$window"

xdotool key F12
expect "picture: .*window.png"
cmp headless.png window.png || fail "the window's picture is not the headless one"

xdotool key 1
expect "^Uniform: "
xdotool key 9
expect "^Ogre-Focused: "
xdotool key 2
expect "^XPSM: "

mv window.png before.png
xdotool keydown w
sleep 1
xdotool keyup w
xdotool key F12
for _ in $(seq 100); do [ -s window.png ] && break; sleep 0.1; done
sleep 0.5
[ -s window.png ] || fail "F12 took no second picture"
if cmp -s before.png window.png; then fail "W did not move the viewer"; fi

xdotool key Escape
for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
if kill -0 "$pid" 2>/dev/null; then fail "Esc did not end the browser"; fi
wait "$pid" || fail "the browser ended with status $?"
trap - EXIT
echo "The window's picture equals the headless one; 1, 2, 9, W, F12 and Esc work."
