// What the keys do: an action's name and its arguments.

/**
 * @typedef {{key: string, shiftKey?: boolean, ctrlKey?: boolean, altKey?: boolean, metaKey?: boolean}} Key
 * @typedef {[name: string, ...values: number[]]} Action
 */

/** @type {Record<string, Action>} */
const pageKeys = {
    '+': ['zoom', 1.5],
    '=': ['zoom', 1.5],
    '-': ['zoom', 1 / 1.5],
    '0': ['showWhole'],
    ' ': ['togglePlaying'],
    k: ['togglePlaying'],
    j: ['goBy', -5],
    l: ['goBy', 5],
    ',': ['stepFrame', -1],
    '.': ['stepFrame', 1],
    '<': ['changeSpeed', -1],
    '>': ['changeSpeed', 1],
    '[': ['changeSpeed', -1],
    ']': ['changeSpeed', 1],
    e: ['toggleTour'],
    g: ['askTime'],
    f: ['toggleFullScreen'],
    x: ['changeShares'],
    a: ['searchByArea'],
    d: ['searchByLine'],
    '?': ['showHelp'],
    Escape: ['leave'],
    ArrowLeft: ['step', -1],
    ArrowUp: ['step', -1],
    ArrowRight: ['step', 1],
    ArrowDown: ['step', 1],
};

/**
 * With Shift.
 * @type {Record<string, Action>}
 */
const shiftedKeys = {
    ArrowLeft: ['pan', 80, 0],
    ArrowRight: ['pan', -80, 0],
    ArrowUp: ['pan', 0, 80],
    ArrowDown: ['pan', 0, -80],
};

/**
 * With Alt.
 * @type {Record<string, Action>}
 */
const turningKeys = {
    ArrowLeft: ['turn', 6, 0],
    ArrowRight: ['turn', -6, 0],
    ArrowUp: ['turn', 0, 4],
    ArrowDown: ['turn', 0, -4],
};

/**
 * On the strip of time.
 * @type {Record<string, Action>}
 */
const stripKeys = {
    ArrowLeft: ['goBy', -1],
    ArrowRight: ['goBy', 1],
    ArrowDown: ['goBy', -1],
    ArrowUp: ['goBy', 1],
    PageDown: ['goBy', -10],
    PageUp: ['goBy', 10],
    Home: ['goToFirst'],
    End: ['goToLast'],
    '+': ['zoomStrip', 1 / 1.5],
    '=': ['zoomStrip', 1 / 1.5],
    '-': ['zoomStrip', 1.5],
};

/** @type {(key: Key) => boolean} */
const isForBrowser = ({ctrlKey, altKey, metaKey}) => Boolean(ctrlKey || altKey || metaKey);

/**
 * What a key does in the page; null = nothing.
 * @param {Key} key
 * @returns {Action | null}
 */
export function pageAction(key) {
    if (key.altKey && !key.ctrlKey && !key.metaKey && Object.hasOwn(turningKeys, key.key)) return turningKeys[key.key];
    if (isForBrowser(key)) return null;
    const name = key.key.length === 1 ? key.key.toLowerCase() : key.key;
    const table = key.shiftKey && Object.hasOwn(shiftedKeys, name) ? shiftedKeys : pageKeys;
    return Object.hasOwn(table, name) ? table[name] : null;
}

/**
 * What a key does on the strip of time; null = nothing. Shift makes steps ten times as long.
 * @param {Key} key
 * @returns {Action | null}
 */
export function stripAction(key) {
    if (isForBrowser(key) || !Object.hasOwn(stripKeys, key.key)) return null;
    const [name, ...values] = stripKeys[key.key];
    return [name, ...values.map(value => name === 'goBy' && key.shiftKey ? value * 10 : value)];
}
