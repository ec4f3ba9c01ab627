
// ---- Scene: what was where over all days of a camera. Events are loaded by day, from files beside the index

const eventsOfDay = new Map();  // day: [{clip, kind, what, number, still, path, bounds}]; a path is [tenths of a second, x, y, ...]
const waiting = new Map();      // day: what goes on when it is there

/// The box about a path: most paths are nowhere near the place that is asked for.
function boundsOf(path) {
    const bounds = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k + 2 < path.length; k += 3) {
        bounds[0] = Math.min(bounds[0], path[k + 1]);
        bounds[1] = Math.min(bounds[1], path[k + 2]);
        bounds[2] = Math.max(bounds[2], path[k + 1]);
        bounds[3] = Math.max(bounds[3], path[k + 2]);
    }
    return bounds;
}
const meets = (a, b) => a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];

/// Called by the files of days.
function vvrDay(day, list) {
    const found = [];
    for (const [url, events] of list) {
        const clip = clipOfUrl.get(url);
        if (!clip) continue;
        for (const [kind, number, still, ...path] of events) {
            const what = typeof path.at(-1) === 'string' ? path.pop() : '';
            found.push({clip, kind: kindOf(kind), what, number, still: still / 10, path, bounds: boundsOf(path)});
        }
    }
    eventsOfDay.set(day, found);
}

function loadDay(day) {
    if (eventsOfDay.has(day)) return Promise.resolve();
    if (!waiting.has(day)) {
        waiting.set(day, new Promise(done => {
            const script = element('script');
            script.src = `index.${day}.js`;
            script.onload = done;
            script.onerror = () => { eventsOfDay.set(day, []); done(); };
            document.head.append(script);
        }));
    }
    return waiting.get(day);
}

let place = null;   // what was drawn: {kind: 'box' or 'line', from: [x, y], to: [x, y]} in thousandths of the scene
let drawKind = 'box';
let drawn = null;
const grid = [48, 36];

/// The days between the two that are chosen, of those that have events.
function chosenDays() {
    return data.days.filter(day => (!at('from').value || day >= at('from').value) && (!at('to').value || day <= at('to').value));
}

/// The clock on the wall at a second of an event's clip.
const clockIn = event => seconds => timeOf(wallOf(event.clip.begins + seconds));

/// What an event has to do with the place that is asked for: when, how long, and a function that says it; null = nothing.
function answerOf(event) {
    if (!place) return {at: event.path[0] / 10, seconds: (event.path.at(-3) - event.path[0]) / 10, words: () => ''};
    const box = sidesOf(place);
    if (!meets(event.bounds, box)) return null;
    if (place.kind === 'box') {
        const stay = stayOf(event.path, box);
        return stay && {at: stay.at / 10, seconds: stay.lasts / 10, words: () => 'here ' + lengthOf(stay.lasts / 10)};
    }
    const crossings = crossingsOf(event.path, place.from, place.to);
    if (!crossings.length) return null;
    const line = place;
    const size = [at('ground').naturalWidth || 4, at('ground').naturalHeight || 3];
    return {at: crossings[0].at / 10, seconds: 0, words: () => crossingWords(crossings, line, size, clockIn(event))};
}

let asking = 0;  // counts questions: an answer to an older one is not shown

async function showScene(list) {
    const mine = ++asking;
    const camera = asked.camera ?? list[0]?.camera ?? 0;
    const wanted = new Set(list.filter(clip => clip.camera === camera));
    const ground = clips.find(clip => clip.camera === camera && clip.files & hasStill) ?? clips.find(clip => clip.camera === camera);
    at('ground').src = ground ? ground.url + (ground.files & hasStill ? '.still.jpg' : '.png') : '';
    at('scenehint').textContent = `${ground ? cameraName(camera) : 'No clips'}: draw on the scene to ask what was there. Warm colours show where most went on.`;
    at('foundheading').textContent = 'Loading…';
    const days = chosenDays().toReversed();
    await Promise.all(days.map(loadDay));
    if (mine !== asking) return;
    const events = days.flatMap(day => eventsOfDay.get(day) ?? []).filter(event => wanted.has(event.clip) && isOf(asked.class, [event.what]));
    answer(events);
}

function answer(events) {
    const began = performance.now();
    const found = [];
    for (const event of events) {
        const how = answerOf(event);
        if (how) found.push({event, how});
    }
    answer.took = performance.now() - began;
    drawHeat(found.map(({event}) => event));
    drawHours(found);
    listFound(found, events.length);
    answer.found = found;
}

/// Where the objects were, and for how long: seconds in each cell, on a scale that shows the seldom too.
function drawHeat(events) {
    const [columns, rows] = grid;
    const cells = new Float32Array(columns * rows);
    for (const {path} of events) {
        for (let k = 0; k + 2 < path.length; k += 3) {
            const next = Math.min(k + 3, path.length - 3);
            const steps = 1 + Math.floor(Math.max(Math.abs(path[next + 1] - path[k + 1]) * columns, Math.abs(path[next + 2] - path[k + 2]) * rows) / 1000);
            for (let step = 0; step < steps; ++step) {
                const share = (step + 0.5) / steps;
                const x = clamp(Math.floor((path[k + 1] + share * (path[next + 1] - path[k + 1])) / 1000 * columns), 0, columns - 1);
                const y = clamp(Math.floor((path[k + 2] + share * (path[next + 2] - path[k + 2])) / 1000 * rows), 0, rows - 1);
                cells[y * columns + x] += Math.max(1, path[next] - path[k]) / steps;
            }
        }
    }
    const heat = at('heat');
    [heat.width, heat.height] = grid;
    const context = heat.getContext('2d');
    const image = context.createImageData(columns, rows);
    const most = Math.log1p(Math.max(...cells));
    cells.forEach((seconds, k) => {
        const share = most > 0 ? Math.log1p(seconds) / most : 0;
        image.data.set([255, Math.round(210 * (1 - share)), 0, seconds > 0 ? Math.round(40 + 160 * share) : 0], 4 * k);
    });
    context.putImageData(image, 0, 0);
}

function drawHours(found) {
    const counts = new Array(24).fill(0);
    for (const {event, how} of found) ++counts[wallOf(event.clip.begins + how.at).getUTCHours()];
    const most = Math.max(1, ...counts);
    at('hours').replaceChildren(...counts.map((count, hour) => {
        const column = element('span');
        const bar = element('i');
        bar.style.height = count / most * 100 + '%';
        column.title = `${digits(hour)}:00 to ${digits(hour)}:59: ${many(count, 'event')}`;
        column.append(bar, element('small', '', hour % 3 ? '' : String(hour)));
        return column;
    }));
    const busiest = counts.indexOf(most);
    at('hours').ariaLabel = found.length ? `Events by hour of the day; most, ${most}, from ${busiest} to ${busiest + 1}` : 'No events';
}

const mostFound = 300;

function listFound(found, count) {
    at('foundheading').textContent = place ? `${found.length.toLocaleString('en')} of ${many(count, 'event')}` : many(count, 'event');
    const byNews = (a, b) => b.event.clip.begins + b.how.at - a.event.clip.begins - a.how.at;
    const sorted = [...found].sort(place ? byNews : (a, b) => a.event.kind.rank - b.event.kind.rank || byNews(a, b));
    const items = sorted.slice(0, mostFound).map(({event, how}) => {
        const link = element('a');
        link.href = event.clip.url + (event.clip.files & hasPage ? `.html#event=${event.number}` : '.png');
        link.addEventListener('click', () => see(event.clip));
        const when = wallOf(event.clip.begins + how.at);
        const badge = element('span', 'badge ' + event.kind.emphasis, event.kind.words);
        const lasts = (event.path.at(-3) - event.path[0]) / 10;
        link.append(element('b', '', `${dayOf(when)} ${timeOf(when)}`), ' ', badge, ' ', event.what ? event.what + ' ' : '', element('small', '', how.words() || (event.kind.tally === 'still' ? durationOf(event.still) : lengthOf(lasts))));
        const item = element('li');
        item.append(link);
        return item;
    });
    if (sorted.length > mostFound) items.push(element('li', 'none', `${(sorted.length - mostFound).toLocaleString('en')} more: choose days, or draw a smaller area.`));
    if (!sorted.length) items.push(element('li', 'none', 'Nothing was here.'));
    at('found').replaceChildren(...items);
}

function pointOnScene(event) {
    const box = at('drawing').getBoundingClientRect();
    return [clamp((event.clientX - box.left) / box.width, 0, 1) * 1000, clamp((event.clientY - box.top) / box.height, 0, 1) * 1000];
}

/// Places are in thousandths of the scene.
const drawPlace = shown => drawShape(at('drawing'), shown, [1000, 1000], 1000);

function askPlace(asked_for) {
    place = asked_for;
    drawPlace(place);
    at('askall').hidden = place === null;
    showScene(chosenClips());
}

at('drawing').addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    drawn = {kind: drawKind, from: pointOnScene(event), to: pointOnScene(event)};
    at('drawing').setPointerCapture(event.pointerId);
});
at('drawing').addEventListener('pointermove', event => {
    if (!drawn) return;
    drawn.to = pointOnScene(event);
    drawPlace(drawn);
});
at('drawing').addEventListener('pointerup', event => {
    if (!drawn) return;
    const done = {...drawn, to: pointOnScene(event)};
    drawn = null;
    askPlace(Math.hypot(done.to[0] - done.from[0], done.to[1] - done.from[1]) < 10 ? null : done);
});
at('drawing').addEventListener('pointercancel', () => { drawn = null; });
for (const [id, kind] of [['askbox', 'box'], ['askline', 'line']]) {
    at(id).addEventListener('click', () => {
        drawKind = kind;
        at('askbox').setAttribute('aria-pressed', kind === 'box');
        at('askline').setAttribute('aria-pressed', kind === 'line');
    });
}
at('askall').addEventListener('click', () => askPlace(null));

function chooseDays(from, to) {
    at('from').value = from;
    at('to').value = to;
    showScene(chosenClips());
}
for (const id of ['from', 'to']) at(id).addEventListener('change', () => showScene(chosenClips()));
const lastDay = () => data.days.at(-1) ?? '';
at('day').addEventListener('click', () => chooseDays(lastDay(), lastDay()));
at('week').addEventListener('click', () => {
    const begin = new Date(lastDay() + 'T00:00:00Z');
    begin.setUTCDate(begin.getUTCDate() - 6);
    chooseDays(dayOf(begin), lastDay());
});
at('everything').addEventListener('click', () => chooseDays('', ''));
at('ground').addEventListener('load', () => {
    at('stage').style.aspectRatio = at('ground').naturalWidth / at('ground').naturalHeight;
});
