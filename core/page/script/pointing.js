
// ---- Pointing: the time and a thumbnail

const tip = at('tip');
const peeker = at('peeker');
let pointed = null;       // the frame
let pointedEvent = null;  // its place in the list
peeker.hidden = true;

function pointAt(frame, x, y, event = null) {
    tip.hidden = frame === null;
    light(event);
    pointedEvent = event;
    if (frame === null) {
        pointed = null;
        return;
    }
    if (frame !== pointed) {
        pointed = frame;
        const nearest = stillNear(frame);
        const apart = Math.abs(secondsOf(nearest.frame) - secondsOf(frame));
        at('about').textContent = film || apart < 0.5 ? '' : 'picture of ' + clockOf(secondsOf(nearest.frame));
        at('peek').src = nearest.src;
        peeker.hidden = true;
        peekAt(frame);
    }
    putRing(at('peekring'), event, film ? frame : stillNear(frame).frame);
    at('when').textContent = clockOf(secondsOf(frame)) + (event === null ? '' : ` · ${numberOf(event)} ${data.events[event].kind}`);
    placeTip(x, y);
}

/// Beside the pointer, on the side on which the picture has less to show.
function placeTip(x, y) {
    const box = tip.getBoundingClientRect();
    const whole = view.getBoundingClientRect();
    const wantsLeft = x < whole.left + whole.width / 2;
    const beside = wantsLeft && x - 18 - box.width > 4 || x + 18 + box.width > innerWidth ? x - 18 - box.width : x + 18;
    tip.style.transform = `translate(${clamp(beside, 4, Math.max(4, innerWidth - box.width - 4))}px, ${clamp(y - box.height / 2, 4, innerHeight - box.height - 4)}px)`;
}

/// A still is there at once; the frame itself comes from the film, one after the other.
function peekAt(frame) {
    if (!film || peeker.readyState < 1 || peeker.seeking) return;
    peeker.dataset.frame = frame;
    goToFrame(peeker, frame);
}
peeker.addEventListener('seeked', () => {
    if (Number(peeker.dataset.frame) === pointed) peeker.hidden = false;
    else if (pointed !== null) peekAt(pointed);
});
peeker.addEventListener('loadeddata', () => {
    if (pointed !== null) peekAt(pointed);
});
