// Lists of events: which are wanted, in which order, and what is said of them. An event is meant by its place in the list
// of all; the number that people see is another.

import {durationOf} from '../shared/durations.js';
import {clamp} from '../shared/text.js';

/**
 * @typedef {import('./data.js').PageEvent} PageEvent
 * @typedef {import('../shared/kinds.js').Kind} Kind
 * @typedef {(name: string) => Kind} KindOf
 * @typedef {{kind: string, what: string, leastSeconds: number}} Filter
 *     kind: 'all' = all; what: a class or a group of classes, '' = all, '?' = unknown
 */

/**
 * The number that the picture shows of an event. In a stream it stays the same while the list moves on.
 * @param {PageEvent[]} events
 * @param {number} place
 */
export const numberOf = (events, place) => events[place].number ?? place + 1;

/**
 * @param {PageEvent[]} events
 * @param {number} number
 * @returns {number | null}
 */
export function placeOfNumber(events, number) {
    const place = events.findIndex((_, k) => numberOf(events, k) === number);
    return place < 0 ? null : place;
}

/**
 * Which event it is, for a screen reader. The list is another than that of all: its numbers need not begin at 1.
 * @param {PageEvent[]} events
 * @param {number} place
 * @param {number[]} listed the places in the list
 */
export const nameOf = (events, place, listed) =>
    `Event ${numberOf(events, place)}, ${listed.indexOf(place) + 1} of ${listed.length} in the list`;

/**
 * What it did, in the words of the picture.
 * @param {PageEvent} event
 */
export const deedOf = event => event.deed ?? event.kind;

/** @type {Record<string, string>} */
const directions = {'←': 'to the left', '→': 'to the right', '↑': 'up', '↓': 'down', '↖': 'up and left', '↗': 'up and right', '↘': 'down and right', '↙': 'down and left'};
/** @type {Record<string, string>} */
const units = {s: 'second', min: 'minute', h: 'hour'};

/**
 * As it is read aloud: "crossed ← 0:06 · 6 s" as "crossed to the left 0:06, 6 seconds".
 * @param {string} text
 */
export const spoken = text => text.replaceAll(' · ', ', ').replace(/[←→↑↓↖↗↘↙]/g, arrow => directions[arrow])
    .replace(/([\d:.]+) (s|min|h)\b/g, (_, count, unit) => `${count} ${units[unit]}${count === '1' ? '' : 's'}`);

/**
 * What is said of an event where there is little room, the longest first; words that arrows or numbers can replace go.
 * @param {string} deed
 */
export function briefDeeds(deed) {
    const brief = deed.replace(' in all', '');
    const way = Object.entries({...directions, '⇄': 'to and fro'}).find(([, words]) => brief.replace('went ', '') === words);
    return [deed, brief.replace('went ', ''), way?.[0] ?? brief.replace(/^\w+ (?=\d)/, '')];
}

/** @type {(event: PageEvent) => number} */
export const secondsFor = event => event.end - event.begin;

/** @type {(event: PageEvent, name: string) => boolean} */
export const isOf = (event, name) => name === '' || (name === '?' ? !event.class : event.class === name || event.group === name);

/** @type {(filter: Filter) => boolean} */
export const isSet = filter => filter.kind !== 'all' || filter.what !== '' || filter.leastSeconds > 0;

/**
 * The places of the events that pass, in the order of time.
 * @param {PageEvent[]} events
 * @param {Filter} filter
 * @param {(event: PageEvent) => string | null} answerOf what an event has to do with the place that is asked for; null = nothing
 */
export function wantedPlaces(events, filter, answerOf) {
    return [...events.keys()].filter(place => {
        const event = events[place];
        return (filter.kind === 'all' || event.kind === filter.kind) && isOf(event, filter.what) &&
            secondsFor(event) >= filter.leastSeconds && answerOf(event) !== null;
    });
}

/**
 * The places in another order.
 * @param {PageEvent[]} events
 * @param {number[]} places
 * @param {string} order
 * @param {KindOf} kindOf
 */
export function sortedPlaces(events, places, order, kindOf) {
    /** @type {Record<string, (a: number, b: number) => number>} */
    const orders = {
        time: (a, b) => a - b,
        newest: (a, b) => events[b].first - events[a].first,
        longest: (a, b) => secondsFor(events[b]) - secondsFor(events[a]),
        kind: (a, b) => kindOf(events[a].kind).rank - kindOf(events[b].kind).rank || events[b].still - events[a].still,
    };
    return [...places].sort(orders[order]);
}

/**
 * The event to go to from the chosen one; without one, from the frame that is shown. null = there is none.
 * @param {PageEvent[]} events
 * @param {number[]} places in the order of time
 * @param {number | null} chosen
 * @param {number} frame
 * @param {number} by 1 = the next, -1 = the one before
 */
export function placeBeside(events, places, chosen, frame, by) {
    if (!places.length) return null;
    const here = chosen === null ? -1 : places.indexOf(chosen);
    if (here >= 0) return places[clamp(here + by, 0, places.length - 1)];
    const found = by > 0 ? places.findIndex(place => events[place].first >= frame)
        : places.findLastIndex(place => events[place].first < frame);
    return places[Math.max(0, found)];
}

/**
 * How many events there are of each kind, the most informative kind first.
 * @param {PageEvent[]} events
 * @param {KindOf} kindOf
 */
export function countsOfKinds(events, kindOf) {
    const counts = new Map();
    for (const event of events) counts.set(event.kind, (counts.get(event.kind) ?? 0) + 1);
    return [...counts].map(([name, count]) => ({name, count})).sort((a, b) => kindOf(a.name).rank - kindOf(b.name).rank);
}

/**
 * What objects can be asked for: each group of classes, the most frequent first, and the classes in it, and '?' for those
 * that are not known.
 * @param {PageEvent[]} events
 */
export function countsOfClasses(events) {
    const counts = new Map();
    const count = (/** @type {string} */ name) => counts.set(name, (counts.get(name) ?? 0) + 1);
    /** @type {Map<string, Set<string>>} */
    const classesOf = new Map();
    for (const event of events) {
        if (!event.class) {
            count('?');
            continue;
        }
        const group = event.group ?? event.class;
        new Set([group, event.class]).forEach(count);
        classesOf.set(group, (classesOf.get(group) ?? new Set()).add(event.class));
    }
    const groups = [...classesOf.keys()].sort((a, b) => counts.get(b) - counts.get(a));
    const rows = groups.flatMap(group => [{name: group, isGroup: true},
        ...[...classesOf.get(group) ?? []].sort().filter(name => name !== group).map(name => ({name, isGroup: false}))]);
    if (counts.has('?')) rows.push({name: '?', isGroup: true});
    return rows.map(row => ({...row, count: /** @type {number} */ (counts.get(row.name))}));
}

/**
 * What an event did, in parts.
 * @param {PageEvent} event
 * @param {Kind} kind
 * @param {string | null} answer what it has to do with the place that is asked for
 */
export function factsOf(event, kind, answer) {
    const lasts = durationOf(secondsFor(event));
    const facts = [kind.isOfScene ? 'missing ' + lasts : lasts];
    if (event.class) facts.push(`${event.class} (${Math.round((event.score ?? 0) * 100)} %)`);
    if (kind.tally === 'still' && !event.deed) facts.push(kind.words + ' ' + durationOf(event.still));
    if (answer) facts.push(answer);
    return facts;
}

/**
 * Other events that belong to an event, with the words for it: "began in one outline with".
 * @param {PageEvent} event
 * @param {Kind} kind
 */
export function relationsOf(event, kind) {
    const relations = [];
    for (const [place, words] of /** @type {[number | null, string][]} */ ([[event.from, 'began in one outline with'], [event.into, 'ended in one outline with'], [event.by, kind.by]])) {
        if (place !== null && place !== undefined) relations.push({place, words});
    }
    return relations;
}

/**
 * Where an event's object is in a frame, in shares of the picture; null = not then. Its path has only some frames.
 * @param {PageEvent} event
 * @param {number} frame
 */
export function pointAt(event, frame) {
    const after = event.path.findIndex(point => point[0] >= frame);
    if (after < 0 || frame < event.first) return null;
    const [end, x, y] = event.path[after];
    const [begin, fromX, fromY] = event.path[Math.max(0, after - 1)];
    const share = end > begin ? (frame - begin) / (end - begin) : 1;
    return [fromX + share * (x - fromX), fromY + share * (y - fromY)];
}

/**
 * The still nearest to a frame.
 * @param {import('./data.js').Still[]} stills
 * @param {number} frame
 * @returns {import('./data.js').Still | undefined} undefined = none has come yet
 */
export const stillNear = (stills, frame) => stills.length
    ? stills.reduce((a, b) => Math.abs(b.frame - frame) < Math.abs(a.frame - frame) ? b : a) : undefined;

/**
 * The row of each of these events on the strip, the first that is free for it; null = they need more than `most`.
 * @param {{first: number, last: number}[]} events in the order of their beginnings
 * @param {number} most
 */
export function rowsOf(events, most) {
    /** @type {number[]} */
    const ends = [];
    const rows = [];
    for (const event of events) {
        let row = ends.findIndex(end => end < event.first);
        if (row < 0) row = ends.length;
        if (row === most) return null;
        ends[row] = event.last;
        rows.push(row);
    }
    return {rows, count: ends.length};
}

/**
 * How many spans there are in each of so many cells.
 * @param {[number, number][]} spans from and to, as shares of all cells
 * @param {number} cells
 */
export function densityOf(spans, cells) {
    const counts = new Array(cells).fill(0);
    for (const span of spans) {
        const [from, to] = span.map(share => clamp(Math.floor(share * cells), 0, cells - 1));
        for (let cell = from; cell <= to; ++cell) ++counts[cell];
    }
    return counts;
}
