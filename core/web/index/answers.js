// Answers of the view Scene: which events have to do with a place, where they were, and when.

import {shortSpanOf} from '../shared/durations.js';
import {meets, sidesOf} from '../shared/shapes.js';
import {clamp} from '../shared/text.js';
import {daysBefore} from '../shared/wall_clock.js';
import {boundsOf, crossingWords, meetingsOf, missingWords, stayOf, stayWords, staysOf} from '../shared/ways.js';

/**
 * @typedef {import('../shared/shapes.js').Shape} Shape
 * @typedef {import('./clips.js').Clip} Clip
 *
 * @typedef {object} SceneEvent
 * @property {Clip} clip
 * @property {import('../shared/kinds.js').Kind} kind
 * @property {string} what its class; '' = unknown
 * @property {number} number
 * @property {number} still seconds
 * @property {number[]} way
 * @property {number[]} bounds of the way
 *
 * @typedef {import('../shared/ways.js').Crossing} Crossing
 * @typedef {object} Answer
 * @property {number} at the second of the clip
 * @property {number[]} ways the sides to which it crossed a line
 * @property {() => string} words what there is to say; '' = only for how long it was in view
 *
 * @typedef {{event: SceneEvent, how: Answer}} Found
 *
 * @typedef {object} Clock
 * @property {(event: SceneEvent, seconds: number) => boolean} has whether a moment is asked for
 * @property {(event: SceneEvent, seconds: number) => string} text
 */

/**
 * @param {Clip} clip
 * @param {import('./data.js').EventRow} row
 * @param {(name: string) => import('../shared/kinds.js').Kind} kindOf
 * @returns {SceneEvent}
 */
export function eventOf(clip, [kind, number, still, ...rest], kindOf) {
    const last = rest[rest.length - 1];
    const what = typeof last === 'string' ? last : '';
    const way = /** @type {number[]} */ (what ? rest.slice(0, -1) : rest);
    return {clip, kind: kindOf(String(kind)), what, number: Number(number), still: Number(still) / 10, way, bounds: boundsOf(way)};
}

/**
 * What an event has to do with a place, within the time that is asked for; null = nothing.
 * @param {SceneEvent} event
 * @param {Shape | null} place in thousandths of the scene; null = everywhere
 * @param {number} way the side to which a line is crossed; 0 = both
 * @param {number[]} size of the scene
 * @param {Clock} clock
 * @returns {Answer | null}
 */
export function answerOf(event, place, way, size, clock) {
    if (place && !meets(event.bounds, sidesOf(place))) return null;
    const {isOfScene} = event.kind;
    if (place?.kind === 'line') {
        if (isOfScene) return null;  // what is not there crosses nothing
        const meetings = meetingsOf(event.way, place.from, place.to).filter(({at}) => clock.has(event, at / 10));
        const wanted = meetings.find(({side}) => way === 0 ? side !== 0 : side === way);
        if (!meetings.length) return null;
        return {at: (wanted ?? meetings[0]).at / 10, ways: [1, -1].filter(one => meetings.some(({side}) => side === one)),
                words: () => crossingWords(meetings, place, size, seconds => clock.text(event, seconds))};
    }
    const box = place ? sidesOf(place) : null;
    const spans = box ? staysOf(event.way, box) : [[event.way[0], event.way[event.way.length - 3]]];
    // An event that lasts into the time is shown when that begins.
    const moments = spans.map(([from, to]) => firstMoment(Math.round(from) / 10, to / 10, seconds => clock.has(event, seconds)));
    const at = moments.find(moment => moment !== null) ?? null;
    if (at === null) return null;
    return {at, ways: [], words: () => isOfScene ? missingWords(clock.text(event, event.way[0] / 10))
        : box ? stayWords(stayOf(event.way, box) ?? {lasts: 0}, shortSpanOf) : ''};
}

/**
 * The first second at which something holds, to half a minute; null = never.
 * @param {number} from
 * @param {number} to
 * @param {(seconds: number) => boolean} holds
 */
function firstMoment(from, to, holds) {
    for (let seconds = from; seconds < to; seconds += 30) if (holds(seconds)) return seconds;
    return holds(to) ? to : null;
}

/**
 * Those that crossed the line to a side; 0 = all.
 * @param {Found[]} found
 * @param {number} way
 */
export const ofWay = (found, way) => way === 0 ? found : found.filter(({how}) => how.ways.includes(way));

/**
 * What was found in an order: by time, or those of some kinds first, the longest of each first.
 * @param {Found[]} found
 * @param {string} order
 * @param {string[]} kinds that are first; none = by time
 */
export function sortedFound(found, order, kinds) {
    const when = (/** @type {Found} */ {event, how}) => event.clip.begins + how.at;
    const byNews = (/** @type {Found} */ a, /** @type {Found} */ b) => when(b) - when(a) || a.event.number - b.event.number;
    const byTime = (/** @type {Found} */ a, /** @type {Found} */ b) => when(a) - when(b) || a.event.number - b.event.number;
    const rankOf = (/** @type {Found} */ {event}) => kinds.includes(event.kind.name) ? event.kind.rank : Infinity;
    const longest = (/** @type {Found} */ {event}) => event.still || (event.way[event.way.length - 3] - event.way[0]) / 10;
    if (!kinds.length) return [...found].sort(order === 'oldest' ? byTime : byNews);
    return [...found].sort((a, b) => {
        const [first, second] = [rankOf(a), rankOf(b)];
        if (first !== second) return first < second ? -1 : 1;
        return (first === Infinity ? 0 : longest(b) - longest(a)) || byNews(a, b);
    });
}

/**
 * The hit beside an event; null = there is none. If the event is no hit any more, the one beside its place in the list.
 * @param {Found[]} hits in their order
 * @param {{clip: string, number: number}} from URL of the clip, and number of the event
 * @param {number} by 1 = the next, -1 = the one before
 */
export function hitBeside(hits, from, by) {
    const here = hits.findIndex(({event}) => event.clip.url === from.clip && event.number === from.number);
    return here < 0 ? null : hits[here + by] ?? null;
}

/**
 * The ways of events for heatOf. Of a thing of the scene it is only the moment at which it goes: then it is no longer there.
 * @param {SceneEvent[]} events
 */
export const waysOf = events => events.map(({kind, way}) => kind.isOfScene ? way.slice(0, 3) : way);

/**
 * For how long objects were in each cell of a grid, in tenths of a second, at least one for each that passes.
 * @param {number[][]} ways
 * @param {number} columns
 * @param {number} rows
 */
export function heatOf(ways, columns, rows) {
    const cells = new Float32Array(columns * rows);
    for (const way of ways) {
        for (let k = 0; k + 2 < way.length; k += 3) {
            const next = Math.min(k + 3, way.length - 3);
            const [x, y, byX, byY] = [way[k + 1], way[k + 2], way[next + 1] - way[k + 1], way[next + 2] - way[k + 2]];
            const steps = 1 + Math.floor(Math.max(Math.abs(byX) * columns, Math.abs(byY) * rows) / 1000);
            for (let step = 0; step < steps; ++step) {
                const share = (step + 0.5) / steps;
                const column = clamp(Math.floor((x + share * byX) / 1000 * columns), 0, columns - 1);
                const row = clamp(Math.floor((y + share * byY) / 1000 * rows), 0, rows - 1);
                cells[row * columns + column] += Math.max(1, way[next] - way[k]) / steps;
            }
        }
    }
    return cells;
}

/**
 * Red, green, blue and alpha of each cell, on a logarithmic scale that also shows the rare.
 * @param {Float32Array} cells
 */
export function coloursOf(cells) {
    const most = Math.log1p(Math.max(...cells));
    const bytes = new Uint8ClampedArray(4 * cells.length);
    cells.forEach((heat, k) => {
        const share = most > 0 ? Math.log1p(heat) / most : 0;
        bytes.set([255, Math.round(210 * (1 - share)), 0, heat > 0 ? Math.round(40 + 160 * share) : 0], 4 * k);
    });
    return bytes;
}

/**
 * The days that may have what is asked for, of those that have events; '' = no limit. A clip may begin a day before it
 * shows something, and a night ends a day later.
 * @param {string[]} days
 * @param {string} from
 * @param {string} to
 */
export const daysBetween = (days, from, to) =>
    days.filter(day => (!from || day >= daysBefore(from, 1)) && (!to || day <= daysBefore(to, -1)));
