// Clips: a section for each day, in it one for each camera, filled when it comes near the window.

import {at, button, element} from '../shared/dom.js';
import {shortSpanOf} from '../shared/durations.js';
import {grouped, many} from '../shared/text.js';
import {timeText, weekday} from '../shared/wall_clock.js';
import {counted, failureOf, tallyWords} from './clips.js';
import {clear} from './filters.js';
import {pictureOf, urlOfCard} from './gallery.js';
import {lastFailed, sortedBy} from './query.js';
import {byCameraName, cameraName, choices, chosenClips, clips, data, isSeen, see, state, wallOf} from './state.js';

/** @typedef {import('./clips.js').Clip} Clip */

const cardHeight = 290;  // about, with the gap below

/** @param {Clip} clip */
function badgesOf(clip) {
    const badges = [];
    for (const kind of data.kinds) {
        const told = clip.tallyOf[kind.name];
        if (told > 0) badges.push(element('span', 'badge ' + kind.emphasis, tallyWords(kind, told)));
    }
    if (clip.events !== null) {
        badges.push(clip.events ? element('span', 'badge', many(clip.events, 'event')) : element('span', 'badge none', 'no events'));
    }
    for (const fault of clip.faults) badges.push(element('span', 'badge strong', fault));
    if (clip.reason && !clip.failed) badges.push(titled(element('span', 'badge strong', 'incomplete'), clip.reason));
    return badges;
}

/**
 * From when to when a picture of a day shows it: most days are not whole.
 * @param {Clip} clip
 */
export function stretchOf(clip) {
    const [from, to] = [clip.time, timeText(wallOf(clip.begins + clip.seconds))].map(time => time.slice(0, 5));
    const hours = !clip.drawn ? '' : from === to ? from : `${from} to ${to}`;
    if (!clip.night) return hours || 'the day';
    return `Night of ${clip.day}` + (hours && ', ' + hours);
}

/**
 * An element with a tooltip.
 * @template {HTMLElement} E
 * @param {E} made
 * @param {string} title
 */
const titled = (made, title) => Object.assign(made, {title});

/** @param {Clip} clip */
function factsOf(clip) {
    const first = element('span', 'first');
    first.append(element('b', '', clip.wholeDay ? stretchOf(clip) : clip.time));
    if (clip.drawn) first.append(element('small', '', shortSpanOf(clip.seconds)));
    if (clip.drawn && !isSeen(clip)) first.append(titled(element('i', 'new', '● new'), 'not seen yet'));
    const badges = element('span', 'badges');
    if (clip.drawn) badges.append(...badgesOf(clip));
    if (clip.failed && clip.drawn) {
        badges.append(titled(element('span', 'badge strong', 'failed; shows what was until ' + clip.until), `${failureOf(clip)}: ${clip.reason}`));
    }
    const second = element('span', 'second');
    second.append(titled(element('bdi', 'name', clip.name), clip.path));
    if (clip.placedBy) {
        second.append(titled(element('small', 'written', clip.wholeDay ? 'day of writing' : 'time of writing'),
                             `Nothing tells when it was recorded, so it stands at ${clip.placedBy}.`));
    }
    if (clip.gone) second.append(element('small', 'gone', 'the clip is gone'));
    const facts = element('span', 'facts');
    facts.append(first, badges, second);
    return facts;
}

/** @param {Clip} clip */
function cardOf(clip) {
    if (!clip.drawn) {
        const card = element('article', 'card failed');
        const reason = titled(element('p', 'reason'), clip.reason);
        reason.append(element('b', '', failureOf(clip)), clip.reason);
        card.append(reason, factsOf(clip));
        return card;
    }
    const card = element('a', 'card');
    card.href = urlOfCard(clip);
    card.dataset.url = clip.url;
    card.ariaLabel = `${cameraName(clip.camera)}, ${clip.day}, ${clip.wholeDay ? stretchOf(clip) : clip.time}: ` +
        [...clip.drawn && !isSeen(clip) ? ['not seen yet'] : [], ...badgesOf(clip).map(badge => badge.textContent), clip.name].join(', ');
    card.append(pictureOf(clip, card), factsOf(clip));
    card.addEventListener('click', () => see(clip));
    return card;
}

/**
 * The clips of sections that are not filled yet.
 * @type {Map<Element, Clip[]>}
 */
const empty = new Map();

const nearby = new IntersectionObserver(entries => {
    for (const {target, isIntersecting} of entries) if (isIntersecting) fill(target);
}, {rootMargin: '1200px'});

/** @param {Element} cards */
function fill(cards) {
    nearby.unobserve(cards);
    if (cards instanceof HTMLElement) cards.style.minHeight = '';
    cards.replaceChildren(...(empty.get(cards) ?? []).map(cardOf));
    empty.delete(cards);
}

/**
 * @param {string} title
 * @param {Clip[]} clipsOf
 * @param {number} columns
 */
function sectionOf(title, clipsOf, columns) {
    const block = element('section', 'camera');
    block.style.setProperty('--count', String(clipsOf.length));
    const cards = element('div', 'cards');
    empty.set(cards, clipsOf);
    cards.style.minHeight = Math.ceil(clipsOf.length / columns) * cardHeight + 'px';
    block.append(element('h3', '', title), cards);
    nearby.observe(cards);
    return block;
}

/**
 * @param {Clip[]} list
 * @param {number} columns
 */
const sectionsByDay = (list, columns) => [...grouped(list, 'day')].map(([day, ofDay]) => {
    const section = element('section', 'day');
    const cameras = [...grouped(ofDay, 'camera')].sort((a, b) => byCameraName(a[0], b[0]));
    section.append(element('h2', '', weekday(day) + ', ' + day), ...cameras.map(([camera, ofCamera]) =>
        sectionOf(`${cameraName(camera)} · ${many(counted(ofCamera).length, 'clip')}`, lastFailed(ofCamera), columns)));
    return section;
});

export function noteOfNone() {
    const note = element('p', 'empty', clips.length ? 'No matching clips · ' : 'No clips yet.');
    if (clips.length) note.append(button('', 'Clear', clear));
    return note;
}

export function drawClips() {
    if (state.view !== 'clips') return;
    const list = chosenClips();
    const days = at('days');
    nearby.disconnect();
    empty.clear();
    const columns = Math.max(1, Math.floor((days.clientWidth + 12) / 284));
    const title = at('order', HTMLSelectElement).selectedOptions[0]?.textContent ?? '';
    const byTime = state.order === 'oldest' ? [...list].reverse() : state.order === 'newest' ? list : null;
    const sections = !list.length ? [noteOfNone()] : byTime ? sectionsByDay(byTime, columns)
        : [sectionOf(title, sortedBy(list, state.order, choices), columns)];
    days.replaceChildren(...sections);
}

/**
 * Scrolls to a clip's card.
 * @param {Clip} clip
 */
export function showCard(clip) {
    for (const [cards, list] of [...empty]) if (list.includes(clip)) fill(cards);
    const card = [...document.querySelectorAll('a.card')].find(one => one instanceof HTMLElement && one.dataset.url === clip.url);
    if (!(card instanceof HTMLElement)) return;
    card.scrollIntoView({block: 'center'});
    card.focus({preventScroll: true});
}

/** What is printed is there as a whole. */
export function fillAll() {
    for (const cards of [...empty.keys()]) fill(cards);
}
