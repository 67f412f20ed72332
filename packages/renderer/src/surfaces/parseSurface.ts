import { INCLUDE_LINE } from '../microshaders/parseMicroShader';
import { type ReachTerm, readReach } from './readReach';
import { readUniforms, threeUniforms, UNIFORM_LINE } from './readUniforms';
import { surfaceError } from './surfaceError';
import type { SurfaceUniform } from './SurfaceUniform';

/** Parsed text of a surface. */
export interface ParsedSurface {
  readonly uniforms: readonly SurfaceUniform[];
  /** Whether the text defines `void surface(inout SurfaceData s)`; `displaces`: `void displace(inout VertexData v)`. */
  readonly paints: boolean;
  readonly displaces: boolean;
  /** Whether the surface discards pixels, or may make the alpha test do so. */
  readonly discards: boolean;
  /** Whether pixels depend on the time; `movesByTime`: whether vertices, or discarded pixels, do. */
  readonly paintsByTime: boolean;
  readonly movesByTime: boolean;
  /** Greatest displacement (m), as a sum of products of uniforms; null if not declared, see `readReach`. */
  readonly reach: readonly ReachTerm[] | null;
  /** GLSL for each stage, with a prefix on every name that the text declares; line numbers are kept. */
  readonly fragment: string;
  readonly vertex: string;
}

const TIME = /\.time\b/;
const HOOKS = {
  surface: 'void surface(inout SurfaceData s)',
  displace: 'void displace(inout VertexData v)',
} as const;

/**
 * Parses a surface: GLSL with a hook for pixels, one for vertices, or both, and declared uniforms (see `readUniforms`).
 * @param name - name for errors
 * @param prefix - prefix of all names that the text declares, so that they differ from other surfaces' and three's
 * @throws MicroShaderCompileError with the line
 */
export function parseSurface(name: string, source: string, prefix: string): ParsedSurface {
  const text = source.replace(/\r\n?/g, '\n');
  const uniforms = readUniforms(name, text);
  const code = withoutComments(text);
  const heads = topLevel(code);
  const body = (hook: keyof typeof HOOKS) => heads.find((head) => head.name === hook && head.end > 0);
  const paint = body('surface');
  const displace = body('displace');
  if (!paint && !displace) throw surfaceError(name, text, 1, `write ${HOOKS.surface}, ${HOOKS.displace}, or both`);
  for (const [hook, found] of [
    ['surface', paint],
    ['displace', displace],
  ] as const) {
    const shape =
      hook === 'surface'
        ? /^void\s+surface\s*\(\s*inout\s+SurfaceData\s+\w+\s*\)/
        : /^void\s+displace\s*\(\s*inout\s+VertexData\s+\w+\s*\)/;
    if (found && !shape.test(code.slice(found.start).trimStart()))
      throw surfaceError(name, text, lineOf(text, found.at), `write ${HOOKS[hook]}`);
  }
  if (/\bvoid\s+main\s*\(/.test(code))
    throw surfaceError(
      name,
      text,
      lineOf(text, code.search(/\bvoid\s+main\s*\(/)),
      `no main(): write ${HOOKS.surface}`,
    );
  const own = new Set([...heads.map((head) => head.name), ...uniforms.map((uniform) => uniform.name)]);
  for (const [, macro] of code.matchAll(/^[ \t]*#[ \t]*define[ \t]+(\w+)/gm)) own.add(macro);
  const plain = text
    .split('\n')
    .map((line) => (isThrees(line) ? '' : line))
    .join('\n');
  const stage = (left: typeof paint) =>
    prefixed(left ? blanked(plain, text, left.start, left.end) : plain, own, prefix);
  const hookOf = (hook: string, type: string) => `void ${prefix}${hook}(inout ${type} data) {}`;
  const fragment = stage(displace);
  const vertex = stage(paint);
  const discards = /\bdiscard\b/.test(code) || /\.opacity\s*[-+*/]?=(?!=)/.test(code);
  const paintsByTime = paint !== undefined && TIME.test(withoutComments(fragment));
  return {
    uniforms,
    paints: paint !== undefined,
    // an empty hook is ignored, since displaced vertices cost more
    displaces: displace !== undefined && !/\{\s*\}$/.test(code.slice(displace.start, displace.end)),
    paintsByTime,
    movesByTime: (displace !== undefined && TIME.test(withoutComments(vertex))) || (discards && paintsByTime),
    discards,
    reach: readReach(name, text, uniforms),
    fragment: `${fragment}${paint ? '' : `\n${hookOf('surface', 'SurfaceData')}`}`,
    vertex: `${vertex}${displace ? '' : `\n${hookOf('displace', 'VertexData')}`}`,
  };
}

function isThrees(line: string): boolean {
  const names = UNIFORM_LINE.exec(line)?.[3].split(',');
  return names?.every((name) => threeUniforms.includes(name.trim())) ?? false;
}

function lineOf(text: string, at: number): number {
  return text.slice(0, at).split('\n').length;
}

/** Replaces comments by blanks; all other characters keep their position. */
function withoutComments(text: string): string {
  return text.replace(/\/\*[^]*?\*\/|\/\/.*/g, (comment) => comment.replace(/[^\n]/g, ' '));
}

interface Head {
  readonly name: string;
  /** Index of the declaration's first character, of its name, and of the end of a function's body (0 without a body). */
  readonly start: number;
  readonly at: number;
  readonly end: number;
}

/** Declarations outside of braces in code without comments: functions, constants, globals, structures. */
function topLevel(code: string): Head[] {
  // preprocessor lines are blanked, since they are not statements
  const text = code.replace(/^[ \t]*#(?:.*\\\n)*.*/gm, (line) => line.replace(/[^\n]/g, ' '));
  const heads: Head[] = [];
  let depth = 0;
  let start = 0;
  for (let i = 0; i < text.length; i++) {
    const c = text[i];
    if (c === '{') {
      if (depth++ === 0) {
        const end = closing(text, i);
        const head = text.slice(start, i);
        const called = /(\w+)\s*\([^()]*\)\s*$/.exec(head) ?? /\bstruct\s+(\w+)\s*$/.exec(head);
        if (called) {
          const isFunction = !/\bstruct\b/.test(head);
          heads.push({ name: called[1], start, at: start + called.index, end: isFunction ? end : 0 });
        }
      }
    } else if (c === '}') {
      depth = Math.max(0, depth - 1);
      if (depth === 0) start = i + 1;
    } else if (c === ';' && depth === 0) {
      const head = text.slice(start, i);
      if (!/^\s*(precision|uniform)\b/.test(head)) {
        const variable = /^\s*(?:const\s+)?(?:(?:high|medium|low)p\s+)?\w+\s+([^]*)$/.exec(head);
        const called = /^\s*(?:const\s+)?(?:(?:high|medium|low)p\s+)?\w+\s+(\w+)\s*\(/.exec(head);
        if (called) heads.push({ name: called[1], start, at: start, end: 0 });
        else if (variable) for (const name of namesOf(variable[1])) heads.push({ name, start, at: start, end: 0 });
      }
      start = i + 1;
    }
  }
  return heads;
}

/** Names declared by a list such as `a, b = f(1, 2), c[3]`. */
function namesOf(list: string): string[] {
  let flat = list;
  for (let before = ''; before !== flat;) {
    before = flat;
    flat = flat.replace(/\([^()]*\)|\[[^[\]]*\]/g, '');
  }
  return flat.split(',').flatMap((one) => /^\s*(\w+)/.exec(one)?.[1] ?? []);
}

function closing(text: string, open: number): number {
  let depth = 0;
  for (let i = open; i < text.length; i++) {
    if (text[i] === '{') depth++;
    else if (text[i] === '}' && --depth === 0) return i + 1;
  }
  return text.length;
}

/** Returns a text with one part blanked out; line numbers are kept. */
function blanked(plain: string, text: string, start: number, end: number): string {
  const first = lineOf(text, start + /^\s*/.exec(text.slice(start))![0].length);
  const last = lineOf(text, end);
  const lines = plain.split('\n');
  const whole = text.split('\n');
  // keeps what its first line has before the part, and what its last line has after it
  const before = text
    .slice(0, start + /^\s*/.exec(text.slice(start))![0].length)
    .split('\n')
    .at(-1)!;
  const after = whole[last - 1].slice(text.slice(0, end).split('\n').at(-1)!.length);
  for (let line = first; line <= last; line++) lines[line - 1] = '';
  lines[first - 1] = before;
  lines[last - 1] += after;
  return lines.join('\n');
}

/** Adds a prefix to names, except to members of structures and in `#include` lines. */
function prefixed(text: string, names: ReadonlySet<string>, prefix: string): string {
  if (names.size === 0) return text;
  const expression = new RegExp(`(?<![\\w.])(?:${[...names].join('|')})(?!\\w)`, 'g');
  return text
    .split('\n')
    .map((line) => (INCLUDE_LINE.test(line) ? line : line.replace(expression, (name) => prefix + name)))
    .join('\n');
}
