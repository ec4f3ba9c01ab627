// The colour of an event, for elements that show it.

import {state} from './state.js';

/**
 * Black or white, whichever can be read better on a colour.
 * @param {string} colour #rrggbb
 */
export function inkOn(colour) {
    const [red, green, blue] = [1, 3, 5].map(k => parseInt(colour.slice(k, k + 2), 16) / 255)
        .map(share => share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4);
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue > 0.179 ? '#000' : '#fff';
}

/**
 * @template {HTMLElement | SVGElement} E
 * @param {E} element
 * @param {number} place
 * @returns {E}
 */
export function ofEvent(element, place) {
    element.dataset.event = String(place);
    const {colour} = state.events[place];
    if (colour) {
        element.style.setProperty('--event', colour);
        element.style.setProperty('--on', inkOn(colour));
    }
    return element;
}
