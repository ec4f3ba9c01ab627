// The picture of a clip's card: a large still of what tells most. Under the pointer, or with the focus, there is one of each
// event, which plays: the place of the pointer, the arrow keys or a swipe say which.

import {element, sharesWithin} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {timeText} from '../shared/wall_clock.js';
import {pointOnWay} from '../shared/ways.js';
import {addressOfClip, addressWith} from '../page/address.js';
import {pageOf} from './clips.js';
import {bits} from './data.js';
import {eventsIn, loadEventsOf, stillsOf} from './events.js';
import {nearestStill, stillsBetween} from './sheet.js';
import {data, search, wallOf} from './state.js';
import {Tile, playOn} from './tiles.js';
import {markOf, pictureOfEvent, placeUnder, spanOf, turnOfKey, turnOfSwipe} from './turning.js';

/** @typedef {import('./clips.js').Clip} Clip */

const mostTicks = 40;

/** @param {import('./answers.js').SceneEvent} event */
const lengthOf = event => spanOf(event)[1] - spanOf(event)[0];

/**
 * @param {Clip} clip
 * @param {string} address the part after '#'
 */
const urlOf = (clip, address) => pageOf(clip) + (clip.files & bits.page ? address : '');

/**
 * The page of a clip as its card leads to it.
 * @param {Clip} clip
 */
export const urlOfCard = clip => urlOf(clip, addressOfClip(search()));

/** What a card shows of a clip, and in which of its events it is. */
class Gallery {
    /**
     * @param {Clip} clip
     * @param {HTMLAnchorElement} card
     */
    constructor(clip, card) {
        this.clip = clip;
        this.card = card;
        this.base = new Tile(clip, 0);
        /** @type {Tile | null} */
        this.tile = null;  // shows the events
        this.place = 0;  // of the event that is shown, in the list of events
        this.share = 0;  // of the card's width, where the pointer is
        this.ticks = element('span', 'ticks');
        this.note = element('small', 'of');
        this.isWanted = false;  // under the pointer, with the focus, or swiped
        for (let k = 0; k < Math.min(clip.events ?? 0, mostTicks); ++k) this.ticks.append(element('i'));
        this.window = element('span', 'images');
        this.window.append(this.base.window, this.ticks, this.note);
    }

    /** What was put down or taken keeps its place: a ring can show it whatever the moment of the large still is. */
    async markThing() {
        const {clip} = this;
        if (!data.kinds.some(({name, isThing}) => isThing && clip.tallyOf[name] > 0)) return;
        await loadEventsOf(clip);
        const [first] = [...this.events].sort((a, b) => a.kind.rank - b.kind.rank || b.still - a.still || lengthOf(b) - lengthOf(a));
        if (!first?.kind.isThing) return;
        const [from, to] = spanOf(first);
        const shown = stillsOf(clip)[nearestStill(stillsOf(clip), (from + to) / 2)];
        if (shown >= from && shown <= to) this.base.mark(null, pointOnWay(first.way, (from + to) * 5));
    }

    get events() { return eventsIn(this.clip); }

    async open() {
        this.isWanted = true;
        await loadEventsOf(this.clip);
        const count = stillsOf(this.clip).length;
        if (!this.isWanted || this.tile || !count || !this.events.length) return;
        this.place = placeUnder(this.share, this.events.length);  // the pointer went on while the events came
        this.tile = new Tile(this.clip, count);
        this.base.window.after(this.tile.window);
        this.show();
    }

    /**
     * Shows an event as it is at a moment, or in its middle.
     * @param {number} [still] the place of a picture on the clip's sheet
     */
    show(still) {
        const event = this.events[this.place];
        if (!this.tile || !event) return;
        const stills = stillsOf(this.clip);
        const {still: shown, at} = pictureOfEvent(event, stills, still);
        this.tile.show(shown);
        this.tile.mark(null, at === null ? null : pointOnWay(event.way, at * 10));
        const nth = this.events.length > 1 ? `${this.place + 1} of ${this.events.length} · ` : '';
        this.note.textContent = `${nth}${timeText(wallOf(this.clip.begins + stills[shown]))} · ${event.kind.words}`;
        const ticks = [...this.ticks.children];
        const mark = markOf(this.place, this.events.length, ticks.length);
        ticks.forEach((tick, k) => { tick.className = k === mark ? 'now' : ''; });
        this.card.href = urlOf(this.clip, addressWith(addressOfClip(search()), event.number));
    }

    /** @param {number} place of an event */
    turnTo(place) {
        const next = clamp(place, 0, this.events.length - 1);
        if (!this.tile || next === this.place) return;
        this.place = next;
        this.show();
        this.card.setAttribute('aria-description', this.note.textContent ?? '');
    }

    /** The moments of the event that is shown. */
    scenes() {
        const event = this.events[this.place];
        if (!this.tile || !event) return [];
        const [from, to] = spanOf(event);
        return stillsBetween(stillsOf(this.clip), from, to).map(still => ({show: () => this.show(still)}));
    }

    rest() {
        this.isWanted = false;
        this.tile?.window.remove();
        this.tile = null;
        this.place = this.share = 0;
        this.note.textContent = '';
        for (const tick of this.ticks.children) tick.className = '';
        this.card.href = urlOfCard(this.clip);
    }
}

/** @param {Gallery} gallery */
function listenTo(gallery) {
    const {card, window} = gallery;
    card.addEventListener('pointerenter', () => gallery.open());
    card.addEventListener('focus', () => gallery.open());
    card.addEventListener('pointermove', event => {
        if (event.pointerType === 'touch') return;
        [gallery.share] = sharesWithin(card, event);
        gallery.turnTo(placeUnder(gallery.share, gallery.events.length));
    });
    card.addEventListener('keydown', event => {
        const by = turnOfKey(event);
        if (!by) return;
        event.preventDefault();
        gallery.turnTo(gallery.place + by);
    });
    let from = 0;
    let wasSwipe = false;
    window.addEventListener('pointerdown', event => {
        from = event.clientX;
        wasSwipe = false;
    });
    window.addEventListener('pointerup', event => {
        const by = event.pointerType === 'touch' ? turnOfSwipe(event.clientX - from) : 0;
        wasSwipe = by !== 0;
        if (wasSwipe) gallery.open().then(() => gallery.turnTo(gallery.place + by));
    });
    card.addEventListener('dragstart', event => event.preventDefault());
    card.addEventListener('click', event => {
        if (wasSwipe) event.preventDefault();
        wasSwipe = false;
    });
    playOn(card, () => gallery.scenes(), () => gallery.rest());
}

/**
 * @param {Clip} clip
 * @param {HTMLAnchorElement} card
 */
export function pictureOf(clip, card) {
    const gallery = new Gallery(clip, card);
    listenTo(gallery);
    gallery.markThing();
    return gallery.window;
}
