import { Color } from 'three';
import { surfaceError } from './surfaceError';
import type { SurfaceUniform, SurfaceUniformType } from './SurfaceUniform';

const sizes: Readonly<Record<SurfaceUniformType, number>> = {
  float: 1,
  int: 1,
  bool: 1,
  vec2: 2,
  vec3: 3,
  vec4: 4,
  sampler2D: 0,
};

/** Names of uniforms that three sets in every shader; a surface that declares one gets three's value. */
export const threeUniforms: readonly string[] = [
  ...['modelMatrix', 'modelViewMatrix', 'projectionMatrix', 'viewMatrix', 'normalMatrix'],
  ...['cameraPosition', 'isOrthographic'],
];

export const UNIFORM_LINE =
  /^([ \t]*)uniform[ \t]+(?:(?:high|medium|low)p[ \t]+)?(\w+)[ \t]+([\w, \t]+?)[ \t]*;[ \t]*(?:\/\/(.*))?$/;
const NUMBER = '[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?';
const RANGE = new RegExp(`^\\[\\s*(${NUMBER})\\s*,\\s*(${NUMBER})\\s*(?:,\\s*(${NUMBER})\\s*)?\\]`);
const LIST = new RegExp(`^(?:i?vec[234]\\()?\\s*(${NUMBER}(?:\\s*,\\s*${NUMBER})*)\\s*\\)?`);
const COLOR = /^#([\da-fA-F]{6}|[\da-fA-F]{3})\b/;

/**
 * Parses the uniforms that a surface declares: `uniform float height; // = 0.2 [0, 1, 0.01] Height of the waves (m)`. The
 * comment's parts (default, range with step, label) may be absent, the last ones first; a comment without `=` is only a label.
 * @param name - name of the surface, for errors
 * @throws MicroShaderCompileError with the line, for an invalid type or default
 */
export function readUniforms(name: string, text: string): SurfaceUniform[] {
  const found: SurfaceUniform[] = [];
  text.split('\n').forEach((lineText, i) => {
    const line = i + 1;
    const match = UNIFORM_LINE.exec(lineText);
    if (match === null) return;
    const [, , type, names, comment = ''] = match;
    for (const each of names.split(',').map((one) => one.trim())) {
      if (threeUniforms.includes(each)) continue;
      if (!Object.hasOwn(sizes, type))
        throw surfaceError(name, text, line, `"${type}" uniforms cannot be set: use ${Object.keys(sizes).join(', ')}`);
      if (found.some((other) => other.name === each))
        throw surfaceError(name, text, line, `a second uniform "${each}"; give it another name`);
      const read = readComment(type as SurfaceUniformType, each, comment);
      if (typeof read === 'string') throw surfaceError(name, text, line, read);
      found.push({ name: each, type: type as SurfaceUniformType, line, ...read });
    }
  });
  return found;
}

/** Parses the comment of a uniform. @returns the uniform, or a text that says what is wrong */
function readComment(
  type: SurfaceUniformType,
  name: string,
  comment: string,
): Omit<SurfaceUniform, 'name' | 'type' | 'line'> | string {
  const given = comment.trim();
  const size = sizes[type];
  const byName = type === 'vec3' && /colou?r/i.test(name);
  const none = size === 0 ? null : type === 'bool' ? false : size === 1 ? 0 : Array.from({ length: size }, () => 0);
  if (!given.startsWith('=') || size === 0) {
    return { isColor: byName, default: none, label: given.replace(/^=\s*/, '') || name };
  }
  let rest = given.slice(1).trim();
  const take = (expression: RegExp): RegExpExecArray | null => {
    const match = expression.exec(rest);
    if (match) rest = rest.slice(match[0].length).trim();
    return match;
  };
  const color = type === 'vec3' ? take(COLOR) : null;
  const isColor = color !== null || byName;
  let value: SurfaceUniform['default'];
  if (type === 'bool') {
    const word = take(/^(true|false)\b/);
    if (!word) return `the default of "${name}" is true or false`;
    value = word[1] === 'true';
  } else if (color) value = new Color(color[0]).toArray();
  else {
    const numbers = take(LIST)?.[1].split(',').map(Number) ?? [];
    if (numbers.length === 1 && size > 1) numbers.push(...Array.from({ length: size - 1 }, () => numbers[0]));
    if (numbers.length !== size || !numbers.every(Number.isFinite))
      return `the default of "${name}" is ${size === 1 ? 'a number' : `${size} numbers`}${type === 'vec3' ? ', or a colour such as #3399ff' : ''}`;
    value = size === 1 ? numbers[0] : numbers;
  }
  const range = take(RANGE);
  if (range && !(Number(range[1]) < Number(range[2]))) return `the range of "${name}" ends before it begins`;
  return {
    isColor,
    default: value,
    ...(range && { min: Number(range[1]), max: Number(range[2]) }),
    ...(range?.[3] !== undefined && { step: Number(range[3]) }),
    label: rest || name,
  };
}
