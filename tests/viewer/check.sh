#!/bin/sh
# Checks one behaviour of osgwaterviewer. Pictures go to the current directory.
# usage: check.sh BEHAVIOUR OSGWATERVIEWER MEASURE_PICTURE DATA_DIRECTORY
set -u

behaviour=$1
viewer=$2
measure=$3
data=$4
tower=$(dirname "$0")/tower.ply
unset DISPLAY OSG_WINDOW OSG_SCREEN OSGWATERREFLECT_DATA

fail()
{
    echo "FAILED: $*" >&2
    exit 1
}

# refused TEXT ARGUMENTS...: exit status 1 and one line on stderr, with that text in it.
refused()
{
    text=$1
    shift
    "$viewer" "$@" > "$behaviour.out" 2> "$behaviour.err"
    status=$?
    [ $status -eq 1 ] || fail "expected exit status 1, got $status: $*"
    lines=$(wc -l < "$behaviour.err")
    [ "$lines" -eq 1 ] || fail "expected one line on stderr, got $lines: $*"
    grep -qF -e "$text" "$behaviour.err" ||
        fail "expected '$text', got '$(cat "$behaviour.err")': $*"
}

# picture NAME ARGUMENTS...: a small picture NAME of this behaviour, its report in NAME.txt.
picture()
{
    name=$behaviour-$1
    shift
    rm -f "$name.png"
    "$viewer" --size 96x72 --frames 1 "$@" --offscreen "$name.png" > "$name.txt" ||
        fail "expected a picture, got exit status $?: $*"
    [ -f "$name.png" ] || fail "expected $name.png, got no file: $*"
}

# differ FIRST SECOND: the pictures differ in at least fifty pixels, more than noise would.
differ()
{
    differences=$("$measure" "$behaviour-$1.png" "$behaviour-$2.png" | cut -d ' ' -f 4)
    [ "${differences:-0}" -ge 50 ] ||
        fail "expected $1 and $2 to differ, got ${differences:-no} pixels"
}

reported()
{
    grep -q "$2" "$behaviour-$1.txt" || fail "expected '$2', got: $(cat "$behaviour-$1.txt")"
}

help()
{
    "$viewer" --help > help.txt || fail "expected exit status 0, got $?"
    for option in --help --help-env --help-keys --help-all --water --sky --no-sky --camera --fovy \
        --search --capture --thickness --stride --capture-scale --trace-scale --guard-band \
        --max-extra-pixels --guard-band-share --frame-time --refractive-index --water-colour \
        --max-edge-pixels --max-error-pixels --max-vertices --debug-view --offscreen --size \
        --time --frames --waves --wave-length --wave-direction -p
    do
        grep -q -e "^  $option\( \|\$\)" help.txt || fail "expected $option in the help"
    done
    grep -q "\[1\.333\]" help.txt || fail "expected the defaults in the help"
    "$viewer" --help-keys > keys.txt || fail "expected exit status 0, got $?"
    for key in d h r s u x 1 6
    do
        grep -q "^  $key  " keys.txt || fail "expected the key $key in the help"
    done
    "$viewer" --help-env | grep -q OSGWATERREFLECT_DATA || fail "expected the variable in the help"
}

wrong_options()
{
    refused --no-such-option --no-such-option
    refused --size --size
    refused --sky --sky --no-sky
    refused --no-sky --sky "$data/sky" --no-sky
    refused --search --search nearest
    refused --capture --capture view_and_mirror
    refused --guard-band --guard-band wide
    refused --debug-view --debug-view 2
    refused --size --size 96x72
    refused --time --time 1
    refused --frames --frames 2
}

wrong_numbers()
{
    refused --stride --stride 3x
    refused --stride --stride 1.5
    refused --thickness --thickness nan
    refused --thickness --thickness inf
    refused --thickness --thickness ''
    refused --max-vertices --max-vertices -5
    refused --wave-length --wave-length 1e999
    refused --water-colour --water-colour 0,0
    refused --water-colour --water-colour 0,0,0,
    refused --camera --camera 1,2,3,4,5
    refused --camera --camera 1,2,3,4,5,6,7
    refused --camera --camera 1,2,3,1,2,3
    refused --fovy --fovy 46degrees
    refused --water --water high "$tower"
    refused --time --time 1s --offscreen wrong.png
    for size in 0x0 0x72 96x-72 96 96x72x1 96X72 99999999999x1
    do
        refused --size --size $size --offscreen wrong.png
    done
}

wrong_ranges()
{
    refused stride --stride 0
    refused stride --stride 65
    refused thickness --thickness -1
    refused captureScale --capture-scale 1.5
    refused traceScale --trace-scale 0
    refused maxExtraPixels --max-extra-pixels 3.1
    refused guardBandShare --guard-band-share -0.1
    refused frameTimeTarget --frame-time -1
    refused refractiveIndex --refractive-index 0.9
    refused waterColour --water-colour 0,2,0
    refused maxEdgePixels --max-edge-pixels 0
    refused maxErrorPixels --max-error-pixels 0
    refused maxVertices --max-vertices 10
    refused steepness --waves 1
    refused length --wave-length 0
    refused --fovy --fovy 180
    refused --frames --frames 0 --offscreen wrong.png
    refused --size --size 1000000x1 "$tower" --offscreen wrong.png
}

wrong_files()
{
    refused no-such-model.obj no-such-model.obj
    refused check.sh "$0"
    refused no-such-model.obj "$tower" no-such-model.obj
    refused no-such-sky --sky no-such-sky "$tower"
    refused no-such-path -p no-such-path "$tower"
    refused no-such-directory "$tower" --size 8x8 --offscreen no-such-directory/wrong.png
    refused wrong.format "$tower" --size 8x8 --offscreen wrong.format
}

picture_size()
{
    picture small "$tower" --size 37x21 # odd sizes find wrong row lengths
    set -- $("$measure" "$behaviour-small.png")
    [ "$1x$2" = 37x21 ] || fail "expected 37x21, got $1x$2"
    [ "$3" -gt 1 ] || fail "expected a picture of more than one colour"
    reported small "^picture: .*37x21"
    reported small "^frame: "
}

water_differs()
{
    picture without "$tower"
    picture with "$tower" --water auto
    differ without with
    reported without "^waters: 0"
    reported without "water auto"
    reported with "^waters: 1"
}

levels_differ()
{
    picture automatic "$tower" --water auto
    picture tenth "$tower" --water 1
    picture negative "$tower" --water -1
    cmp -s "$behaviour-automatic.png" "$behaviour-tenth.png" ||
        fail "expected automatic water at a tenth of the height"
    differ automatic negative
}

# Millimetres or metres: the same picture, but for what rounding does to a pixel here and there.
scale_does_not_matter()
{
    picture metres "$tower" --water auto --waves 0.1
    picture millimetres "$tower.1000,1000,1000.scale" --water auto --waves 0.1
    differences=$("$measure" "$behaviour-metres.png" "$behaviour-millimetres.png" | cut -d ' ' -f 4)
    [ "${differences:-9999}" -lt 50 ] || fail "expected one picture, got $differences other pixels"
}

waves_and_time_differ()
{
    picture calm --time 1
    picture now --waves 0.15
    picture later --waves 0.15 --time 1
    differ calm now
    differ now later
    reported calm "^waves: none"
    reported now "^waves: steepness 0.15"
}

camera_and_field_differ()
{
    picture home "$tower"
    picture above "$tower" --camera 0,0,50,0,0,0
    picture wide "$tower" --camera 0,0,50,0,0,0 --fovy 20
    differ home above
    differ above wide
}

debug_view_differs()
{
    picture none "$tower" --water auto
    for view in reason reflection
    do
        picture $view "$tower" --water auto --debug-view $view
        differ none $view
    done
}

search_is_reported()
{
    for search in sequential binary hierarchical
    do
        picture $search "$tower" --water auto --search $search --stride 2 --thickness 2
        reported $search "^search: $search, thickness 2"
    done
}

# A copy has another name, so that only its Geode says where water is.
water_geodes_are_replaced()
{
    cp "$data/lake.osgb" copy.osgb
    picture copy copy.osgb --camera 0,-30,2.2,0,0,2.6 --fovy 46 --sky "$data/sky"
    picture lake
    reported copy "^waters: 1"
    cmp -s "$behaviour-copy.png" "$behaviour-lake.png" ||
        fail "expected the copy of the lake to look like the lake"
}

sky_differs()
{
    picture without "$tower" --water auto
    picture with "$tower" --water auto --sky "$data/sky"
    differ without with
}

data_directory()
{
    OSGWATERREFLECT_DATA=no-such-directory
    export OSGWATERREFLECT_DATA
    refused no-such-directory
}

no_display()
{
    refused display "$tower"
}

"$behaviour"
