// What the pixels of the picture show: a frame and an event each.

/**
 * @typedef {object} Pixels
 * @property {number} width
 * @property {number} height
 * @property {Int32Array} frames -1 = none
 * @property {Int32Array | null} objects places of events; -1 = none
 */

/**
 * Reads the numbers that the program wrote as three bytes per pixel; 0 becomes -1.
 * @param {ArrayLike<number>} bytes red, green, blue and alpha of each pixel
 * @param {number} sum of all numbers
 */
export function numbersIn(bytes, sum) {
    const read = new Int32Array(bytes.length / 4);
    let found = 0;
    for (let k = 0; k < read.length; ++k) {
        const value = bytes[4 * k] << 16 | bytes[4 * k + 1] << 8 | bytes[4 * k + 2];
        found += value;
        read[k] = value - 1;
    }
    // Some browsers answer with noise, so that pages can't tell machines apart.
    if (found !== sum) throw new Error('this browser changes what pages read from pictures');
    return read;
}

/**
 * The part of a picture that differs from its corner, with a border of 1 %: left, top, right, bottom.
 * @param {ArrayLike<number>} words a colour per pixel
 * @param {number} width
 * @param {number} height
 */
export function contentsOf(words, width, height) {
    let [left, top, right, bottom] = [width, height, 0, 0];
    for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) {
            if (words[y * width + x] === words[0]) continue;
            left = Math.min(left, x);
            right = Math.max(right, x + 1);
            top = Math.min(top, y);
            bottom = Math.max(bottom, y + 1);
        }
    }
    if (right <= left) return [0, 0, width, height];
    const edge = Math.round(width / 100);
    return [Math.max(0, left - edge), Math.max(0, top - edge), Math.min(width, right + edge), Math.min(height, bottom + edge)];
}

/** @typedef {{frame: number, event: number | null, distance: number}} Near what is near a point: an event, or null = something else */

/**
 * What is within reach of a point: of each event, and of all that is none, the nearest pixel; the nearest of these first.
 * @param {Pixels | null} pixels
 * @param {number} x
 * @param {number} y
 * @param {number} reach pixels of the picture
 */
export function shownNear(pixels, x, y, reach) {
    /** @type {Map<number, Near>} */
    const nearest = new Map();
    if (!pixels) return [];
    const {width, height, frames, objects} = pixels;
    const [column, row, far] = [x, y, reach].map(Math.floor);
    for (let j = Math.max(0, row - far); j <= Math.min(height - 1, row + far); ++j) {
        for (let i = Math.max(0, column - far); i <= Math.min(width - 1, column + far); ++i) {
            const [pixel, distance] = [j * width + i, Math.hypot(i - column, j - row)];
            if (frames[pixel] < 0 || distance > reach) continue;
            const event = objects ? objects[pixel] : -1;
            const other = nearest.get(event);
            if (!other || distance < other.distance) nearest.set(event, {frame: frames[pixel], event: event < 0 ? null : event, distance});
        }
    }
    return [...nearest.values()].sort((a, b) => a.distance - b.distance);
}

/**
 * What a finger may mean of what is near it: events rather than what is none, and those that are wanted rather than pale ones.
 * @template {{event: number | null}} N
 * @param {N[]} near the nearest first
 * @param {number[]} wanted places of events
 */
export function meantByFinger(near, wanted) {
    const events = near.filter(({event}) => event !== null);
    const lit = events.filter(({event}) => event !== null && wanted.includes(event));
    return lit.length ? lit : events.length ? events : near.slice(0, 1);
}

/**
 * Returns a function that says whether a pixel shows something else than some events.
 * @param {Pixels} pixels
 * @param {number[] | null} lit places of the events; null = all, and what is of no event
 * @param {{first: number, last: number}[]} events
 * @returns {(pixel: number) => boolean}
 */
export function othersThan({frames, objects}, lit, events) {
    if (lit === null) return () => false;
    if (objects) {
        const isLit = new Uint8Array(events.length);
        for (const place of lit) isLit[place] = 1;
        return k => objects[k] < 0 || !isLit[objects[k]];
    }
    const spans = lit.map(place => [events[place].first, events[place].last]);
    return k => !spans.some(([first, last]) => frames[k] >= first && frames[k] <= last);
}
