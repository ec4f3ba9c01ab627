// What a search has found, as a list of pictures.

import {at, element} from '../shared/dom.js';
import {shortSpanOf} from '../shared/durations.js';
import {many} from '../shared/text.js';
import {dayText, timeText, weekday} from '../shared/wall_clock.js';
import {pointOnWay} from '../shared/ways.js';
import {addressOfHit} from '../page/address.js';
import {tallyWords} from './clips.js';
import {bits} from './data.js';
import {stillsOf} from './events.js';
import {wallIn} from './scene.js';
import {nearestStill, stillsBetween} from './sheet.js';
import {cameraName, data, hits, search, see, state} from './state.js';
import {Tile, playOn, shaped} from './tiles.js';

/** @typedef {import('./answers.js').Found} Found */

const mostFound = 300;
const leadIn = 2;  // seconds that are played before what was searched for

/**
 * The page of a clip at a hit.
 * @param {Found} found
 * @param {boolean} [all] whether the next hits follow by themselves
 * @param {number} [ended] the way in which there is no other hit
 */
export function urlOfHit({event, how}, all, ended) {
    if (!(event.clip.files & bits.page)) return event.clip.url + '.png';
    const nth = hits().findIndex(hit => hit.event === event) + 1;
    const seconds = Math.max(event.way[0] / 10, how.at - leadIn);
    const hit = {number: event.number, seconds, place: state.place, search: search(), nth, of: hits().length};
    return event.clip.url + '.html' + addressOfHit(hit, {all, ended});
}

/** @param {Found} found */
function pictureOf({event, how}) {
    const stills = stillsOf(event.clip);
    const [begin, end] = [event.way[0], event.way[event.way.length - 3]].map(tenths => tenths / 10);
    // Where nobody asked for a place, the middle of an event shows more than its beginning at the border.
    const moment = state.place ? how.at : (begin + end) / 2;
    const tile = new Tile(event.clip, stills.length).mark(state.place, stills.length ? pointOnWay(event.way, moment * 10) : null);
    const place = nearestStill(stills, moment, begin - 1, end + 1);
    const note = element('small', 'of');
    const rest = () => {
        tile.show(place);
        tile.window.classList.remove('playing');
        const apart = stills.length ? Math.abs(stills[place] - moment) : 0;
        note.textContent = apart > 1 ? 'picture of ' + timeText(wallIn(event, stills[place])) : '';
    };
    const scenes = () => stills.length ? stillsBetween(stills, begin, end).map(next => ({show: () => {
        tile.show(next);
        tile.window.classList.add('playing');  // the spot is that of the moment
        note.textContent = timeText(wallIn(event, stills[next]));
    }})) : [];
    rest();
    const window = shaped(element('span', 'images'), event.clip.camera);
    window.append(tile.window, note);
    return {window, scenes, rest};
}

/** @param {Found} found */
function itemOf(found) {
    const {event, how} = found;
    const link = element('a');
    link.href = urlOfHit(found);
    link.addEventListener('click', () => see(event.clip));
    const {window, scenes, rest} = pictureOf(found);
    playOn(link, scenes, rest);
    const when = wallIn(event, how.at);
    const lasts = (event.way[event.way.length - 3] - event.way[0]) / 10;
    const facts = element('span', 'facts');
    const day = dayText(when);
    facts.append(element('b', '', timeText(when)));
    if (state.camera === null && data.cameras.length > 1) facts.append(element('bdi', '', cameraName(event.clip.camera)));
    facts.append(element('small', '', `${weekday(day).slice(0, 3)} ${day}`),
                 element('span', 'badge ' + event.kind.emphasis, event.kind.tally === 'still' ? tallyWords(event.kind, event.still) : event.kind.words));
    if (event.what) facts.append(element('span', '', event.what));
    facts.append(element('span', 'answer', how.words() || 'in view ' + shortSpanOf(lasts)));
    link.append(window, facts);
    const item = element('li');
    item.append(link);
    return item;
}

export function drawHits() {
    const heading = at('foundheading');
    const playAll = at('playall', HTMLAnchorElement);
    if (!state.answer) {
        heading.textContent = 'Loading…';
        return;
    }
    const found = hits();
    heading.textContent = state.place ? `${found.length.toLocaleString('en')} of ${many(state.answer.events.length, 'event')}` : many(found.length, 'event');
    const items = found.slice(0, state.all ? found.length : mostFound).map(itemOf);
    const more = found.length - items.length;
    if (more > 0) items.push(element('li', 'none', `${more.toLocaleString('en')} more: choose days, or draw a smaller area.`));
    if (!found.length) items.push(element('li', 'none', 'No matching events.'));
    at('found').replaceChildren(...items);
    playAll.hidden = !found.length;
    if (found.length) playAll.href = urlOfHit(found[0], true);
}

/**
 * Arrow keys go from hit to hit.
 * @param {KeyboardEvent} event
 */
function goByKey(event) {
    const links = /** @type {HTMLElement[]} */ ([...at('found').querySelectorAll('a')]);
    const here = links.findIndex(link => link === document.activeElement);
    const columns = new Set(links.map(link => link.offsetLeft)).size;
    /** @type {Record<string, number>} */
    const steps = {ArrowRight: here + 1, ArrowLeft: here - 1, ArrowDown: here + columns, ArrowUp: here - columns, Home: 0, End: links.length - 1};
    if (here < 0 || steps[event.key] === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    links[steps[event.key]]?.focus();
    event.preventDefault();
}

export function listenToHits() {
    at('found').addEventListener('keydown', goByKey);
}
