
// ---- Beginning

function summarise() {
    const count = lastFrame - firstFrame + 1;
    const span = `${clockOf(begins, false)} to ${clockOf(ends, false)}, ${count} frame${count === 1 ? '' : 's'}`;
    const zone = data.clock?.zone ? ', ' + data.clock.zone : '';
    at('summary').textContent = data.clock === null ? span
        : `${dayOf(begins)}, ${span}, ${spanOf(ends - begins)}; times are of the day${zone}`;
}
summarise();
document.title = upright(document.title);
document.querySelector('h1').textContent = upright(data.name);
at('screen').style.aspectRatio = at('peeked').style.aspectRatio = data.size[0] + ' / ' + data.size[1];
at('screen').style.setProperty('--shape', data.size[0] / data.size[1]);
at('peeked').style.width = 220 * data.size[0] / Math.max(...data.size) + 'px';
strip.ariaValueMin = 0;
strip.ariaValueMax = lasts.toFixed(1);
drawChips();
listEvents();
drawStrip();
place();
drawNow();
drawButtons();
openFilm(0);
followPlayer();
followAddress();
readPicture().then(() => {
    labelEnds();
    drawVeil();
    document.documentElement.dataset.ready = '';
}).catch(error => {
    at('notice').textContent = `The picture can’t tell times here: ${error.message}. The strip of time and the events can.`;
    at('notice').hidden = false;
});
