#!/bin/sh
# Each kind of the garden's casters alone: casters.sh REPORT. Lixel's shadows have to be those of what
# is seen; OGRE's are printed beside them.
set -eu
unset DISPLAY
said=$("$1" --casters)
printf '%s\n' "$said"
printf '%s\n' "$said" | awk '
    # Kind, pixels in shadow, then percent of them that are wrong.
    /^(whole|with holes|bent in hardware|instances, with holes|all) / {
        ++kinds
        shadowed = $(NF - 4)
        wrong = $(NF - 3)
        ogres = $(NF - 1)
        if (shadowed < 300 || wrong > 20) { print "FAILED: " $0; failed = 1 }
        # OGRE draws whole bodies well, and what is bent at rest: else these are not its shadows.
        if ($1 == "whole" && ogres > 20) { print "FAILED (OGRE): " $0; failed = 1 }
        if ($1 == "bent" && ogres < 50) { print "FAILED (OGRE): " $0; failed = 1 }
    }
    END { exit failed || kinds != 5 }'
