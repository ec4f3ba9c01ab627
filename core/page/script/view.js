
// ---- Zoom and pan

const view = at('view');
const stage = at('stage');
let scale = 1;        // 1 = all contents of the picture fit
let middle = [0.5, 0.5];  // of the picture, stands in the middle of the view

function place() {
    const [left, top, right, bottom] = contents;
    const fit = Math.min(view.clientWidth / (right - left), view.clientHeight / (bottom - top));
    const size = [width * fit * scale, height * fit * scale];
    const room = [view.clientWidth, view.clientHeight];
    const ends = [[left / width, right / width], [top / height, bottom / height]];
    const corner = [0, 1].map(k => {
        const half = room[k] / 2 / size[k];
        const [low, high] = ends[k];
        // What is smaller than the view stands in its middle; else no border comes into it.
        middle[k] = 2 * half >= high - low ? (low + high) / 2 : clamp(middle[k], low + half, high - half);
        return room[k] / 2 - middle[k] * size[k];
    });
    view.style.touchAction = scale > 1 ? 'none' : 'pan-y';
    stage.style.width = size[0] + 'px';
    stage.style.height = size[1] + 'px';
    stage.style.transform = `translate(${corner[0]}px, ${corner[1]}px)`;
}

/// Zooms so that what is under a point of the window stays there.
function zoom(factor, x, y) {
    const before = picture.getBoundingClientRect();
    const point = x === undefined ? middle : [(x - before.left) / before.width, (y - before.top) / before.height];
    const wanted = clamp(scale * factor, 1, 16);
    const ratio = scale / wanted;
    middle = middle.map((value, k) => point[k] + (value - point[k]) * ratio);
    scale = wanted;
    place();
}

function pan(x, y) {
    const box = picture.getBoundingClientRect();
    middle = [middle[0] - x / box.width, middle[1] - y / box.height];
    place();
}

function showWhole() {
    scale = 1;
    place();
}

function shownUnder(event) {
    const box = picture.getBoundingClientRect();
    return shownAt((event.clientX - box.left) / box.width * width, (event.clientY - box.top) / box.height * height);
}

const fingers = new Map();  // pointers that are down: where they are
let press = null;           // where the first went down

/// The middle of two fingers, and how far they are apart.
function spreadOf() {
    const [a, b] = [...fingers.values()];
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y))};
}

view.addEventListener('pointerdown', event => {
    if (event.button !== 0 || event.target.closest('button')) return;
    fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    press = {x: event.clientX, y: event.clientY, drag: fingers.size > 1};
    view.setPointerCapture(event.pointerId);
});
view.addEventListener('pointermove', event => {
    const finger = fingers.get(event.pointerId);
    if (finger && fingers.size === 2) {
        const before = spreadOf();
        Object.assign(finger, {x: event.clientX, y: event.clientY});
        const after = spreadOf();
        zoom(after.apart / before.apart, before.x, before.y);
        pan(after.x - before.x, after.y - before.y);
        pointAt(null);
        return;
    }
    if (finger && press) {
        const [byX, byY] = [event.clientX - finger.x, event.clientY - finger.y];
        press.drag ||= Math.hypot(event.clientX - press.x, event.clientY - press.y) > 4;
        if (press.drag) {
            Object.assign(finger, {x: event.clientX, y: event.clientY});
            view.classList.add('dragging');
            pan(byX, byY);
            pointAt(null);
            return;
        }
    }
    const shown = event.target.closest('button') ? {frame: null, event: null} : shownUnder(event);
    pointAt(shown.frame, event.clientX, event.clientY, shown.event);
});
function lift(event) {
    fingers.delete(event.pointerId);
    view.classList.remove('dragging');
    const clicked = press && !press.drag && event.type === 'pointerup';
    if (fingers.size === 0) press = null;
    return clicked;
}
view.addEventListener('pointerup', event => {
    if (!lift(event)) return;
    const shown = shownUnder(event);
    if (shown.frame === null) return;
    choose(shown.event);
    show(shown.frame, true);
    until = shown.event === null ? null : data.events[shown.event].last;
    bringIntoSight();
    pointAt(null);  // what follows in the picture is to be seen
    say('Plays from ' + clockOf(secondsOf(shown.frame)) + (shown.event === null ? '' : `, event ${numberOf(shown.event)}`));
});
view.addEventListener('pointercancel', lift);
view.addEventListener('pointerleave', () => pointAt(null));
view.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.04 : 0.0016)), event.clientX, event.clientY);
}, {passive: false});
at('closer').addEventListener('click', () => zoom(1.5));
at('farther').addEventListener('click', () => zoom(1 / 1.5));
at('whole').addEventListener('click', showWhole);
new ResizeObserver(place).observe(view);
