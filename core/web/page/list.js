// The list of events, and its filters.

import {at, button, element, press} from '../shared/dom.js';
import {maskOption} from './commands.js';
import {playEvent, rowOf, step} from './choice.js';
import {addressOfEvent} from './address.js';
import {countsOfClasses, countsOfKinds, deedOf, factsOf, numberOf, relationsOf, spoken, stillNear} from './events.js';
import {copy} from './export.js';
import {answerOf, asksForSome, hiddenCount, listedEvents} from './filters.js';
import {ofEvent} from './looks.js';
import {changed, clipKey, keyOf, readMarks} from './marks.js';
import {offer, say} from './messages.js';
import {kindOf, set, state} from './state.js';

const classes = at('class', HTMLSelectElement);
const order = at('order', HTMLSelectElement);
const least = at('least', HTMLSelectElement);
const starred = at('starred', HTMLInputElement);
const showHidden = at('showhidden', HTMLInputElement);

/**
 * "began in one outline with 5", each a link to its event.
 * @param {import('./data.js').PageEvent} event
 */
const linksOf = event => relationsOf(event, kindOf(event.kind)).map(({place, words}) => {
    const number = numberOf(state.events, place);
    const link = ofEvent(element('a', 'relation', words + ' '), place);
    link.append(element('b', 'number', String(number)));
    link.href = addressOfEvent(number);
    link.addEventListener('click', click => {
        click.preventDefault();
        playEvent(place);
    });
    return link;
});

/** @param {import('./data.js').PageEvent} event */
function portraitOf(event) {
    const frame = element('span', 'portrait');
    const src = event.portrait ?? stillNear(state.parts.stills, (event.first + event.last) / 2)?.src;
    if (!src) return frame;
    const image = element('img');
    image.alt = '';
    image.loading = 'lazy';
    image.src = src;
    frame.append(image);
    return frame;
}

/**
 * Changes a mark of an event, and keeps it.
 * @param {import('./data.js').PageEvent} event
 * @param {import('./marks.js').Mark} change
 */
function mark(event, change) {
    set({marks: changed(state.marks, keyOf(event), change)});
    try {
        localStorage.setItem(clipKey(state.data), JSON.stringify(state.marks));
    } catch {
        say('This browser keeps nothing: save the notes as a file.');
    }
}

/** @param {number} place */
function hide(place) {
    const event = state.events[place];
    const isNothing = state.marks[keyOf(event)]?.nothing === true;
    mark(event, {nothing: !isNothing});
    if (isNothing) return;
    const option = maskOption(event.box, state.data.size);
    offer(`Event ${numberOf(state.events, place)} is hidden. A mask keeps such events out of the next run.`, [
        ['Undo', () => mark(event, {nothing: false})], ['Copy --mask', () => copy(option, 'the option for the next run')]]);
}

/** @param {number} place */
function note(place) {
    const event = state.events[place];
    const field = element('input', 'note');
    field.value = state.marks[keyOf(event)]?.note ?? '';
    field.placeholder = 'A note; Enter keeps it';
    field.ariaLabel = 'A note on event ' + numberOf(state.events, place);
    const keep = () => mark(event, {note: field.value.trim()});
    field.addEventListener('keydown', key => {
        key.stopPropagation();
        if (key.key === 'Enter') keep();
        if (key.key === 'Escape') drawList();
    });
    field.addEventListener('change', keep);
    rowOf(place)?.closest('li')?.append(field);
    field.focus();
}

/** @param {number} place */
function actsOf(place) {
    const marked = state.marks[keyOf(state.events[place])] ?? {};
    const number = numberOf(state.events, place);
    const acts = element('span', 'acts');
    const act = (/** @type {string} */ sign, /** @type {string} */ words, /** @type {boolean} */ on, /** @type {() => void} */ does) => {
        const made = button('', sign, does);
        made.title = words;
        made.ariaLabel = `${words}: event ${number}`;
        made.tabIndex = -1;
        press(made, on);
        acts.append(made);
    };
    act(marked.star ? '★' : '☆', 'Star', marked.star === true, () => mark(state.events[place], {star: !marked.star}));
    act('✎', 'Note', Boolean(marked.note), () => note(place));
    act('⊘', marked.nothing ? 'Show it again' : 'That’s nothing', marked.nothing === true, () => hide(place));
    return acts;
}

/** @param {number} place */
function itemOf(place) {
    const {events, time, marks} = state;
    const event = events[place];
    const kind = kindOf(event.kind);
    const marked = marks[keyOf(event)];
    const row = button('row', '', () => playEvent(place));
    row.dataset.event = String(place);
    row.tabIndex = -1;
    const words = element('span', 'words');
    const [lasts, ...facts] = factsOf(event, kind, answerOf(event));
    const head = element('b', '', time.fromTo(event.begin, event.end));
    head.prepend(ofEvent(element('span', 'number', String(numberOf(events, place))), place), ' ');
    const deed = element('span');
    deed.append(element('span', 'kind ' + kind.emphasis, deedOf(event)), element('span', 'lasts', ' · ' + lasts));
    words.append(head, deed);
    if (facts.length) words.append(element('small', '', facts.join(' · ')));
    if (marked?.note) words.append(element('small', 'noted', '✎ ' + marked.note));
    row.ariaLabel = spoken([`Event ${numberOf(events, place)}`, time.clockOf(event.begin, false), lasts, deedOf(event), ...facts, ...marked?.note ? [marked.note] : []].join(', '));
    row.append(portraitOf(event), words);
    row.addEventListener('pointerenter', () => set({lightened: place}));
    row.addEventListener('pointerleave', () => set({lightened: null}));
    const item = ofEvent(element('li', 'card'), place);
    if (marked?.nothing) item.classList.add('nothing');
    item.append(row, actsOf(place));
    const links = linksOf(event);
    if (links.length) {
        const more = element('span', 'more');
        more.append(...links);
        item.append(more);
    }
    return item;
}

const mostListed = 1000;  // a list that is longer is no use to a person, and slow

/** Searches everywhere, for everything. */
const clearSearch = () => set({kind: 'all', what: '', leastSeconds: 0, onlyStarred: false, asked: null, drawn: null});

function nothingFound() {
    const item = element('li', 'none', 'No matching events · ');
    item.append(button('', 'Clear', clearSearch));
    return item;
}

/**
 * What a list without events says.
 * @param {number} others events that --events doesn't choose
 */
export const noEvents = others => others === 0 ? 'No events.' : `No event that --events chooses; ${others} other${others === 1 ? '' : 's'} found.`;

export function drawList() {
    const {events, data} = state;
    const places = listedEvents();
    const count = events.length;
    const all = count ? count + (count === 1 ? ' event' : ' events') : 'Events';
    const hidden = state.showsHidden ? 0 : hiddenCount();
    at('tabevents').textContent = `${places.length} event${places.length === 1 ? '' : 's'}`;
    at('heading').textContent = (places.length === count ? all : `${places.length} of ${all}`) + (hidden ? `, ${hidden} hidden` : '');
    at('previous', HTMLButtonElement).disabled = at('next', HTMLButtonElement).disabled = at('playall', HTMLButtonElement).disabled = places.length === 0;
    const items = count ? places.slice(0, mostListed).map(itemOf) : [element('li', 'none', data.events
        ? noEvents(data.unchosen) : 'The filter of this picture marks no objects, so nobody looked for events.')];
    if (count && !places.length) items.push(nothingFound());
    if (places.length > mostListed) items.push(element('li', 'none', `${places.length - mostListed} more: ask for a kind, a length or a place.`));
    at('events').replaceChildren(...items);
    drawChosen();
    drawLitRow();
    if (asksForSome()) say(at('heading').textContent ?? '');
}

/** One row can be reached by Tab: the chosen one, else the first. From there arrows go on. */
export function drawChosen() {
    const chosen = rowOf(state.chosen);
    const reached = chosen ?? at('events').querySelector('.row');
    for (const row of at('events').querySelectorAll('.row')) {
        row.setAttribute('aria-current', String(row === chosen));
        row.closest('li')?.classList.toggle('current', row === chosen);
        for (const part of row.closest('li')?.querySelectorAll('button, a') ?? []) /** @type {HTMLElement} */ (part).tabIndex = row === reached ? 0 : -1;
    }
}

/** The row of the event that the pointer is on. */
export function drawLitRow() {
    for (const row of at('events').querySelectorAll('.lit')) row.classList.remove('lit');
    rowOf(state.lightened)?.closest('li')?.classList.add('lit');
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

export function drawFilters() {
    least.value = String(state.leastSeconds);
    starred.checked = state.onlyStarred;
    showHidden.checked = state.showsHidden;
}

export function listenToList() {
    classes.addEventListener('change', () => set({what: classes.value}));
    order.addEventListener('change', () => set({order: order.value}));
    least.addEventListener('change', () => set({leastSeconds: Number(least.value)}));
    starred.addEventListener('change', () => set({onlyStarred: starred.checked}));
    showHidden.addEventListener('change', () => set({showsHidden: showHidden.checked}));
    at('previous').addEventListener('click', () => step(-1));
    at('next').addEventListener('click', () => step(1));
    try {
        set({marks: readMarks(localStorage.getItem(clipKey(state.data)))});
    } catch {
        // Some browsers keep nothing for files.
    }
}
