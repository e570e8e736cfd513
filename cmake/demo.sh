#!/bin/sh
# Shows Lixel: prepares this machine, builds the sample browser, and draws real scenes.
#
#     sh cmake/demo.sh                  a window where there is a display, else pictures
#     sh cmake/demo.sh --headless       pictures in build/demo/, with or without a display
#     sh cmake/demo.sh OPTIONS…         lixel-browser with these options (--help lists them), in a
#                                       window where there is a display, else one picture, which
#                                       is build/demo/picture.png unless --output says otherwise
#
# The pictures come with a table: how many percent of the pixels are wrong compared with exact,
# ray-traced shadows, and how long a frame takes.
set -eu
cd "$(dirname "$0")/.."
export LC_ALL=C

say() { printf '== %s\n' "$*"; }

browser=build/bin/lixel-browser
pictures=build/demo
model=/usr/share/assimp/models/IFC/AC14-FZK-Haus.ifc

# A number or a name of the statistics that the browser has written.
statistic() {
    sed -n 's/^ *"'"$1"'": "*\([0-9A-Za-z/.+-]*\)"*,*$/\1/p' "$pictures/statistics.json"
}

# picture FILE OPTIONS…: draws one and prints its line of the table.
picture() {
    file=$pictures/$1.png
    shift
    "$browser" --headless --size 800x600 "$@" \
        --output "$file" --stats "$pictures/statistics.json" >/dev/null
    printf '%-36s %-11s %4d %10.3f %10.1f\n' "$file" "$(statistic setup)" "$(statistic map)" \
        "$(statistic error_percent)" "$(statistic frame_ms)"
}

sh cmake/setup.sh
say "Building lixel-browser"
NINJA_STATUS='[%f of %t, %e s] ' ninja -C build lixel-browser
mkdir -p "$pictures"

headless=
if [ "${1:-}" = --headless ]; then
    headless=yes
    shift
fi

if [ -n "${DISPLAY:-}" ] && [ -z "$headless" ]; then
    say "Opening a window. Its mouse and keys:"
    status=0
    "$browser" "$@" || status=$?
    # 1 says that there is no window; what else went wrong stays wrong.
    [ "$status" = 1 ] || exit "$status"
    say "No window could be opened. Drawing without one."
fi

if [ $# -gt 0 ]; then
    case " $* " in
    *" --output"*) ;;
    *) set -- --output "$pictures/picture.png" "$@" ;;
    esac
    exec "$browser" --headless "$@"
fi

say "Drawing without a display, on $(nproc) CPU cores"
printf '\n%-36s %-11s %4s %10s %10s\n' "picture" "setup" "map" "wrong (%)" "frame (ms)"
picture field --sample field --map 512
picture field-uniform --setup Uniform --sample field --map 512
picture duel --sample duel
picture miners-lamp --sample miners-lamp
picture street --sample street
# Where Lixel is built with OGRE's shader system.
if "$browser" --list | grep -qx '  garden'; then
    picture garden --sample garden
    picture garden-lantern --sample garden --view 4
fi
picture model --scene "$model" --view 3 --light 75,25
cat <<END

wrong: of the pixels that the light can reach, how many have a shadow where there should be
       light or light where there should be a shadow, compared with exact shadows
frame: CPU time of one frame on all cores, drawn by software

The pictures are in $PWD/$pictures.
field.png and field-uniform.png show the same with shadow maps of the same size: compare the
shadows' edges near the viewer.
END
