// What is asked of the index: which clips and events, in which order and view. It is in the address, so that going back
// from a clip's page, a reload and a link that is sent find it again.

import {isWithin, overlaps, timesIn} from '../shared/day_time.js';
import {shapeOfText, shapeText} from '../shared/shapes.js';
import {folded, grouped} from '../shared/text.js';

/**
 * @typedef {import('./data.js').IndexData} IndexData
 * @typedef {import('./clips.js').Clip} Clip
 * @typedef {import('../shared/shapes.js').Shape} Shape
 *
 * @typedef {object} Query
 * @property {string} view
 * @property {string} text
 * @property {string} kind
 * @property {string} class
 * @property {string} order
 * @property {number | null} camera null = all
 * @property {string} from the first day; '' = all
 * @property {string} to the last day
 * @property {string} since a time of day, as 20:00; '' = any
 * @property {string} until
 * @property {Shape | null} place in thousandths of the scene; null = everywhere
 * @property {number} way the side to which a line is crossed, 1 or -1; 0 = both
 *
 * @typedef {object} Choices
 * @property {Map<string, import('../shared/kinds.js').KindRow[]>} kinds of events that are chosen together, by the name of the choice
 * @property {Map<string, string[]>} classes that a choice has: a group's, or a class alone
 * @property {Record<'view' | 'kind' | 'class' | 'order', string[]>} known values, the default first
 */

/** @type {Query} */
export const nothingAsked = {view: 'clips', text: '', kind: 'all', class: '', order: 'newest', camera: null, from: '', to: '', since: '', until: '',
                             place: null, way: 0};

/**
 * @param {IndexData} data
 * @returns {Choices}
 */
export function choicesIn(data) {
    const kinds = /** @type {Choices['kinds']} */ (grouped(data.kinds.filter(({choice}) => choice !== null), 'choice'));
    const classes = new Map(Object.entries(data.classes).flatMap(([group, names]) =>
        [/** @type {[string, string[]]} */ ([group, names]), ...names.map(name => /** @type {[string, string[]]} */ ([name, [name]]))]));
    return {kinds, classes, known: {
        view: ['clips', 'days', 'scene'],
        kind: ['all', 'events', ...kinds.keys(), 'unseen', 'failed'],
        class: ['', ...classes.keys()],
        order: ['newest', 'oldest', ...kinds.keys(), 'events'],
    }};
}

const named = /** @type {const} */ (['view', 'kind', 'class', 'order']);

/** Parts of the address that are free, and what they look like. */
const spans = /** @type {const} */ ([['from', /^\d{4}-\d\d-\d\d$/], ['to', /^\d{4}-\d\d-\d\d$/], ['since', /^([01]\d|2[0-3]):[0-5]\d$/],
                                     ['until', /^([01]\d|2[0-3]):[0-5]\d$|^24:00$/]]);

/**
 * @param {string} hash of the address
 * @param {Choices} choices
 * @param {string[]} cameras
 * @returns {Query}
 */
export function readQuery(hash, choices, cameras) {
    const parts = new URLSearchParams(hash.replace(/^#/, ''));
    const camera = cameras.findIndex(name => name === parts.get('camera'));
    const query = {...nothingAsked, text: parts.get('text') ?? '', camera: camera < 0 ? null : camera, place: shapeOfText(parts.get('place'))};
    for (const name of named) {
        const value = parts.get(name) ?? '';
        query[name] = choices.known[name].includes(value) ? value : choices.known[name][0];
    }
    for (const [name, form] of spans) query[name] = form.test(parts.get(name) ?? '') ? parts.get(name) ?? '' : '';
    if (query.place?.kind === 'line') query.way = [1, -1].find(way => String(way) === parts.get('way')) ?? 0;
    return query;
}

/**
 * @param {Query} query
 * @param {Choices} choices
 * @param {string[]} cameras
 */
export function writeQuery(query, choices, cameras) {
    const parts = new URLSearchParams();
    if (query.text) parts.set('text', query.text);
    for (const [name] of spans) if (query[name]) parts.set(name, query[name]);
    for (const name of named) if (query[name] !== choices.known[name][0]) parts.set(name, query[name]);
    if (query.camera !== null) parts.set('camera', cameras[query.camera]);
    if (query.place) parts.set('place', shapeText(query.place));
    if (query.way) parts.set('way', String(query.way));
    return '#' + parts;
}

/** @type {(choices: Choices, name: string, classes: string[]) => boolean} */
export const isOf = (choices, name, classes) => name === '' || (choices.classes.get(name) ?? []).some(one => classes.includes(one));

/**
 * Whether an event is of a kind; choices that mean clips take all.
 * @param {Choices} choices
 * @param {string} choice
 * @param {import('../shared/kinds.js').Kind} kind
 */
export const isOfChoice = (choices, choice, kind) => choices.kinds.get(choice)?.some(({name}) => name === kind.name) ?? true;

/**
 * @param {string} kind
 * @param {Clip} clip
 * @param {Choices} choices
 * @param {(clip: Clip) => boolean} isSeen
 */
function isOfKind(kind, clip, choices, isSeen) {
    switch (kind) {
        case 'all': return true;
        case 'events': return (clip.events ?? 0) > 0;
        case 'unseen': return clip.drawn && !isSeen(clip);
        case 'failed': return clip.failed;
        default: return (choices.kinds.get(kind) ?? []).some(({name}) => clip.tallyOf[name] > 0);
    }
}

/**
 * The days and the time of day that are asked for; a time can be in the text.
 * @param {Query} query
 */
export function spanOf({text, from, to, since, until}) {
    const times = since || until ? {since, until} : timesIn(text);
    return {from, to, since: times.since, until: times.until};
}

/**
 * The clips that are asked for.
 * @param {Clip[]} clips
 * @param {Query} query
 * @param {Choices} choices
 * @param {(clip: Clip) => boolean} isSeen
 * @param {(seconds: number) => Date} wallOf
 */
export function chosenOf(clips, query, choices, isSeen, wallOf) {
    const words = timesIn(query.text).words.split(/\s+/).filter(Boolean).map(word => folded(word).split('\n'));
    const span = spanOf(query);
    const days = {...span, since: '', until: ''};
    return clips.filter(clip => (query.camera === null || clip.camera === query.camera) && isOfKind(query.kind, clip, choices, isSeen) &&
                                isOf(choices, query.class, clip.classes) && words.every(ways => ways.some(word => clip.text.includes(word))) &&
                                // A picture of a day belongs to its day, whatever its first clip does.
                                (clip.wholeDay ? isWithin(days, new Date(clip.day + 'T12:00:00Z')) : overlaps(span, clip.begins, clip.seconds, wallOf)));
}

/**
 * Pictures of whole days come first, what failed last.
 * @param {Clip} clip
 */
const placeInList = clip => !clip.drawn ? 2 : clip.wholeDay ? 0 : 1;

/** @param {Clip[]} list */
export const lastFailed = list => [...list].sort((a, b) => placeInList(a) - placeInList(b));

/**
 * The clips in an order, those without a picture last. Clips that the order does not tell apart stay as they are.
 * @param {Clip[]} list the newest first
 * @param {string} order
 * @param {Choices} choices
 */
export function sortedBy(list, order, choices) {
    const kinds = choices.kinds.get(order) ?? [];
    const byEvents = (/** @type {Clip} */ a, /** @type {Clip} */ b) => (b.events ?? 0) - (a.events ?? 0);
    const byKinds = (/** @type {Clip} */ a, /** @type {Clip} */ b) => {
        const differs = kinds.find(({name}) => a.tallyOf[name] !== b.tallyOf[name]);
        return differs ? b.tallyOf[differs.name] - a.tallyOf[differs.name] : 0;
    };
    return lastFailed([...list].sort(order === 'events' ? byEvents : byKinds));
}
