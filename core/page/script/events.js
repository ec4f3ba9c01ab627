
// ---- Events: which are wanted, in which order, and which is chosen

let events = data.events ?? [];
let chosen = null;      // place in data.events
let lightened = null;   // the one that the pointer is on
let wanted = null;      // the places of those that are wanted; made when it is asked for
let kind = 'all';
let what = '';          // a class or a group of classes, as the detector says; '' = all, '?' = unknown
let leastSeconds = 0;
let order = 'time';

/// The number that the picture shows of an event. In a stream it stays the same while the list moves on.
const numberOf = place => events[place].number ?? place + 1;
const placeOfNumber = number => events.findIndex((_, place) => numberOf(place) === number);

const secondsFor = event => secondsOf(event.last) - secondsOf(event.first);
const orders = {
    time: (a, b) => a - b,
    newest: (a, b) => events[b].first - events[a].first,
    longest: (a, b) => secondsFor(events[b]) - secondsFor(events[a]),
    kind: (a, b) => kindOf(events[a].kind).rank - kindOf(events[b].kind).rank || events[b].still - events[a].still,
};

const isOf = (event, name) => name === '' || (name === '?' ? !event.class : event.class === name || event.group === name);
const asksForSome = () => kind !== 'all' || what !== '' || leastSeconds > 0 || asked !== null;

/// The places in the list of the events that are wanted, in the order of time.
function wantedEvents() {
    wanted ??= [...events.keys()].filter(number => {
        const event = events[number];
        return (kind === 'all' || event.kind === kind) && isOf(event, what) && secondsFor(event) >= leastSeconds && answerOf(event) !== null;
    });
    return wanted;
}

function filterEvents() {
    wanted = null;
    listEvents();
    drawStrip();
    drawVeil();
}

/// Shows which event the pointer is on, without choosing it.
function light(number) {
    if (number === lightened) return;
    rowOf(lightened)?.classList.remove('lit');
    lightened = number;
    rowOf(lightened)?.classList.add('lit');
    drawVeil();
}

const rowOf = number => number === null ? null : at('events').querySelector(`button[data-event="${number}"]`);

/// What an event did, in words.
function textOf(event) {
    const parts = [event.kind, spanOf(secondsFor(event))];
    if (event.class) parts.push(`${event.class} (${Math.round(event.score * 100)} %)`);
    const {words, tally} = kindOf(event.kind);
    if (tally === 'still') parts.push(words + ' ' + durationOf(event.still));
    const answer = answerOf(event);
    if (answer) parts.push(answer);
    return parts.join(' · ');
}

/// "came out of 5", each number a link to its event.
function relationsOf(event) {
    return [[event.from, 'came out of'], [event.into, 'went into'], [event.by, kindOf(event.kind).by]]
        .filter(([number]) => number !== null && number !== undefined)
        .map(([number, words]) => {
            const link = element('a', 'relation', `${words} ${numberOf(number)}`);
            link.href = '#event=' + numberOf(number);
            return link;
        });
}

/// A part of a picture in which the event's object is to be seen.
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

function itemOf(number) {
    const event = events[number];
    const button = element('button');
    button.type = 'button';
    button.dataset.event = number;
    button.setAttribute('aria-current', number === chosen);
    if (event.colour) button.style.borderLeftColor = event.colour;
    const words = element('span', 'words');
    const {emphasis, words: kindWords} = kindOf(event.kind);
    const badge = element('span', 'kind ' + emphasis, kindWords);
    const more = textOf(event).split(' · ').slice(1).join(' · ');
    words.append(element('b', '', `${numberOf(number)}.  ${clockOf(secondsOf(event.first))} – ${clockOf(secondsOf(event.last))}`),
                 badge, element('small', '', more));
    button.append(portraitOf(event), words);
    button.addEventListener('click', () => playEvent(number));
    button.addEventListener('pointerenter', () => light(number));
    button.addEventListener('pointerleave', () => light(null));
    const item = element('li');
    item.append(button, ...relationsOf(event));
    return item;
}

/// A chip for each kind that there is.
function drawChips() {
    const counts = new Map();
    for (const event of events) counts.set(event.kind, (counts.get(event.kind) ?? 0) + 1);
    const kinds = [...counts.keys()].sort((a, b) => kindOf(a).rank - kindOf(b).rank);
    at('kinds').replaceChildren(...['all', ...kinds].map(name => {
        const chip = element('button', 'chip', name === 'all' ? `all ${events.length}` : `${kindOf(name).words} ${counts.get(name)}`);
        chip.type = 'button';
        chip.setAttribute('aria-pressed', name === kind);
        chip.addEventListener('click', () => {
            kind = name;
            drawChips();
            filterEvents();
        });
        return chip;
    }));
    at('filters').hidden = events.length < 2;
    at('kinds').hidden = kinds.length < 2;
    drawClasses();
}

/// A choice of each group, and of each class in it, if the detector knows some of the objects.
function drawClasses() {
    const counts = new Map();
    const count = name => counts.set(name, (counts.get(name) ?? 0) + 1);
    for (const event of events) {
        if (!event.class) count('?');
        else new Set([event.group, event.class]).forEach(count);
    }
    const groups = [...new Set(events.filter(event => event.class).map(event => event.group))].sort((a, b) => counts.get(b) - counts.get(a));
    const inGroup = group => [...new Set(events.filter(event => event.group === group).map(event => event.class))].sort().filter(name => name !== group);
    const names = [...groups.flatMap(group => [group, ...inGroup(group)]), ...counts.has('?') ? ['?'] : []];
    if (what !== '' && !names.includes(what)) what = '';
    const choice = (name, words) => Object.assign(element('option', '', words), {value: name, selected: name === what});
    at('class').replaceChildren(choice('', 'everything'), ...names.map(name =>
        choice(name, `${groups.includes(name) || name === '?' ? '' : '\u2013 '}${name === '?' ? 'unknown' : name} ${counts.get(name)}`)));
    at('class').hidden = groups.length === 0;
}
at('class').addEventListener('change', () => { what = at('class').value; filterEvents(); });
at('order').addEventListener('change', () => { order = at('order').value; listEvents(); });
at('least').addEventListener('change', () => { leastSeconds = Number(at('least').value); filterEvents(); });

const mostListed = 1000;  // a list that is longer is no use to a person, and slow

function listEvents() {
    const list = at('events');
    const numbers = [...wantedEvents()].sort(orders[order]);
    const count = events.length;
    const all = count ? count + (count === 1 ? ' event' : ' events') : 'Events';
    at('heading').textContent = numbers.length === count ? all : `${numbers.length} of ${all}`;
    at('previous').disabled = at('next').disabled = numbers.length === 0;
    if (!count) {
        list.replaceChildren(element('li', 'none', data.events ? 'Nothing moved long enough to be an event.'
            : 'The filter of this picture marks no objects, so nobody looked for events.'));
        return;
    }
    const items = numbers.slice(0, mostListed).map(itemOf);
    if (!numbers.length) items.push(element('li', 'none', 'No event is like that.'));
    if (numbers.length > mostListed) items.push(element('li', 'none', `${numbers.length - mostListed} more: ask for a kind, a length or a place.`));
    list.replaceChildren(...items);
}

/// Lights up one event, or all of them for null.
function choose(number) {
    chosen = number;
    until = null;
    for (const button of at('events').querySelectorAll('button')) {
        const mine = Number(button.dataset.event) === number;
        button.setAttribute('aria-current', mine);
        if (mine) button.scrollIntoView({block: 'nearest'});
    }
    for (const bar of at('bars').children) bar.classList.toggle('chosen', bar.dataset.event !== undefined && Number(bar.dataset.event) === number);
    at('copycut').disabled = number === null || filesOf(events[number]) === null;
    drawVeil();
    drawRing();
    keepInAddress();
}

/// Goes to the next event that is wanted, or the one before, and shows its first moment.
function step(by) {
    const numbers = wantedEvents();
    if (!numbers.length) return;
    const here = numbers.indexOf(chosen);
    const place = here >= 0 ? clamp(here + by, 0, numbers.length - 1)
        : by > 0 ? Math.max(0, numbers.findIndex(number => events[number].first >= now))
        : Math.max(0, numbers.findLastIndex(number => events[number].first < now));
    const number = numbers[place];
    choose(number);
    const event = events[number];
    show(event.first, false);
    until = event.last;
    if (document.activeElement?.closest('#events')) rowOf(number)?.focus();
    say(`Event ${numberOf(number)} of ${events.length}, from ${clockOf(secondsOf(event.first))} to ${clockOf(secondsOf(event.last))}, ${textOf(event)}`);
}
at('previous').addEventListener('click', () => step(-1));
at('next').addEventListener('click', () => step(1));
