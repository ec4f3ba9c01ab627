// Where the address leads: to what was asked, to a clip in it, or from the page of a clip to the one beside it. Pages can't
// know that one: they were made before it was there.

import {at} from '../shared/dom.js';
import {addressOfClip} from '../page/address.js';
import {hitBeside} from './answers.js';
import {neighbourOf, pageOf} from './clips.js';
import {urlOfHit} from './hits.js';
import {showCard} from './list.js';
import {readQuery} from './query.js';
import {choices, chosenClips, clipOfUrl, data, hits, refresh, search, see, set, state} from './state.js';

/**
 * @typedef {import('./clips.js').Clip} Clip
 * @typedef {{clip: Clip, number: number, by: number, all: boolean}} Step
 *     from an event of a clip; by: 1 = to the next hit, -1 = to the one before; all: whether they follow by themselves
 */

/**
 * Goes to the clip before or after, within what was asked; where there is none, back.
 * @param {Clip} clip
 * @param {number} by
 */
function leadToClip(clip, by) {
    const next = neighbourOf(chosenClips(), clip, by);
    see(next ?? clip);
    location.replace(pageOf(next ?? clip) + addressOfClip(search(), next ? 0 : by));
}

/** Goes to the hit beside one, once it is known; where there is none, back. */
export function leadToHit() {
    const {leading, answer} = state;
    if (!leading || !answer) return;
    set({leading: null});
    const {clip, number, by, all} = leading;
    const next = hitBeside(hits(), {clip: clip.url, number}, by);
    if (next) {
        see(next.event.clip);
        location.replace(urlOfHit(next, all));
        return;
    }
    const last = hitBeside(hits(), {clip: clip.url, number}, 0);
    location.replace(last ? urlOfHit(last, false, by) : pageOf(clip) + addressOfClip(search(), by));
}

export function followAddress() {
    const parts = new URLSearchParams(location.hash.slice(1));
    const clipIn = (/** @type {string} */ name) => clipOfUrl.get(parts.get(name) ?? '');
    refresh();
    set({...readQuery(location.hash, choices, data.cameras), drawn: null});
    const [after, before, hit, shown] = ['after', 'before', 'hit', 'clip'].map(clipIn);
    if (after || before || hit) document.documentElement.dataset.leading = '';
    if (after) return leadToClip(after, 1);
    if (before) return leadToClip(before, -1);
    if (hit) {
        set({leading: {clip: hit, number: Number(parts.get('event')), by: parts.get('go') === '-1' ? -1 : 1, all: parts.has('all')}});
        return;
    }
    if ([...parts.keys()].length) history.replaceState(null, '', '#' + search());
    if (shown) showClip(shown, Number(parts.get('event')));
}

/**
 * Where somebody was before.
 * @param {Clip} clip
 * @param {number} number of the event
 */
function showClip(clip, number) {
    if (state.view !== 'scene') return showCard(clip);
    state.shown = {clip, number};
}

/** The hit that somebody comes back from. */
export function focusShown() {
    const {shown, answer} = state;
    if (!shown || !answer) return;
    const nth = hits().findIndex(({event}) => event.clip === shown.clip && event.number === shown.number);
    /** @type {HTMLElement | null} */ (at('found').querySelectorAll('a')[nth] ?? null)?.focus();
    set({shown: null});
}

/** Pages have marked clips as seen, and somebody comes back. */
export function listenToReturn() {
    addEventListener('pageshow', event => {
        if (!event.persisted) return;
        delete document.documentElement.dataset.leading;
        if (refresh()) set({seen: state.seen + 1});
    });
    addEventListener('hashchange', followAddress);
}
