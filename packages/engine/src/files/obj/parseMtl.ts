import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';

export interface MtlMap {
  /** Path as written in the MTL file. */
  readonly path: string;
  /** Factors on the texture coordinates u and v. */
  readonly scale: readonly [number, number];
  /** Offset added to u and v after scaling. */
  readonly offset: readonly [number, number];
  /** Whether the texture is clamped beyond its edges, not repeated. */
  readonly isClamped: boolean;
  /** Strength of the bump map. */
  readonly bump: number;
}

type Triple = readonly [number, number, number];

/** A material of an MTL file, with the properties that the file has. Colours are sRGB, as in the file. */
export interface MtlMaterial {
  readonly name: string;
  readonly diffuse?: Triple;
  readonly specular?: Triple;
  readonly emissive?: Triple;
  /** Phong exponent of the specular highlight. */
  readonly shininess?: number;
  /** Opacity: `d`, or 1 − `Tr`. */
  readonly opacity?: number;
  readonly roughness?: number;
  readonly metalness?: number;
  readonly diffuseMap?: MtlMap;
  readonly specularMap?: MtlMap;
  readonly emissiveMap?: MtlMap;
  readonly opacityMap?: MtlMap;
  /** Normal map, named by `norm`. */
  readonly normalMap?: MtlMap;
  /** Height map (`bump`, `map_bump`); in many files really a normal map. */
  readonly bumpMap?: MtlMap;
  /** Displacement map; used only when its texels are in fact normals. */
  readonly displacementMap?: MtlMap;
}

/** Number of values of each texture option; `-o`, `-s` and `-t` have one to three. */
const optionLengths: Readonly<Record<string, number>> = {
  '-blendu': 1,
  '-blendv': 1,
  '-boost': 1,
  '-bm': 1,
  '-cc': 1,
  '-clamp': 1,
  '-imfchan': 1,
  '-mm': 2,
  '-o': 3,
  '-s': 3,
  '-t': 3,
  '-texres': 1,
  '-type': 1,
};

/** Options whose one value is a word. */
const wordValues: Readonly<Record<string, RegExp>> = {
  '-blendu': /^(on|off)$/i,
  '-blendv': /^(on|off)$/i,
  '-cc': /^(on|off)$/i,
  '-clamp': /^(on|off)$/i,
  '-imfchan': /^[rgbmlz]$/i,
  '-type': /^(sphere|cube_\w+)$/i,
};

const isOption = (word: string | undefined): boolean => Object.hasOwn(optionLengths, word?.toLowerCase() ?? '');
const isNumber = (word: string | undefined): word is string => word !== undefined && /^[-+]?[\d.]/.test(word);

/** Reads options into `options`, beginning at word `from`. @returns index after the options */
function readOptions(words: readonly string[], from: number, options: Map<string, string[]>): number {
  let at = from;
  while (isOption(words[at])) {
    const name = words[at++].toLowerCase();
    const most = optionLengths[name];
    const values: string[] = [];
    if (most === 1) values.push(words[at++] ?? '');
    else while (values.length < most && isNumber(words[at])) values.push(words[at++]);
    options.set(name, values);
  }
  return at;
}

/** Whether words are valid values of an option, and not part of a file name that resembles one. */
function areValues(name: string, values: readonly string[]): boolean {
  const word = wordValues[name];
  if (word) return word.test(values[0]);
  return values.length > 0 && values.every((value) => value !== '' && Number.isFinite(Number(value)));
}

/** Words at the end of a line that are searched for options: twice as many as all options can have. */
const TRAILING = 64;

/**
 * Parses options at the end of a line, where some programs write them.
 * @returns index of the first option's word; the number of words for none
 */
function trailingOptions(words: readonly string[], from: number, options: Map<string, string[]>): number {
  for (let start = Math.max(from, words.length - TRAILING); start < words.length; start++) {
    const found = new Map<string, string[]>();
    if (readOptions(words, start, found) !== words.length) continue;
    if (![...found].every(([name, values]) => areValues(name, values))) continue;
    for (const [name, values] of found) options.set(name, values);
    return start;
  }
  return words.length;
}

/** Parses the value of `map_Kd` and similar keywords: options, a path that may contain blanks, and options again. */
export function parseMtlMap(text: string): MtlMap | undefined {
  const words = text.trim().split(/\s+/);
  const options = new Map<string, string[]>();
  const from = readOptions(words, 0, options);
  const to = trailingOptions(words, from + 1, options);
  // cuts the options off the text, which keeps blanks within the path
  let path = text.trim();
  for (let i = 0; i < from; i++) path = path.replace(/^\S+\s*/, '');
  for (const word of words.slice(to).toReversed()) path = path.slice(0, -word.length).trimEnd();
  path = path.replace(/^"(.*)"$/, '$1');
  if (!path) return undefined;
  const pair = (name: string, otherwise: number): [number, number] => {
    const [u = otherwise, v = otherwise] = (options.get(name) ?? []).map(Number);
    return [Number.isFinite(u) ? u : otherwise, Number.isFinite(v) ? v : otherwise];
  };
  const bump = Number(options.get('-bm')?.[0] ?? 1);
  return {
    path,
    scale: pair('-s', 1),
    offset: pair('-o', 0),
    isClamped: options.get('-clamp')?.[0]?.toLowerCase() === 'on',
    bump: Number.isFinite(bump) ? bump : 1,
  };
}

type MtlInfo = Readonly<Record<string, string | readonly number[] | undefined>>;

/** Reads the materials of an MTL file, by name. */
export function parseMtl(text: string): Map<string, MtlMaterial> {
  // MTLLoader expects a single blank after a keyword
  const creator = new MTLLoader().parse(text.replace(/\r\n?/g, '\n').replaceAll('\t', ' '), '');
  const table = creator.materialsInfo as unknown as Readonly<Record<string, MtlInfo>>;
  return new Map(Object.entries(table).map(([name, info]) => [name, readMaterial(name, info)]));
}

function readMaterial(name: string, info: MtlInfo): MtlMaterial {
  const number = (key: string): number | undefined => {
    const value = parseFloat(String(info[key] ?? ''));
    return Number.isFinite(value) ? value : undefined;
  };
  const triple = (key: string): Triple | undefined => {
    const [r, g = r, b = r] = (info[key] as readonly number[] | undefined) ?? [];
    const values = [r, Number.isFinite(g) ? g : r, Number.isFinite(b) ? b : r] as const;
    return values.every(Number.isFinite) ? values : undefined;
  };
  const map = (...keys: string[]): MtlMap | undefined => {
    for (const key of keys) {
      const text = info[key];
      const read = typeof text === 'string' ? parseMtlMap(text) : undefined;
      if (read) return read;
    }
    return undefined;
  };
  return {
    name,
    diffuse: triple('kd'),
    specular: triple('ks'),
    emissive: triple('ke'),
    shininess: number('ns'),
    opacity: opacityOf(number('d'), number('tr')),
    roughness: number('pr'),
    metalness: number('pm'),
    diffuseMap: map('map_kd', 'map_ka'),
    specularMap: map('map_ks'),
    emissiveMap: map('map_ke'),
    opacityMap: map('map_d', 'map_opacity'),
    normalMap: map('norm', 'map_norm', 'map_kn'),
    bumpMap: map('map_bump', 'bump'),
    displacementMap: map('disp', 'map_disp'),
  };
}

/**
 * Opacity; a fully invisible material counts as opaque, since programs write `d 0` (as in the common Sponza) or `Tr 1`.
 */
function opacityOf(d: number | undefined, transparency: number | undefined): number | undefined {
  const opacity = d ?? (transparency === undefined ? undefined : 1 - transparency);
  return opacity === undefined || opacity <= 0 ? undefined : Math.min(1, opacity);
}
