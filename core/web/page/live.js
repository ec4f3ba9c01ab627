// A stream's page asks whether there is a newer one, and takes over what is new in it.

import {at} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {numberOf, placeOfNumber} from './events.js';
import {readPicture} from './picture.js';
import {set, state} from './state.js';
import {Timeline} from './timeline.js';

let stamp = '';  // what the server says of the page that is shown
/**
 * Seconds between the server's clock and this machine's; null = it says no time.
 * @type {number | null}
 */
let serverAhead = null;

async function lookForNews() {
    try {
        const head = await fetch(location.href, {method: 'HEAD', cache: 'no-store'});
        const date = Date.parse(head.headers.get('Date') ?? '');
        serverAhead = Number.isFinite(date) ? (date - Date.now()) / 1000 : null;
        const found = ['ETag', 'Last-Modified', 'Content-Length'].map(name => head.headers.get(name)).join(' ');
        if (!head.ok || found === stamp) return;
        const isFirst = stamp === '';
        stamp = found;
        if (isFirst) return;  // it is what the browser has just opened
        takeOver(await (await fetch(location.href, {cache: 'no-store'})).text());
    } catch {
        // A page that was opened as a file may fetch nothing: it opens itself again.
        if (location.protocol === 'file:' && document.visibilityState === 'visible') location.reload();
    }
}

/** @param {string} text a newer page */
function takeOver(text) {
    const fresh = new DOMParser().parseFromString(text, 'text/html');
    const node = fresh.getElementById('data');
    const picture = fresh.getElementById('picture');
    if (!node || !(picture instanceof HTMLImageElement)) return;
    /** @type {import('./data.js').PageData} */
    const data = JSON.parse(node.textContent ?? '');
    const time = new Timeline(data.times, data.clock);
    const events = data.events ?? [];
    const number = state.chosen === null ? null : numberOf(state.events, state.chosen);
    at('picture', HTMLImageElement).src = picture.src;
    document.title = fresh.title;
    const heading = document.querySelector('h1');
    if (heading) heading.textContent = fresh.querySelector('h1')?.textContent ?? '';
    set({data, time, events, pixels: null, lightened: null, chosen: number === null ? null : placeOfNumber(events, number),
         now: time.clamped(state.now), stripFrom: time.begins, stripLasts: time.lasts});
    readPicture().catch(() => {});  // the next page brings another picture
}

/** Says what the stream does, and how old the picture is by the clock of the machine that serves it. */
export function drawAge() {
    const {live} = state.data;
    at('state').hidden = !live;
    if (!live) return;
    const seconds = Math.max(0, Math.round(Date.now() / 1000 + (serverAhead ?? 0) - live.written));
    const old = seconds > 2 * live.brick + 5;
    at('state').className = old ? 'old' : '';
    at('state').textContent = [live.state, old ? `no new picture for ${seconds} s` : `updated ${seconds} s ago`].join(' · ');
}

export function followStream() {
    if (!state.data.live) return;
    setInterval(drawAge, 1000);
    const every = clamp(state.data.live.brick / 2, 1, 30) * 1000;
    if (location.protocol !== 'file:') lookForNews();
    setInterval(lookForNews, location.protocol === 'file:' ? 2 * every : every);
}
