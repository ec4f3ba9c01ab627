// The state of the page. Whether something plays is asked from the player (isPlaying in player.js).

import {at, dataOfPage} from '../shared/dom.js';
import {kindsBy} from '../shared/kinds.js';
import {store} from '../shared/state.js';
import {Timeline} from './timeline.js';

/** @type {import('./data.js').PageData} */
const data = dataOfPage();
const time = new Timeline(data.times, data.clock);

const picture = at('picture', HTMLImageElement);
/** Width and height of the picture. */
export const pictureSize = [Number(picture.getAttribute('width')), Number(picture.getAttribute('height'))];

export const kindOf = kindsBy(data.kinds);

export const {state, set, render, drawAll} = store({
    data,  // that of a stream is replaced
    time,
    events: data.events ?? [],

    // the player
    now: time.firstFrame,  // the frame that is shown
    moved: false,          // whether anybody has asked for a moment yet
    film: /** @type {import('./player.js').Film | null} */ (null),  // what the player has open
    source: '',            // what the player shows, in words
    stills: false,         // whether there is no film, only stills
    wantsPlay: false,      // whether stills play, or the film is to play once it is open
    stillClock: time.begins,  // of playing stills, seconds
    until: /** @type {number | null} */ (null),  // the frame at which playing ends; null = none

    // events, each as its place in the list
    chosen: /** @type {number | null} */ (null),
    lightened: /** @type {number | null} */ (null),  // the one that the pointer is on
    kind: 'all',
    what: '',  // a class or a group of classes; '' = all, '?' = unknown
    leastSeconds: 0,
    order: 'time',

    // the place that is asked for
    asking: /** @type {'box' | 'line' | null} */ (null),  // while one is to be drawn
    drawn: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // so far
    asked: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // in shares of the clip's picture

    // the picture
    pixels: /** @type {import('./pixels.js').Pixels | null} */ (null),  // null = not read yet
    ground: [255, 255, 255],  // the colour behind everything
    contents: [0, 0, ...pictureSize],  // the part that is not empty: left, top, right, bottom
    scale: 1,                 // 1 = all contents fit
    middle: [0.5, 0.5],       // the point in the middle of the view, in shares of the picture
    room: [0, 0],             // width and height of the view

    // the strip of time, in seconds
    stripFrom: time.begins,
    stripLasts: time.lasts,
    stripWidth: 0,

    // what the pointer is on
    pointed: /** @type {{frame: number, x: number, y: number, note: string} | null} */ (null),
});
