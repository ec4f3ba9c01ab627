
// ---- Asking by place: a rectangle or a line that is drawn on the player

const drawing = at('drawing');
let asking = null;  // 'box' or 'line' while one is to be drawn
let asked = null;   // what was drawn: {kind, from: [x, y], to: [x, y]} in shares of the clip's picture

/// A place in thousandths of the picture, in which the ways of events are.
const inThousandths = ({kind, from, to}) => ({kind, from: from.map(share => share * 1000), to: to.map(share => share * 1000)});

/// What an event has to do with the place that is asked for, in words; null = nothing.
function answerOf(event) {
    if (!asked) return '';
    const place = inThousandths(asked);
    if (asked.kind === 'box') {
        const stay = stayOf(event.way, sidesOf(place));
        return stay && `here ${spanOf(stay.lasts / 10)}`;
    }
    const crossings = crossingsOf(event.way, place.from, place.to);
    return crossings.length ? crossingWords(crossings, asked, data.size, seconds => clockOf(seconds, false)) : null;
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
