import { dirname, join } from 'node:path/posix';
import { parseSync } from 'vite';

/** A file of the repository as comments name one: its name, the end of its path, or a path from the comment's own file. */
const FILE_NAME = /(?<![\w./*<>{}-])(?:[\w.@-]+\/)*[\w-][\w.-]*\.(?:ts|tsx|mjs|glsl)(?![\w/*])/g;

/**
 * Files that comments name and that do not exist.
 *
 * @param {string} path - of the source that holds the comments
 * @param {string} source - TypeScript, a module, or GLSL
 * @param {readonly string[]} files - paths of all files that may be named
 * @returns {string[]} one line each: the source and what its comment names
 */
export function missingNamedFiles(path, source, files) {
  const comments = path.endsWith('.glsl')
    ? (source.match(/\/\/.*|\/\*[\s\S]*?\*\//g) ?? [])
    : parseSync(path, source).comments.map(({ value }) => value);
  const names = comments.flatMap((comment) => comment.match(FILE_NAME) ?? []);
  const exists = (/** @type {string} */ name) => {
    const ending = /^\.\.?\//.test(name) ? join(dirname(path), name) : name;
    return files.some((file) => file === ending || file.endsWith(`/${ending}`));
  };
  return [...new Set(names)].filter((name) => !exists(name)).map((name) => `${path} names ${name}`);
}
