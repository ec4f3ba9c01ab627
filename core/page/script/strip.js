
// ---- The strip of time: a bar for each event; where there are too many, how many there are at each moment

const strip = at('strip');
let stripFrom = begins;   // what the strip shows, in seconds
let stripLasts = lasts;
let rubbing = null;       // where the pointer went down, and whether it was dragged from there

const shareOnStrip = seconds => (seconds - stripFrom) / stripLasts;

function frameOnStrip(event) {
    const box = strip.getBoundingClientRect();
    return frameAt(stripFrom + clamp((event.clientX - box.left) / box.width, 0, 1) * stripLasts);
}

/// The event under the pointer: the one whose bar it is on.
const eventOnStrip = event => event.target.dataset?.event === undefined ? null : Number(event.target.dataset.event);

strip.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    rubbing = {x: event.clientX, far: false, down: true};
    strip.setPointerCapture(event.pointerId);
});
strip.addEventListener('pointermove', event => {
    const drags = rubbing?.down && (rubbing.far ||= Math.abs(event.clientX - rubbing.x) > 4);
    if (drags) goTo(frameOnStrip(event));
    pointAt(frameOnStrip(event), event.clientX, strip.getBoundingClientRect().top - 100, drags ? null : eventOnStrip(event));
    if (isInGap(event)) at('when').textContent = 'no signal after ' + at('when').textContent;
});
for (const kind of ['pointerup', 'pointercancel']) strip.addEventListener(kind, () => { if (rubbing) rubbing.down = false; });
strip.addEventListener('pointerleave', () => pointAt(null));
strip.addEventListener('click', event => {
    if (rubbing?.far) return;  // it was a drag
    const number = barAt(event);
    choose(number);
    show(frameOnStrip(event), true);
    until = number === null ? null : data.events[number].last;
});

/// The pointer is captured while it is down, so a click is always the strip's own: which bar lies there?
function barAt(event) {
    const bar = document.elementsFromPoint(event.clientX, event.clientY).find(found => found.dataset.event !== undefined && strip.contains(found));
    return bar ? Number(bar.dataset.event) : null;
}

strip.addEventListener('wheel', event => {
    event.preventDefault();
    const box = strip.getBoundingClientRect();
    const share = clamp((event.clientX - box.left) / box.width, 0, 1);
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) showOnStrip(stripFrom + (event.deltaX || event.deltaY) / 600 * stripLasts, stripLasts);
    else zoomStrip(Math.exp(event.deltaY * 0.0016), share);
}, {passive: false});
strip.addEventListener('dblclick', () => showOnStrip(begins, lasts));

function zoomStrip(factor, share) {
    const wanted = clamp(stripLasts * factor, Math.min(lasts, 2), lasts);
    showOnStrip(stripFrom + share * (stripLasts - wanted), wanted);
}

function showOnStrip(from, length) {
    stripLasts = length;
    stripFrom = clamp(from, begins, begins + lasts - length);
    drawStrip();
}

strip.addEventListener('keydown', event => {
    const second = {ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1, PageDown: -10, PageUp: 10}[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (second) goBy(event.shiftKey ? second * 10 : second);
    else if (event.key === 'Home') goTo(firstFrame);
    else if (event.key === 'End') goTo(lastFrame);
    else if (event.key === '+' || event.key === '=') zoomStrip(1 / 1.5, clamp(shareOnStrip(secondsOf(now)), 0, 1));
    else if (event.key === '-') zoomStrip(1.5, clamp(shareOnStrip(secondsOf(now)), 0, 1));
    else return;
    event.preventDefault();
    event.stopPropagation();
});

function drawCursor() {
    const share = shareOnStrip(secondsOf(now));
    at('cursor').hidden = share < 0 || share > 1;
    at('cursor').style.left = share * 100 + '%';
    strip.ariaValueNow = (secondsOf(now) - begins).toFixed(1);
    strip.ariaValueText = bothClocks(secondsOf(now));
}

function drawTicks() {
    const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200, 86400];
    const most = Math.max(2, strip.clientWidth / 90);
    const step = steps.find(seconds => stripLasts / seconds <= most) ?? 86400 * Math.ceil(stripLasts / 864000);
    const zero = data.clock === null ? 0 : data.clock.begin % step;  // ticks are whole steps of the clock that is shown
    const labels = [];
    for (let seconds = Math.ceil((stripFrom + zero) / step) * step - zero; seconds <= stripFrom + stripLasts * 0.98; seconds += step) {
        const label = element('span', '', clockOf(seconds, false));
        const share = shareOnStrip(seconds);
        const half = label.textContent.length * 3.5 / Math.max(1, strip.clientWidth);  // of its width, about
        label.style.left = share * 100 + '%';
        label.className = share < half ? 'atedge' : share > 1 - half ? 'atend' : '';
        labels.push(label);
    }
    at('ticks').replaceChildren(...labels);
}

const mostRows = 10;

/// Each of these events in the first row that is free for it; null where they need too many rows.
function rowsOf(numbers) {
    const ends = [];
    const rows = [];
    for (const number of numbers) {
        const event = data.events[number];
        let row = ends.findIndex(end => end < event.first);
        if (row < 0) row = ends.length;
        if (row === mostRows) return null;
        ends[row] = event.last;
        rows.push(row);
    }
    return {rows, count: ends.length};
}

/// Time without signal is hatched, as in the picture.
function drawGaps() {
    at('gaps').replaceChildren(...gaps.flatMap(([last, first]) => {
        const [from, to] = [secondsOf(last) + lengthOf(last), secondsOf(first)].map(seconds => clamp(shareOnStrip(seconds), 0, 1));
        if (to <= from) return [];
        const gap = element('i', '', (to - from) * strip.clientWidth > 70 ? 'no signal' : '');
        gap.style.left = from * 100 + '%';
        gap.style.width = (to - from) * 100 + '%';
        return [gap];
    }));
}

/// Whether the pointer is where there is no signal.
function isInGap(event) {
    const box = strip.getBoundingClientRect();
    const seconds = stripFrom + clamp((event.clientX - box.left) / box.width, 0, 1) * stripLasts;
    return gaps.some(([last, first]) => seconds >= secondsOf(last) + lengthOf(last) && seconds < secondsOf(first));
}

function drawStrip() {
    drawTicks();
    drawGaps();
    drawCursor();
    const inside = [];
    wantedEvents().forEach(number => {
        const event = data.events[number];
        if (secondsOf(event.last) >= stripFrom && secondsOf(event.first) <= stripFrom + stripLasts) inside.push(number);
    });
    inside.sort((a, b) => data.events[a].first - data.events[b].first || a - b);
    const rows = inside.length <= 400 ? rowsOf(inside) : null;
    if (rows) drawBars(inside, rows);
    else drawDensity(inside);
}

function drawBars(numbers, {rows, count}) {
    const share = 100 / Math.max(count, 4);
    at('bars').replaceChildren(...numbers.map((number, k) => {
        const event = data.events[number];
        const bar = element('i');
        if (event.colour) bar.style.background = event.colour;
        const [left, right] = [event.first, event.last].map(frame => clamp(shareOnStrip(secondsOf(frame)), 0, 1));
        bar.style.left = left * 100 + '%';
        bar.style.width = (right - left) * 100 + '%';
        bar.style.top = rows[k] * share + '%';
        bar.style.height = `max(2px, ${share * 0.75}%)`;
        bar.dataset.event = number;
        bar.classList.toggle('chosen', number === chosen);
        return bar;
    }));
}

/// How many events there are at each moment, and a mark for each thing that was put down or taken.
function drawDensity(numbers) {
    const cells = 240;
    const counts = new Float32Array(cells);
    const marks = [];
    for (const number of numbers) {
        const event = data.events[number];
        const [from, to] = [event.first, event.last].map(frame => clamp(Math.floor(shareOnStrip(secondsOf(frame)) * cells), 0, cells - 1));
        for (let cell = from; cell <= to; ++cell) ++counts[cell];
        if (kindOf(event.kind).isThing) marks.push(number);
    }
    const most = Math.max(1, ...counts);
    const columns = Array.from(counts, (count, cell) => {
        const column = element('i', 'density');
        column.style.left = cell / cells * 100 + '%';
        column.style.width = 100 / cells + '%';
        column.style.height = count / most * 100 + '%';
        return column;
    });
    for (const number of marks.slice(0, 200)) {
        const event = data.events[number];
        const mark = element('i', 'mark');
        mark.style.left = clamp(shareOnStrip(secondsOf(event.first)), 0, 1) * 100 + '%';
        mark.dataset.event = number;
        columns.push(mark);
    }
    at('bars').replaceChildren(...columns);
}
new ResizeObserver(() => { drawTicks(); drawGaps(); }).observe(strip);
