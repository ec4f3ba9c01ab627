#!/bin/sh
# Draws each clip of a folder that has no picture yet, or an older one: new-clips.sh CLIPS PICTURES
# For cron, which sends a mail with whatever is printed, and nothing is unless a clip fails:
#
#     */10 * * * * /usr/local/bin/new-clips.sh /srv/cctv /srv/pictures
set -u
clips=$1
pictures=$2
mkdir -p "$pictures" || exit
exec 9>"$pictures/.lock"
flock -n 9 || exit 0 # the last run still draws

failed=0
for clip in "$clips"/*; do
    picture=$pictures/$(basename "$clip").png
    [ -f "$clip" ] || continue
    [ "$picture" -nt "$clip" ] && continue
    vvr render "$clip" -o "$picture" --quiet || failed=1
done
exit $failed
