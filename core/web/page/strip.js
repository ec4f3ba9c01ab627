// The strip of time: a bar for each event; where there are too many, how many there are at each moment.

import {at, element, sharesWithin} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {ticksOf, within, zoomed} from '../shared/time_axis.js';
import {choose} from './choice.js';
import {densityOf, numberOf, rowsOf} from './events.js';
import {wantedEvents} from './filters.js';
import {ofEvent} from './looks.js';
import {stripAction} from './key_table.js';
import {goBy, goTo, show} from './player.js';
import {point} from './pointing.js';
import {kindOf, set, state} from './state.js';
import {inSentence} from './timeline.js';
import {wheelZooms} from './zoom.js';

export const strip = at('strip');

/** @param {number} seconds */
const shareOnStrip = seconds => (seconds - state.stripFrom) / state.stripLasts;

/** @param {number} frame */
const shareOfFrame = frame => clamp(shareOnStrip(state.time.secondsOf(frame)), 0, 1);

/** @param {{clientX: number, clientY: number}} event */
const secondsOnStrip = event => state.stripFrom + clamp(sharesWithin(strip, event)[0], 0, 1) * state.stripLasts;

/** @param {{from: number, lasts: number}} part */
const showPart = ({from, lasts}) => set({stripFrom: from, stripLasts: lasts});
const whole = () => ({from: state.time.begins, lasts: state.time.lasts});
const shown = () => ({from: state.stripFrom, lasts: state.stripLasts});

/**
 * @param {number} factor
 * @param {number} share of the strip that stays in place
 */
export const zoomStrip = (factor, share) => showPart(zoomed(shown(), whole(), factor, share));

/** @param {number} factor */
const zoomAtNow = factor => zoomStrip(factor, clamp(shareOnStrip(state.time.secondsOf(state.now)), 0, 1));

/** @param {EventTarget | null} target */
const eventOf = target => target instanceof HTMLElement && target.dataset.event !== undefined ? Number(target.dataset.event) : null;

/**
 * The pointer is captured while it is down, so a click is always the strip's own: which bar is there?
 * @param {MouseEvent} event
 */
const barAt = event => eventOf(document.elementsFromPoint(event.clientX, event.clientY).find(found => eventOf(found) !== null && strip.contains(found)) ?? null);

/** Zoomed in, the strip follows what is chosen and what plays, and says which part of the time it shows. */
export function followNow() {
    const {time, now, stripFrom, stripLasts, chosen, moved, events} = state;
    if (!moved || stripLasts >= time.lasts * 0.999) return;
    const seconds = time.secondsOf(chosen !== null && now === events[chosen].first ? events[chosen].first : now);
    if (seconds >= stripFrom && seconds <= stripFrom + stripLasts) return;
    showPart(within({from: seconds - stripLasts * 0.2, lasts: stripLasts}, whole()));
}

export function drawPart() {
    const {time, stripFrom, stripLasts} = state;
    const isWhole = stripLasts >= time.lasts * 0.999;
    at('stripwhole').hidden = at('part').hidden = isWhole;
    at('part').style.left = (stripFrom - time.begins) / time.lasts * 100 + '%';
    at('part').style.width = stripLasts / time.lasts * 100 + '%';
}

export function drawCursor() {
    const {time, now} = state;
    const share = shareOnStrip(time.secondsOf(now));
    at('cursor').hidden = share < 0 || share > 1;
    at('cursor').style.left = share * 100 + '%';
    strip.ariaValueNow = (time.secondsOf(now) - time.begins).toFixed(1);
    strip.ariaValueText = time.bothClocks(time.secondsOf(now));
}

export function drawTicks() {
    const {time, stripFrom, stripLasts, stripWidth} = state;
    const most = Math.max(2, stripWidth / 90);
    at('ticks').replaceChildren(...ticksOf(stripFrom, stripLasts, most, time.clock?.begin ?? 0).map(seconds => {
        const label = element('span', '', time.clockOf(seconds, false));
        const share = shareOnStrip(seconds);
        const half = time.clockOf(seconds, false).length * 3.5 / Math.max(1, stripWidth);  // of its width, about
        label.style.left = share * 100 + '%';
        label.className = share < half ? 'atedge' : share > 1 - half ? 'atend' : '';
        return label;
    }));
}

/** Time without frames is hatched, as in the picture, and says why where there is room. */
export function drawGaps() {
    const {reasons} = state.time;
    at('gaps').replaceChildren(...state.time.gapSpans().flatMap((span, k) => {
        const [from, to] = span.map(seconds => clamp(shareOnStrip(seconds), 0, 1));
        if (to <= from) return [];
        const gap = element('i', '', (to - from) * state.stripWidth > 7 * reasons[k].length ? reasons[k] : '');
        gap.style.left = from * 100 + '%';
        gap.style.width = (to - from) * 100 + '%';
        return [gap];
    }));
}

const mostRows = 10;
const rowHeight = 12;  // pixels
const mostBars = 400;

export function drawBars() {
    const {time, events, stripFrom, stripLasts} = state;
    const inside = wantedEvents().filter(place => time.secondsOf(events[place].last) >= stripFrom &&
                                                  time.secondsOf(events[place].first) <= stripFrom + stripLasts);
    inside.sort((a, b) => events[a].first - events[b].first || a - b);
    // Between two bars of a row there is space for a number.
    const space = state.stripLasts * 26 / Math.max(200, state.stripWidth);
    const rowsWith = (/** @type {number} */ after) => rowsOf(inside.map(place => ({
        first: time.secondsOf(events[place].first), last: time.secondsOf(events[place].last) + after})), mostRows);
    const numbered = inside.length <= mostBars ? rowsWith(space) : null;
    const rows = numbered ?? (inside.length <= mostBars ? rowsWith(0) : null);
    strip.style.setProperty('--strip', 26 + rowHeight * Math.max(3, rows?.count ?? mostRows / 2) + 'px');
    at('bars').replaceChildren(...rows ? barsOf(inside, rows, numbered !== null) : columnsOf(inside));
    markChosen();
}

/**
 * @param {number[]} places
 * @param {{rows: number[], count: number}} rows
 * @param {boolean} isNumbered
 */
function barsOf(places, {rows, count}, isNumbered) {
    const share = 100 / Math.max(count, 3);
    const placed = (/** @type {HTMLElement} */ bar, /** @type {number} */ first, /** @type {number} */ last, /** @type {number} */ row) => {
        const [left, right] = [shareOfFrame(first), shareOfFrame(last)];
        bar.style.left = left * 100 + '%';
        bar.style.width = (right - left) * 100 + '%';
        bar.style.top = row * share + '%';
        bar.style.height = share * 0.86 + '%';
        return bar;
    };
    return places.flatMap((place, k) => {
        const event = state.events[place];
        const number = element('b', '', String(numberOf(state.events, place)));
        number.dataset.number = String(place);
        const left = shareOfFrame(event.first);
        number.className = left * state.stripWidth > 20 ? 'before' : 'inside';
        number.style.left = left * 100 + '%';
        number.style.top = (rows[k] + 0.43) * share + '%';
        const bar = ofEvent(placed(element('i'), event.first, event.last, rows[k]), place);
        const isThere = ([from, to] = [0, 0]) => shareOfFrame(to) > 0 && shareOfFrame(from) < 1;
        const stays = (event.stays ?? []).filter(stay => isThere(/** @type {[number, number]} */ (stay)))
            .map(([from, to]) => ofEvent(placed(element('i', 'stay ' + event.kind), from, to, rows[k]), place));
        return isNumbered ? [bar, ...stays, number] : [bar, ...stays];
    });
}

/**
 * How many events there are at each moment, and a mark for each thing that was put down or taken.
 * @param {number[]} places
 */
function columnsOf(places) {
    const {events} = state;
    const cells = 240;
    const counts = densityOf(places.map(place => [shareOfFrame(events[place].first), shareOfFrame(events[place].last)]), cells);
    const most = Math.max(1, ...counts);
    const columns = counts.map((count, cell) => {
        const column = element('i', 'density');
        column.style.left = cell / cells * 100 + '%';
        column.style.width = 100 / cells + '%';
        column.style.height = count / most * 100 + '%';
        return column;
    });
    const marks = places.filter(place => kindOf(events[place].kind).isThing).slice(0, 200).map(place => {
        const mark = element('i', 'mark');
        mark.style.left = shareOfFrame(events[place].first) * 100 + '%';
        mark.dataset.event = String(place);
        return mark;
    });
    return [...columns, ...marks];
}

export function markChosen() {
    for (const bar of at('bars').children) {
        bar.classList.toggle('chosen', state.chosen !== null && eventOf(bar) === state.chosen && !bar.classList.contains('stay'));
        bar.classList.toggle('ofchosen', bar.getAttribute('data-number') === String(state.chosen));
        bar.classList.toggle('pale', state.chosen !== null && eventOf(bar) !== null && eventOf(bar) !== state.chosen);
    }
}

export function drawRange() {
    strip.ariaValueMin = '0';
    strip.ariaValueMax = state.time.lasts.toFixed(1);
}

/** @type {Record<string, (value: number) => void>} */
const actions = {goBy, zoomStrip: zoomAtNow, goToFirst: () => goTo(state.time.firstFrame), goToLast: () => goTo(state.time.lastFrame)};

/** The piece of time that is chosen for the volume. */
export function drawBrush() {
    const {brush, piece, turnable} = state;
    const chosen = brush ?? piece;
    at('rail').hidden = !turnable;
    at('brush').hidden = !chosen;
    if (!chosen) return;
    const [from, to] = chosen.map(seconds => clamp(shareOnStrip(seconds), 0, 1));
    at('brush').style.left = from * 100 + '%';
    at('brush').style.width = (to - from) * 100 + '%';
}

/**
 * Chooses a piece of time; the volume that is cut or bent already follows.
 * @param {number} from seconds
 * @param {number} to
 */
function brushOver(from, to) {
    /** @type {[number, number]} */
    const brush = from < to ? [from, to] : [to, from];
    set(state.piece ? {brush, piece: brush} : {brush});
}

/** @returns {boolean} whether there was anything to end */
export function endBrush() {
    const had = state.brush !== null || state.piece !== null;
    if (had) set({brush: null, piece: null, bends: false});
    return had;
}

/**
 * Where the pointer went down, and whether it was dragged from there; from: seconds, where it chooses a piece.
 * @type {{x: number, far: boolean, down: boolean, from: number | null} | null}
 */
let rubbing = null;

export function listenToStrip() {
    strip.addEventListener('pointerdown', event => {
        if (event.button !== 0) return;
        const brushes = state.turnable && (event.shiftKey || event.target === at('rail'));
        rubbing = {x: event.clientX, far: false, down: true, from: brushes ? secondsOnStrip(event) : null};
        strip.setPointerCapture(event.pointerId);
    });
    strip.addEventListener('pointermove', event => {
        const drags = Boolean(rubbing?.down && (rubbing.far ||= Math.abs(event.clientX - rubbing.x) > 4));
        const seconds = secondsOnStrip(event);
        const frame = state.time.frameAt(seconds);
        const reason = state.time.reasonAt(seconds);
        if (drags && rubbing && rubbing.from !== null) brushOver(rubbing.from, seconds);
        else if (drags) goTo(frame);
        point(frame, event.clientX, strip.getBoundingClientRect().top - 100, drags ? null : eventOf(event.target),
              reason ? `${inSentence(reason)} after ` : '');
    });
    const up = () => { if (rubbing) rubbing.down = false; };
    strip.addEventListener('pointerup', up);
    strip.addEventListener('pointercancel', up);
    strip.addEventListener('pointerleave', () => point(null));
    strip.addEventListener('click', event => {
        if (rubbing?.far) return;  // it was a drag
        if (rubbing && rubbing.from !== null) {
            endBrush();
            return;
        }
        const place = barAt(event);
        choose(place);  // nothing is there: all again
        show(state.time.frameAt(secondsOnStrip(event)), true, {until: place === null ? null : state.events[place].last});
    });
    strip.addEventListener('wheel', event => {
        if (!wheelZooms(event)) return;
        event.preventDefault();
        if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
            const from = state.stripFrom + (event.deltaX || event.deltaY) / 600 * state.stripLasts;
            showPart(within({from, lasts: state.stripLasts}, whole()));
        } else {
            zoomStrip(Math.exp(event.deltaY * 0.0016), clamp(sharesWithin(strip, event)[0], 0, 1));
        }
    }, {passive: false});
    for (const [target, name] of /** @type {[HTMLElement, string][]} */ ([[strip, 'dblclick'], [at('stripwhole'), 'click']])) {
        target.addEventListener(name, () => showPart(whole()));
    }
    strip.addEventListener('keydown', event => {
        const action = stripAction(event);
        if (!action) return;
        actions[action[0]](action[1]);
        event.preventDefault();
        event.stopPropagation();
    });
    new ResizeObserver(() => set({stripWidth: strip.clientWidth})).observe(strip);
}
