// The stretches in which something happens, for playing the events one after another.

/**
 * The times of events, joined where they overlap or nearly touch.
 * @param {{first: number, last: number}[]} events
 * @param {number} apart frames that may lie between two that are joined
 * @returns {{first: number, last: number}[]} in order
 */
export function busyStretches(events, apart) {
    /** @type {{first: number, last: number}[]} */
    const stretches = [];
    for (const {first, last} of [...events].sort((a, b) => a.first - b.first)) {
        const before = stretches.at(-1);
        if (before && first <= before.last + apart) before.last = Math.max(before.last, last);
        else stretches.push({first, last});
    }
    return stretches;
}

/**
 * Where playing the stretches goes on from a frame: within the stretch there, else in the next one; null = they are over.
 * @param {{first: number, last: number}[]} stretches
 * @param {number} frame
 */
export function stretchFrom(stretches, frame) {
    const next = stretches.find(({last}) => last > frame);
    return next ? {from: Math.max(next.first, frame), last: next.last} : null;
}

/**
 * The event to look at in a frame: of those that are there, the one that came last; -1 = none.
 * @param {{first: number, last: number}[]} events
 * @param {number[]} places
 * @param {number} frame
 */
export function newestAt(events, places, frame) {
    let newest = -1;
    for (const place of places) {
        const {first, last} = events[place];
        if (first <= frame && frame <= last && (newest < 0 || first >= events[newest].first)) newest = place;
    }
    return newest;
}
