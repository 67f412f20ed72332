import {
  Color,
  type IUniform,
  type Material,
  type Texture,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { wearSurfaces, type WornSurfaces } from '../materials/surfacesOf';
import type { TwinShader } from '../materials/TwinKind';
import type { MicroShaderRegistry } from '../microshaders';
import { insertSurfaces } from './insertSurfaces';
import type { ParsedSurface } from './parseSurface';
import { Surface, type SurfaceValue, type SurfaceValues } from './Surface';
import type { SurfaceUniform } from './SurfaceUniform';

interface Worn {
  readonly surface: Surface;
  readonly uniforms: Record<string, IUniform<SurfaceValue>>;
  /** GLSL text of each uniform's default at the time when its value was made, by name. */
  readonly defaults: Map<string, string>;
  /** `Surface.version` for which `uniforms` are complete. */
  version: number;
  readonly timeBefore: IUniform<number>;
}

let changes = 0;

/** The surfaces of one material, with their values; kept for the material's lifetime, since its programs refer to the values. */
export class MaterialSurfaces implements WornSurfaces {
  list: readonly Worn[] = [];
  private names: readonly string[] = [];
  private stamp = 0;
  /** Values of all surfaces that the material uses or has used. */
  private readonly known = new Map<Surface, Worn>();
  /** Uniforms of the material's surfaces, by their names in shaders. */
  private readonly uniforms: Record<string, IUniform> = {};

  /** `Surface.version` of each surface for which `uniforms` is complete. */
  private readonly linked = new Map<Worn, number>();

  constructor(private readonly material: Material) {}

  /** Sets the surfaces of another material, sharing their values, and adds `surface`. @returns the values of `surface` */
  layer(
    below: MaterialSurfaces | null,
    surface: Surface,
    values: SurfaceValues,
  ): Record<string, IUniform<SurfaceValue>> {
    const others = below?.list.filter((worn) => worn.surface !== surface) ?? [];
    for (const worn of others) this.known.set(worn.surface, worn);
    return this.set([...others.map((worn) => worn.surface), surface], surface, values);
  }

  /** Sets the material's surfaces, with their values. @returns the values of `shown`, with `values` set */
  set(
    surfaces: readonly Surface[],
    shown: Surface | null,
    values: SurfaceValues,
  ): Record<string, IUniform<SurfaceValue>> {
    let result: Record<string, IUniform<SurfaceValue>> = {};
    if (shown !== null) {
      const unknown = Object.keys(values).find((name) => !shown.uniforms.some((uniform) => uniform.name === name));
      if (unknown !== undefined)
        throw new Error(
          `Surface "${shown.name}" has no uniform "${unknown}"; give one of: ${shown.uniforms.map(({ name }) => name).join(', ') || 'none'}.`,
        );
      const before = this.known.get(shown);
      const isNew = !this.list.some(({ surface }) => surface === shown);
      const worn = before ?? makeWorn(shown);
      this.known.set(shown, worn);
      if (isNew) worn.defaults.clear();
      this.complete(worn);
      for (const uniform of shown.uniforms)
        if (uniform.name in values) worn.uniforms[uniform.name].value = valueOf(uniform, values[uniform.name]);
      result = worn.uniforms;
    }
    wearSurfaces(this.material, this);
    const isSame = surfaces.length === this.list.length && surfaces.every((each, i) => each === this.list[i].surface);
    if (isSame) return result;
    this.list = surfaces.map((surface) => this.known.get(surface)!);
    this.names = surfaces.flatMap(({ chunk, vertexChunk }) => [chunk, vertexChunk]);
    this.stamp = ++changes;
    return result;
  }

  get displaces(): boolean {
    return this.list.some(({ surface }) => surface.parsed.displaces);
  }

  get discards(): boolean {
    return this.list.some(({ surface }) => surface.parsed.discards);
  }

  reach(): number {
    let reach = 0;
    for (let i = 0; i < this.list.length; i++) {
      const { surface, uniforms } = this.list[i];
      if (surface.parsed.displaces) reach += reachOf(surface.parsed.reach, uniforms);
    }
    return reach;
  }

  version(registry: MicroShaderRegistry): number {
    let version = this.stamp;
    for (const { surface } of this.list) version += surface.version;
    return version + registry.revision(this.names);
  }

  key(registry: MicroShaderRegistry): string {
    if (this.list.length === 0) return '';
    const texts = this.list.map(({ surface }) => surface.key).join();
    return this.list.every(({ surface }) => surface.isUsable(registry))
      ? `${texts}:${registry.textKey(this.names)}`
      : `${texts}!`;
  }

  rewrite(shader: TwinShader, registry: MicroShaderRegistry, webgl: WebGLRenderer): void {
    const used = this.list.filter(({ surface }) => {
      const problem = surface.addTo(registry, webgl);
      if (problem) console.warn(`Farol: an object is drawn without its surface: ${problem.message}`);
      return surface.isUsable(registry);
    });
    for (const worn of this.list) this.complete(worn);
    Object.assign(shader.uniforms, this.uniforms);
    if (used.length > 0)
      insertSurfaces(
        shader,
        used.map(({ surface }) => surface),
        registry,
      );
  }

  colourVersion(): number {
    let look = this.stamp;
    for (let i = 0; i < this.list.length; i++) {
      const { parsed, time } = this.list[i].surface;
      if (parsed.paints) look += stateOf(this.list[i], i, parsed.paintsByTime ? time.value : 0);
    }
    return look;
  }

  shapeVersion(): number {
    let shape = this.stamp;
    for (let i = 0; i < this.list.length; i++) {
      const { parsed, time } = this.list[i].surface;
      if (parsed.displaces || parsed.discards) shape += stateOf(this.list[i], i, parsed.movesByTime ? time.value : 0);
    }
    return shape;
  }

  copyTimes(times: number[]): void {
    for (let i = 0; i < this.list.length; i++) times[i] = this.list[i].surface.time.value;
  }

  setTimesBefore(times: readonly number[]): void {
    for (let i = 0; i < this.list.length; i++)
      this.list[i].timeBefore.value = times[i] ?? this.list[i].surface.time.value;
  }

  /** Gives every declared uniform a value; a value equal to the default of an earlier text becomes the present default. */
  private complete(worn: Worn): void {
    const { surface, uniforms, defaults } = worn;
    if (worn.version === surface.version && defaults.size === surface.uniforms.length) return this.link(worn);
    worn.version = surface.version;
    for (const declared of surface.uniforms) {
      const { name } = declared;
      const initial = JSON.stringify([declared.type, declared.isColor, declared.default]);
      const before = defaults.get(name);
      const uniform = (uniforms[name] ??= { value: null });
      const wasDefault =
        before === undefined ||
        sameAsDefault(uniform.value, before) ||
        !before.startsWith(`["${declared.type}",${declared.isColor}`);
      if (initial !== before && wasDefault) uniform.value = Surface.defaultOf(declared);
      defaults.set(name, initial);
    }
    for (const name of defaults.keys())
      if (!surface.uniforms.some((declared) => declared.name === name)) defaults.delete(name);
    this.link(worn);
  }

  private link(worn: Worn): void {
    const { surface, uniforms } = worn;
    if (this.linked.get(worn) === surface.version) return;
    this.linked.set(worn, surface.version);
    const { prefix } = surface;
    for (const { name } of surface.uniforms) this.uniforms[prefix + name] = uniforms[name];
    this.uniforms[`${prefix}time`] = surface.time;
    this.uniforms[`${prefix}timeBefore`] = worn.timeBefore;
  }
}

/** Greatest displacement by a surface at its uniforms' current values (m). */
function reachOf(terms: ParsedSurface['reach'], uniforms: Worn['uniforms']): number {
  if (terms === null) return Infinity;
  let reach = 0;
  for (const { factor, names } of terms) {
    let term = factor;
    for (const name of names) term *= Number(uniforms[name]?.value ?? 0);
    reach += Math.abs(term);
  }
  return reach;
}

function stateOf({ surface, uniforms }: Worn, place: number, time: number): number {
  let state = surface.version * 0.37 + time * 1.7;
  const declared = surface.uniforms;
  for (let i = 0; i < declared.length; i++) {
    const uniform = uniforms[declared[i].name] as IUniform<SurfaceValue> | undefined;
    if (uniform !== undefined) state += numberOf(uniform.value) * (1 + ((place * 7 + i * 3) % 31));
  }
  return state;
}

function makeWorn(surface: Surface): Worn {
  return { surface, uniforms: {}, defaults: new Map(), version: -1, timeBefore: { value: 0 } };
}

function sameAsDefault(value: SurfaceValue, described: string): boolean {
  const [, , initial] = JSON.parse(described) as [string, boolean, SurfaceUniform['default']];
  if (Array.isArray(initial)) return JSON.stringify(numbersOf(value)) === JSON.stringify(initial);
  return value === initial;
}

function numbersOf(value: SurfaceValue): number[] | null {
  return value !== null && typeof value === 'object' && 'toArray' in value ? value.toArray() : null;
}

function valueOf(uniform: SurfaceUniform, value: SurfaceValues[string]): SurfaceValue {
  if (!Array.isArray(value)) return value as SurfaceValue;
  return Surface.defaultOf({ ...uniform, default: value as readonly number[] });
}

function numberOf(value: SurfaceValue): number {
  if (value === null) return 0;
  if (typeof value !== 'object') return Number(value);
  if (value instanceof Color) return value.r + value.g * 3 + value.b * 7;
  if (value instanceof Vector2) return value.x + value.y * 3;
  if (value instanceof Vector3) return value.x + value.y * 3 + value.z * 7;
  if (value instanceof Vector4) return value.x + value.y * 3 + value.z * 7 + value.w * 13;
  const texture = value as Texture;
  return texture.id * 17 + texture.version;
}
