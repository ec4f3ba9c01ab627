// The events that are wanted: those that pass the filters and have to do with the place that is asked for.

import {spanOf} from '../shared/durations.js';
import {scaled, sidesOf} from '../shared/shapes.js';
import {derived} from '../shared/state.js';
import {crossingWords, crossingsOf, stayOf} from '../shared/ways.js';
import {isSet, wantedPlaces} from './events.js';
import {state} from './state.js';

/**
 * What an event has to do with the place that is asked for, in words; null = nothing.
 * @param {import('./data.js').PageEvent} event
 */
export function answerOf(event) {
    const {asked, data, time} = state;
    if (!asked) return '';
    const place = scaled(asked, 1000);
    if (asked.kind === 'box') {
        const stay = stayOf(event.way, sidesOf(place));
        return stay && `here ${spanOf(stay.lasts / 10)}`;
    }
    const crossings = crossingsOf(event.way, place.from, place.to);
    return crossings.length ? crossingWords(crossings, asked, data.size, seconds => time.clockOf(seconds, false)) : null;
}

export const asksForSome = () => isSet(state) || state.asked !== null;

/** The places of the wanted events, in the order of time. */
export const wantedEvents = derived(() => [state.events, state.kind, state.what, state.leastSeconds, state.asked],
                                    () => wantedPlaces(state.events, state, state.time, answerOf));
