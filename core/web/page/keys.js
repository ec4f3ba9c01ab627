// Keys of the page.

import {askBy, askByKeys, askPlace} from './asking.js';
import {choose, step} from './choice.js';
import {pageAction} from './key_table.js';
import {askTime, changeSpeed, goBy, stepFrame, togglePlaying, toggleTour} from './player.js';
import {endFilling, changeShares, toggleFullScreen} from './layout.js';
import {at} from '../shared/dom.js';
import {state} from './state.js';
import {endBrush} from './strip.js';
import {turn, turnBack} from './turning.js';
import {pan, showWhole, zoom} from './view.js';
import {endWhich} from './which.js';

/** Ends what was begun last. */
function leave() {
    const open = document.querySelector('details.menu[open]');
    if (open) open.removeAttribute('open');
    else if (endWhich() || endFilling()) return;
    else if (state.asking) askBy(state.asking);
    else if (state.chosen !== null) choose(null);
    else if (endBrush()) return;
    else askPlace(null);
}

/** @type {Record<string, (...values: number[]) => void>} */
const actions = {zoom: factor => zoom(factor), showWhole: () => { showWhole(); turnBack(); }, turn, togglePlaying, goBy, stepFrame, leave, step, pan,
    changeSpeed, toggleTour, askTime, toggleFullScreen, changeShares, searchByArea: () => askByKeys('box'), searchByLine: () => askByKeys('line'),
    showHelp: () => at('help').toggleAttribute('open')};

/**
 * @param {EventTarget | null} target
 * @param {string} selector
 */
const isIn = (target, selector) => target instanceof Element && target.closest(selector) !== null;

// There the page scrolls as a whole (page.css has the same limit), so the up and down keys scroll it; left and right still go through the events.
const hasFewLines = matchMedia('(max-height: 520px)');

export function listenToKeys() {
    // A button that was clicked keeps the focus and would take Space for itself; only for who came by keyboard it does.
    let byKeyboard = false;
    addEventListener('keydown', event => { if (event.key === 'Tab') byKeyboard = true; }, true);
    addEventListener('pointerdown', () => { byKeyboard = false; }, true);
    document.addEventListener('change', event => { if (!byKeyboard && event.target instanceof HTMLElement) event.target.blur(); });
    document.addEventListener('keydown', event => {
        const action = pageAction(event);
        if (isIn(event.target, 'select, input:not([type="checkbox"])')) return;
        if (!action) return;
        if (hasFewLines.matches && !event.shiftKey && ['ArrowUp', 'ArrowDown'].includes(event.key)) return;
        if (byKeyboard && event.key === ' ' && isIn(event.target, 'button, a, summary, input')) return;
        const [name, ...values] = action;
        actions[name](...values);
        event.preventDefault();
    });
    // A menu closes when one presses elsewhere.
    addEventListener('pointerdown', event => {
        for (const menu of document.querySelectorAll('details.menu[open]')) {
            if (event.target instanceof Node && !menu.contains(event.target)) menu.removeAttribute('open');
        }
    });
    // Space presses a focused button when it comes up again.
    document.addEventListener('keyup', event => {
        if (event.key === ' ' && !byKeyboard && isIn(event.target, 'button')) event.preventDefault();
    });
}
