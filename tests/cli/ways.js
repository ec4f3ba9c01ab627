// Holds the shared functions of page and index that ask ways (core/page/shared/ways.js) against brute force, by looking
// at very many of a way's moments. It runs in node, and in the browser within a page and an index. Gives what is wrong.

/// Numbers that look random, the same each time.
function chance(seed) {
    return below => {
        seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
        return Math.floor(seed / 2 ** 32 * below);
    };
}

/// The crossings of a way, found by going along it in small steps: on which side is it, and where was it when that changed?
function crossingsByForce(way, [ax, ay], [bx, by], steps) {
    const crossings = [];
    const length = Math.hypot(bx - ax, by - ay);
    let last = null;   // {side, at, x, y} of the last moment on one of the sides
    let onLine = null; // of the last moment on the line since then
    const look = (at, x, y) => {
        const off = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
        const side = Math.abs(off) < 1e-7 ? 0 : off < 0 ? -1 : 1;
        if (side === 0) {
            onLine = {at, x, y};
            return;
        }
        if (last && last.side !== side) {
            const place = onLine ?? {at: (last.at + at) / 2, x: (last.x + x) / 2, y: (last.y + y) / 2};
            const along = ((place.x - ax) * (bx - ax) + (place.y - ay) * (by - ay)) / length ** 2;
            const slack = onLine ? 1e-9 : Math.hypot(x - last.x, y - last.y) / length + 1e-9;
            if (along >= -slack && along <= 1 + slack) crossings.push({at: place.at, side, near: along < slack || along > 1 - slack});
        }
        [last, onLine] = [{side, at, x, y}, null];
    };
    for (let k = 0; k + 5 < way.length; k += 3) {
        for (let step = 0; step <= steps; ++step) {
            const share = step / steps;
            const [at, x, y] = [0, 1, 2].map(n => way[k + n] + share * (way[k + 3 + n] - way[k + n]));
            look(at, x, y);
        }
    }
    return crossings;
}

/// What two lists of crossings differ in; '' = nothing.
function difference(found, forced, slack) {
    if (found.length !== forced.length) return `${found.length} crossings, not ${forced.length}`;
    for (let k = 0; k < found.length; ++k) {
        if (found[k].side !== forced[k].side) return `crossing ${k} goes to side ${found[k].side}`;
        if (Math.abs(found[k].at - forced[k].at) > slack) return `crossing ${k} at ${found[k].at}, not ${forced[k].at}`;
    }
    return '';
}

function faultsOfWays() {
    const faults = [];
    const tell = (what, ...of) => { if (what) faults.push(`${what}: ${of.map(value => JSON.stringify(value)).join(' ')}`); };

    // Each of these has been a case of its own: the line goes from top to bottom, at x = 500, from y = 200 to 800.
    const [top, bottom] = [[500, 200], [500, 800]];
    const [left, right] = [1, -1];  // sides
    for (const [what, way, sides] of [
        ['to the right', [0, 400, 500, 10, 600, 500], [[5, right]]],
        ['to the left', [0, 600, 500, 10, 400, 500], [[5, left]]],
        ['there and back', [0, 600, 500, 10, 400, 500, 50, 700, 500], [[5, left], [23, right]]],
        ['beside it', [0, 100, 500, 10, 499, 500], []],
        ['above it', [0, 400, 199, 10, 600, 199], []],
        ['below it', [0, 400, 801, 10, 600, 801], []],
        ['over its upper end', [0, 400, 200, 10, 600, 200], [[5, right]]],
        ['over its lower end', [0, 600, 900, 10, 400, 700], [[5, left]]],
        ['comes to it and goes back', [0, 400, 500, 10, 500, 500, 20, 400, 500], []],
        ['comes to it, waits, goes back', [0, 400, 500, 10, 500, 500, 90, 500, 500, 99, 400, 300], []],
        ['comes to it, waits, goes on', [0, 400, 500, 10, 500, 500, 90, 500, 500, 99, 600, 500], [[90, right]]],
        ['walks along it and goes on', [0, 400, 500, 10, 500, 500, 90, 500, 300, 99, 600, 300], [[90, right]]],
        ['walks along it beyond its end', [0, 400, 500, 10, 500, 500, 90, 500, 100, 99, 600, 100], []],
        ['begins on it', [0, 500, 500, 10, 600, 500], []],
        ['ends on it', [0, 400, 500, 10, 500, 500], []],
        ['is on it all the time', [0, 500, 500, 10, 500, 600], []],
        ['round its end and back through it', [0, 400, 100, 10, 600, 100, 20, 600, 500, 30, 400, 500], [[25, left]]],
        ['jumps over it at one moment', [7, 400, 500, 7, 600, 500], [[7, right]]],
        ['a gap of an hour', [0, 400, 500, 36000, 600, 500, 36010, 400, 500], [[18000, right], [36005, left]]],
        ['one point', [0, 500, 500], []],
        ['none', [], []],
    ]) {
        const found = crossingsOf(way, top, bottom).map(({at, side}) => [at, side]);
        if (JSON.stringify(found) !== JSON.stringify(sides)) tell(what, found, sides);
    }

    // A small grid: many ends on the line, stays on it, ways along it, jumps over several points. All is exact there.
    const roll = chance(5);
    for (let round = 0; round < 800; ++round) {
        const [a, b] = [[roll(4), roll(4)], [roll(4), roll(4)]];
        if (a[0] === b[0] && a[1] === b[1]) continue;
        const way = [];
        for (let [k, time] = [0, 0]; k < 1 + roll(7); ++k, time += 840 * roll(3)) way.push(time, roll(4), roll(4));
        // 2520 has all whole numbers to 10 as parts; others are told from the line's ends by a slack below 1/18.
        const steps = 2520;
        tell(difference(crossingsOf(way, a, b), crossingsByForce(way, a, b, steps), 2), way, a, b);
    }

    // Ways as they are: through the whole picture, with jumps over several lines, gaps, and several points at one time.
    let crossed = 0;
    for (let round = 0; round < 600; ++round) {
        const [a, b] = [[roll(1000) + 0.37, roll(1000) + 0.61], [roll(1000) + 0.19, roll(1000) + 0.83]];
        const way = [];
        let time = roll(100);
        for (let k = 0; k < 2 + roll(12); ++k) {
            way.push(time, roll(1001), roll(1001));
            time += roll(10) === 0 ? 36000 : roll(30);
        }
        const forced = crossingsByForce(way, a, b, 500);
        if (forced.some(({near}) => near)) continue;  // so close to an end that steps don't tell
        const found = crossingsOf(way, a, b);
        const slowest = Math.max(...way.filter((_, k) => k % 3 === 0).map((at, k, all) => k ? at - all[k - 1] : 0));
        tell(difference(found, forced, 1 + slowest / 500), way, a, b);
        crossed += found.length;
    }
    if (crossed < 400) tell('too few crossings to be a test', crossed);

    // Stays in a rectangle.
    for (let round = 0; round < 200; ++round) {
        const box = sidesOf({from: [roll(1000) + 0.5, roll(1000) + 0.5], to: [roll(1000) + 0.5, roll(1000) + 0.5]});
        const way = [];
        for (let [k, time] = [0, 0]; k < 1 + roll(8); ++k, time += roll(100)) way.push(time, roll(1001), roll(1001));
        let lasts = 0;
        for (let k = 0; k + 5 < way.length; k += 3) {
            for (let step = 0; step < 500; ++step) {
                const [x, y] = [1, 2].map(n => way[k + n] + (step + 0.5) / 500 * (way[k + 3 + n] - way[k + n]));
                if (x >= box[0] && x <= box[2] && y >= box[1] && y <= box[3]) lasts += (way[k + 3] - way[k]) / 500;
            }
        }
        const found = stayOf(way, box)?.lasts ?? 0;
        if (Math.abs(found - lasts) > 0.02 * way.length + 1) tell('stay', found, lasts, way, box);
    }

    const clock = seconds => `0:${String(Math.floor(seconds)).padStart(2, '0')}`;
    const line = {from: top, to: bottom};
    const words = crossingWords(crossingsOf([0, 600, 500, 128, 400, 500, 200, 700, 500], top, bottom), line, [768, 576], clock);
    if (words !== 'crossed ← 0:06, → 0:15') tell('words', words);
    const often = crossingsOf([0, 400, 500, 20, 600, 500, 40, 400, 500, 60, 600, 500, 80, 400, 500, 100, 600, 500], top, bottom);
    const told = crossingWords(often, line, [768, 576], clock);
    if (told !== 'crossed 5 times (← 2, → 3): → 0:01, ← 0:03, → 0:05, ← 0:07, and 1 more') tell('words', told);
    return faults;
}
