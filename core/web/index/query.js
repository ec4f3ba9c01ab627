// What is asked of the index: which clips, in which order and view. It is in the address, so that going back from a clip's
// page finds it again.

import {folded, grouped} from '../shared/text.js';

/**
 * @typedef {import('./data.js').IndexData} IndexData
 * @typedef {import('./clips.js').Clip} Clip
 * @typedef {{view: string, text: string, kind: string, class: string, order: string, camera: number | null, day: string | null}} Query
 *
 * @typedef {object} Choices
 * @property {Map<string, import('../shared/kinds.js').KindRow[]>} kinds of events that are chosen together, by the name of the choice
 * @property {Map<string, string[]>} classes that a choice has: a group's, or a class alone
 * @property {Record<'view' | 'kind' | 'class' | 'order', string[]>} known values, the default first
 */

/** @type {Query} */
export const nothingAsked = {view: 'clips', text: '', kind: 'all', class: '', order: 'newest', camera: null, day: null};

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
        order: ['newest', ...kinds.keys(), 'events'],
    }};
}

const named = /** @type {const} */ (['view', 'kind', 'class', 'order']);

/**
 * @param {string} hash of the address
 * @param {Choices} choices
 * @param {string[]} cameras
 * @returns {Query}
 */
export function readQuery(hash, choices, cameras) {
    const parts = new URLSearchParams(hash.replace(/^#/, ''));
    const camera = cameras.findIndex(name => name === parts.get('camera'));
    const query = {...nothingAsked, text: parts.get('text') ?? '', day: parts.get('day'), camera: camera < 0 ? null : camera};
    for (const name of named) {
        const value = parts.get(name) ?? '';
        query[name] = choices.known[name].includes(value) ? value : choices.known[name][0];
    }
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
    if (query.day) parts.set('day', query.day);
    for (const name of named) if (query[name] !== choices.known[name][0]) parts.set(name, query[name]);
    if (query.camera !== null) parts.set('camera', cameras[query.camera]);
    return '#' + parts;
}

/** @type {(choices: Choices, name: string, classes: string[]) => boolean} */
export const isOf = (choices, name, classes) => name === '' || (choices.classes.get(name) ?? []).some(one => classes.includes(one));

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
 * The clips that are asked for.
 * @param {Clip[]} clips
 * @param {Query} query
 * @param {Choices} choices
 * @param {(clip: Clip) => boolean} isSeen
 */
export function chosenOf(clips, query, choices, isSeen) {
    const words = query.text.split(/\s+/).filter(Boolean).map(word => folded(word).split('\n'));
    return clips.filter(clip => (query.camera === null || clip.camera === query.camera) && isOfKind(query.kind, clip, choices, isSeen) &&
                                isOf(choices, query.class, clip.classes) && (!query.day || clip.day === query.day) &&
                                words.every(ways => ways.some(word => clip.text.includes(word))));
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
