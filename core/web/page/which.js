// Which event did a finger mean? Where several are within its reach, their portraits are offered to choose from.

import {at, button, element} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {deedOf, numberOf} from './events.js';
import {ofEvent} from './looks.js';
import {set, state} from './state.js';

/** @typedef {{frame: number, event: number}} Candidate */

const most = 4;  // more have no room, and a finger that is on as many is better zoomed

/**
 * @param {Candidate[]} candidates the nearest first
 * @param {{clientX: number, clientY: number}} tap
 */
export const askWhich = (candidates, {clientX, clientY}) => set({which: {candidates: candidates.slice(0, most), x: clientX, y: clientY}});

/** @returns {boolean} whether there was anything to end */
export function endWhich() {
    const asks = state.which !== null;
    if (asks) set({which: null});
    return asks;
}

/** @param {(candidate: Candidate) => void} plays */
export const drawWhich = plays => () => {
    const {which, events} = state;
    const box = at('which');
    box.hidden = which === null;
    box.replaceChildren(...(which?.candidates ?? []).map(candidate => {
        const {event: place} = candidate;
        const made = ofEvent(button('', '', () => {
            endWhich();
            plays(candidate);
        }), place);
        const image = element('img');
        image.alt = '';
        const {portrait} = events[place];
        if (portrait) image.src = portrait;
        made.append(...portrait ? [image] : [], element('b', 'number', String(numberOf(events, place))), element('span', '', deedOf(events[place])));
        return made;
    }));
    if (!which) return;
    // Above the finger, which would cover it.
    const {width, height} = box.getBoundingClientRect();
    const top = which.y - height - 24 > 4 ? which.y - height - 24 : which.y + 24;
    box.style.transform = `translate(${clamp(which.x - width / 2, 4, Math.max(4, innerWidth - width - 4))}px, ${clamp(top, 4, Math.max(4, innerHeight - height - 4))}px)`;
};

export function listenToWhich() {
    addEventListener('pointerdown', event => {
        if (event.target instanceof Node && !at('which').contains(event.target)) endWhich();
    }, true);
    addEventListener('scroll', endWhich);
    addEventListener('resize', endWhich);
}
