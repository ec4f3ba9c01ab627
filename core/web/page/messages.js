// What the page tells: on the screen for a while, or to screen readers.

import {at} from '../shared/dom.js';

let timer = 0;

/** @param {string} text */
export function tell(text) {
    at('told').textContent = text;
    at('told').hidden = false;
    clearTimeout(timer);
    timer = window.setTimeout(() => { at('told').hidden = true; }, 6000);
}

/**
 * Tells screen readers.
 * @param {string} text
 */
export function say(text) {
    at('said').textContent = text;
}
