// Why a clip can't be played.

/** What Chromium and Firefox say of a file that is not there. They have one code for all that fails. */
const missing = [/^MEDIA_ELEMENT_ERROR: Format error$/, /^\d+: /];

/**
 * @param {string} message of the browser
 * @param {string} name of the clip
 */
export function whyNot(message, name) {
    if (missing.some(words => words.test(message))) return 'the clip is not where it was';
    if (message !== '' || !/\.(mp4|m4v|webm|mov)$/i.test(name)) return 'this browser doesn’t play this kind of file';
    return 'the clip is missing or can’t be played here';
}
