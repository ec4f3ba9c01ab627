// Clips: a section for each day with all cameras, filled when it comes near the window.

import {at, button, element} from '../shared/dom.js';
import {shortSpanOf} from '../shared/durations.js';
import {grouped, many} from '../shared/text.js';
import {timeText, weekday} from '../shared/wall_clock.js';
import {counted, failureOf, tallyWords} from './clips.js';
import {clear, dayWords} from './filters.js';
import {pictureOf, urlOfCard} from './gallery.js';
import {lastFailed, sortedBy} from './query.js';
import {cameraName, choices, chosenClips, clips, data, isSeen, see, state, wallOf} from './state.js';
import {shaped} from './tiles.js';

/** @typedef {import('./clips.js').Clip} Clip */

const cardHeight = 230;  // about, with the gap below
const cardWidth = 232;  // about, with the gap beside
const mostColumns = 12;

/**
 * What a card says on its picture: how much of what, and what is wrong with the recording.
 * @param {Clip} clip
 */
function badgesOf(clip) {
    const badges = data.kinds.filter(({name}) => clip.tallyOf[name] > 0)
        .map(kind => element('span', 'badge ' + kind.emphasis, tallyWords(kind, clip.tallyOf[kind.name])));
    for (const fault of clip.faults) badges.push(element('span', 'badge strong', fault));
    if (clip.reason && !clip.failed) badges.push(titled(element('span', 'badge strong', 'incomplete'), clip.reason));
    return badges;
}

/** @param {Clip} clip */
const eventsOf = ({events}) => events === null ? '' : events ? many(events, 'event') : 'no events';

/**
 * From when to when a picture of a day shows it: most days are not whole.
 * @param {Clip} clip
 */
export function stretchOf(clip) {
    const [from, to] = [clip.time, timeText(wallOf(clip.begins + clip.seconds))].map(time => time.slice(0, 5));
    const hours = !clip.drawn ? '' : from === to ? from : `${from}–${to}`;
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

/** Whether days are headings, which cards need not repeat. */
const isByDay = () => ['newest', 'oldest'].includes(state.order);

/** @param {Clip} clip */
function factsOf(clip) {
    const first = element('span', 'first');
    const when = clip.wholeDay ? stretchOf(clip) : clip.clock;
    first.append(element('b', '', isByDay() ? when : `${dayWords(clip.day)}, ${when}`));
    if (data.cameras.length > 1) first.append(element('bdi', '', cameraName(clip.camera)));
    if (clip.drawn && clip.events !== null) first.append(element('span', 'count', eventsOf(clip)));
    const facts = titled(element('span', 'facts'), clip.wholeDay ? `${clip.path}: ${clip.name}` : clip.path);
    facts.append(first);
    if (clip.failed && clip.drawn) {
        facts.append(titled(element('small', 'bad', 'failed; shows what was until ' + clip.until), `${failureOf(clip)}: ${clip.reason}`));
    }
    if (clip.placedBy) {
        facts.append(titled(element('small', 'written', clip.wholeDay ? 'day of writing' : 'time of writing'),
                            `Nothing tells when it was recorded, so it stands at ${clip.placedBy}.`));
    }
    if (clip.gone) facts.append(element('small', 'gone', 'the clip is gone'));
    return facts;
}

/** @param {Clip} clip */
function cardOf(clip) {
    if (!clip.drawn) {
        const card = shaped(element('article', 'card failed'), clip.camera);
        const reason = titled(element('p', 'reason'), clip.reason);
        reason.append(element('b', '', failureOf(clip)), clip.reason);
        card.append(reason, factsOf(clip));
        return card;
    }
    const card = shaped(element('a', isSeen(clip) ? 'card seen' : 'card'), clip.camera);
    card.href = urlOfCard(clip);
    card.dataset.url = clip.url;
    const badges = badgesOf(clip);
    card.ariaLabel = `${cameraName(clip.camera)}, ${clip.day}, ${clip.wholeDay ? stretchOf(clip) : clip.time}: ` +
        [...isSeen(clip) ? ['seen'] : [], ...badges.map(badge => badge.textContent), eventsOf(clip), clip.name].filter(Boolean).join(', ');
    const picture = pictureOf(clip, card);
    const told = element('span', 'told');
    told.append(...badges);
    picture.append(told, element('small', 'length', shortSpanOf(clip.seconds)));
    card.append(picture, factsOf(clip));
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
    const list = empty.get(cards) ?? [];
    // Cards of a row are equally high, and as wide as their shapes want. What fills the last row is not to be seen.
    const fillers = Array.from({length: mostColumns}, () => shaped(element('i'), list[list.length - 1]?.camera ?? 0));
    cards.replaceChildren(...list.map(cardOf), ...fillers);
    empty.delete(cards);
}

/**
 * @param {string} title
 * @param {Clip[]} list
 * @param {number} columns
 */
function sectionOf(title, list, columns) {
    const section = element('section', 'day');
    const heading = element('h2', '', title + ' ');
    heading.append(element('small', '', many(counted(list).length, 'clip')));
    const cards = element('div', 'cards');
    empty.set(cards, list);
    cards.style.minHeight = Math.ceil(list.length / columns) * cardHeight + 'px';
    section.append(heading, cards);
    nearby.observe(cards);
    return section;
}

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
    const columns = Math.max(1, Math.floor(days.clientWidth / cardWidth));
    const sections = !list.length ? [noteOfNone()]
        : isByDay() ? [...grouped(state.order === 'oldest' ? [...list].reverse() : list, 'day')].map(([day, ofDay]) =>
            sectionOf(`${weekday(day)}, ${day}`, lastFailed(ofDay), columns))
        : [sectionOf(at('order', HTMLSelectElement).selectedOptions[0]?.textContent ?? '', sortedBy(list, state.order, choices), columns)];
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
