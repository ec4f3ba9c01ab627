// Keys of the page.

import {askBy, askPlace} from './asking.js';
import {choose, step} from './choice.js';
import {pageAction} from './key_table.js';
import {goBy, stepFrame, togglePlaying} from './player.js';
import {state} from './state.js';
import {pan, showWhole, zoom} from './view.js';

/** Ends what was begun last. */
function leave() {
    if (state.asking) askBy(state.asking);
    else if (state.chosen !== null) choose(null);
    else askPlace(null);
}

/** @type {Record<string, (...values: number[]) => void>} */
const actions = {zoom: factor => zoom(factor), showWhole, togglePlaying, goBy, stepFrame, leave, step, pan};

/**
 * @param {EventTarget | null} target
 * @param {string} selector
 */
const isIn = (target, selector) => target instanceof Element && target.closest(selector) !== null;

export function listenToKeys() {
    // A button that was clicked keeps the focus and would take Space for itself; only for who came by keyboard it does.
    let byKeyboard = false;
    addEventListener('keydown', event => { if (event.key === 'Tab') byKeyboard = true; }, true);
    addEventListener('pointerdown', () => { byKeyboard = false; }, true);
    document.addEventListener('change', event => { if (!byKeyboard && event.target instanceof HTMLElement) event.target.blur(); });
    document.addEventListener('keydown', event => {
        const action = pageAction(event);
        if (!action || isIn(event.target, 'select, input')) return;
        if (byKeyboard && event.key === ' ' && isIn(event.target, 'button, a')) return;
        const [name, ...values] = action;
        actions[name](...values);
        event.preventDefault();
    });
    // Space presses a focused button when it comes up again.
    document.addEventListener('keyup', event => {
        if (event.key === ' ' && !byKeyboard && isIn(event.target, 'button')) event.preventDefault();
    });
}
