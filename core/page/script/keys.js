
// ---- Keys

const arrows = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
const keys = {
    '+': () => zoom(1.5),
    '=': () => zoom(1.5),
    '-': () => zoom(1 / 1.5),
    '0': showWhole,
    ' ': togglePlaying,
    k: togglePlaying,
    j: () => goBy(-5),
    l: () => goBy(5),
    ',': () => stepFrame(-1),
    '.': () => stepFrame(1),
    Escape: () => {
        if (asking) askBy(asking);
        else if (chosen !== null) choose(null);
        else askPlace(null);
    },
};
// A button that was clicked keeps the focus and would take Space for itself; only for who came by keyboard it does.
let byKeyboard = false;
addEventListener('keydown', event => { if (event.key === 'Tab') byKeyboard = true; }, true);
addEventListener('pointerdown', () => { byKeyboard = false; }, true);
document.addEventListener('change', event => { if (!byKeyboard) event.target.blur(); });

document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest('select, input')) return;
    const arrow = arrows[event.key];
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const pressesButton = byKeyboard && event.key === ' ' && event.target.closest('button, a');
    if (pressesButton) return;
    if (arrow && event.shiftKey) pan(80 * arrow[0], 80 * arrow[1]);
    else if (arrow) step(event.key === 'ArrowRight' || event.key === 'ArrowDown' ? 1 : -1);
    else if (keys[key]) keys[key]();
    else return;
    event.preventDefault();
});
// Space presses a focused button when it comes up again.
document.addEventListener('keyup', event => {
    if (event.key === ' ' && !byKeyboard && event.target.closest('button')) event.preventDefault();
});
