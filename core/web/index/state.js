// The state of the index.

import {dataOfPage} from '../shared/dom.js';
import {kindsBy} from '../shared/kinds.js';
import {seenOf} from '../shared/seen.js';
import {derived, store} from '../shared/state.js';
import {upright} from '../shared/text.js';
import {wallIn} from '../shared/wall_clock.js';
import {ofWay, sortedFound} from './answers.js';
import {clipsOf} from './clips.js';
import {choicesIn, chosenOf, nothingAsked, spanOf, writeQuery} from './query.js';

/** @type {import('./data.js').IndexData} */
export const data = dataOfPage();
export const kindOf = kindsBy(data.kinds);
export const wallOf = wallIn(data.zone.length ? data.zone : [[0, 0, 'UTC']]);
export const clips = clipsOf(data, wallOf);
export const clipOfUrl = new Map(clips.map(clip => [clip.url, clip]));
export const choices = choicesIn(data);
export const {isSeen, see, refresh} = seenOf(location.href);

/** @param {number} camera */
export const cameraName = camera => data.cameras[camera] === '' ? '(top folder)' : upright(data.cameras[camera]);

/** The cameras in the order of their names, as people count: cam 2 before cam 10. */
export const camerasByName = [...data.cameras.keys()].sort((a, b) => cameraName(a).localeCompare(cameraName(b), 'en', {numeric: true}));
const ranks = new Map(camerasByName.map((camera, rank) => [camera, rank]));

/**
 * @param {number} a a camera
 * @param {number} b
 */
export const byCameraName = (a, b) => (ranks.get(a) ?? 0) - (ranks.get(b) ?? 0);

export const {state, set, drawAll} = store({
    ...nothingAsked,

    seen: 0,  // how often more clips were found to be seen
    days: false,   // whether days and times that are not in the lists are to be entered
    times: false,

    // the view Scene
    tool: /** @type {'box' | 'line' | null} */ (null),  // what a drag draws; null = nothing
    drawn: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // so far
    answer: /** @type {{found: import('./answers.js').Found[], events: import('./answers.js').SceneEvent[], took: number} | null} */ (null),  // null = not there yet
    all: false,  // whether the list has all hits, for a printer

    shown: /** @type {{clip: import('./clips.js').Clip, number: number} | null} */ (null),  // the hit that somebody comes back from
    leading: /** @type {import('./leading.js').Step | null} */ (null),  // from the page of a hit to the one beside it
});

const filters = () => [state.camera, state.kind, state.class, state.from, state.to, state.since, state.until, state.text, state.seen];

/** The days and times that are asked for. */
export const span = derived(() => [state.from, state.to, state.since, state.until, state.text], () => spanOf(state));

/** The clips that are asked for, the newest first. */
export const chosenClips = derived(filters, () => chosenOf(clips, state, choices, isSeen, wallOf));

/** The clips in whose events a search looks: kinds of events then mean the events, not the clips. */
export const searchedClips = derived(filters, () => {
    const kind = choices.kinds.has(state.kind) ? 'all' : state.kind;
    return chosenOf(clips, {...state, kind, class: ''}, choices, isSeen, wallOf);
});

/** The events that a search has found, in their order. */
export const hits = derived(() => [state.answer, state.way, state.order],
    () => state.answer ? sortedFound(ofWay(state.answer.found, state.way), state.order, (choices.kinds.get(state.order) ?? []).map(({name}) => name)) : []);

/** What is asked, as the part of the address after '#'. */
export const search = () => writeQuery(state, choices, data.cameras).slice(1);

/**
 * Asks for something else.
 * @param {Partial<import('./query.js').Query>} change
 */
export function ask(change) {
    const isElsewhere = change.camera !== undefined && change.camera !== state.camera && change.place === undefined;
    const place = isElsewhere ? null : change.place !== undefined ? change.place : state.place;
    Object.assign(state, {...change, place, way: place?.kind === 'line' ? change.way ?? (change.place ? 0 : state.way) : 0});
    history.replaceState(null, '', '#' + search());
    set({});
    if (change.view !== undefined) scrollTo(0, 0);
}
