// The parts of the page's data that come after its script, so that the page can be used before it has come as a whole.

import {set, state} from './state.js';

const ids = ['pixeldata', 'stilldata', 'volumedata', 'previewdata'];
/** @type {Set<string>} */
const taken = new Set();

/**
 * @param {import('./data.js').PageEvent[]} events
 * @param {(string | null)[]} portraits
 */
export const withPortraits = (events, portraits) => events.map((event, place) => ({...event, portrait: portraits[place] ?? null}));

/** Takes what has come since it was last called. */
export function takeArrived() {
    const arrived = ids.filter(id => !taken.has(id) && document.getElementById(id));
    if (!arrived.length) return;
    let parts = state.parts;
    for (const id of arrived) {
        taken.add(id);
        parts = {...parts, ...JSON.parse(document.getElementById(id)?.textContent ?? '{}')};
    }
    const events = parts.portraits === state.parts.portraits ? state.events : withPortraits(state.events, parts.portraits);
    set({parts, events, allArrived: taken.size === ids.length});
}
