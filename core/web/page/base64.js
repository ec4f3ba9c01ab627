// Bytes in the page's text.

/** @param {string} base64 */
export const bytesOf = base64 => Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
