// Shapes, and ways across lines and through rectangles, against brute force: very many of a way's moments are looked at.

import assert from 'node:assert/strict';
import test from 'node:test';
import {firstShape, inThousandths, meets, movedShape, partInBox, scaled, shapeOfText, shapeText, sidesOf} from '../../core/web/shared/shapes.js';
import {arrowAcross, boundsOf, crossingWords, crossingsOf, meetingsOf, pointOnWay, stayOf} from '../../core/web/shared/ways.js';

/** Numbers that look random, the same each time. */
function chance(seed) {
    return below => {
        seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
        return Math.floor(seed / 2 ** 32 * below);
    };
}

/** The crossings of a way, found by going along it in small steps: on which side is it, and where was it when that changed? */
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

function expectSame(found, forced, slack, what) {
    assert.deepEqual(found.map(({side}) => side), forced.map(({side}) => side), what);
    found.forEach(({at}, k) => assert.ok(Math.abs(at - forced[k].at) <= slack, `${what}: crossing ${k} at ${at}, not ${forced[k].at}`));
}

// The line goes from top to bottom, at x = 500, from y = 200 to 800.
const [top, bottom] = [[500, 200], [500, 800]];
const [left, right] = [1, -1];  // sides
const ways = [
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
];
for (const [what, way, sides] of ways) {
    test(`a way ${what}`, () => assert.deepEqual(crossingsOf(way, top, bottom).map(({at, side}) => [at, side]), sides));
}

test('crossings on a small grid are those of brute force', () => {
    // Many ends on the line, stays on it, ways along it, jumps over several points. All is exact there.
    const roll = chance(5);
    let crossed = 0;
    for (let round = 0; round < 800; ++round) {
        const [a, b] = [[roll(4), roll(4)], [roll(4), roll(4)]];
        if (a[0] === b[0] && a[1] === b[1]) continue;
        const way = [];
        for (let [k, time] = [0, 0]; k < 1 + roll(7); ++k, time += 840 * roll(3)) way.push(time, roll(4), roll(4));
        // 2520 has all whole numbers to 10 as parts; others are told from the line's ends by a slack below 1/18.
        const found = crossingsOf(way, a, b);
        crossed += found.length;
        expectSame(found, crossingsByForce(way, a, b, 2520), 2, JSON.stringify([way, a, b]));
    }
    assert.ok(crossed > 100, `too few crossings: ${crossed}`);
});

test('crossings of ways through the whole picture are those of brute force', () => {
    const roll = chance(7);
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
        expectSame(found, forced, 1 + slowest / 500, JSON.stringify([way, a, b]));
        crossed += found.length;
    }
    assert.ok(crossed > 400, `too few crossings: ${crossed}`);
});

test('stays in a rectangle are those of brute force', () => {
    const roll = chance(9);
    let stayed = 0;
    for (let round = 0; round < 200; ++round) {
        const box = sidesOf({from: [roll(1000) + 0.5, roll(1000) + 0.5], to: [roll(1000) + 0.5, roll(1000) + 0.5]});
        const way = [];
        for (let [k, time] = [0, 0]; k < 1 + roll(8); ++k, time += roll(100)) way.push(time, roll(1001), roll(1001));
        let lasts = 0;
        let first = null;
        for (let k = 0; k + 5 < way.length; k += 3) {
            for (let step = 0; step < 500; ++step) {
                const [at, x, y] = [0, 1, 2].map(n => way[k + n] + (step + 0.5) / 500 * (way[k + 3 + n] - way[k + n]));
                if (x < box[0] || x > box[2] || y < box[1] || y > box[3]) continue;
                lasts += (way[k + 3] - way[k]) / 500;
                first ??= at;
            }
        }
        const found = stayOf(way, box);
        assert.ok(Math.abs((found?.lasts ?? 0) - lasts) <= 0.02 * way.length + 1, JSON.stringify([found, lasts, way, box]));
        if (lasts > 5) assert.ok(Math.abs(found.at - first) < 2, `first at ${found.at}, not ${first}`);
        stayed += lasts > 5;
    }
    assert.ok(stayed > 40, `too few stays: ${stayed}`);
});

test('a point in a rectangle stays for no time', () => {
    assert.deepEqual(stayOf([30, 500, 500], [400, 400, 600, 600]), {at: 30, lasts: 0});
    assert.equal(stayOf([30, 300, 500], [400, 400, 600, 600]), null);
    assert.equal(stayOf([], [0, 0, 1, 1]), null);
});

test('crossings in words', () => {
    const clock = seconds => `0:${String(Math.floor(seconds)).padStart(2, '0')}`;
    const line = {from: top, to: bottom};
    assert.equal(crossingWords(crossingsOf([0, 600, 500, 128, 400, 500, 200, 700, 500], top, bottom), line, [768, 576], clock),
                 'crossed ← 0:06, → 0:15');
    const often = crossingsOf([0, 400, 500, 20, 600, 500, 40, 400, 500, 60, 600, 500, 80, 400, 500, 100, 600, 500], top, bottom);
    assert.equal(crossingWords(often, line, [768, 576], clock), 'crossed 5 times (← 2, → 3): → 0:01, ← 0:03, → 0:05, ← 0:07, and 1 more');
});

test('who is back within a second has touched a line, and not crossed it', () => {
    const clock = seconds => seconds.toFixed(1);
    const words = way => crossingWords(meetingsOf(way, top, bottom), {from: top, to: bottom}, [768, 576], clock);
    const sides = way => meetingsOf(way, top, bottom).map(({side}) => side);
    assert.equal(words([0, 490, 500, 4, 510, 500, 8, 490, 500]), 'touched 0.2');
    assert.deepEqual(sides([0, 490, 500, 12, 510, 500, 24, 490, 500]), [1, -1].map(side => side * meetingsOf([0, 490, 500, 9, 510, 500], top, bottom)[0].side));
    // Whoever trembles on the line and goes on has crossed it once.
    const [across] = sides([0, 400, 500, 9, 600, 500]);
    assert.deepEqual(sides([0, 490, 500, 2, 510, 500, 4, 490, 500, 6, 510, 500, 99, 900, 500]), [0, across]);
    assert.equal(words([0, 490, 500, 2, 510, 500, 4, 490, 500, 6, 510, 500, 99, 900, 500]), 'crossed → 0.5');
    assert.deepEqual(sides([0, 400, 500, 9, 600, 500]), [across]);
});

test('an arrow across a line is that of the way that is seen', () => {
    // A line at 45 degrees of the picture's shares is not at 45 degrees of a wide picture.
    assert.equal(arrowAcross({from: [0, 0], to: [1, 0]}, 1, [100, 100]), '↓');
    assert.equal(arrowAcross({from: [0, 0], to: [1, 0]}, -1, [100, 100]), '↑');
    assert.equal(arrowAcross({from: [0, 0], to: [1, 1]}, 1, [100, 100]), '↙');
    assert.equal(arrowAcross({from: [0, 0], to: [1, 1]}, -1, [100, 100]), '↗');
    assert.equal(arrowAcross({from: [0, 0], to: [1, 1]}, -1, [400, 100]), '↑');
});

test('the part of a stretch in a rectangle', () => {
    const box = [10, 10, 20, 20];
    assert.deepEqual(partInBox(0, 15, 30, 15, box), [1 / 3, 2 / 3]);
    assert.deepEqual(partInBox(30, 15, 0, 15, box), [1 / 3, 2 / 3]);
    assert.deepEqual(partInBox(15, 12, 15, 18, box), [0, 1]);
    assert.equal(partInBox(0, 25, 30, 25, box), null);
    assert.equal(partInBox(0, 0, 9, 9, box), null);
    assert.deepEqual(partInBox(0, 0, 10, 10, box), [1, 1]);  // it ends at the corner
});

test('shapes that keys move stay in the picture', () => {
    const line = firstShape('line', 1000);
    assert.deepEqual(line, {kind: 'line', from: [500, 200], to: [500, 800]});
    assert.deepEqual(movedShape(line, 'from', [30, -500], 1000), {kind: 'line', from: [530, 0], to: [500, 800]});
    assert.deepEqual(movedShape(line, 'to', [-10, 0], 1000), {kind: 'line', from: [500, 200], to: [490, 800]});
    assert.deepEqual(movedShape(line, null, [700, 900], 1000), {kind: 'line', from: [1000, 400], to: [1000, 1000]});
    assert.deepEqual(movedShape(firstShape('box', 100), null, [-90, -1], 100), {kind: 'box', from: [0, 34], to: [30, 64]});
});

test('shapes in addresses', () => {
    const line = {kind: 'line', from: [500, 0], to: [500, 1000]};
    assert.equal(shapeText(line), 'line.500.0.500.1000');
    assert.deepEqual(inThousandths({kind: 'line', from: [0.4996, 0], to: [0.5, 1]}, 1), line);
    // What is drawn is what its address says, in the units of page and index, and both compare ways with the same.
    for (let k = 0; k <= 1000; ++k) {
        const drawn = {kind: 'box', from: [k / 1000 + 0.0004, 0], to: [1, 1 - k / 1000]};
        const read = shapeOfText(shapeText(inThousandths(drawn, 1)));
        assert.deepEqual(read, inThousandths(scaled(drawn, 1000), 1000));
        assert.deepEqual(inThousandths(scaled(read, 1 / 1000), 1), read);
    }
    for (const text of [null, '', 'line', 'line.1.2.3', 'line.1.2.3.x', 'line.1.2.3.1001', 'oval.1.2.3.4', 'box.1.2.3.4.5', 'box.-1.2.3.4']) {
        assert.equal(shapeOfText(text), null, text);
    }
});

test('where a way is at a time', () => {
    const way = [10, 0, 100, 20, 100, 100, 40, 100, 300];
    assert.deepEqual([0, 10, 15, 20, 30, 40, 99].map(at => pointOnWay(way, at)), [[0, 100], [0, 100], [50, 100], [100, 100], [100, 200], [100, 300], [100, 300]]);
    assert.deepEqual(pointOnWay([5, 1, 2], 7), [1, 2]);
});

test('shapes and the boxes about ways', () => {
    assert.deepEqual(sidesOf({from: [5, 1], to: [2, 7]}), [2, 1, 5, 7]);
    assert.deepEqual(scaled({kind: 'line', from: [0.1, 0.25], to: [1, 0]}, 1000), {kind: 'line', from: [100, 250], to: [1000, 0]});
    assert.deepEqual(boundsOf([0, 5, 6, 1, 2, 9, 2, 4, 1]), [2, 1, 5, 9]);
    assert.equal(meets([0, 0, 2, 2], [2, 2, 3, 3]), true);
    assert.equal(meets([0, 0, 2, 2], [2.1, 0, 3, 3]), false);
    assert.equal(meets([0, 0, 2, 2], [0, 2.1, 3, 3]), false);
    assert.equal(meets(boundsOf([]), [0, 0, 1000, 1000]), false);
});
