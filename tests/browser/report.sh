#!/bin/sh
# The report's command line: report.sh REPORT. Everything here is refused before anything is drawn.
set -eu
report=$1
unset DISPLAY

# refuses STATUS TEXT OPTIONS…: the report must end with that status and say that text.
refuses() {
    status=$1 text=$2
    shift 2
    actual=0
    said=$("$report" "$@" 2>&1) || actual=$?
    case "$actual $said" in
    "$status "*"$text"*) ;;
    *)
        printf 'FAILED: %s\n' "status $actual, not $status with '$text', for: $*: $said" >&2
        exit 1
        ;;
    esac
}

refuses 105 "--lights" --lights 0
refuses 105 "--lights" --table --lights 0
for mode in --table --budgets --best-xpsm --motion --feedback; do
    refuses 108 "--set" $mode --set strength=1
done
refuses 2 "--table or --motion" --json cases.json
refuses 2 "--table or --motion" --budgets --json cases.json
refuses 2 "--table or --motion" --feedback --json cases.json
refuses 107 "--table" --size 320x240
refuses 105 "800x600" --table --size wide
refuses 107 "--table" --drawn 2
refuses 105 "--drawn" --table --drawn 0
refuses 107 "--table" --pictures pictures
refuses 108 "--pictures" --table --row Optimal --pictures pictures
refuses 1 "could not be made" --table --pictures /dev/null/pictures
refuses 2 "there are: field" --kind nowhere
refuses 2 "there are: field" --table --kind field --kind garden
refuses 2 "--motion or --feedback" --table --frames 20
refuses 108 "--kind" --motion --kind field
refuses 1 "'model' goes with --scene" --motion --sample model
refuses 105 "--frames" --motion --frames 1
refuses 2 "there are: Uniform" --setup Magic
refuses 2 "there are: Uniform" --baseline Magic
refuses 2 "Cascades-3" --table --baseline Magic
refuses 2 "strength: '-1' is not a number, at least 0" --setup XPSM --set strength=-1
echo "Wrong names, values and combinations of options are refused with a reason."
