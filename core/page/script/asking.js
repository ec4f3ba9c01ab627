
// ---- Asking by place: a rectangle or a line that is drawn on the player

const drawing = at('drawing');
let asking = null;  // 'box' or 'line' while one is to be drawn
let asked = null;   // what was drawn: {kind, from: [x, y], to: [x, y]} in shares of the clip's picture

/// The part of a stretch from (x, y) to (toX, toY) that lies in a box, as shares of the stretch; null = none.
function partInBox([x, y], [toX, toY], [left, top, right, bottom]) {
    let [begin, end] = [0, 1];
    for (const [from, by, low, high] of [[x, toX - x, left, right], [y, toY - y, top, bottom]]) {
        if (by === 0) {
            if (from < low || from > high) return null;
            continue;
        }
        const cuts = [(low - from) / by, (high - from) / by].sort((a, b) => a - b);
        begin = Math.max(begin, cuts[0]);
        end = Math.min(end, cuts[1]);
    }
    return begin <= end ? [begin, end] : null;
}

/// On which side of a line a point is: the sign says it.
const sideOf = ([ax, ay], [bx, by], [x, y]) => (bx - ax) * (y - ay) - (by - ay) * (x - ax);

/// How often a path crosses a line, and towards which side last: 1 or -1.
function crossingsOf(path, from, to) {
    let count = 0;
    let side = 0;
    for (let k = 1; k < path.length; ++k) {
        const [a, b] = [path[k - 1].slice(1), path[k].slice(1)];
        const [before, after] = [sideOf(from, to, a), sideOf(from, to, b)];
        if ((before < 0) === (after < 0) || (sideOf(a, b, from) < 0) === (sideOf(a, b, to) < 0)) continue;
        ++count;
        side = after < 0 ? -1 : 1;
    }
    return {count, side};
}

/// Seconds that the middle of an event's object was in a box.
function secondsInBox(path, box) {
    let seconds = 0;
    let touched = path.length === 1 && partInBox(path[0].slice(1), path[0].slice(1), box) !== null;
    for (let k = 1; k < path.length; ++k) {
        const part = partInBox(path[k - 1].slice(1), path[k].slice(1), box);
        if (!part) continue;
        touched = true;
        seconds += (part[1] - part[0]) * (secondsOf(path[k][0]) - secondsOf(path[k - 1][0]));
    }
    return touched ? seconds : null;
}

/// An arrow for a way in the picture, as it is seen: in pixels, y downwards.
function arrowOf(x, y) {
    return '→↘↓↙←↖↑↗'[(Math.round(Math.atan2(y, x) / (Math.PI / 4)) + 8) % 8];
}

/// What an event has to do with the place that is asked for, in words; null = nothing.
function answerOf(event) {
    if (!asked) return '';
    const {kind, from, to} = asked;
    if (kind === 'box') {
        const box = [Math.min(from[0], to[0]), Math.min(from[1], to[1]), Math.max(from[0], to[0]), Math.max(from[1], to[1])];
        const seconds = secondsInBox(event.path, box);
        return seconds === null ? null : `here ${spanOf(seconds)}`;
    }
    const {count, side} = crossingsOf(event.path, from, to);
    if (count === 0) return null;
    // The way across the line is its normal on the side to which it went.
    const [alongX, alongY] = [(to[0] - from[0]) * data.size[0], (to[1] - from[1]) * data.size[1]];
    const arrow = arrowOf(-alongY * side, alongX * side);
    return `crossed ${arrow}` + (count > 1 ? ` ${count} times` : '');
}

function pointOnPlayer(event) {
    const box = drawing.getBoundingClientRect();
    return [clamp((event.clientX - box.left) / box.width, 0, 1), clamp((event.clientY - box.top) / box.height, 0, 1)];
}

/// Lets the next drag on the player draw; the same button again ends that.
function askBy(kind) {
    asking = asking === kind ? null : kind;
    drawing.classList.toggle('active', asking !== null);
    for (const [id, of] of [['askbox', 'box'], ['askline', 'line']]) at(id).ariaPressed = asking === of;
    at('hint').textContent = !asking ? '' : asking === 'box' ? 'Draw a rectangle on the player: what was in it is listed.'
                                                             : 'Draw a line on the player: what crossed it is listed.';
}
at('askbox').addEventListener('click', () => askBy('box'));
at('askline').addEventListener('click', () => askBy('line'));
at('askall').addEventListener('click', () => askPlace(null));

let drawn = null;
drawing.addEventListener('pointerdown', event => {
    if (!asking || event.button !== 0) return;
    event.preventDefault();
    drawn = {kind: asking, from: pointOnPlayer(event), to: pointOnPlayer(event)};
    drawing.setPointerCapture(event.pointerId);
});
drawing.addEventListener('pointermove', event => {
    if (!drawn) return;
    drawn.to = pointOnPlayer(event);
    drawPlace(drawn);
});
drawing.addEventListener('pointerup', event => {
    if (!drawn) return;
    const done = drawn;
    drawn = null;
    done.to = pointOnPlayer(event);
    const far = Math.hypot(done.to[0] - done.from[0], done.to[1] - done.from[1]);
    askBy(asking);
    askPlace(far < 0.01 ? null : done);
});
drawing.addEventListener('pointercancel', () => { drawn = null; });

function drawPlace(place) {
    drawing.setAttribute('viewBox', `0 0 ${data.size[0]} ${data.size[1]}`);
    drawing.replaceChildren();
    if (!place) return;
    const [[x, y], [toX, toY]] = [place.from, place.to].map(point => [point[0] * data.size[0], point[1] * data.size[1]]);
    const shape = document.createElementNS('http://www.w3.org/2000/svg', place.kind === 'box' ? 'rect' : 'line');
    const values = place.kind === 'box'
        ? {x: Math.min(x, toX), y: Math.min(y, toY), width: Math.abs(toX - x), height: Math.abs(toY - y)}
        : {x1: x, y1: y, x2: toX, y2: toY};
    for (const [name, value] of Object.entries(values)) shape.setAttribute(name, value);
    drawing.append(shape);
}

/// Lists what has to do with a place; null = everything.
function askPlace(place) {
    asked = place;
    drawPlace(place);
    at('askall').hidden = at('copyroi').hidden = place === null;
    at('copyroi').hidden ||= place?.kind === 'line';
    filterEvents();
    say(place ? at('heading').textContent : 'All events again');
}

/// The rectangle as the value of --roi: its corners in pixels of the clip.
function roiOfPlace() {
    const [x, toX] = [asked.from[0], asked.to[0]].map(share => Math.round(share * data.size[0])).sort((a, b) => a - b);
    const [y, toY] = [asked.from[1], asked.to[1]].map(share => Math.round(share * data.size[1])).sort((a, b) => a - b);
    return `--roi '${x},${y} ${toX},${y} ${toX},${toY} ${x},${toY}'`;
}
at('copyroi').addEventListener('click', () => copy(roiOfPlace(), 'the option for the next run'));
