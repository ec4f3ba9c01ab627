
// ---- Beginning

/// Marks that turn the writing are shown as what they are.
function nameIt() {
    document.title = upright(document.title);
    for (const name of [document.querySelector('h1'), at('file')]) name.textContent = upright(name.textContent);
}

function summarise() {
    const count = framesIn(data.times);
    const span = `${clockOf(begins, false)} to ${clockOf(ends, false)}, ${count.toLocaleString('en')} frame${count === 1 ? '' : 's'}`;
    const lost = gaps.length ? ` of video, no signal for ${spanOf(ends - begins - secondsSeen())}` : '';
    const zone = data.clock?.zone ? ', ' + data.clock.zone : '';
    at('summary').textContent = data.clock === null ? `${span}, ${spanOf(secondsSeen())}${lost}; ${data.told}`
        : `${dayOf(begins)}, ${span}, ${spanOf(secondsSeen())}${lost}; times are of the day${zone}, ${data.told}`;
}
nameIt();
summarise();
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
