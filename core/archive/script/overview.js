
// ---- Days: a row for each, cameras as columns, in each cell the hours

function cellOf(all, most) {
    const cell = element('td');
    if (!all.length) return cell;
    const recording = all.find(clip => clip.wholeDay && clip.drawn);
    const single = all.filter(clip => !clip.wholeDay);
    const clipsOf = single.length ? single : all;
    const button = element('button');
    button.type = 'button';
    const hours = element('span', 'hours');
    const counts = new Array(24).fill(null);
    for (const clip of single) counts[clip.hour] = (counts[clip.hour] ?? 0) + (clip.events ?? 0);
    for (const count of counts) {
        const hour = element('i', count === null ? 'nothing' : count === 0 ? 'quiet' : 'busy');
        if (count) hour.style.opacity = 0.25 + 0.75 * Math.sqrt(count / most);
        hours.append(hour);
    }
    const events = clipsOf.reduce((sum, clip) => sum + (clip.events ?? 0), 0);
    const failed = clipsOf.filter(clip => clip.failed).length;
    const words = element('span', 'badges');
    words.append(element('span', '', many(events, 'event')));
    for (const {name, emphasis} of data.kinds.filter(({tally}) => tally === 'lasts' || tally === 'still')) {
        const longest = Math.max(...clipsOf.map(clip => clip.tallyOf[name]));
        if (longest > 0) words.append(element('span', 'badge ' + emphasis, name + ' ' + durationOf(longest)));
    }
    if (failed) words.append(element('span', 'bad', `✕${failed} failed`));
    button.append(hours, words);
    button.ariaLabel = `${cameraName(clipsOf[0].camera)}, ${clipsOf[0].day}: ${words.textContent}`;
    button.addEventListener('click', () => ask({view: 'clips', camera: clipsOf[0].camera, day: clipsOf[0].day}));
    cell.append(button);
    if (recording) {
        const link = element('a', 'wholeday', stretchOf(recording));
        link.href = pageOf(recording);
        link.addEventListener('click', () => see(recording));
        cell.append(link);
    }
    return cell;
}

function showDays(list) {
    const table = element('table');
    const cameras = [...new Set(list.map(clip => clip.camera))].sort((a, b) => a - b);
    const head = element('tr');
    head.append(element('td'), ...cameras.map(camera => {
        const cell = element('th', '', cameraName(camera));
        cell.scope = 'col';
        return cell;
    }));
    table.append(head);
    const byHour = new Map();
    for (const clip of list.filter(other => !other.wholeDay)) {
        const key = `${clip.camera} ${clip.day} ${clip.hour}`;
        byHour.set(key, (byHour.get(key) ?? 0) + (clip.events ?? 0));
    }
    const most = Math.max(1, ...byHour.values());
    let month = '';
    for (const [day, ofDay] of grouped(list, 'day')) {
        if (day.slice(0, 7) !== month) {
            month = day.slice(0, 7);
            const row = element('tr', 'month');
            const name = element('th', '', new Date(day + 'T00:00:00Z').toLocaleDateString('en', {month: 'long', year: 'numeric', timeZone: 'UTC'}));
            name.colSpan = cameras.length + 1;
            row.append(name);
            table.append(row);
        }
        const row = element('tr');
        const name = element('th', '', `${weekday(day).slice(0, 3)} ${day.slice(8)}`);
        name.scope = 'row';
        row.append(name, ...cameras.map(camera => cellOf(ofDay.filter(clip => clip.camera === camera), most)));
        table.append(row);
    }
    const hint = element('p', 'hint', 'Each little box is an hour of the day, 0 to 23: the stronger its colour, the more events. Click a cell for its clips.');
    at('overview').replaceChildren(list.length ? hint : element('p', 'empty', 'Nothing here is like that.'), table);
}
