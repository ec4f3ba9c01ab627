// What the picture's colours and marks mean, as the legend of a picture without a page says it.

/**
 * The entries for what the picture has; none if its colours are not those of objects.
 * @param {Pick<import('./data.js').PageData, 'settings' | 'live'>} data
 * @param {Pick<import('./data.js').PageEvent, 'stays'>[]} events
 */
export function entriesOf({settings, live}, events) {
    const shows = (settings.show ?? '').split(',');
    if (settings.color !== 'object' || !shows.includes('volume')) return [];
    return [
        // In a stream, the picture has its colours before it is known what stands.
        {sign: 'stripes', words: 'it stood', is: !live && events.some(({stays}) => stays?.length)},
        {sign: 'grey', words: 'other changes', is: true},
        {sign: 'arrow', words: 'way it went', is: shows.includes('directions') && events.length > 0},
    ].filter(({is}) => is);
}
