// What a reader marks: stars, notes, and events that are nothing. The browser keeps it, by the clip; it can be saved as a file.

import {upright} from '../shared/text.js';
import {deedOf, numberOf} from './events.js';

/** @typedef {{star?: boolean, note?: string, nothing?: boolean}} Mark */

/**
 * Marks stay with an event when the page is made again.
 * @param {{first: number, last: number, twin?: number}} event
 */
export const keyOf = event => `${event.first}-${event.last}${event.twin ? `-${event.twin}` : ''}`;

/**
 * The events, of which those with the same frames are told apart.
 * @param {import('./data.js').PageEvent[]} events
 * @returns {import('./data.js').PageEvent[]}
 */
export function withTwins(events) {
    /** @type {Map<string, number>} */
    const counts = new Map();
    return events.map(event => {
        const frames = `${event.first}-${event.last}`;
        const twin = counts.get(frames) ?? 0;
        counts.set(frames, twin + 1);
        return {...event, twin};
    });
}

/**
 * A name for the clip that its page has again when it is made again (FNV-1a of its name, size and times).
 * @param {import('./data.js').PageData} data
 */
export function clipKey({name, camera, size, times, clock}) {
    let hash = 0x811c9dc5;
    for (const letter of JSON.stringify([name, camera, size, times, clock?.begin ?? null])) {
        hash = Math.imul(hash ^ letter.charCodeAt(0), 0x01000193) >>> 0;
    }
    return 'vvr-marks-' + hash.toString(16).padStart(8, '0');
}

/**
 * The marks that were kept. What is damaged is as nothing.
 * @param {string | null} text
 * @returns {Record<string, Mark>}
 */
export function readMarks(text) {
    try {
        const read = JSON.parse(text ?? '{}');
        if (typeof read !== 'object' || read === null) return {};
        /** @type {Record<string, Mark>} */
        const marks = {};
        for (const [key, mark] of Object.entries(read)) {
            if (/^\d+-\d+(-\d+)?$/.test(key) && typeof mark === 'object' && mark) {
                marks[key] = {star: mark.star === true, note: typeof mark.note === 'string' ? mark.note : '', nothing: mark.nothing === true};
            }
        }
        return marks;
    } catch {
        return {};
    }
}

/**
 * The marks with one changed; a mark that says nothing goes.
 * @param {Record<string, Mark>} marks
 * @param {string} key
 * @param {Mark} change
 */
export function changed(marks, key, change) {
    const mark = {...marks[key], ...change};
    const rest = Object.fromEntries(Object.entries(marks).filter(([other]) => other !== key));
    return mark.star || mark.note || mark.nothing ? {...rest, [key]: mark} : rest;
}

/**
 * The file of all marks.
 * @param {import('./data.js').PageData} data
 * @param {import('./data.js').PageEvent[]} events
 * @param {Record<string, Mark>} marks
 * @param {import('./timeline.js').Timeline} time
 */
export function savedMarks(data, events, marks, time) {
    const clock = (/** @type {number} */ seconds) => `${time.dayOf(seconds)} ${time.clockOf(seconds)}`.trim();
    const rows = [...events.keys()].filter(place => marks[keyOf(events[place])]).map(place => {
        const event = events[place];
        const mark = marks[keyOf(event)];
        return {event: numberOf(events, place), from: clock(event.begin), to: clock(event.end), frames: [event.first, event.last],
                deed: deedOf(event), class: event.class ?? null, star: Boolean(mark.star), nothing: Boolean(mark.nothing), note: mark.note ?? ''};
    });
    return JSON.stringify({clip: upright(data.name), camera: data.camera, file: data.clip, events: rows}, null, 2) + '\n';
}
