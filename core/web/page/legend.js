// What the picture's colours mean.

/**
 * The entries for what the picture has; none if its colours are not those of objects.
 * @param {Pick<import('./data.js').PageData, 'settings' | 'live'>} data
 * @param {Pick<import('./data.js').PageEvent, 'stays'>[]} events
 */
export function entriesOf({settings, live}, events) {
    const shows = (settings.show ?? '').split(',');
    if (settings.color !== 'object' || !shows.includes('volume')) return [];
    return [
        {sign: 'plain', words: 'moved', is: events.length > 0},
        // In a stream, the picture has its colours before it is known what stays.
        {sign: 'stripes', words: 'stayed or left behind', is: !live && events.some(({stays}) => stays?.length)},
        {sign: 'grey', words: 'other change', is: true},
    ].filter(({is}) => is);
}
