// A stream's page asks whether there is a newer one, and takes over what is new in it. It shows the newest frame unless one
// looks back.

import {at} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {within} from '../shared/time_axis.js';
import {numberOf, placeOfNumber} from './events.js';
import {withTwins} from './marks.js';
import {withPortraits} from './parts.js';
import {picture, readLooks, readPixels} from './picture.js';
import {isPlaying, show, takeFilms} from './player.js';
import {set, state} from './state.js';
import {Timeline} from './timeline.js';
import {becomeTurnable} from './turning.js';
import {nextVolume} from './volume_view.js';

let stamp = '';  // what the server says of the page that is shown
/**
 * Seconds between the server's clock and this machine's; null = it says no time.
 * @type {number | null}
 */
let serverAhead = null;
/** A page that was opened as a file may fetch nothing: it opens itself again. */
const isFile = location.protocol === 'file:';
const kept = 'vvr-live ' + location.pathname;

async function lookForNews() {
    if (state.data.live?.ended) return;
    if (isFile) {
        if (document.visibilityState !== 'visible' || document.querySelector('details.menu[open]') ||
            document.activeElement?.matches('input:not([type="checkbox"])')) return;
        keepState();
        return location.reload();
    }
    try {
        const head = await fetch(location.href, {method: 'HEAD', cache: 'no-store'});
        const date = Date.parse(head.headers.get('Date') ?? '');
        serverAhead = Number.isFinite(date) ? (date - Date.now()) / 1000 : null;
        const found = ['ETag', 'Last-Modified', 'Content-Length'].map(name => head.headers.get(name)).join(' ');
        if (!head.ok || found === stamp) return;
        const isFirst = stamp === '';
        stamp = found;
        if (isFirst) return;  // it is what the browser has just opened
        await takeOver(await (await fetch(location.href, {cache: 'no-store'})).text());
    } catch {
        // The server does not answer: the page says how old the picture is.
    }
}

/**
 * The strip of time as it is zoomed, in what the page has now.
 * @param {Timeline} time
 */
function stripIn(time) {
    const isWhole = state.stripLasts >= state.time.lasts * 0.999;
    const all = {from: time.begins, lasts: time.lasts};
    const {from, lasts} = isWhole ? all : within({from: state.stripFrom, lasts: Math.min(state.stripLasts, time.lasts)}, all);
    return {stripFrom: from, stripLasts: lasts};
}

/**
 * Takes over what is new. Picture and volume are read before they are shown, so that all changes at once: no new picture lies
 * below the veil of the one before.
 * @param {string} text a newer page
 */
async function takeOver(text) {
    const fresh = new DOMParser().parseFromString(text, 'text/html');
    const image = fresh.getElementById('picture');
    const json = (/** @type {string} */ id) => JSON.parse(fresh.getElementById(id)?.textContent ?? 'null');
    const [data, pixels, stills, volume] = ['data', 'pixeldata', 'stilldata', 'volumedata'].map(json);
    if (!data || !(image instanceof HTMLImageElement)) return;
    const time = new Timeline(data.times, data.clock, data.gaps);
    const had = state.parts.volume;
    const parts = {...state.parts, ...pixels, ...stills, ...volume};
    const events = withPortraits(withTwins(data.events ?? []), parts.portraits);
    const read = Object.assign(new Image(), {src: image.src});
    await read.decode();
    const looks = readLooks(read, data.overlay);
    const numbers = await readPixels(parts).catch(() => null);  // the list and the strip can do without
    const showVolume = await nextVolume(parts.volume);
    picture.decoding = 'sync';
    picture.src = read.src;
    showVolume();
    const number = state.chosen === null ? null : numberOf(state.events, state.chosen);
    document.title = fresh.title;
    const heading = document.querySelector('h1');
    if (heading) heading.textContent = fresh.querySelector('h1')?.textContent ?? '';
    const now = state.follows && !isPlaying() ? time.lastFrame : time.clamped(state.now);
    const isGone = state.piece !== null && state.piece[1] <= time.begins;  // the piece of time that is chosen
    set({...isGone ? {piece: null, bends: false} : {}, data, parts, time, events, ...looks, pixels: numbers, lightened: null, chosen: number === null ? null : placeOfNumber(events, number),
         now, stillClock: Math.max(state.stillClock, time.secondsOf(now)), ...stripIn(time)});
    takeFilms();
    if (!had) becomeTurnable();
}

/** Before the page opens itself again. */
function keepState() {
    const {now, follows, scale, middle, tab, filmScale, filmMiddle, kind, what, leastSeconds, onlyStarred, showsHidden, order, asked,
        speed, density, chosen, events, stripFrom, stripLasts, time} = state;
    const strip = stripLasts < time.lasts * 0.999 ? {stripFrom, stripLasts} : {};
    sessionStorage.setItem(kept, JSON.stringify({
        state: {now, follows, scale, middle, tab, filmScale, filmMiddle, kind, what, leastSeconds, onlyStarred, showsHidden, order, asked,
            speed, density, ...strip},
        plays: isPlaying(), number: chosen === null ? null : numberOf(events, chosen)}));
}

/** After it has. */
export function takeKeptState() {
    if (!state.data.live) return;
    set({now: state.time.lastFrame, moved: true});
    const text = isFile ? sessionStorage.getItem(kept) : null;
    if (text === null) return;
    sessionStorage.removeItem(kept);
    const {state: old, plays, number} = JSON.parse(text);
    const place = number === null ? null : placeOfNumber(state.events, number);
    Object.assign(state, old);
    const now = old.follows ? state.time.lastFrame : state.time.clamped(old.now);
    set({now, chosen: place, wantsPlay: plays, stillClock: state.time.secondsOf(now), ...stripIn(state.time)});
}

/** Says what the stream does, and how old the picture is by the clock of the machine that serves it. */
export function drawAge() {
    const {live} = state.data;
    at('state').hidden = !live;
    if (!live) return;
    const seconds = Math.max(0, Math.round(Date.now() / 1000 + (serverAhead ?? 0) - live.written));
    const old = !live.ended && seconds > 2 * live.brick + 5;
    at('state').className = old ? 'old' : '';
    const words = live.ended ? 'the stream has ended' : live.state;
    // A screen reader is told when it changes, not each second.
    if (at('livestate').textContent !== words) at('livestate').textContent = words;
    at('age').textContent = live.ended ? '' : old ? `· no new picture for ${seconds} s` : `· updated ${seconds} s ago`;
}

export function drawFollowing() {
    at('tonow').hidden = !state.data.live || state.follows;
}

export function followStream() {
    const {live} = state.data;
    if (!live) return;
    at('tonow').addEventListener('click', () => show(state.time.lastFrame, false, {follows: true, until: null, touring: false}));
    setInterval(drawAge, 1000);
    const pause = isFile ? Math.max(2, live.brick) : clamp(live.brick / 2, 1, 30);  // seconds
    const wait = () => setTimeout(look, pause * 1000);  // one look after the other, however long it takes
    const look = () => lookForNews().then(wait);
    if (isFile) wait();
    else look();
}
