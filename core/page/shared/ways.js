
// ---- Ways of objects, [time, x, y, time, x, y, ...]: tenths of a second, thousandths of the picture's width and height.
// Page and index have the same ways, and ask them here, so that they give the same answers.

/// On which side of the line from (ax, ay) to (bx, by) a point is: the sign says it; 0 = on the line.
const sideOf = ([ax, ay], [bx, by], x, y) => Math.sign((bx - ax) * (y - ay) - (by - ay) * (x - ax));

/// Where the way from one point to the next meets the line through a and b, as a share of the way.
function shareAt([ax, ay], [bx, by], x, y, toX, toY) {
    const before = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    const after = (bx - ax) * (toY - ay) - (by - ay) * (toX - ax);
    return before / (before - after);
}

/// Each time that a way goes across the line from a to b, in order: {at, side}, the tenths of a second at which it leaves the
/// line, and the side to which it goes, 1 or -1. Who comes to the line, stands on it and goes back did not cross it, nor
/// did who was on it at first, or is on it at last.
function crossingsOf(way, a, b) {
    const crossings = [];
    let from = 0;  // the side on which it was last
    for (let k = 0; k < way.length; k += 3) {
        const [time, x, y] = [way[k], way[k + 1], way[k + 2]];
        const side = sideOf(a, b, x, y);
        if (side === 0) continue;
        if (from !== 0 && side !== from) {
            const [before, lastX, lastY] = [way[k - 3], way[k - 2], way[k - 1]];
            const ends = [a, b].map(end => sideOf([lastX, lastY], [x, y], ...end));
            if (ends[0] * ends[1] <= 0) {
                crossings.push({at: Math.round(before + shareAt(a, b, lastX, lastY, x, y) * (time - before)), side});
            }
        }
        from = side;
    }
    return crossings;
}

/// How long a way is within a rectangle, and when first, both in tenths of a second; null = never.
function stayOf(way, box) {
    let [lasts, first] = [0, null];
    for (let k = 0; k < way.length; k += 3) {
        const next = Math.min(k + 3, way.length - 3);
        const part = partInBox(way[k + 1], way[k + 2], way[next + 1], way[next + 2], box);
        if (!part) continue;
        const length = way[next] - way[k];
        first ??= way[k] + part[0] * length;
        lasts += (part[1] - part[0]) * length;
    }
    return first === null ? null : {at: Math.round(first), lasts};
}

/// An arrow for the way across a line, as it is seen, y downwards: the line's normal on the side to which it went.
/// \param size of the picture in pixels, of which the places are shares or other parts
function arrowAcross({from, to}, side, [width, height]) {
    const [x, y] = [-(to[1] - from[1]) * height * side, (to[0] - from[0]) * width * side];
    return '→↘↓↙←↖↑↗'[(Math.round(Math.atan2(y, x) / (Math.PI / 4)) + 8) % 8];
}

const mostCrossings = 4;  // that are told one by one

/// "crossed ← 0:06, → 0:10"
/// \param clock that writes a time, given in seconds
function crossingWords(crossings, line, size, clock) {
    const told = crossings.slice(0, mostCrossings).map(({at, side}) => `${arrowAcross(line, side, size)} ${clock(at / 10)}`).join(', ');
    const more = crossings.length - mostCrossings;
    if (more <= 0) return 'crossed ' + told;
    const counts = [1, -1].map(side => [arrowAcross(line, side, size), crossings.filter(crossing => crossing.side === side).length]);
    const both = counts.filter(([, count]) => count > 0).map(([arrow, count]) => `${arrow} ${count}`).join(', ');
    return `crossed ${crossings.length} times (${both}): ${told}, and ${more} more`;
}
