import { REVISION, ShaderChunk, ShaderLib } from 'three';
import { hashText } from '../microshaders/hashText';

const chunks = ShaderChunk as Record<string, string>;
const INCLUDE = /#include +<([\w./]+)>/g;
const LIGHTS = ['lights_pars_begin', 'lights_fragment_begin'];
/** Names of the shaders of lit materials; from SHADERS_LIT on, of shaders that draw shadow maps. */
const SHADERS = ['lambert', 'phong', 'toon', 'physical', 'depth', 'distance'] as const;
const SHADERS_LIT = 4;
/** Number of frames over which the comparison of three's texts is spread. */
const FRAMES = 8;

/** @param i - twice an index of SHADERS for its vertex shader, one more for its fragment shader */
const shaderText = (i: number) => ShaderLib[SHADERS[i >> 1]][i & 1 ? 'fragmentShader' : 'vertexShader'];

export type ChunkGroup = 'lights' | 'shadows' | 'shading';

/**
 * Hashes of the unchanged texts of each minor of three, by `REVISION`, see `textHash`. Up to 0.185, three compensated multiple
 * scattering for each light by its direction, which cannot be summed over lights: shading counts as changed there, so that lit
 * materials are drawn forward, by three's own functions.
 */
const PRISTINE: Record<string, Partial<Record<ChunkGroup, string>>> = {
  183: { lights: '1k59at', shadows: 'ok22gn' },
  184: { lights: 'n4mgpa', shadows: 'zpf8d3' },
  185: { lights: 'y3mupo', shadows: 'f6e5rp' },
  186: { lights: 'macnam', shadows: '1e3z16', shading: 'zpywff' },
  187: { lights: '1oj3hy', shadows: '1m54z6', shading: '1cwb5h' },
};
/** Hashes of the page's version of three; none for an unknown version, which then counts as changed. */
const pristine = PRISTINE[REVISION] ?? {};

/** Whether this three's shading can be summed over lights, as buffers need: since 0.186. */
export const sumsLights = Number(REVISION) >= 186;

/** Hash of a text without comments and spaces, which builds of three remove. */
export function textHash(text: string): string {
  return hashText(text.replace(/\/\/.*|\/\*[^]*?\*\/|\s+/g, '')).slice(0, 6);
}

function addIncludes(text: string, names: Set<string>): void {
  for (const [, name] of text.matchAll(INCLUDE)) {
    if (names.has(name) || chunks[name] === undefined) continue;
    names.add(name);
    addIncludes(chunks[name], names);
  }
}

/**
 * Detects shaders of three's that the page has changed by `ShaderChunk` or `ShaderLib`, before or after Farol was loaded, as
 * add-ons for soft shadows, cascades, fogs and tone mappings do.
 */
export class ThreeChunks {
  /** Number that grows with each change of three's shaders by the page. */
  revision = 0;
  /** Whether the light loops or the lights' data have changed: then three must light the scene. */
  lights = false;
  /** Whether shadow look-ups or casters' positions have changed: then three must draw the shadow maps. */
  shadows = false;
  /** Whether any other part of lit shaders has changed: then lit materials are drawn forward by three's own functions. */
  shading = false;
  private readonly names: string[] = [];
  private readonly texts: string[] = [];
  private calls = 0;

  /**
   * Compares three's texts with those of the last call.
   * @param some - whether to compare only one in FRAMES of the texts, and others in later calls. Default false
   * @returns whether any has changed
   */
  follow(some = false): boolean {
    const { names, texts } = this;
    const step = some ? FRAMES : 1;
    let same = texts.length > 0;
    for (let i = some ? this.calls++ % FRAMES : 0; i < texts.length; i += step)
      if ((i < names.length ? chunks[names[i]] : shaderText(i - names.length)) !== texts[i]) same = false;
    if (same) return false;
    const hashes = this.hashes();
    this.lights = hashes.lights !== pristine.lights;
    this.shadows = hashes.shadows !== pristine.shadows;
    this.shading = hashes.shading !== pristine.shading;
    this.revision++;
    return true;
  }

  /** Hashes of the current texts. */
  hashes(): Record<ChunkGroup, string> {
    const casters = new Set(['shadowmap_pars_fragment', 'shadowmap_pars_vertex', 'shadowmap_vertex']);
    const lit = new Set<string>(['tonemapping_pars_fragment', 'colorspace_pars_fragment']);
    const shaders = Array.from({ length: 2 * SHADERS.length }, (_, i) => shaderText(i));
    shaders.forEach((text, i) => addIncludes(text, i < 2 * SHADERS_LIT ? lit : casters));
    casters.delete('common');
    for (const name of [...LIGHTS, ...casters]) lit.delete(name);
    // positions computed from depth rely on three's projection
    lit.add('project_vertex');
    this.names.length = this.texts.length = 0;
    const hash = (names: Iterable<string>, from = 0, to = from) => {
      const sorted = [...names].sort();
      this.names.push(...sorted);
      return textHash([...shaders.slice(from, to), ...sorted.map((name) => chunks[name])].join(';'));
    };
    const hashes = {
      lights: hash(LIGHTS),
      shadows: hash(casters, 2 * SHADERS_LIT, shaders.length),
      shading: hash(lit, 0, 2 * SHADERS_LIT),
    };
    this.texts.push(...this.names.map((name) => chunks[name]), ...shaders);
    return hashes;
  }
}

/** The page's only ThreeChunks, since three has one `ShaderChunk` for each page. */
export const threeChunks = new ThreeChunks();
