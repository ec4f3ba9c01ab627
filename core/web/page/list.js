// The list of events, and its filters.

import {at, button, element, press} from '../shared/dom.js';
import {playEvent, rowOf, step} from './choice.js';
import {addressOfEvent} from './address.js';
import {countsOfClasses, countsOfKinds, factsOf, numberOf, relationsOf, sortedPlaces} from './events.js';
import {answerOf, wantedEvents} from './filters.js';
import {kindOf, set, state} from './state.js';

const classes = at('class', HTMLSelectElement);
const order = at('order', HTMLSelectElement);
const least = at('least', HTMLSelectElement);

/**
 * "came out of 5", each a link to its event.
 * @param {import('./data.js').PageEvent} event
 */
const linksOf = event => relationsOf(event, kindOf(event.kind)).map(({place, words}) => {
    const number = numberOf(state.events, place);
    const link = element('a', 'relation', `${words} ${number}`);
    link.href = addressOfEvent(number);
    return link;
});

/**
 * A part of a frame that shows the event's object.
 * @param {import('./data.js').PageEvent} event
 */
function portraitOf(event) {
    const frame = element('span', 'portrait');
    if (!event.portrait) return frame;
    const image = element('img');
    image.alt = '';
    image.loading = 'lazy';
    image.src = event.portrait;
    frame.append(image);
    return frame;
}

/** @param {number} place */
function itemOf(place) {
    const {events, time} = state;
    const event = events[place];
    const kind = kindOf(event.kind);
    const row = button('', '', () => playEvent(place));
    row.dataset.event = String(place);
    if (event.colour) row.style.borderLeftColor = event.colour;
    const words = element('span', 'words');
    const [first, last] = [event.first, event.last].map(frame => time.clockOf(time.secondsOf(frame)));
    words.append(element('b', '', `${numberOf(events, place)}.  ${first} – ${last}`), element('span', 'kind ' + kind.emphasis, kind.words),
                 element('small', '', factsOf(event, time, kind, answerOf(event)).join(' · ')));
    row.append(portraitOf(event), words);
    row.addEventListener('pointerenter', () => set({lightened: place}));
    row.addEventListener('pointerleave', () => set({lightened: null}));
    const item = element('li');
    item.append(row, ...linksOf(event));
    return item;
}

const mostListed = 1000;  // a list that is longer is no use to a person, and slow

export function drawList() {
    const {events, data, time} = state;
    const places = sortedPlaces(events, wantedEvents(), state.order, time, kindOf);
    const count = events.length;
    const all = count ? count + (count === 1 ? ' event' : ' events') : 'Events';
    at('heading').textContent = places.length === count ? all : `${places.length} of ${all}`;
    at('previous', HTMLButtonElement).disabled = at('next', HTMLButtonElement).disabled = places.length === 0;
    const items = count ? places.slice(0, mostListed).map(itemOf) : [element('li', 'none', data.events
        ? 'Nothing moved long enough to be an event.' : 'The filter of this picture marks no objects, so nobody looked for events.')];
    if (count && !places.length) items.push(element('li', 'none', 'No event is like that.'));
    if (places.length > mostListed) items.push(element('li', 'none', `${places.length - mostListed} more: ask for a kind, a length or a place.`));
    at('events').replaceChildren(...items);
    drawChosen();
    drawLit();
}

export function drawChosen() {
    for (const row of at('events').querySelectorAll('button')) row.setAttribute('aria-current', String(Number(row.dataset.event) === state.chosen));
}

/** The row of the event that the pointer is on. */
export function drawLit() {
    for (const row of at('events').querySelectorAll('.lit')) row.classList.remove('lit');
    rowOf(state.lightened)?.classList.add('lit');
}

/** A button for each kind that there is. */
export function drawChips() {
    const {events} = state;
    const kinds = countsOfKinds(events, kindOf);
    const chip = (/** @type {string} */ name, /** @type {string} */ words) => {
        const made = button('chip', words, () => set({kind: name}));
        press(made, name === state.kind);
        return made;
    };
    at('kinds').replaceChildren(chip('all', `all ${events.length}`), ...kinds.map(({name, count}) => chip(name, `${kindOf(name).words} ${count}`)));
    at('filters').hidden = events.length < 2;
    at('kinds').hidden = kinds.length < 2;
}

/** A choice of each group of classes, and of each class in it, if the detector knows some of the objects. */
export function drawClasses() {
    const rows = countsOfClasses(state.events);
    if (state.what !== '' && !rows.some(({name}) => name === state.what)) set({what: ''});
    const choice = (/** @type {string} */ name, /** @type {string} */ words) =>
        Object.assign(element('option', '', words), {value: name, selected: name === state.what});
    classes.replaceChildren(choice('', 'everything'), ...rows.map(({name, isGroup, count}) =>
        choice(name, `${isGroup ? '' : '\u2013 '}${name === '?' ? 'unknown' : name} ${count}`)));
    classes.hidden = rows.every(({name}) => name === '?');
}

export function listenToList() {
    classes.addEventListener('change', () => set({what: classes.value}));
    order.addEventListener('change', () => set({order: order.value}));
    least.addEventListener('change', () => set({leastSeconds: Number(least.value)}));
    at('previous').addEventListener('click', () => step(-1));
    at('next').addEventListener('click', () => step(1));
}
