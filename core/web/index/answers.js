// Answers of the view Scene: which events have to do with a place, where they were, and when.

import {clamp} from '../shared/text.js';
import {shortSpanOf} from '../shared/durations.js';
import {meets, sidesOf} from '../shared/shapes.js';
import {boundsOf, crossingWords, crossingsOf, stayOf} from '../shared/ways.js';

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
 * @typedef {{at: number, words: () => string}} Answer the second of the clip, and what there is to say
 * @typedef {{event: SceneEvent, how: Answer}} Found
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
 * What an event has to do with a place; null = nothing.
 * @param {SceneEvent} event
 * @param {Shape | null} place in thousandths of the scene; null = everywhere
 * @param {number[]} size of the scene
 * @param {(event: SceneEvent, seconds: number) => string} clock
 * @returns {Answer | null}
 */
export function answerOf(event, place, size, clock) {
    if (!place) return {at: event.way[0] / 10, words: () => ''};
    const box = sidesOf(place);
    if (!meets(event.bounds, box)) return null;
    if (place.kind === 'box') {
        const stay = stayOf(event.way, box);
        return stay && {at: stay.at / 10, words: () => 'here ' + shortSpanOf(stay.lasts / 10)};
    }
    const crossings = crossingsOf(event.way, place.from, place.to);
    return crossings.length ? {at: crossings[0].at / 10, words: () => crossingWords(crossings, place, size, seconds => clock(event, seconds))} : null;
}

/**
 * The latest first; without a place those that tell most.
 * @param {Found[]} found
 * @param {boolean} byKind
 */
export function sortedFound(found, byKind) {
    const byNews = (/** @type {Found} */ a, /** @type {Found} */ b) => b.event.clip.begins + b.how.at - a.event.clip.begins - a.how.at;
    return [...found].sort((a, b) => (byKind ? a.event.kind.rank - b.event.kind.rank : 0) || byNews(a, b));
}

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
 * The days between two, of those that have events; '' = no limit.
 * @param {string[]} days
 * @param {string} from
 * @param {string} to
 */
export const daysBetween = (days, from, to) => days.filter(day => (!from || day >= from) && (!to || day <= to));
