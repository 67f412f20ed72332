/** Columns of a line of GLSL, as Prettier has it for the other languages. */
export const MOST_COLUMNS = 120;

/**
 * Lines that are too long.
 *
 * @param {string} path - named in the result
 * @param {string} text
 * @returns {string[]} one line each: file, line and columns
 */
export function longLines(path, text) {
  return text
    .split(/\r?\n/)
    .map((line, i) => (line.length > MOST_COLUMNS ? `${path}:${i + 1} has ${line.length} columns` : ''))
    .filter((line) => line !== '');
}
