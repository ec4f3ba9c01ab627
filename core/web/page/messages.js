// What the page tells: on the screen for a while, or to screen readers.

import {at, button} from '../shared/dom.js';

let timer = 0;

/** @param {string} text */
export const tell = text => offer(text, []);

/**
 * Tells something, with what can be done about it.
 * @param {string} text
 * @param {[words: string, action: () => void][]} actions
 */
export function offer(text, actions) {
    const told = at('told');
    const hide = () => { told.hidden = true; };
    told.replaceChildren(text, ...actions.map(([words, action]) => button('', words, () => {
        hide();
        action();
    })));
    told.hidden = false;
    clearTimeout(timer);
    timer = window.setTimeout(hide, actions.length ? 12_000 : 6000);
}

/**
 * Tells screen readers.
 * @param {string} text
 */
export function say(text) {
    at('said').textContent = text;
}
