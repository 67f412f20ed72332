import { dirname } from 'node:path/posix';

/**
 * Maximum of each count that the repository may have. A limit only falls: whoever lowers a count lowers it. A feature
 * may raise `lines` by its own, which are of product code: TypeScript, GLSL, CSS and scripts of packages and apps,
 * without tests and the folders `testing/` of what tests share.
 */
export const houseLimits = {
  riddles: 2,
  parametersWithoutDash: 0,
  tinyFiles: 6,
  macrosAcrossFiles: 40,
  lines: 188_708,
};

/** First words by which a docblock hides its noun. */
const RIDDLE = /^(What|Where|Of|Has|The same)\b/;

/** Lines that a file of product code may have. */
export const MOST_LINES = 400;

/** Lines from which on a file may stand by itself although one neighbour alone imports it. */
const FEWEST_LINES = 15;

/**
 * Docblocks that begin with What, Where, Of, Has or The same.
 *
 * @param {string} path - named in the result
 * @param {string} source
 * @returns {string[]} one line each: file, line and first words
 */
export function riddles(path, source) {
  return docblocks(source)
    .filter(({ text }) => RIDDLE.test(text))
    .map(({ line, text }) => `${path}:${line} ${text.split('\n')[0].trim().slice(0, 60)}`);
}

/**
 * Parameters in docblocks that are described without a dash: the form is `@param name - text`.
 *
 * @param {string} path - named in the result
 * @param {string} source
 * @returns {string[]} one line each
 */
export function parametersWithoutDash(path, source) {
  const described = /@param (?:\{(?:[^{}]|\{[^{}]*\})*\} )?(?:\[[^\]]*\]|[\w.$]+) (?!-\s)[^\s@*]/;
  return docblocks(source)
    .filter(({ text }) => described.test(text))
    .map(({ line }) => `${path}:${line}`);
}

/**
 * Files of under 15 lines that one other file imports, which lies in the same folder: they read better within it. Not those
 * that an `index.ts` lists: a technique or a kind of field is a file of its own and a line there.
 *
 * @param {ReadonlyMap<string, string>} files - source by path, with `/`; no tests
 * @param {import('./importCircles.mjs').ImportGraph} imports
 * @returns {string[]} paths
 */
export function tinyFiles(files, imports) {
  /** @type {Map<string, string[]>} */
  const importers = new Map();
  for (const [path, targets] of imports) {
    for (const target of new Set([...targets.static, ...targets.types, ...targets.fetched]))
      importers.set(target, [...(importers.get(target) ?? []), path]);
  }
  return [...files.keys()].filter((path) => {
    const lines = files.get(path)?.trimEnd().split('\n').length ?? 0;
    const by = importers.get(path) ?? [];
    return (
      !path.endsWith('/index.ts') &&
      lines < FEWEST_LINES &&
      by.length === 1 &&
      dirname(by[0]) === dirname(path) &&
      !by[0].endsWith('/index.ts')
    );
  });
}

/**
 * Macros of our shaders (`FAROL_…`) that one file defines and another reads.
 *
 * @param {ReadonlyMap<string, string>} files - GLSL and TypeScript by path
 * @returns {string[]} names in alphabetical order
 */
export function macrosAcrossFiles(files) {
  /** @type {Map<string, Set<string>>} */
  const definers = new Map();
  /** @type {Map<string, Set<string>>} */
  const readers = new Map();
  /** @type {(map: Map<string, Set<string>>, name: string, path: string) => void} */
  const add = (map, name, path) => void map.set(name, (map.get(name) ?? new Set()).add(path));
  for (const [path, source] of files) {
    if (path.endsWith('.glsl')) {
      for (const [, name] of source.matchAll(/^\s*#\s*define\s+(\w+)/gm)) add(definers, name, path);
      for (const [, line] of source.matchAll(/^\s*#\s*(?:el)?if(?:n?def)?\s+(.*)/gm))
        for (const [name] of line.matchAll(/\b[A-Z]\w*\b/g)) add(readers, name, path);
    } else {
      for (const [, name] of source.matchAll(/\b([A-Z][A-Z\d]*(?:_[A-Z\d]+)+)\b/g)) add(definers, name, path);
    }
  }
  return [...readers]
    .filter(
      ([name, by]) =>
        name.startsWith('FAROL_') && [...(definers.get(name) ?? [])].some((path) => !by.has(path) || by.size > 1),
    )
    .map(([name]) => name)
    .toSorted();
}

/** @param {string} source */
function docblocks(source) {
  return [...source.matchAll(/\/\*\*([\s\S]*?)\*\//g)].map((match) => ({
    line: source.slice(0, match.index).split('\n').length,
    text: match[1].replace(/^[\s*]+/, '').replace(/\n\s*\* ?/g, '\n'),
  }));
}
