// The events that are wanted: those that pass the filters and have to do with the place that is asked for.

import {spanOf} from '../shared/durations.js';
import {inThousandths, sidesOf} from '../shared/shapes.js';
import {derived} from '../shared/state.js';
import {crossingWords, meetingsOf, missingWords, stayOf, stayWords} from '../shared/ways.js';
import {isSet, sortedPlaces, wantedPlaces} from './events.js';
import {keyOf} from './marks.js';
import {kindOf, state} from './state.js';

/**
 * What an event has to do with the place that is asked for, in words; null = nothing.
 * @param {import('./data.js').PageEvent} event
 */
export function answerOf(event) {
    const {asked, data, time} = state;
    if (!asked) return '';
    const place = inThousandths(asked, 1);
    if (asked.kind === 'box') {
        const stay = stayOf(event.way, sidesOf(place));
        if (!stay) return null;
        return kindOf(event.kind).isOfScene ? missingWords(time.clockOf(event.begin, false)) : stayWords(stay, spanOf);
    }
    // What is not there crosses nothing.
    const meetings = kindOf(event.kind).isOfScene ? [] : meetingsOf(event.way, place.from, place.to);
    return meetings.length ? crossingWords(meetings, asked, data.size, seconds => time.clockOf(seconds, false)) : null;
}

/** @param {import('./data.js').PageEvent} event */
const isNothing = event => state.marks[keyOf(event)]?.nothing === true;

export const hiddenCount = () => state.events.filter(isNothing).length;

export const asksForSome = () => isSet(state) || state.asked !== null || state.onlyStarred || (!state.showsHidden && hiddenCount() > 0);

/** @param {import('./data.js').PageEvent} event */
const isMarkedRight = event => (state.showsHidden || !isNothing(event)) && (!state.onlyStarred || state.marks[keyOf(event)]?.star === true);

/** The places of the wanted events, in the order of time. */
export const wantedEvents = derived(() => [state.events, state.kind, state.what, state.leastSeconds, state.asked, state.marks, state.onlyStarred, state.showsHidden],
                                    () => wantedPlaces(state.events, state, answerOf).filter(place => isMarkedRight(state.events[place])));

/** The same, in the order of the list. */
export const listedEvents = derived(() => [wantedEvents(), state.order], () => sortedPlaces(state.events, wantedEvents(), state.order, kindOf));
