// The state of the index.

import {dataOfPage} from '../shared/dom.js';
import {kindsBy} from '../shared/kinds.js';
import {derived, store} from '../shared/state.js';
import {upright} from '../shared/text.js';
import {wallIn} from '../shared/wall_clock.js';
import {clipsOf} from './clips.js';
import {choicesIn, chosenOf, nothingAsked, writeQuery} from './query.js';
import {isSeen} from './seen.js';

/** @type {import('./data.js').IndexData} */
export const data = dataOfPage();
export const kindOf = kindsBy(data.kinds);
export const wallOf = wallIn(data.zone.length ? data.zone : [[0, 0, 'UTC']]);
export const clips = clipsOf(data, wallOf);
export const clipOfUrl = new Map(clips.map(clip => [clip.url, clip]));
export const choices = choicesIn(data);

/** @param {number} camera */
export const cameraName = camera => data.cameras[camera] === '' ? '(top folder)' : upright(data.cameras[camera]);

export const {state, set, drawAll} = store({
    ...nothingAsked,

    // the view Scene
    from: '',  // the first day; '' = all
    to: '',
    tool: /** @type {'box' | 'line'} */ ('box'),
    drawn: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // so far
    place: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // in thousandths of the scene; null = everywhere
    answer: /** @type {{found: import('./answers.js').Found[], of: number, took: number} | null} */ (null),  // null = not there yet
});

/** The clips that are asked for, the newest first. */
export const chosenClips = derived(() => [state.camera, state.kind, state.class, state.day, state.text],
                                   () => chosenOf(clips, state, choices, isSeen));

/**
 * Asks for something else.
 * @param {Partial<import('./query.js').Query>} change
 */
export function ask(change) {
    Object.assign(state, change);
    history.replaceState(null, '', writeQuery(state, choices, data.cameras));
    set({});
    scrollTo(0, 0);
}
