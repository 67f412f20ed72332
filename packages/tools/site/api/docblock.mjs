/**
 * A docblock, taken apart.
 *
 * @typedef {object} Docblock
 * @property {string} text - Markdown before the first tag
 * @property {{ name: string, text: string }[]} params
 * @property {string[]} returns
 * @property {string[]} throws
 * @property {string[]} see
 * @property {boolean} isInternal
 */

/**
 * @param {string} comment - between its opening and closing marks, from the second star on
 * @returns {Docblock}
 */
export function parseDocblock(comment) {
  const lines = comment
    .replace(/^\*/, '')
    .split('\n')
    .map((line) => line.replace(/^\s*\*? ?/, '').trimEnd());
  const [text, ...parts] = lines
    .join('\n')
    .split(/(?:^|\s)@(?=[a-z]+\b(?!\/))(?=internal|param|typeParam|returns|throws|see|example)/m);
  const tags = parts.map((part) => {
    const [, name, rest] = /** @type {RegExpExecArray} */ (/^(\w+)\s*([\s\S]*)$/.exec(part));
    return { name, text: rest.trim() };
  });
  const all = (/** @type {string[]} */ ...names) =>
    tags.filter(({ name }) => names.includes(name)).map((tag) => tag.text);
  return {
    text: text.trim(),
    params: all('param', 'typeParam').map((tag) => {
      const [name] = tag.split(/\s/, 1);
      return { name, text: tag.slice(name.length).replace(/^\s*-?\s*/, '') };
    }),
    returns: all('returns'),
    throws: all('throws'),
    see: all('see'),
    isInternal: tags.some(({ name }) => name === 'internal'),
  };
}

/**
 * Docblock that ends where a declaration begins, with nothing but space between.
 *
 * @param {{ type: string, value: string, start: number, end: number }[]} comments - of the file, in order
 * @param {string} source
 * @param {number} start - of the declaration
 * @returns {Docblock}
 */
export function docblockBefore(comments, source, start) {
  const found = comments.findLast(({ end }) => end <= start);
  const isDocblock = found?.type === 'Block' && found.value.startsWith('*');
  return parseDocblock(isDocblock && source.slice(found.end, start).trim() === '' ? found.value : '');
}
