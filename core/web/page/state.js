// The state of the page. Whether something plays is asked from the player (isPlaying in player.js).

import {at, dataOfPage} from '../shared/dom.js';
import {kindsBy} from '../shared/kinds.js';
import {store} from '../shared/state.js';
import {withTwins} from './marks.js';
import {Timeline} from './timeline.js';

/** @type {import('./data.js').PageData} */
const data = dataOfPage();
/** @type {import('./data.js').Parts} */
const nothing = {pixels: null, objects: null, stills: [], portraits: [], volume: null, preview: null};
const time = new Timeline(data.times, data.clock, data.gaps);

const picture = at('picture', HTMLImageElement);
/** Width and height of the picture. */
export const pictureSize = [Number(picture.getAttribute('width')), Number(picture.getAttribute('height'))];

export const kindOf = kindsBy(data.kinds);

export const {state, set, render, drawAll} = store({
    data,  // that of a stream is replaced
    time,
    events: withTwins(data.events ?? []),
    parts: nothing,      // that have arrived
    allArrived: false,
    dark: matchMedia('(prefers-color-scheme: dark)').matches,

    // the player
    now: data.live ? time.lastFrame : time.firstFrame,  // the frame that is shown
    moved: false,          // whether anybody has asked for a moment yet
    film: /** @type {import('./player.js').Film | null} */ (null),  // what the player has open
    source: '',            // what the player shows, in words
    gone: false,           // whether the clip is no longer where it was
    stills: false,         // whether there is no film, only stills
    wantsPlay: false,      // whether stills play, or the film is to play once it is open
    stillClock: time.begins,  // of playing stills, seconds
    touring: false,        // whether the events play one after another
    speed: 1,
    jumping: false,        // whether a time is to be typed
    filmScale: 1,          // 1 = the whole film
    filmMiddle: [0.5, 0.5],
    fills: false,          // whether film and strip fill the window or the screen
    filmShare: 0.5,        // of the width that film and volume have
    tab: /** @type {'events' | 'volume' | 'map'} */ ('events'),  // what a phone shows below the film
    isFirst: false,        // whether nobody has dragged yet
    follows: data.live !== null,  // whether a stream's page shows the newest frame
    until: /** @type {number | null} */ (null),  // the frame at which playing ends; null = none

    // events, each as its place in the list
    chosen: /** @type {number | null} */ (null),
    lightened: /** @type {number | null} */ (null),  // the one that the pointer is on
    kind: 'all',
    what: '',  // a class or a group of classes; '' = all, '?' = unknown
    leastSeconds: 0,
    onlyStarred: false,
    showsHidden: false,
    marks: /** @type {Record<string, import('./marks.js').Mark>} */ ({}),  // by the event's key
    order: 'time',

    // the place that is asked for
    asking: /** @type {'box' | 'line' | null} */ (null),  // while one is to be drawn
    drawn: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // so far
    asked: /** @type {import('../shared/shapes.js').Shape | null} */ (null),  // in shares of the clip's picture

    // the picture
    pixels: /** @type {import('./pixels.js').Pixels | null} */ (null),  // null = not read yet
    ground: /** @type {number[] | null} */ (null),  // the colour behind everything; null = the page's
    contents: [0, 0, ...pictureSize],  // the part that is not empty: left, top, right, bottom
    scale: 1,                 // 1 = all contents fit
    middle: [0.5, 0.5],       // the point in the middle of the view, in shares of the picture
    room: [0, 0],             // width and height of the view
    stageWidth: 0,            // of the picture on the screen

    // the volume that turns
    turnable: false,          // whether there is one
    turns: false,             // whether it is shown instead of the picture
    angle: [0, 46],           // azimuth and elevation, degrees
    unbent: false,            // whether it is straight
    density: 1,               // a factor on its extinction
    piece: /** @type {[number, number] | null} */ (null),  // of the time, in seconds; null = all
    brush: /** @type {[number, number] | null} */ (null),  // the part of the strip that is chosen for it
    bends: false,             // whether the piece has all of the arc

    // the strip of time, in seconds
    stripFrom: time.begins,
    stripLasts: time.lasts,
    stripWidth: 0,

    // what the pointer is on
    which: /** @type {{candidates: import('./which.js').Candidate[], x: number, y: number} | null} */ (null),  // a finger's choice
    pointed: /** @type {{frame: number, x: number, y: number, note: string} | null} */ (null),
});
