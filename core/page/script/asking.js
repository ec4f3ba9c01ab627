
// ---- Asking by place: a rectangle or a line that is drawn on the player

const drawing = at('drawing');
let asking = null;  // 'box' or 'line' while one is to be drawn
let asked = null;   // what was drawn: {kind, from: [x, y], to: [x, y]} in shares of the clip's picture

/// How often a path crosses a line, and towards which side last: 1 or -1.
function crossingsOf(path, from, to) {
    let count = 0;
    let side = 0;
    for (let k = 1; k < path.length; ++k) {
        const crossing = crossingOf(path[k - 1][1], path[k - 1][2], path[k][1], path[k][2], from, to);
        if (!crossing) continue;
        ++count;
        side = crossing.side;
    }
    return {count, side};
}

/// Seconds that the middle of an event's object was in a box.
function secondsInBox(path, box) {
    let seconds = 0;
    let touched = path.length === 1 && partInBox(path[0][1], path[0][2], path[0][1], path[0][2], box) !== null;
    for (let k = 1; k < path.length; ++k) {
        const part = partInBox(path[k - 1][1], path[k - 1][2], path[k][1], path[k][2], box);
        if (!part) continue;
        touched = true;
        seconds += (part[1] - part[0]) * (secondsOf(path[k][0]) - secondsOf(path[k - 1][0]));
    }
    return touched ? seconds : null;
}

/// What an event has to do with the place that is asked for, in words; null = nothing.
function answerOf(event) {
    if (!asked) return '';
    if (asked.kind === 'box') {
        const seconds = secondsInBox(event.path, sidesOf(asked));
        return seconds === null ? null : `here ${spanOf(seconds)}`;
    }
    const {count, side} = crossingsOf(event.path, asked.from, asked.to);
    if (count === 0) return null;
    return `crossed ${arrowAcross(asked, side, data.size)}` + (count > 1 ? ` ${count} times` : '');
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

/// Places are shares of the clip's picture.
const drawPlace = place => drawShape(drawing, place, data.size, 1);

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
    const [x, y, toX, toY] = sidesOf(asked).map((share, k) => Math.round(share * data.size[k % 2]));
    return `--roi '${x},${y} ${toX},${y} ${toX},${toY} ${x},${toY}'`;
}
at('copyroi').addEventListener('click', () => copy(roiOfPlace(), 'the option for the next run'));
